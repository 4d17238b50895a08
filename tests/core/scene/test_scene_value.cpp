// A number of a scene by its path: found, set, and nothing else with it.
#include <map>

#include <QTest>

#include "core/scene/bodies.h"
#include "core/scene/scene_value.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_scene_value {

using namespace tactum;
using namespace tactum::test;

namespace {

Surface called(const char* name, std::vector<TextureLayer> layers = {}) {
    Surface surface;
    surface.name = name;
    surface.layers = std::move(layers);
    return surface;
}

TextureLayer layer(TextureTarget target, double strength) {
    TextureLayer made;
    made.target = target;
    made.strength = strength;
    return made;
}

/// A box with two surfaces, one with two layers, that hangs on a hinge; and a plate with one.
Scene crate() {
    Scene scene;
    const ObjectId box = add(scene, "box", test::box({0.1, 0.02, 0.3}), {});
    SceneObject& object = *scene.find(box);
    TextureLayer masked = layer(TextureTarget::StaticFriction, 0.5);
    masked.mask = TexturePattern{};
    object.surfaces = {called("lid", {layer(TextureTarget::Height, 2e-4), masked}), called("floor")};
    object.surfaces[0].shading.on = true;
    const BodyId body = makeBody(scene, box);
    setAxisJoint(scene, body, guessedJoint(scene, body, AxisKind::Hinge));
    SceneObject plate = *scene.find(box);
    plate.id = 0, plate.body = kWorldBody, plate.name = "plate";
    plate.surfaces = {called("lid", {layer(TextureTarget::Height, 1e-4)}), called("floor")};
    scene.add(plate);
    return scene;
}

SceneValue at(std::string_view path) {
    const auto value = SceneValue::named(path);
    if (!value) qFatal("no %s", std::string(path).c_str());
    return *value;
}

} // namespace

class TestSceneValue : public QObject {
    Q_OBJECT

private slots:
    void aPathNamesOneNumber_data() {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("places");
        const auto row = [](const char* path, double value, int places) {
            QTest::newRow(path) << QByteArray(path) << value << places;
        };
        row("stiffness", 321, 1);
        row("crease-angle", 0.5, 1);
        row("layers[0].height", 3e-4, 1);
        row("layers[0].opacity", 0.25, 1);
        row("layers[1].ratio", 0.75, 1);
        row("layers[1].size", 0.02, 1);
        row("layers[1].mask.size", 0.03, 1);
        row("proxy-radius", 2e-3, 1);
        row("shell-radius", 0.04, 1);
        row("air-density", 1.2, 1);
        row("body-mass", 0.3, 1);
        row("joints[0].hinge-friction", 0.25, 1);
        row("layers[0].ratio", 0.5, 0);      // it is a height
        row("layers[1].height", 1e-4, 0);    // and this a friction
        row("layers[0].mask.size", 0.03, 0); // without a mask
        row("layers[2].opacity", 0.5, 0);    // without a third layer
        row("joints[0].slider-friction", 1, 0);
        row("joints[1].hinge-friction", 1, 0);
    }

    /// By hand, in a copy.
    static Scene expected(Scene scene, const QByteArray& path, double value) {
        SceneObject& box = scene.objects[0];
        Surface& lid = box.surfaces[0];
        const std::map<QByteArray, double*> plain{{"stiffness", &lid.material.stiffness},
                                                  {"crease-angle", &lid.shading.creaseAngle},
                                                  {"layers[0].height", &lid.layers[0].strength},
                                                  {"layers[0].opacity", &lid.layers[0].opacity},
                                                  {"layers[1].ratio", &lid.layers[1].strength},
                                                  {"layers[1].size", &lid.layers[1].pattern.size},
                                                  {"layers[1].mask.size", &lid.layers[1].mask->size},
                                                  {"proxy-radius", &scene.proxyRadius},
                                                  {"shell-radius", &scene.reach.shell},
                                                  {"air-density", &scene.mechanics.airDensity}};
        if (const auto found = plain.find(path); found != plain.end()) *found->second = value;
        if (path == "body-mass") setMass(*findBody(scene, box.body), value);
        if (path == "joints[0].hinge-friction") {
            AxisJoint joint = *axisJointOf(scene, box.body);
            joint.friction = value;
            setAxisJoint(scene, box.body, joint);
        }
        return scene;
    }

    void aPathNamesOneNumber() {
        QFETCH(QByteArray, path);
        QFETCH(double, value);
        QFETCH(int, places);
        const Scene before = crate();
        Scene scene = before;
        const SceneValue number = at(path.toStdString());
        QCOMPARE(number.path(), path.toStdString());
        QCOMPARE(number.set(scene, {"box", "lid"}, value), std::size_t(places));
        QVERIFY(scene == (places > 0 ? expected(before, path, value) : before));
        QCOMPARE(number.in(scene, {"box", "lid"}).has_value(), places > 0);
        if (places == 0) return;
        QVERIFY(!(scene == before));
        COMPARE_NEAR(*number.in(scene, {"box", "lid"}), value, 1e-15, "");
    }

    void aPlaceWithoutNamesIsEverywhere() {
        Scene scene = crate();
        QCOMPARE(at("layers[0].height").set(scene, {}, 5e-4), std::size_t(2));
        QCOMPARE(scene.objects[0].surfaces[0].layers[0].strength, 5e-4);
        QCOMPARE(scene.objects[1].surfaces[0].layers[0].strength, 5e-4);
        QCOMPARE(at("damping").set(scene, {"plate", {}}, 3), std::size_t(2));
        QCOMPARE(at("damping").set(scene, {{}, "floor"}, 3), std::size_t(2));
        QCOMPARE(at("damping").set(scene, {"lamp", {}}, 3), std::size_t(0));
        QVERIFY(!at("damping").in(scene, {{}, "handle"}));
    }

    void aNumberIsSetAsAPersonSetsIt() {
        Scene scene = crate();
        at("dynamic-friction").set(scene, {}, 0.7);
        QCOMPARE(scene.objects[1].surfaces[1].material.staticFriction, 0.7); // never below
        at("layers[0].opacity").set(scene, {}, 7);
        QCOMPARE(scene.objects[0].surfaces[0].layers[0].opacity, 1.0);
    }

    void whatThereIsNotIsNoPath() {
        for (const char* path :
             {"", "warmth", "layers[0]", "layers[0].", "layers[-1].height", "layers[].height",
              "layers[a].height", "layers[0].stiffness", "layers[99999999999999999999].height", "height",
              "mask.size", "layers[0].mask.opacity", "joints[0].body-mass", "layers[0].height ", "Stiffness"})
            QVERIFY2(!SceneValue::named(path), path);
    }

    void aSceneSaysWhatItHas() {
        const Scene scene = crate();
        const std::vector<SceneValue> values = valuesIn(scene);
        QStringList paths;
        for (const SceneValue& value : values) {
            paths << QString::fromStdString(value.path());
            QVERIFY(SceneValue::named(value.path()) == value);
            QVERIFY2(value.in(scene, {}), value.path().c_str());
        }
        QCOMPARE(paths.removeDuplicates(), qsizetype(0));
        for (const char* path :
             {"stiffness", "crease-angle", "layers[0].height", "layers[1].ratio", "layers[1].mask.octaves",
              "body-mass", "joints[0].hinge-damping", "proxy-radius", "air-density"})
            QVERIFY2(paths.contains(QLatin1String(path)), path);
        for (const char* path : {"layers[0].ratio", "layers[0].fill", "layers[0].mask.size",
                                 "layers[2].opacity", "joints[0].slider-damping", "shell-radius"})
            QVERIFY2(!paths.contains(QLatin1String(path)), path);
        QCOMPARE(valuesIn(Scene{}).size(), kMaterialFields.size() + 1); // and the proxy's radius
    }
};

TACTUM_TEST(TestSceneValue)

} // namespace test_scene_value

#include "test_scene_value.moc"
