// What a person prefers: kept, brought into its range, and counting where it should. A mistake in this test
// would show as a row of the table that no field of the dialog has.
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/numbers.h"
#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/document/journal.h"
#include "ui/view/scene_view.h"

namespace test_preferences {

using namespace tactum;

namespace {

void prefer(Preferred id, double value) {
    Preferences::instance().set(id, value);
}

double preferred(Preferred id) {
    return Preferences::instance().value(id);
}

/// A drag in the view with real events; by default far from the model, which is small in the middle.
void drag(TouchedWindow& program, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    QWidget& view = program.window->view();
    QTest::mousePress(&view, button, modifiers, QPoint(40, 40));
    for (int i = 1; i <= 5; ++i) {
        QMouseEvent move(QEvent::MouseMove, QPointF(40 + 10 * i, 40),
                         view.mapToGlobal(QPointF(40 + 10 * i, 40)), Qt::NoButton, button, modifiers);
        QCoreApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, button, modifiers, QPoint(90, 40));
}

} // namespace

class TestPreferences : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        for (const Preference& each : preferenceTable())
            prefer(each.id, each.parameter.initial);
    }

    void everyRowHasAFieldThatSetsIt();
    void aDragTurnsOrMoves();
    void theWheelGoesWhereItShould();
    void lengthsAreShownAndTypedInTheirUnit();
    void theThemeIsOneWithTheMenus();
    void theJournalIsWrittenAfterSoManyEdits();
};

void TestPreferences::everyRowHasAFieldThatSetsIt() {
    TouchedWindow program;
    program.command("preferences").trigger();
    auto* dialog = program.window->findChild<QDialog*>(QStringLiteral("preferences"));
    QVERIFY(dialog);
    COMPARE_SHOWN(test::shownIn(*dialog), "preferences");
    auto* pages = dialog->findChild<QTabWidget*>();
    program.command("preferences").trigger(); // once more brings the same one to the front
    QCOMPARE(program.window->findChildren<QDialog*>(QStringLiteral("preferences")).size(), 1);
    for (const Preference& each : preferenceTable()) {
        auto* field = dialog->findChild<QWidget*>(asIs(each.parameter.key));
        QVERIFY2(field, each.parameter.key.data());
        for (int i = 0; i < pages->count(); ++i)
            if (pages->widget(i)->isAncestorOf(field)) pages->setCurrentIndex(i);
        QSignalSpy changed(&Preferences::instance(), &Preferences::changed);
        field->setFocus();
        const double before = preferred(each.id);
        if (auto* choice = qobject_cast<QComboBox*>(field))
            QTest::keyClick(choice, before > 0 ? Qt::Key_Up : Qt::Key_Down);
        else
            QTest::keyClick(field, Qt::Key_Up);
        QVERIFY2(preferred(each.id) != before, each.parameter.key.data());
        QCOMPARE(changed.size(), 1);
    }
    auto* defaults = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults);
    for (int i = 0; i < pages->count(); ++i) {
        pages->setCurrentIndex(i);
        QTest::mouseClick(defaults, Qt::LeftButton);
    }
    for (const Preference& each : preferenceTable())
        QCOMPARE(preferred(each.id), each.parameter.initial);
}

void TestPreferences::aDragTurnsOrMoves() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto what = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
        const ViewCamera before = program.window->view().camera();
        drag(program, button, modifiers);
        const ViewCamera& now = program.window->view().camera();
        return now.yaw != before.yaw ? "turns" : now.focus != before.focus ? "moves" : "nothing";
    };
    QCOMPARE(what(Qt::MiddleButton), "turns");
    QCOMPARE(what(Qt::MiddleButton, Qt::ShiftModifier), "moves");
    QCOMPARE(what(Qt::RightButton), "nothing");
    prefer(Preferred::DragTurns, 1);
    QCOMPARE(what(Qt::MiddleButton), "moves");
    QCOMPARE(what(Qt::MiddleButton, Qt::ShiftModifier), "turns");
    QSignalSpy menu(&program.window->view(), &SceneView::menuAsked);
    QSignalSpy picked(&program.window->view(), &SceneView::picked);
    prefer(Preferred::DragTurns, 2);
    QCOMPARE(what(Qt::RightButton), "turns");
    QCOMPARE(what(Qt::MiddleButton), "moves");
    QCOMPARE(menu.size(), 0);
    QCOMPARE(picked.size(), 0);
    // How far: in proportion.
    const double yaw = program.window->view().camera().yaw;
    drag(program, Qt::RightButton);
    const double once = program.window->view().camera().yaw - yaw;
    prefer(Preferred::TurnSpeed, 2);
    drag(program, Qt::RightButton);
    COMPARE_NEAR(std::remainder(program.window->view().camera().yaw - yaw - 3 * once, 2 * M_PI), 0, 1e-9,
                 "rad");
}

void TestPreferences::theWheelGoesWhereItShould() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    const auto turned = [&] {
        const double before = view.camera().distance;
        program.wheel(QPoint(60, 60), 1);
        return view.camera().distance / before;
    };
    const Vec3 focus = view.camera().focus;
    COMPARE_NEAR(turned(), 0.87, 1e-9, "");
    QVERIFY2((view.camera().focus - focus).norm() > 1e-4, "toward the cursor the focus moves");
    prefer(Preferred::ZoomTo, 1);
    const Vec3 there = view.camera().focus;
    COMPARE_NEAR(turned(), 0.87, 1e-9, "");
    COMPARE_NEAR(view.camera().focus, there, 1e-12, "m");
    prefer(Preferred::WheelAway, 1);
    COMPARE_NEAR(turned(), 1 / 0.87, 1e-9, "");
    prefer(Preferred::ZoomSpeed, 2);
    COMPARE_NEAR(turned(), 1 / (0.87 * 0.87), 1e-9, "");
}

void TestPreferences::lengthsAreShownAndTypedInTheirUnit() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const double metres[] = {1, 1e-2, 1e-3, 0.0254};
    for (int i = 0; i < 4; ++i) {
        prefer(Preferred::Lengths, i);
        COMPARE_NEAR(displayUnit(kProxyRadius).factor * metres[i], 1, 1e-12, "");
    }
    program.document.select(SurfaceRef{program.document.scene().objects.front().id, 0});
    prefer(Preferred::Stiffnesses, 1);
    COMPARE_CONTAINS(program.box(QStringLiteral("stiffness")).toolTip() + lengthText(0.0254),
                     QStringLiteral("1.00 in"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("0.45"));
    QCOMPARE(program.document.surface(*program.document.selection())->material.stiffness, 450);
    prefer(Preferred::Stiffnesses, 0);
    QCOMPARE(program.box(QStringLiteral("stiffness")).value(), 450);
    program.type(QStringLiteral("stiffness"), QStringLiteral("0.5 N/mm"));
    QCOMPARE(program.document.surface(*program.document.selection())->material.stiffness, 500);
}

void TestPreferences::theThemeIsOneWithTheMenus() {
    TouchedWindow program;
    QVERIFY(theme().dark);
    program.command("theme-light").trigger();
    QCOMPARE(preferred(Preferred::Theme), double(ThemeChoice::Light));
    QVERIFY(!theme().dark);
    prefer(Preferred::Theme, double(ThemeChoice::Dark));
    QVERIFY(theme().dark);
    QVERIFY(program.command("theme-dark").isChecked());
}

void TestPreferences::theJournalIsWrittenAfterSoManyEdits() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    prefer(Preferred::JournalTime, 600);
    QSignalSpy written(&program.window->journal(), &Journal::written);
    program.type(QStringLiteral("stiffness"), QStringLiteral("500"));
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 1, kPatience); // the first one is soon in a journal
    // By time the next one would be there in ten minutes.
    prefer(Preferred::JournalEdits, 1);
    program.type(QStringLiteral("stiffness"), QStringLiteral("510"));
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 2, kPatience);
}

TACTUM_GUI_TEST(TestPreferences)

} // namespace test_preferences

#include "test_preferences.moc"
