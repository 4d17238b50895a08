// Scenes through the public surface of the library: opened, made, changed, written, touched.
#include <limits>

#include <QTemporaryDir>
#include <QTest>

#include "tests/app/library/plates.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_library_scene {

using namespace tactum;
using namespace tactum::test;

namespace {

const std::filesystem::path kScenes = TACTUM_SCENES;

} // namespace

class TestLibraryScene : public QObject {
    Q_OBJECT

private slots:
    void opensAFile();
    void aFileThatIsNoneIsAnError();
    void placesWhatSaysNoUnit();
    void feelsAsTheBundleSays_data();
    void feelsAsTheBundleSays();
    void aBundleOfAnotherHandIsRefused();
    void aMeshOfArraysPushesAsItsStiffnessSays();
    void refusesArraysThatAreNoMesh();
    void everyParameterCanBeSet();
    void refusesValuesOutOfRange();
    void choicesGoByWords();
    void dynamicFrictionFollows();
    void layersChangeWhatIsFelt();
    void refusesLayersThatCannotBe();
    void presetsAreKnownByName();
    void aCopyIsASceneOfItsOwn();
    void handlesOfWhatIsGoneAreErrors();
    void movesWhatItIsToldTo();
    void savesAndOpensBitForBit();
    void refusesPathsThatAreNone();
};

void TestLibraryScene::opensAFile() {
    const lib::Scene scene = lib::Scene::open(kScenes / "teapot.glb");
    QVERIFY(!scene.objects().empty());
    QVERIFY(!scene.path().empty());
    const lib::Object first = scene.objects().front();
    QCOMPARE(first.id(), 1U);
    QCOMPARE_GT(first.triangles().size(), std::size_t(1000));
    for (const lib::Triangle& triangle : first.triangles())
        QVERIFY(std::ranges::max(triangle) < first.vertices().size());
    QCOMPARE(scene.object(first.name()).id(), first.id());
    QCOMPARE(std::string(lib::version()), std::string(TACTUM_VERSION));
}

void TestLibraryScene::aFileThatIsNoneIsAnError() {
    COMPARE_CONTAINS(sentenceOf([] { lib::Scene::open("/nowhere/teapot.glb"); }), "/nowhere/teapot.glb");
    try {
        lib::Scene::open("/nowhere/teapot.glb");
        QFAIL("was opened");
    } catch (const std::runtime_error&) { // as which programs may catch it
    }
    COMPARE_CONTAINS(sentenceOf([] { lib::openBundle(kScenes / "teapot.glb"); }), "teapot.glb");
}

void TestLibraryScene::placesWhatSaysNoUnit() {
    const auto highest = [](const lib::Scene& scene) {
        double most = -std::numeric_limits<double>::infinity();
        for (const lib::Object& object : scene.objects())
            for (const lib::Vec3& vertex : object.vertices())
                most = std::max(most, object.pose().position.y + vertex.y);
        return most;
    };
    const double plain = highest(lib::Scene::open(kScenes / "teapot.obj"));
    COMPARE_NEAR(highest(lib::Scene::open(kScenes / "teapot.obj", {.unit = 0.5})), plain / 2, 1e-12, "m");
    QCOMPARE(sentenceOf([] { lib::Scene::open(kScenes / "teapot.obj", {.unit = 0}); }),
             "unit: is not from 1e-6 to 1e6 m");
    QCOMPARE(sentenceOf([] { lib::Scene::open(kScenes / "teapot.obj", {.fit = -1}); }),
             "fit: is not from 1e-6 to 1e6 m");
}

void TestLibraryScene::feelsAsTheBundleSays_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"teapot", "friction-ladder", "texture-wall", "moving/windmill"})
        QTest::newRow(sample) << QString(sample);
}

void TestLibraryScene::feelsAsTheBundleSays() {
    QFETCH(QString, sample);
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("sample.tactum").toStdString();
    lib::Scene::open(kScenes / (sample.toStdString() + ".glb")).convert(file);
    const lib::Bundle bundle = lib::openBundle(file);
    const auto touch = bundle.scene.touch(bundle.finger);
    QCOMPARE(touch.size(), bundle.forces.size());
    double most = 0;
    for (std::size_t i = 0; i < touch.size(); ++i) {
        COMPARE_NEAR(eigen(touch[i].force), eigen(bundle.forces[i]), 1e-12, "N");
        most = std::max(most, eigen(touch[i].force).norm());
    }
    QCOMPARE_GT(most, 0.01);
    QVERIFY(bundle.scene.touch() == touch); // its path is the scene's own
}

void TestLibraryScene::aBundleOfAnotherHandIsRefused() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("plate.tactum");
    lib::Scene scene = plate();
    scene.setPath(press());
    scene.convert(file.toStdString());
    QFile changed(file);
    QVERIFY(changed.open(QFile::ReadWrite));
    QVERIFY(changed.seek(2000));
    QVERIFY(changed.putChar('x'));
    changed.close();
    COMPARE_CONTAINS(sentenceOf([&] { lib::openBundle(file.toStdString()); }), "plate.tactum");
}

void TestLibraryScene::aMeshOfArraysPushesAsItsStiffnessSays() {
    lib::Scene scene = plate(700);
    scene.set("proxy-radius", 0.002);
    QCOMPARE(scene.get("proxy-radius"), 0.002);
    const auto rows = scene.touch(press(0.003));
    QCOMPARE(rows.back().contacts, 1U);
    COMPARE_NEAR(rows.back().force.y, 700 * (0.003 + 0.002), 1e-9, "N");
    QCOMPARE(rows.front().force, lib::Vec3());
}

void TestLibraryScene::refusesArraysThatAreNoMesh() {
    lib::Scene scene;
    const std::vector<lib::Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const std::vector<lib::Triangle> whole{{0, 1, 2}}, beyond{{0, 1, 3}};
    const std::vector<std::uint32_t> two{0, 1}, many{10000};
    QCOMPARE(sentenceOf([&] { scene.addMesh({}, whole); }), "mesh: has no vertices or no triangles");
    QCOMPARE(sentenceOf([&] { scene.addMesh(corners, {}); }), "mesh: has no vertices or no triangles");
    QCOMPARE(sentenceOf([&] { scene.addMesh(corners, beyond); }),
             "triangles: 0 names vertex 3, and there are 3");
    QCOMPARE(sentenceOf([&] { scene.addMesh(corners, whole, two); }),
             "surfaces: has 2 numbers, and there are 1 triangle");
    QCOMPARE(sentenceOf([&] { scene.addMesh(corners, whole, many); }),
             "surfaces: names 10000, and there are 10000 at most");
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e7}) {
        auto wrong = corners;
        wrong[1].y = bad;
        QCOMPARE(sentenceOf([&] { scene.addMesh(wrong, whole); }),
                 "vertices: 1 is farther than 1e6 m from the origin, or not finite");
    }
    QVERIFY(scene.objects().empty());
}

void TestLibraryScene::everyParameterCanBeSet() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    lib::Layer layer = surface.addLayer("noise");
    int count = 0;
    for (const lib::Parameter& one : lib::parameters()) {
        const double value = one.minimum + 0.25 * (one.maximum - one.minimum);
        QVERIFY(!one.label.empty() && !one.sentence.empty());
        ++count;
        if (one.of == "surface") {
            surface.set(one.key, value);
            QCOMPARE(surface.get(one.key), value);
        } else if (one.of == "layer") {
            layer.set(one.key, value);
            QCOMPARE(layer.get(one.key), value);
        } else {
            scene.set(one.key, value);
            QCOMPARE(scene.get(one.key), value);
        }
    }
    QCOMPARE(count, 6 + 11 + 4);
}

void TestLibraryScene::refusesValuesOutOfRange() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    QCOMPARE(sentenceOf([&] { surface.set("static-friction", 3); }), "static-friction: 3 is not from 0 to 2");
    QCOMPARE(sentenceOf([&] { scene.set("stiffness", std::numeric_limits<double>::quiet_NaN()); }),
             "stiffness: nan is not from 1 to 10000 N/m");
    COMPARE_BEGINS(sentenceOf([&] { surface.set("bounce", 1); }),
                   "\"bounce\" cannot be set here; there are stiffness, damping");
    COMPARE_BEGINS(sentenceOf([&] { scene.set("bounce", 1); }), "\"bounce\" cannot be set here");
    QCOMPARE(surface.get("stiffness"), 500.0);
}

void TestLibraryScene::choicesGoByWords() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    QCOMPARE(surface.word("sides"), "both");
    surface.set("sides", "back");
    QCOMPARE(surface.word("sides"), "back");
    QCOMPARE(scene.touch(press()).back().contacts, 0U);
    QCOMPARE(sentenceOf([&] { surface.set("sides", "left"); }),
             "sides: \"left\" is none of both, front, back, none");
    surface.setShading(true);
    surface.setVisible(false);
    QVERIFY(surface.shading() && !surface.visible());
}

void TestLibraryScene::dynamicFrictionFollows() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    surface.set("dynamic-friction", 0.5);
    QCOMPARE(surface.get("static-friction"), 0.5);
    surface.set("static-friction", 0.2);
    QCOMPARE(surface.get("dynamic-friction"), 0.2);
}

void TestLibraryScene::layersChangeWhatIsFelt() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    const auto smooth = scene.touch(press());
    lib::Layer grooves = surface.addLayer("grooves");
    grooves.set("strength", 1e-4);
    grooves.set("size", 2e-3);
    QVERIFY(scene.touch(press()) != smooth);
    grooves.setEnabled(false);
    QVERIFY(scene.touch(press()) == smooth);

    const std::vector<double> half{0, 1, 0, 1};
    lib::Layer image = surface.addLayer({2, 2, half});
    image.set("target", "stiffness");
    image.set("strength", 1);
    image.set("size", 0.01);
    QVERIFY(scene.touch(press()) != smooth);
    QCOMPARE(surface.layers().size(), std::size_t(2));
    surface.clearLayers();
    QVERIFY(scene.touch(press()) == smooth);
    QCOMPARE(sentenceOf([&] { image.get("size"); }), "layer 1 is not on its surface any more");
}

void TestLibraryScene::refusesLayersThatCannotBe() {
    lib::Scene scene = plate();
    lib::Surface surface = scene.object("plate").surface("plate");
    COMPARE_BEGINS(sentenceOf([&] { surface.addLayer("wool"); }), "source: \"wool\" is none of image, noise");
    COMPARE_BEGINS(sentenceOf([&] { surface.addLayer("painted"); }), "source: what is painted");
    QCOMPARE(sentenceOf([&] { surface.addLayer("image"); }), "source: give the picture itself");
    COMPARE_BEGINS(sentenceOf([&] { surface.addLayer(lib::Image{}); }), "image: its sides are from 1 to");
    COMPARE_BEGINS(sentenceOf([&] {
                       surface.addLayer(lib::Image{std::size_t(1) << 40, std::size_t(1) << 40, {}});
                   }),
                   "image: its sides are from 1 to");
    const std::vector<double> bad{0, std::numeric_limits<double>::infinity()};
    QCOMPARE(sentenceOf([&] {
                 surface.addLayer({1, 1, bad});
             }),
             "image: has 2 values, and width times height is 1");
    QCOMPARE(sentenceOf([&] { surface.addLayer({2, 1, bad}); }), "image: has a value that is not finite");
    for (int i = 0; i < 16; ++i)
        surface.addLayer("dots");
    QCOMPARE(sentenceOf([&] { surface.addLayer("dots"); }), "a surface has at most 16 layers");
}

void TestLibraryScene::presetsAreKnownByName() {
    QCOMPARE_GT(lib::presets().size(), std::size_t(20));
    lib::Scene scene = plate();
    for (const std::string& name : lib::presets())
        scene.apply(lib::Preset(name));
    scene.apply(lib::Preset("ice-on-ice"));
    QCOMPARE(lib::Preset("ice-on-ice").name(), "Ice on ice");
    QVERIFY(scene.object("plate").surface("plate").get("static-friction") > 0);
    QCOMPARE(sentenceOf([] { lib::Preset("fog"); }),
             "there is no preset \"fog\"; presets() lists those that there are");
}

void TestLibraryScene::aCopyIsASceneOfItsOwn() {
    lib::Scene scene = plate(500);
    lib::Scene other = scene;
    other.set("stiffness", 900);
    QCOMPARE(scene.object("plate").surface("plate").get("stiffness"), 500.0);
    scene = std::move(other);
    QCOMPARE(scene.object("plate").surface("plate").get("stiffness"), 900.0);
    // What was moved from can be used again, and says so until then.
    COMPARE_BEGINS(sentenceOf([&] { other.objects(); }), "this scene was moved elsewhere");
    COMPARE_BEGINS(sentenceOf([&] { lib::World world(other); }), "this scene was moved elsewhere");
    other = plate();
    QCOMPARE(other.objects().size(), std::size_t(1));
}

void TestLibraryScene::handlesOfWhatIsGoneAreErrors() {
    lib::Scene scene = plate();
    lib::Object object = scene.object("plate");
    lib::Surface surface = object.surface("plate");
    QCOMPARE(sentenceOf([&] { plate().remove(object); }), "the object is of another scene");
    scene.remove(object);
    QCOMPARE(sentenceOf([&] { object.name(); }), "object 1 is not in the scene any more");
    QCOMPARE(sentenceOf([&] { surface.set("stiffness", 1); }), "object 1 is not in the scene any more");
    QCOMPARE(sentenceOf([&] { scene.remove(object); }), "object 1 is not in the scene any more");
    QCOMPARE(sentenceOf([&] { scene.object("plate"); }), "the scene has no object \"plate\"");
    lib::Surface elsewhere = std::move(surface); // both name the same
    QCOMPARE(sentenceOf([&] { surface.name(); }), sentenceOf([&] { elsewhere.name(); }));
    scene = lib::Scene(); // the handles keep the scene that they are of
    QCOMPARE(sentenceOf([&] { object.name(); }), "object 1 is not in the scene any more");
}

void TestLibraryScene::movesWhatItIsToldTo() {
    lib::Scene scene = plate();
    lib::Object object = scene.object("plate");
    object.setPose({{0, -0.001, 0}, {2, 0, 0, 0}});
    QCOMPARE(object.pose(), (lib::Pose{{0, -0.001, 0}, {1, 0, 0, 0}}));
    COMPARE_NEAR(scene.touch(press(0.002)).back().force.y, 500 * (0.001 + 0.001), 1e-9, "N");
    QCOMPARE(sentenceOf([&] {
                 object.setPose({{0, 0, 0}, {0, 0, 0, 0}});
             }),
             "rotation: has no length that says a turn");
    QCOMPARE(sentenceOf([&] {
                 object.setPose({{0, 1e7, 0}, {}});
             }),
             "position: is farther than 1e6 m from the origin, or not finite");
}

void TestLibraryScene::savesAndOpensBitForBit() {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("plate.glb").toStdString();
    lib::Scene scene = plate(321);
    scene.setPath(press());
    scene.save(file);
    QVERIFY(lib::Scene::open(file).touch() == scene.touch());
    QVERIFY(lib::Scene::open(file).path() == press());
    COMPARE_CONTAINS(sentenceOf([&] { scene.save("plate.obj"); }), "a scene is saved as .glb");
    COMPARE_CONTAINS(sentenceOf([&] { scene.convert("plate.docx"); }), "docx");
}

void TestLibraryScene::refusesPathsThatAreNone() {
    lib::Scene scene = plate();
    QCOMPARE(sentenceOf([&] { scene.touch(); }), "path: the scene has none of its own; give one");
    auto path = press();
    std::swap(path[3], path[4]);
    COMPARE_BEGINS(sentenceOf([&] { scene.touch(path); }), "path: its times have to rise");
    path = press();
    path[7].position.z = std::numeric_limits<double>::infinity();
    COMPARE_BEGINS(sentenceOf([&] { scene.setPath(path); }), "path: its times have to rise");
    QVERIFY(scene.path().empty());
}

TACTUM_TEST(TestLibraryScene)

} // namespace test_library_scene

#include "test_library_scene.moc"
