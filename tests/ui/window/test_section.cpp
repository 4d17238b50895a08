// Cutting the model open in the view, as a person does: by key, buttons, number and handle.
#include <cmath>

#include <QAction>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/tool_strip.h"

namespace test_section {

using namespace tactum;

class TestSection : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static ToolStrip& strip(TouchedWindow& program) {
        return *program.window->findChild<ToolStrip*>(QStringLiteral("section-strip"));
    }
    static void click(TouchedWindow& program, const char* button) {
        auto* found = strip(program).findChild<QToolButton*>(QString::fromLatin1(button));
        if (!found) qFatal("no button %s", button);
        QTest::mouseClick(found, Qt::LeftButton);
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aKeyCutsAndMakesWhole();
    void theNumberIsThePlace();
    void thePlaneIsAsLargeAsTheSceneThatComesBack();
    void aKeptPictureIsWithoutHandles();
    void aSectionIsOnlySeen();
    void anotherSceneIsWhole();
    void aTrialIsWhole();
    void escapeGivesUpADrag();
};

void TestSection::escapeGivesUpADrag() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("section").trigger();
    SceneView& view = program.window->view();
    const auto drag = [&](bool givenUp) {
        const QPoint tip = view.sectionHandles().placeOf(SectionHandle::Move, view.camera())->toPoint();
        program.press(tip);
        program.moveTo(tip + QPoint(20, 0));
        program.moveTo(tip + QPoint(40, 0));
        if (givenUp) QTest::keyClick(&view, Qt::Key_Escape);
        program.release(tip + QPoint(40, 0));
    };
    const Vec3 before = view.section()->frame.translation;
    drag(true);
    COMPARE_NEAR((view.section()->frame.translation - before).norm(), 0, 1e-12, "m");
    drag(false);
    QCOMPARE_GT((view.section()->frame.translation - before).norm(), 1e-4);
}

void TestSection::aTrialIsWhole() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("section").trigger();
    QVERIFY(program.window->view().section());
    program.command("trial-spring").trigger();
    QVERIFY(!program.window->view().section());
    QVERIFY(!strip(program).isVisible());
}

void TestSection::aKeyCutsAndMakesWhole() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    QVERIFY(!strip(program).isVisible());
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_X, Qt::ShiftModifier);
    QVERIFY(view.section());
    QVERIFY(strip(program).isVisible());
    COMPARE_NEAR(std::abs(view.section()->normal().x()), 1, 1e-12, "");
    COMPARE_NEAR(view.section()->height(view.bounds().centre()), 0, 1e-12, "m");
    QCOMPARE_LT(view.section()->normal().dot(view.camera().forward()), 0); // the near side is away
    click(program, "section-z-button");
    COMPARE_NEAR(std::abs(view.section()->normal().z()), 1, 1e-12, "");
    QVERIFY(program.command("section-z").isChecked() && !program.command("section-x").isChecked());
    click(program, "section-button");
    QVERIFY(!view.section());
    QVERIFY(!strip(program).isVisible());
}

void TestSection::theNumberIsThePlace() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    program.command("section-y").trigger();
    auto* place = strip(program).findChild<NumberBox*>(QStringLiteral("section-place"));
    const auto type = [&](const char* text) {
        QTest::mouseClick(place, Qt::LeftButton);
        place->selectAll();
        QTest::keyClicks(place, QString::fromLatin1(text));
        QTest::keyClick(place, Qt::Key_Return);
    };
    type("12");
    COMPARE_NEAR(view.section()->frame.translation.y(), 0.012, 1e-12, "m");
    const Vec3 before = view.section()->normal();
    click(program, "section-flip-button"); // the same plane, counted along the same axis
    COMPARE_NEAR(view.section()->normal().dot(before), -1, 1e-12, "");
    COMPARE_NEAR(place->value(), 12, 1e-9, "mm");
    type("-2");
    COMPARE_NEAR(view.section()->frame.translation.y(), -0.002, 1e-12, "m");
    type("-0.1 in"); // in another unit
    COMPARE_NEAR(view.section()->frame.translation.y(), -0.00254, 1e-12, "m");
    type("1900"); // no farther than the scene is large
    QCOMPARE_LT(std::abs(view.section()->height(view.bounds().centre())), 1.001 * view.bounds().diagonal());
}

void TestSection::thePlaneIsAsLargeAsTheSceneThatComesBack() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    program.command("section").trigger();
    const double reach = view.sectionHandles().reach();
    COMPARE_NEAR(reach, 0.36 * view.bounds().diagonal(), 1e-12, "m");
    program.document.select(SurfaceRef{program.document.scene().objects.front().id, 0});
    program.command("remove").trigger();
    QVERIFY(program.document.scene().objects.empty());
    program.command("undo").trigger();
    COMPARE_NEAR(view.sectionHandles().reach(), reach, 1e-12, "m");
}

void TestSection::aKeptPictureIsWithoutHandles() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    program.command("section").trigger();
    const auto at = view.sectionHandles().placeOf(SectionHandle::Move, view.camera());
    QVERIFY(at);
    const QPoint place = (*at * view.devicePixelRatioF()).toPoint();
    QVERIFY(view.grabPicture().pixel(place) != view.grabWithoutHandles().pixel(place));
    QCOMPARE(view.grabPicture().pixel(place), view.grabPicture().pixel(place));
}

void TestSection::aSectionIsOnlySeen() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    const auto world = program.window->publisher().world();
    program.command("section").trigger();
    program.command("section-z").trigger();
    program.frames(3);
    QVERIFY(program.document.scene() == before);
    QVERIFY(program.window->publisher().world() == world);
    QVERIFY(!program.document.history().canUndo());
}

void TestSection::anotherSceneIsWhole() {
    TouchedWindow program;
    program.command("section").trigger(); // nothing is there to be cut
    QVERIFY(!program.window->view().section());
    QVERIFY(!program.command("section").isChecked());
    const QString file = writeCube(folder_);
    QVERIFY(program.open(file));
    program.command("section").trigger();
    QVERIFY(program.window->view().section());
    QVERIFY(program.open(file));
    QVERIFY(!program.window->view().section());
    QVERIFY(!program.command("section").isChecked());
}

TACTUM_GUI_TEST(TestSection)

} // namespace test_section

#include "test_section.moc"
