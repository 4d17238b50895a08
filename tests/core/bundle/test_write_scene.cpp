// A scene in every format that is written, read again by the reader of that format. Wrong itself if reader
// and writer were wrong alike: other programs read them in test_other_programs.
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/bundle/write_scene.h"
#include "core/files/load_scene.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_write_scene {

using namespace tactum;
using namespace tactum::test;

namespace fs = std::filesystem;

namespace {

/// A box of 20 x 30 x 40 mm, which feels like something.
Scene boxScene() {
    Scene scene;
    SceneObject object;
    object.name = "box";
    object.geometry = std::make_shared<const TriangleSoup>(box(Vec3(0.02, 0.03, 0.04)));
    object.surfaces.resize(1);
    object.surfaces[0].name = "side";
    object.surfaces[0].material.stiffness = 321;
    object.surfaces[0].colour = {1, 0, 0};
    scene.add(object);
    return scene;
}

std::string namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(folder))
        names.push_back(each.path().filename());
    std::ranges::sort(names);
    std::string all;
    for (const std::string& name : names)
        all += (all.empty() ? "" : " ") + name;
    return all;
}

} // namespace

class TestWriteScene : public QObject {
    Q_OBJECT
private slots:
    void everyFormatIsReadAgain_data() {
        QTest::addColumn<std::string>("ending");
        QTest::addColumn<std::string>("files");
        QTest::addColumn<bool>("felt"); // whether the feel comes back
        const auto row = [](const char* ending, const char* files, bool felt) {
            QTest::newRow(ending) << std::string(ending) << std::string(files) << felt;
        };
        row("glb", "s.glb", true);
        row("gltf", "s.bin s.gltf", true);
        row("tactum", "s.tactum", true);
        row("zip", "s.zip", true);
        row("x3d", "s-deviceinfo.x3d s.x3d", true);
        row("obj", "s.mtl s.obj", false);
        row("ply", "s.ply", false);
        row("stl", "s.stl", false);
        row("off", "s.off", false);
        row("STL", "s.STL", false); // capitals do not matter
    }

    void everyFormatIsReadAgain() {
        QFETCH(std::string, ending);
        QFETCH(std::string, files);
        QFETCH(bool, felt);
        const QTemporaryDir folder;
        const fs::path out = fs::path(folder.path().toStdString()) / ("s." + ending);
        const Scene scene = boxScene();
        const auto written = writeScene(scene, {out, {}, {}});
        QCOMPARE(written ? "" : written.error().text, "");
        QCOMPARE(namesIn(folder.path().toStdString()), files);
        const auto back = loadScene(out);
        QCOMPARE(back ? "" : back.error().text, "");
        const Bounds now = boundsOf(back->scene), was = boundsOf(scene);
        COMPARE_NEAR(Vec3(now.high - now.low), Vec3(was.high - was.low), 1e-8, "m");
        QCOMPARE(triangleCount(back->scene), triangleCount(scene));
        if (felt) QCOMPARE(back->scene.objects[0].surfaces[0].material.stiffness, 321.0);
        QCOMPARE(written->losses.empty(), false); // each thing that the scene has is told
        QCOMPARE(formatOf(out)->alone, files.find(' ') == std::string::npos);
    }

    void otherEndingsAreRefused() {
        const QTemporaryDir folder;
        for (const char* name : {"scene.blend", "scene", "scene.glbx", ".glb"}) {
            const fs::path out = fs::path(folder.path().toStdString()) / name;
            const std::string fault = out.string() + ": cannot be written by its ending; writable are glb, "
                                                     "gltf, tactum, zip, x3d, obj, ply, stl, off";
            QCOMPARE(writeScene(boxScene(), {out, {}, {}}).error().text, fault);
            QCOMPARE(formatOf(out).error().text, fault);
            QCOMPARE(formatOf(out).error().kind, Error::Kind::Usage);
        }
        QCOMPARE(namesIn(folder.path().toStdString()), "");
        QCOMPARE(writableEndings(), "glb, gltf, tactum, zip, x3d, obj, ply, stl, off");
        QCOMPARE(writableEndings(true), "glb, tactum, zip, ply, stl, off");
    }

    void aFolderIsThereBeforeTheWorkBegins() {
        const QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        QVERIFY(checkFolder(root / "a.glb").has_value());
        QVERIFY(checkFolder("a.glb").has_value()); // of this folder
        const std::string fault = (root / "none/a.glb").string() +
                                  ": cannot be written: there is no folder " + (root / "none").string() +
                                  "; make it, or check the path";
        QCOMPARE(checkFolder(root / "none/a.glb").error().text, fault);
        QCOMPARE(writeScene(boxScene(), {root / "none/a.glb", {}, {}}).error().text, fault);
        QVERIFY(!fs::exists(root / "none"));
    }

    /// The finger path of a bundle is held against the scene.
    void aBundleSaysWhetherItsFingerTouches() {
        const QTemporaryDir folder;
        const fs::path out = fs::path(folder.path().toStdString()) / "s.tactum";
        Scene scene = boxScene();
        const auto downTo = [&](double height) { // from 5 mm above the top
            std::vector<FingerPoint> points;
            for (int i = 0; i <= 100; ++i)
                points.push_back({0.01 * i, {0, 0.02 + (height - 0.02) * 0.01 * i, 0}});
            scene.finger = std::make_shared<const std::vector<FingerPoint>>(points);
            return writeScene(scene, {out, {}, {}})->touches;
        };
        QVERIFY(!downTo(0.018)); // the proxy's radius is 1 mm
        QVERIFY(downTo(0.014));
    }
};

TACTUM_TEST(TestWriteScene)

} // namespace test_write_scene

#include "test_write_scene.moc"
