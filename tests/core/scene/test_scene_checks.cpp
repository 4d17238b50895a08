// Validation, description and finger paths.
#include <cmath>
#include <fstream>
#include <thread>

#include <QTest>
#include <sys/stat.h>

#include "core/files/read_finger_path.h"
#include "core/scene/describe.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_checks {

using namespace tactum;

namespace {

std::shared_ptr<TriangleSoup> tetrahedron(double size) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    soup->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    soup->surfaceOf = {0, 0, 1, 1};
    return soup;
}

Scene soundScene(double size = 0.1) {
    Scene scene;
    SceneObject object;
    object.name = "rock";
    object.geometry = tetrahedron(size);
    object.surfaces.resize(2);
    object.surfaces[0].name = "top";
    object.surfaces[1].name = "side";
    scene.add(object);
    return scene;
}

using Severity = Finding::Severity;

/// The severity of the one finding whose sentence contains `part`; fails the test when there is another
/// number.
std::optional<Severity> only(const Scene& scene, const std::string& part) {
    std::optional<Severity> severity;
    for (const Finding& finding : validate(scene)) {
        if (finding.sentence.find(part) == std::string::npos) continue;
        if (severity || finding.remedy.empty()) return std::nullopt;
        severity = finding.severity;
    }
    return severity;
}

} // namespace

class TestSceneChecks : public QObject {
    Q_OBJECT

private slots:
    void aSoundSceneHasNoFindings() { QCOMPARE(validate(soundScene()).size(), std::size_t(0)); }

    void shadingAndLayersAreDescribed() {
        Scene scene = soundScene();
        Surface& top = scene.objects[0].surfaces[0];
        top.shading = {true, NormalSource::Computed, 0.5};
        TextureLayer layer;
        layer.name = "grip";
        layer.enabled = false;
        layer.pattern.source = TextureSource::Dots;
        layer.target = TextureTarget::Viscosity;
        layer.blend = TextureBlend::Multiply;
        layer.strength = 3;
        top.layers = {layer};
        const std::vector<SurfaceDescription> surfaces = describe(scene).objects.at(0).surfaces;
        QVERIFY(surfaces[0].shading == top.shading);
        QVERIFY(!surfaces[1].shading.on);
        QVERIFY(surfaces[1].layers.empty());
        const LayerDescription& grip = surfaces[0].layers.at(0);
        QCOMPARE(grip.name, std::string("grip"));
        QVERIFY(!grip.enabled);
        QVERIFY(grip.image.empty());
        QCOMPARE_EQ(grip.source, "dots");
        QCOMPARE_EQ(grip.mapping, "triplanar");
        QCOMPARE_EQ(grip.blend, "multiply");
        QCOMPARE_EQ(grip.target, "viscosity");
        QVERIFY(grip.strength.unit.empty());
        QCOMPARE_EQ(grip.strength.value, 3);
    }

    void oneSideOfAnUnevenMeshIsDoubted() {
        Scene scene = soundScene();
        scene.objects[0].surfaces[1].sides = Sides::Front;
        QVERIFY(validate(scene).empty());
        QCOMPARE(describe(scene).objects[0].surfaces[1].sides, Sides::Front);
        auto turned = tetrahedron(0.1);
        std::swap(turned->triangles[2][0], turned->triangles[2][1]);
        scene.objects[0].geometry = turned;
        QCOMPARE(only(scene, "surface \"side\" is felt from its front alone"), Severity::Warning);
        scene.objects[0].surfaces[1].sides = Sides::Both;
        QVERIFY(!only(scene, "is felt from its"));
    }

    void everyValueIsHeldAgainstItsRange() {
        for (const MaterialField& field : kMaterialFields) {
            const std::string label(field.parameter->label);
            Scene scene = soundScene();
            double& value = scene.objects[0].surfaces[1].material.*field.value;
            value = field.parameter->maximum * 1.5 + 1;
            QCOMPARE(only(scene, label + " of surface \"side\" is "), Severity::Warning);
            value = field.parameter->minimum - 1;
            QCOMPARE(only(scene, label + " of surface \"side\" is "), Severity::Error);
            value = NAN;
            QCOMPARE(only(scene, label + " of surface \"side\" is not a number"), Severity::Error);
            value = field.parameter->maximum;
            QVERIFY(!only(scene, label + " of surface"));
        }
        Scene scene = soundScene();
        scene.proxyRadius = 0;
        QCOMPARE(only(scene, "Proxy radius is 0 m, outside 1e-05 to 0.1 m"), Severity::Error);
    }

    void dynamicFrictionMayNotExceedStatic() {
        Scene scene = soundScene();
        scene.objects[0].surfaces[0].material.staticFriction = 0.3;
        scene.objects[0].surfaces[0].material.dynamicFriction = 0.3;
        QVERIFY(validate(scene).empty());
        scene.objects[0].surfaces[0].material.dynamicFriction = 0.31;
        QCOMPARE(only(scene, "dynamic friction of surface \"top\" (0.31) is above static friction (0.3)"),
                 Severity::Warning);
    }

    void sizesOfOtherUnitsAreDoubted() {
        QCOMPARE(only(soundScene(100), "141.421 m across"), std::nullopt); // the box has three sides
        QCOMPARE(only(soundScene(100), "173.205 m across"), Severity::Warning);
        Scene small = soundScene(0.0025);
        small.proxyRadius = 1e-4;
        QCOMPARE(only(small, "looks like another unit"), Severity::Warning);
    }

    void objectsThatCannotBeTouchedAreNamed() {
        Scene scene = soundScene();
        scene.objects[0].geometry = std::make_shared<TriangleSoup>();
        QCOMPARE(only(scene, "has no triangles"), Severity::Warning);
        scene = soundScene();
        scene.proxyRadius = 0.099;
        QCOMPARE(only(scene, "than the proxy (radius 0.099 m)"), Severity::Warning);
        QCOMPARE(only(Scene(), "the scene is empty"), Severity::Warning);
    }

    void theHealthOfMeshesIsPartOfIt() {
        Scene scene = soundScene();
        auto soup = std::make_shared<TriangleSoup>(*scene.objects[0].geometry);
        soup->triangles[0] = soup->triangles[1];
        scene.objects[0].geometry = soup;
        QCOMPARE(only(scene, "1 triangle equal to another one"), Severity::Warning);
        QCOMPARE(only(scene, "1 open rim with 2 edges"), Severity::Note);
    }

    void theDescriptionHasEverything() {
        Scene scene = soundScene();
        SceneObject copy = scene.objects[0];
        copy.name = "copy";
        copy.pose.translation = Vec3(1, 0, 0);
        copy.surfaces[0].material.viscosity = 99;
        scene.add(copy);
        const SceneDescription description = describe(scene);
        QCOMPARE(description.triangles, std::size_t(8));
        QCOMPARE(description.bounds_W.high, Vec3(1.1, 0.1, 0.1));
        QCOMPARE(description.parameters[0].key, std::string_view("proxy-radius"));
        const ObjectDescription& second = description.objects[1];
        QCOMPARE(second.name, std::string("copy"));
        QCOMPARE(second.bounds_B.high, Vec3(0.1, 0.1, 0.1));
        QVERIFY(second.health.closed());
        QCOMPARE(second.surfaces[1].triangles, std::size_t(2));
        QCOMPARE(second.surfaces[0].parameters.size(), kMaterialFields.size());
        QCOMPARE(second.surfaces[0].parameters[0].unit, std::string_view("N/m"));
        QCOMPARE(second.surfaces[0].parameters[4].value, 99.0);
        QVERIFY(!second.surfaces[0].parameters[4].allowed);
    }

    void fingerPathsAreReadToTheLastBit() {
        const auto path = readFingerPath(
            folder_.write("a.csv", "t,x,y,z\r\n0,0.1,-2e-3,+3\r\n0.001, 0.30000000000000004 ,0,0\r\n\r\n\n"));
        VERIFY_RESULT(path);
        QCOMPARE(path->size(), std::size_t(2));
        QCOMPARE((*path)[0].position, Vec3(0.1, -0.002, 3));
        QCOMPARE_EQ((*path)[1].t, 0.001);
        QCOMPARE_EQ((*path)[1].position.x(), 0.30000000000000004);
    }

    void aByteOrderMarkIsNoPartOfTheHeader() {
        const auto path = readFingerPath(folder_.write("mark.csv", "\xEF\xBB\xBFt,x,y,z\n0,1,2,3\n  \n"));
        VERIFY_RESULT(path);
        QCOMPARE(path->front().position, Vec3(1, 2, 3));
    }

    void aFingerPathComesThroughAPipe() {
        const auto pipe = folder_.path() / "pipe";
        QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
        // Not waited for: it would wait for a reader that refuses the pipe.
        std::thread([pipe] { std::ofstream(pipe) << "t,x,y,z\n0,1,2,3\n1,1,2,4\n"; }).detach();
        const auto path = readFingerPath(pipe);
        VERIFY_RESULT(path);
        QCOMPARE(path->size(), std::size_t(2));
        // A scene is no stream: nothing may wait for a writer that never comes.
        const auto model = folder_.path() / "pipe.obj";
        QCOMPARE(::mkfifo(model.c_str(), 0600), 0);
        QVERIFY(!loadScene(model));
    }

    void brokenFingerPathsNameLineAndColumn_data() {
        QTest::addColumn<QString>("content");
        QTest::addColumn<QString>("error");
        QTest::newRow("empty") << ""
                               << "a.csv: is empty";
        QTest::newRow("no header") << "0,0,0,0\n"
                                   << "a.csv:1: the header must be \"t,x,y,z\"";
        QTest::newRow("other header") << "t,x,y,w\n0,0,0,0\n"
                                      << "a.csv:1: the header must";
        QTest::newRow("longer header") << "t,x,y,z,w\n0,0,0,0\n"
                                       << "a.csv:1: the header must";
        QTest::newRow("no rows") << "t,x,y,z\n\n"
                                 << "a.csv: has a header but no rows";
        QTest::newRow("word") << "t,x,y,z\n0,0,zero,0\n"
                              << "a.csv:2: column y: \"zero\" is not a number";
        QTest::newRow("decimal comma") << "t,x,y,z\n0,1,5,0,0\n"
                                       << "a.csv:2: column z: \"0,0\" is not a number";
        QTest::newRow("short row") << "t,x,y,z\n0,0,0,0\n1,0,0\n"
                                   << "a.csv:3: column z: \"\" is not a number";
        QTest::newRow("nan") << "t,x,y,z\n0,nan,0,0\n"
                             << "a.csv:2: column x: \"nan\" is not within 1e6 m";
        QTest::newRow("infinite time") << "t,x,y,z\ninf,0,0,0\n"
                                       << "a.csv:2: column t: \"inf\" is not finite";
        QTest::newRow("same time") << "t,x,y,z\n1,0,0,0\n1,0,0,0\n"
                                   << "a.csv:3: column t: 1";
        // The finger's speed would be no number, and the force with it.
        QTest::newRow("nearly the same time") << "t,x,y,z\n0,0,0,0\n1e-300,0.1,0,0\n"
                                              << "a.csv:3: column t: 0.000000 is not 1e-7 s or more after";
        QTest::newRow("gap") << "t,x,y,z\n1,0,0,0\n\n2,0,0,0\n"
                             << "a.csv:3: a blank line inside the path";
    }
    void brokenFingerPathsNameLineAndColumn() {
        QFETCH(QString, content);
        QFETCH(QString, error);
        const auto path = readFingerPath(folder_.write("a.csv", content.toStdString()));
        QVERIFY(!path);
        QVERIFY2(QString::fromStdString(path.error().text).contains(error), path.error().text.c_str());
    }

private:
    FileFolder folder_;
};

TACTUM_TEST(TestSceneChecks)

} // namespace test_scene_checks

#include "test_scene_checks.moc"
