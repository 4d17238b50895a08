// Measuring as a person does: by key, clicks on the model, the row over the view, Esc.
#include <algorithm>
#include <cmath>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QTest>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/tool_strip.h"

namespace test_measuring {

using namespace tactum;

class TestMeasuring : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static ToolStrip& strip(TouchedWindow& program) {
        return *program.window->findChild<ToolStrip*>(QStringLiteral("measure-strip"));
    }
    /// At a place of the model, some pixels beside it.
    static void click(TouchedWindow& program, const Vec3& p_W, QPoint off = {}) {
        const auto seen = program.window->view().camera().project(p_W);
        if (!seen) qFatal("it is behind the eye");
        const QPoint at = seen->toPoint() + off;
        program.moveTo(at);
        program.press(at);
        program.release(at);
    }
    static std::vector<Vec3> measured(TouchedWindow& program) { return program.window->view().measured(); }
    void begin(TouchedWindow& program) {
        if (!program.open(writeCube(folder_))) qFatal("it was not opened");
        SceneView& view = program.window->view();
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_D);
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void twoClicksAreTheDistance();
    void aThirdGivesTheAngleAndAFourthBeginsAnew();
    void escapeTakesItAwayAndLeavesTheTool();
    void aDragTurnsTheCamera();
    void aBodyTakesItsPointsAlong();
    void copyPutsTheNumbersOnTheClipboard();
    void itGoesWithWhatItIsOf();
    void rowsOfToolsDoNotHideTheNumber();
};

// The upper edge of the cube just below the row.
void TestMeasuring::rowsOfToolsDoNotHideTheNumber() {
    TouchedWindow program;
    begin(program);
    SceneView& view = program.window->view();
    view.showStandardView(StandardView::Front);
    program.frames(5);
    QVERIFY(strip(program).isVisible());
    const int foot = view.mapFrom(program.window.get(), program.placeOf(strip(program)).bottomLeft()).y();
    const Vec3 left(-0.05, 0.05, 0.05), right(0.05, 0.05, 0.05);
    while (view.camera().project(left)->y() > foot + 12)
        view.moveCamera(0, 0, 0.99);
    click(program, left, {2, 2});
    click(program, right, {-2, 2});
    QCOMPARE(measured(program).size(), std::size_t(2));
    const auto isSeen = [&] {
        const auto boxes = view.measuredBoxes();
        const QRectF& box = boxes.at(0);
        return std::ranges::all_of(
            std::vector{box.topLeft(), box.topRight(), box.center(), box.bottomLeft()}, [&](QPointF corner) {
                return program.window->childAt(view.mapTo(program.window.get(), corner.toPoint())) == &view;
            });
    };
    QVERIFY2(isSeen(), "the row hides the number");
    program.window->showFault(QStringLiteral("The disk is full; make room and save again."));
    QTRY_VERIFY2_WITH_TIMEOUT(isSeen(), "the notice hides the number", kPatience);
}

// The cube's face toward +z: its corners are 0.1 m apart.
void TestMeasuring::twoClicksAreTheDistance() {
    TouchedWindow program;
    begin(program);
    const Scene before = program.document.scene();
    const Vec3 finger = program.finger();
    QVERIFY(program.command("measure").isChecked() && !program.command("touch").isChecked());
    QVERIFY(strip(program).isVisible());
    QVERIFY(!program.command("measure-copy").isEnabled());
    program.window->view().showStandardView(StandardView::Isometric);
    click(program, {-0.05, -0.05, 0.05}, {3, -2});
    QCOMPARE(measured(program).size(), std::size_t(1));
    click(program, {0.05, 0.05, 0.05}, {-2, 3});
    const auto points = measured(program);
    QCOMPARE(points.size(), std::size_t(2));
    COMPARE_NEAR(points[0], Vec3(-0.05, -0.05, 0.05), 1e-9, "m");
    COMPARE_NEAR((points[1] - points[0]).norm(), 0.1 * std::sqrt(2), 1e-9, "m");
    COMPARE_NEAR(points[1] - points[0], Vec3(0.1, 0.1, 0), 1e-9, "m");
    QVERIFY(program.command("measure-copy").isEnabled());
    QVERIFY(program.document.scene() == before);
    QVERIFY(!program.document.history().canUndo());
    COMPARE_NEAR(program.finger(), finger, 1e-6, "m"); // nothing was touched
}

void TestMeasuring::aThirdGivesTheAngleAndAFourthBeginsAnew() {
    TouchedWindow program;
    begin(program);
    program.window->view().showStandardView(StandardView::Isometric);
    click(program, {-0.05, 0.05, 0.05});
    click(program, {0.05, 0.05, 0.05});
    click(program, {0.05, 0.05, -0.05});
    const auto numbers = numbersOf(measured(program));
    QVERIFY(numbers && numbers->angle);
    COMPARE_NEAR(*numbers->angle, EIGEN_PI / 2, 1e-9, "rad");
    click(program, {-0.05, -0.05, 0.05});
    QCOMPARE(measured(program).size(), std::size_t(1));
    COMPARE_NEAR(measured(program)[0], Vec3(-0.05, -0.05, 0.05), 1e-9, "m");
}

void TestMeasuring::escapeTakesItAwayAndLeavesTheTool() {
    TouchedWindow program;
    if (!program.open(writeCube(folder_))) return;
    program.command("select").trigger();
    program.command("measure").trigger();
    SceneView& view = program.window->view();
    view.setFocus();
    click(program, {0, 0, 0.05});
    QCOMPARE(measured(program).size(), std::size_t(1));
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(measured(program).empty());
    QVERIFY(program.command("measure").isChecked());
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(program.command("select").isChecked());
    QVERIFY(!strip(program).isVisible());
}

void TestMeasuring::aDragTurnsTheCamera() {
    TouchedWindow program;
    begin(program);
    const double yaw = program.window->view().camera().yaw;
    program.press(program.centre());
    program.moveTo(program.centre() + QPoint(30, 0));
    program.moveTo(program.centre() + QPoint(60, 0));
    program.release(program.centre() + QPoint(60, 0));
    QCOMPARE_GT(std::abs(program.window->view().camera().yaw - yaw), 0.05);
    QVERIFY(measured(program).empty());
}

void TestMeasuring::aBodyTakesItsPointsAlong() {
    TouchedWindow program;
    begin(program);
    program.window->view().showStandardView(StandardView::Isometric);
    click(program, {-0.05, -0.05, 0.05});
    click(program, {0.05, 0.05, 0.05});
    const auto before = measured(program);
    program.document.editScene(QStringLiteral("Move"), SceneChange::What::Objects,
                               [](Scene& scene) { scene.objects[0].pose.translation.x() += 0.02; });
    const auto after = measured(program);
    QCOMPARE(after.size(), std::size_t(2));
    COMPARE_NEAR(after[0] - before[0], Vec3(0.02, 0, 0), 1e-9, "m");
    program.command("touch").trigger(); // it stays, to be looked at while something moves
    QCOMPARE(measured(program).size(), std::size_t(2));
    QVERIFY(strip(program).isVisible());
    program.command("measure-clear").trigger();
    QVERIFY(measured(program).empty());
    QVERIFY(!strip(program).isVisible());
}

void TestMeasuring::copyPutsTheNumbersOnTheClipboard() {
    TouchedWindow program;
    begin(program);
    program.window->view().showStandardView(StandardView::Isometric);
    click(program, {-0.05, 0.05, 0.05});
    click(program, {0.05, 0.05, 0.05});
    program.command("measure-copy").trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Distance 100.00 mm\ndx 100.00 mm\ndy 0.00 mm\ndz 0.00 mm"));
}

void TestMeasuring::itGoesWithWhatItIsOf() {
    TouchedWindow program;
    begin(program);
    click(program, {0, 0, 0.05});
    QCOMPARE(measured(program).size(), std::size_t(1));
    program.document.setVisible(program.document.scene().objects[0].id, false);
    QVERIFY(measured(program).empty());
    QVERIFY(!program.command("measure-clear").isEnabled());
}

TACTUM_GUI_TEST(TestMeasuring)

} // namespace test_measuring

#include "test_measuring.moc"
