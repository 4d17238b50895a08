// What is taken for the unit of a file that does not say it, and a scene by other axes.
#include <QTest>

#include "core/scene/placing.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_placing {

using namespace tactum;
using namespace tactum::test;

namespace {

/// So many metres across, its longest side along z.
Scene plateOf(double across) {
    Scene scene;
    SceneObject object;
    object.geometry =
        SoupBuilder()
            .quad({0, 0, 0}, {0.6 * across, 0, 0}, {0.6 * across, 0, 0.8 * across}, {0, 0, 0.8 * across})
            .build();
    object.surfaces.resize(1);
    scene.add(std::move(object));
    return scene;
}

} // namespace

class TestPlacing : public QObject {
    Q_OBJECT

private slots:
    void millimetresAreGuessedWhereTheyFitAHandAlone_data() {
        QTest::addColumn<double>("across");
        QTest::addColumn<double>("unit");
        const auto row = [](double across, double unit) { QTest::addRow("%g", across) << across << unit; };
        row(0.001, 1);
        row(0.019, 1);
        row(0.021, 1);
        row(0.49, 1);
        row(0.51, 1);
        row(19, 1);
        row(21, 1e-3);
        row(120, 1e-3);
        row(490, 1e-3);
        row(510, 1);
    }

    void millimetresAreGuessedWhereTheyFitAHandAlone() {
        QFETCH(double, across);
        QFETCH(double, unit);
        const FileAxes guess = guessAxes(plateOf(across));
        QCOMPARE_EQ(guess.unit, unit);
        QVERIFY(!guess.zUp);
    }

    /// What was exported once more in another unit, or lying on its side.
    void takenAsTheModelOfBefore() {
        const auto boxOf = [](const Vec3& sides) {
            Scene scene;
            SceneObject object;
            object.geometry =
                SoupBuilder().quad(Vec3::Zero(), {sides.x(), 0, 0}, sides, {0, sides.y(), sides.z()}).build();
            object.surfaces.resize(1);
            scene.add(std::move(object));
            return scene;
        };
        const Scene before = boxOf({0.06, 0.02, 0.14});
        QVERIFY(axesLike(boxOf({0.06, 0.02, 0.14}), before) == (FileAxes{1, false}));
        QVERIFY(axesLike(boxOf({60, 20, 140}), before) == (FileAxes{1e-3, false}));
        QVERIFY(axesLike(boxOf({6, 14, 2}), before) == (FileAxes{1e-2, true}));
        QVERIFY(axesLike(boxOf({66, 21, 150}), before) ==
                (FileAxes{1e-3, false})); // a little larger than it was
        QVERIFY(axesLike(boxOf({2.36, 5.5, 0.79}), before) == (FileAxes{0.0254, true}));
        QVERIFY(axesLike(boxOf({60, 140, 20}), before, 1) == (FileAxes{1, true})); // the person says metres
        QVERIFY(axesLike(boxOf({60, 140, 20}), before, {}, false) == (FileAxes{1e-3, false}));
        QVERIFY(axesLike(Scene{}, before).unit > 0);
        QVERIFY(axesLike(before, Scene{}) == (FileAxes{1, false}));
    }

    void unitsByTheirNames() {
        QCOMPARE_EQ(metresOf("m").value_or(0), 1.0);
        QCOMPARE_EQ(metresOf("cm").value_or(0), 0.01);
        QCOMPARE_EQ(metresOf("mm").value_or(0), 0.001);
        QCOMPARE_EQ(metresOf("in").value_or(0), 0.0254);
        QVERIFY(!metresOf("ft"));
        QVERIFY(!metresOf(""));
    }

    void aSceneIsTakenByItsAxes() {
        Scene scene = plateOf(100);
        placeAs(scene, {1e-3, true});
        const Bounds box = boundsOf(scene);
        COMPARE_NEAR(box.low, Vec3(0, 0, 0), 1e-12, "m");
        COMPARE_NEAR(box.high, Vec3(0.06, 0.08, 0), 1e-12, "m"); // what was z is up
        Scene same = plateOf(100);
        const auto geometry = same.objects[0].geometry;
        placeAs(same, {});
        QVERIFY(same.objects[0].geometry == geometry);
    }
};

TACTUM_TEST(TestPlacing)

} // namespace test_placing

#include "test_placing.moc"
