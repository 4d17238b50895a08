// How a model is taken whose file leaves its unit or its axes open, and what is remembered of that. Wrong
// itself if the box here were not so many units long: the units that are guessed are told by it.
#include <cmath>

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "core/scene/placing.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/own_folders.h"
#include "ui/document/taken_as.h"

namespace test_taken_as {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Two corners of a triangle are (0, 0, 0) and (x, y, z) units.
LoadedScene loaded(const Vec3& size, bool unitGuessed, bool upGuessed) {
    LoadedScene scene;
    SceneObject object;
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, size, {size.x(), 0, 0}};
    soup->triangles = {{0, 1, 2}};
    soup->surfaceOf = {0};
    object.geometry = soup;
    object.surfaces.resize(1);
    scene.scene.add(object);
    scene.unitGuessed = unitGuessed, scene.upGuessed = upGuessed;
    return scene;
}

Vec3 sidesOf(const LoadedScene& scene) {
    const Bounds box = boundsOf(scene.scene);
    return box.high - box.low;
}

double farFrom(const LoadedScene& scene, const Vec3& sides) {
    return (sidesOf(scene) - sides).norm();
}

} // namespace

class TestTakenAs : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void init() {
        useFoldersIn(folder_.path());
        QSettings().clear();
    }

    void whatIsSaidIsNotOpen() {
        LoadedScene scene = loaded({100, 50, 25}, false, false);
        const Scene before = scene.scene;
        QVERIFY(!takeAs(scene, {0.001, true}));
        QVERIFY(scene.scene == before);
    }

    /// 100 units are no metres for a hand, but millimetres.
    void unitsAreGuessed() {
        LoadedScene scene = loaded({100, 50, 25}, true, false);
        const auto taken = takeAs(scene, {{}, true}); // up is not open
        QVERIFY(taken && taken->unitOpen && !taken->upOpen);
        QCOMPARE(taken->by, TakenAs::By::Guess);
        QCOMPARE(taken->axes, (FileAxes{0.001, false}));
        QCOMPARE(taken->guess, (FileAxes{0.001, false}));
        COMPARE_NEAR(farFrom(scene, {0.1, 0.05, 0.025}), 0, 1e-15, "m");
        COMPARE_NEAR(taken->across, 0.1 * std::sqrt(1 + 0.25 + 0.0625), 1e-15, "m");
    }

    void unitsAreChosen() {
        LoadedScene scene = loaded({100, 50, 25}, true, false);
        const auto taken = takeAs(scene, {0.0254, {}});
        QCOMPARE(taken->by, TakenAs::By::Choice);
        QCOMPARE(taken->axes.unit, 0.0254);
        QCOMPARE(taken->guess.unit, 0.001);
        COMPARE_NEAR(farFrom(scene, {2.54, 1.27, 0.635}), 0, 1e-12, "m");
        scene = loaded({100, 50, 25}, true, false);
        QCOMPARE(takeAs(scene, {0.001, {}})->by, TakenAs::By::Guess); // which it is anyway
    }

    void axesAreChosen() {
        LoadedScene scene = loaded({0.1, 0.05, 0.025}, false, true);
        auto taken = takeAs(scene, {0.01, {}}); // the unit is not open
        QVERIFY(taken && !taken->unitOpen && taken->upOpen);
        QCOMPARE(taken->axes, (FileAxes{1, false}));
        COMPARE_NEAR(farFrom(scene, {0.1, 0.05, 0.025}), 0, 1e-15, "m");
        scene = loaded({0.1, 0.05, 0.025}, false, true);
        taken = takeAs(scene, {{}, true});
        QCOMPARE(taken->by, TakenAs::By::Choice);
        QVERIFY(taken->axes.zUp && !taken->guess.zUp);
        COMPARE_NEAR(farFrom(scene, {0.1, 0.025, 0.05}), 0, 1e-15, "m"); // z is y now
    }

    void theGuessOfAMetreIsNoLongerSaid() {
        LoadedScene scene = loaded({100, 50, 25}, true, false);
        scene.findings = {{Finding::Severity::Note, "", "a face was left out", ""}};
        takeAs(scene, {});
        QCOMPARE(scene.findings.size(), 1u);
    }

    /// The unit in which an export is about as large as the last one was.
    void unitsBySize() {
        const auto unit = [](double units, double before, double metres) {
            return unitBySize(units, before, metres).value_or(0);
        };
        QCOMPARE(unit(100, 1, 0.1), 0.001); // metres before, millimetres now
        QCOMPARE(unit(0.1, 0.001, 0.1), 1.0);
        QCOMPARE(unit(10, 1, 0.1), 0.01);
        QCOMPARE(unit(4, 0.001, 0.1), 0.0254); // 0.1016 m, and 4 mm are 25 times less
        QCOMPARE(unit(100, 0.001, 0.1), 0.0);  // it is right
        QCOMPARE(unit(1900, 0.001, 0.1), 0.0); // 19 times as large: somebody made it so
        QCOMPARE(unit(2100, 0.001, 0.1), 0.0); // 21 times; no unit is within 3
        QCOMPARE(unit(5.1, 0.001, 0.1), 0.0);  // hardly 20 times smaller
        QCOMPARE(unit(4.9, 0.001, 0.1), 0.0254);
        QCOMPARE(unit(299, 1, 0.1), 0.001); // 2.99 times as large by millimetres
        QCOMPARE(unit(301, 1, 0.1), 0.0);
        QCOMPARE(unit(0, 1, 0.1), 0.0);
        QCOMPARE(unit(1, 1, 0), 0.0);
        QCOMPARE(unit(-1, 1, 1), 0.0);
    }

    void choicesAreRememberedByFormat() {
        const std::filesystem::path stl = "/somewhere/Part.STL", other = "other.stl", obj = "part.obj";
        QCOMPARE(rememberedAxes(stl), AxesChoice{});
        rememberUnit(stl, 0.0254, 0.001);
        rememberUp(stl, true, false);
        QCOMPARE(rememberedAxes(other), (AxesChoice{0.0254, true}));
        QCOMPARE(rememberedAxes(obj), AxesChoice{});
        rememberUp(other, false, true);
        QCOMPARE(rememberedAxes(stl), (AxesChoice{0.0254, false}));
        rememberUnit(other, 0.001, 0.001); // what is guessed anyway
        QCOMPARE(rememberedAxes(stl), (AxesChoice{{}, false}));
        rememberUp(stl, true, true);
        QCOMPARE(rememberedAxes(stl), AxesChoice{});
        rememberUnit(stl, 0.3048, 0.001); // no unit that is offered
        QCOMPARE(rememberedAxes(stl), AxesChoice{});
        QSettings().setValue(QStringLiteral("import/stl/up"), QStringLiteral("x"));
        QSettings().setValue(QStringLiteral("import/stl/unit"), QStringLiteral("ell"));
        QCOMPARE(rememberedAxes(stl), AxesChoice{});
    }
};

TACTUM_TEST(TestTakenAs)

} // namespace test_taken_as

#include "test_taken_as.moc"
