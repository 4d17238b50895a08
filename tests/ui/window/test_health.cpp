// Faults, pauses and figures of the loops, as the window tells them.
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include "core/safety/inhibit_words.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/english.h"
#include "tests/ui/window/troubled_hand.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/engine/health_words.h"
#include "ui/panels/health_panel.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/period_chart.h"

namespace test_health {

using namespace tactum;

namespace {

/// A dock behind another tab counts as visible for Qt.
bool isSeen(const QDockWidget& dock) {
    return !dock.widget()->visibleRegion().isEmpty();
}

/// The program with a device that can fail, over a cube.
struct TroubledWindow {
    TroubledWindow() : TroubledWindow(std::make_shared<Trouble>()) {}
    explicit TroubledWindow(std::shared_ptr<Trouble> theTrouble)
        : trouble(std::move(theTrouble)), program({1200, 800}, {}, [this](auto hand) {
              return std::make_unique<TroubledHand>(std::move(hand), trouble);
          }) {}

    QWidget& widget(const char* name) {
        auto* found = program.window->findChild<QWidget*>(QString::fromLatin1(name));
        if (!found) qFatal("no widget %s", name);
        return *found;
    }
    QString text(const char* name) { return static_cast<QLabel&>(widget(name)).text(); }
    void click(const char* name) { QTest::mouseClick(&widget(name), Qt::LeftButton); }
    bool red() { return widget("statusStrip").property("fault").toBool(); }
    QAction& action(const char* name) {
        for (const auto* where : {&widget("forces"), &widget("tools"), &widget("Device")})
            for (QAction* action : where->actions())
                if (action->objectName() == QLatin1String(name)) return *action;
        qFatal("no action %s", name);
    }
    void showHealth() {
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-health"))->raise();
        program.frames(20);
    }
    QString events() {
        auto& list = static_cast<QTreeWidget&>(widget("health-events"));
        QString all;
        for (int i = 0; i < list.topLevelItemCount(); ++i)
            all += list.topLevelItem(i)->text(0) + u'\n';
        return all;
    }
    /// The guard has seen that the forces are off.
    bool disarmed() {
        return test::waitFor([this] { return program.engine.servo().inhibit == InhibitReason::NotArmed; });
    }
    bool fullForce() { return program.fullForce(); }

    std::shared_ptr<Trouble> trouble;
    TouchedWindow program;
};

} // namespace

class TestHealth : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path()); // every fault is saved as a recording there
        unfoldPlots();
    }

    void everyReasonHasItsWords();
    void aFaultTurnsTheBarRedUntilArmedAgain();
    void armingDoesNotHideAFaultThatGoesOn();
    void aPauseIsSaidQuietly();
    void figuresFollowTheTelemetry();
    void detailThatIsLeftOutIsSaid();
    void periodsAreCountedInTheirBins();
    void jitterDoesNotMoveTheCeilingOfTheWindow();
    void motorsWarmUp();
    void theCeilingIsOverriddenOnceItsRiskIsTaken();
    void theButtonMustBeHeldToFeel();
    void aDeviceWithoutButtonsIsNotAskedForOne();
    void theDockIsRemembered();
};

void TestHealth::everyReasonHasItsWords() {
    for (std::size_t i = 0; i < kInhibitWords.size(); ++i) {
        const InhibitWords& words = kInhibitWords[i];
        QCOMPARE(words.why, InhibitReason(i));
        QVERIFY(*words.brief);
        QVERIFY(*words.what);
        const QString sentences = guardSentences(words.why);
        QVERIFY2(sentences.endsWith(u'.'), qPrintable(sentences));
        // A fault says how to go on, and all of it has room in the bar.
        // Who has no device watchdog gets none by arming.
        const char* again = words.why == InhibitReason::Unguarded ? "start the program again" : "arm again";
        if (isFault(words.why)) QVERIFY2(sentences.contains(QLatin1String(again)), words.what);
        QCOMPARE_LE(sentences.size(), 150);
    }
    QCOMPARE(kInhibitWords.back().why, InhibitReason::Stopped); // the last of them
}

void TestHealth::aFaultTurnsTheBarRedUntilArmedAgain() {
    TroubledWindow troubled;
    QVERIFY(troubled.program.open(writeCube(folder_)));
    QVERIFY(troubled.fullForce());
    QVERIFY(!troubled.red());
    QVERIFY(!troubled.widget("arm-again").isVisible());
    const QString sentences = guardSentences(InhibitReason::DeviceLost);
    // A busy machine may have something else to say there.
    const auto saysTheFault = [&] {
        return troubled.widget("notice").isVisible() && troubled.text("notice-text").startsWith(sentences);
    };
    for (const char* button : {"arm-again", "notice-act"}) {
        troubled.trouble->nonsense = true;
        QTRY_VERIFY_WITH_TIMEOUT(troubled.red(), kPatience);
        QCOMPARE(troubled.widget("status-note").toolTip(), sentences);
        COMPARE_BEGINS(troubled.text("notice-text"), sentences);
        QVERIFY(saysTheFault());
        QVERIFY(troubled.widget("arm-again").isVisible());
        // Off by itself, and off it stays when the device is well again.
        QVERIFY(!troubled.program.engine.armed());
        QVERIFY(!troubled.action("armed").isChecked());
        QVERIFY(!troubled.widget("stop").isEnabled());
        troubled.trouble->nonsense = false;
        QVERIFY(troubled.disarmed());
        troubled.program.frames(20);
        QVERIFY(troubled.red());
        QCOMPARE_EQ(troubled.program.engine.servo().force.norm(), 0);
        QTest::keyPress(troubled.program.window.get(), Qt::Key_Escape);
        troubled.program.frames(50); // held: forces off, which ends no fault
        QTest::keyRelease(troubled.program.window.get(), Qt::Key_Escape);
        QVERIFY(troubled.red());
        QVERIFY(troubled.widget("notice-act").isVisible());
        troubled.click(button);
        QVERIFY(troubled.program.engine.armed());
        QVERIFY(troubled.action("armed").isChecked());
        QVERIFY(troubled.fullForce());
        QVERIFY(!troubled.red());
        QVERIFY(!troubled.widget("arm-again").isVisible());
        QVERIFY(!saysTheFault());
    }
    QCOMPARE(troubled.events().count(QString::fromLatin1(inhibitWords(InhibitReason::DeviceLost).what)), 2);
}

void TestHealth::armingDoesNotHideAFaultThatGoesOn() {
    TroubledWindow troubled;
    QVERIFY(troubled.program.open(writeCube(folder_)));
    QVERIFY(troubled.fullForce());
    troubled.trouble->nonsense = true;
    QTRY_VERIFY_WITH_TIMEOUT(troubled.red(), kPatience);
    QVERIFY(troubled.disarmed());
    QTest::keyClick(troubled.program.window.get(), Qt::Key_Return, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(troubled.program.engine.servo().faults, std::uint64_t(2), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(troubled.red() && !troubled.program.engine.armed(), kPatience);
}

void TestHealth::aPauseIsSaidQuietly() {
    TroubledWindow troubled;
    // What stands there while there is nothing else to say; a busy machine may pause at the start as well.
    QTRY_COMPARE_WITH_TIMEOUT(troubled.widget("status-note").toolTip(),
                              QString::fromStdString(troubled.program.engine.priorityNote()), kPatience);
    QVERIFY(troubled.program.open(writeCube(folder_)));
    QVERIFY(troubled.fullForce());
    troubled.trouble->slow = true;
    const QString sentences = guardSentences(InhibitReason::Stall);
    QTRY_COMPARE_WITH_TIMEOUT(troubled.widget("status-note").toolTip(), sentences, kPatience);
    QVERIFY(!troubled.red());
    QVERIFY(troubled.program.engine.armed());
    QVERIFY(!troubled.widget("notice").isVisible());
    COMPARE_CONTAINS(troubled.events(), QString::fromLatin1(inhibitWords(InhibitReason::Stall).what));
    troubled.trouble->slow = false;
    QVERIFY(troubled.fullForce());
    troubled.trouble->hangs = true;
    QTRY_VERIFY_WITH_TIMEOUT(troubled.events().contains(QStringLiteral("stands still")), kPatience);
    troubled.trouble->hangs = false;
    QVERIFY(troubled.fullForce());
    QTRY_VERIFY_WITH_TIMEOUT(troubled.widget("status-note").toolTip() != sentences, kPatience);
}

void TestHealth::figuresFollowTheTelemetry() {
    HealthPanel panel;
    const auto text = [&](const char* name) {
        return panel.findChild<QLabel*>(QString::fromLatin1(name))->text();
    };
    const DeviceInfo device; // 1 kHz
    ServoTelemetry servo;
    servo.rate = 987;
    servo.misses = 15;
    servo.machineMisses = 12;
    servo.periods.add(7440);
    servo.heat = 0.25;
    servo.energy = 4.2e-4;
    ProxyTelemetry proxy;
    proxy.rate = 12300;
    panel.display(servo, proxy, device);
    QCOMPARE(text("health-servo"), QStringLiteral("987 of 1000 Hz"));
    QCOMPARE(text("health-proxy"), QStringLiteral("12.3k of 2000 Hz"));
    QCOMPARE(text("health-late"), QStringLiteral("Late ticks: 3 of our own, 12 of the machine's"));
    QCOMPARE(text("health-gap"), QStringLiteral("8.4 ms"));
    QCOMPARE(text("health-energy"), QStringLiteral("0.42 mJ"));
    QCOMPARE(text("health-damping"), QStringLiteral("0.0 N s/m"));
    QCOMPARE(text("health-heat"), QStringLiteral("25 % warm"));
    servo.energy = -1; // what the surface took is no gift
    servo.passivityDamping = 3.5;
    panel.display(servo, proxy, device);
    QCOMPARE(text("health-energy"), QStringLiteral("0.00 mJ"));
    QCOMPARE(text("health-damping"), QStringLiteral("3.5 N s/m"));
    for (const auto* label : panel.findChildren<QLabel*>())
        if (!label->objectName().isEmpty())
            QVERIFY2(!label->toolTip().isEmpty(), qPrintable(label->objectName()));
}

void TestHealth::detailThatIsLeftOutIsSaid() {
    HealthPanel panel;
    const auto* words = panel.findChild<QLabel*>(QStringLiteral("health-fidelity"));
    ProxyTelemetry proxy;
    proxy.fidelity = Fidelity::NoTexture;
    proxy.stepsDown = 1;
    panel.display({}, proxy, {});
    QCOMPARE(words->text(), QStringLiteral("Textures are left out: the scene is too heavy. Lowered once."));
    QVERIFY(words->property("limit").toBool());
    proxy.fidelity = Fidelity::Full;
    proxy.stepsDown = 4;
    panel.display({}, proxy, {});
    QCOMPARE(words->text(), QStringLiteral("Nothing is left out. Lowered 4 times."));
    QVERIFY(!words->property("limit").toBool());
}

void TestHealth::periodsAreCountedInTheirBins() {
    test::speakEnglish();
    PeriodHistogram periods;
    for (int i = 0; i < 997; ++i)
        periods.add(7);
    periods.add(150);
    periods.add(1500);
    periods.add(9000);
    PeriodChart chart;
    chart.setPeriods(periods, 1000);
    QCOMPARE(chart.figuresOf(2), QStringLiteral("5 to 10 \u00b5s: 997 ticks, 100 %"));
    QCOMPARE(chart.figuresOf(6), QStringLiteral("100 to 200 \u00b5s: 1 tick, 0.1 %"));
    QCOMPARE(chart.figuresOf(11), QStringLiteral("more than 5000 \u00b5s: 1 tick, 0.1 %"));
}

void TestHealth::jitterDoesNotMoveTheCeilingOfTheWindow() {
    auto trouble = std::make_shared<Trouble>();
    TroubledWindow troubled(trouble);
    TouchedWindow& program = troubled.program;
    QVERIFY(program.open(writeCube(folder_)));
    troubled.showHealth();
    trouble->jitters = true;
    QString before = troubled.text("health-ceiling");
    int moves = 0;
    for (int i = 0; i < 30; ++i) {
        program.frames(7);
        const QString now = troubled.text("health-ceiling");
        moves += std::exchange(before, now) != now;
    }
    QVERIFY2(moves <= 5, qPrintable(QString::number(moves))); // each has lasted for a second
    trouble->jitters = false;
    trouble->late = true;
    QTRY_VERIFY_WITH_TIMEOUT(troubled.events().contains(QStringLiteral("The stiffness ceiling fell from")),
                             kPatience);
    COMPARE_CONTAINS(troubled.text("health-reason"), QStringLiteral("comes late"));
}

void TestHealth::motorsWarmUp() {
    auto trouble = std::make_shared<Trouble>();
    trouble->continuousForce = 0.05;
    TroubledWindow troubled(trouble);
    TouchedWindow& program = troubled.program;
    QVERIFY(program.open(writeCube(folder_)));
    program.window->view().showStandardView(StandardView::Front);
    troubled.showHealth();
    QTRY_COMPARE_WITH_TIMEOUT(troubled.text("health-heat"), QStringLiteral("0 % warm"), kPatience);
    program.press(program.centre());
    QTRY_VERIFY_WITH_TIMEOUT(program.touch().contacts == 1, kPatience);
    program.wheel(program.centre(), 8);
    const auto percent = [&] { return troubled.text("health-heat").section(u' ', 0, 0).toInt(); };
    QTRY_VERIFY_WITH_TIMEOUT(percent() > 70, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(program.engine.servo().force.norm() < 0.1, kPatience);
}

void TestHealth::theCeilingIsOverriddenOnceItsRiskIsTaken() {
    auto trouble = std::make_shared<Trouble>();
    trouble->maxStiffness = 300;
    TroubledWindow troubled(trouble);
    TouchedWindow& program = troubled.program;
    QVERIFY(program.open(writeCube(folder_)));
    troubled.showHealth();
    auto& box = static_cast<QCheckBox&>(troubled.widget("health-override"));
    const auto tick = [&] { return program.box(QStringLiteral("stiffness")).parentWidget()->toolTip(); };
    QTRY_COMPARE_WITH_TIMEOUT(troubled.text("health-ceiling"), QStringLiteral("300 N/m"), kPatience);
    QCOMPARE(troubled.text("health-stiffest"), QStringLiteral("800 N/m"));
    QCOMPARE(troubled.text("health-reason"), QStringLiteral("limited by the maker's figure"));
    COMPARE_CONTAINS(tick(), QStringLiteral("300 N/m, limited by the maker's figure"));
    // Asked once.
    box.click();
    QVERIFY(!box.isChecked());
    QVERIFY(!program.engine.overridesCeiling());
    COMPARE_CONTAINS(troubled.text("notice-text"), QStringLiteral("Above the ceiling"));
    troubled.click("notice-act");
    QVERIFY(box.isChecked());
    QVERIFY(program.engine.overridesCeiling());
    QCOMPARE(troubled.text("health-reason"), QStringLiteral("overridden at your own risk"));
    COMPARE_CONTAINS(tick(), QStringLiteral("own risk"));
    box.click();
    QVERIFY(!box.isChecked());
    QVERIFY(!program.engine.overridesCeiling());
    box.click();
    QVERIFY(box.isChecked());
    QVERIFY(program.engine.overridesCeiling());
    // The scene's stiffest surface is followed.
    program.type(QStringLiteral("stiffness"), QStringLiteral("1250"));
    QTRY_COMPARE_WITH_TIMEOUT(troubled.text("health-stiffest"), QStringLiteral("1250 N/m"), kPatience);
}

void TestHealth::theButtonMustBeHeldToFeel() {
    const QString sentences = guardSentences(InhibitReason::DeadMan);
    COMPARE_CONTAINS(sentences, QStringLiteral("Hold the button to feel"));
    {
        TroubledWindow troubled;
        TouchedWindow& program = troubled.program;
        QVERIFY(program.open(writeCube(folder_)));
        program.window->view().showStandardView(StandardView::Front);
        QVERIFY(troubled.fullForce()); // nobody asked for it
        QAction& action = troubled.action("dead-man");
        QVERIFY(action.isEnabled());
        QVERIFY(!action.isChecked());
        action.trigger();
        const auto inhibit = [&] { return program.engine.servo().inhibit; };
        QTRY_COMPARE_WITH_TIMEOUT(inhibit(), InhibitReason::DeadMan, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(troubled.widget("status-note").toolTip(), sentences, kPatience);
        QVERIFY(!troubled.red());
        QVERIFY(program.engine.armed()); // no fault
        program.press(program.centre());
        QVERIFY(troubled.fullForce());
        QTRY_VERIFY_WITH_TIMEOUT(program.engine.servo().force.norm() > 0.1, kPatience);
        program.release(program.centre());
        QTRY_COMPARE_WITH_TIMEOUT(inhibit(), InhibitReason::DeadMan, kPatience);
        QCOMPARE(program.engine.servo().force.norm(), 0.0);
        program.window->close();
    }
    TroubledWindow again; // it is remembered
    QAction& action = again.action("dead-man");
    QVERIFY(action.isChecked());
    QVERIFY(again.program.engine.deadMan());
    QVERIFY(again.program.open(writeCube(folder_)));
    QTRY_COMPARE_WITH_TIMEOUT(again.program.engine.servo().inhibit, InhibitReason::DeadMan, kPatience);
    action.trigger();
    QVERIFY(again.fullForce());
}

void TestHealth::aDeviceWithoutButtonsIsNotAskedForOne() {
    QSettings().setValue(QStringLiteral("device/deadMan"), true); // left by another device
    auto trouble = std::make_shared<Trouble>();
    trouble->buttons = 0;
    TroubledWindow troubled(trouble);
    QVERIFY(!troubled.action("dead-man").isEnabled());
    QVERIFY(!troubled.program.engine.deadMan());
    QVERIFY(troubled.program.open(writeCube(folder_)));
    QVERIFY(troubled.fullForce());
    QSettings().remove(QStringLiteral("device/deadMan"));
}

void TestHealth::theDockIsRemembered() {
    const auto dockOf = [](TroubledWindow& troubled) {
        return troubled.program.window->findChild<QDockWidget*>(QStringLiteral("dock-health"));
    };
    {
        TroubledWindow troubled;
        QVERIFY(troubled.program.open(writeCube(folder_)));
        const auto* plot = troubled.program.window->findChild<QDockWidget*>(QStringLiteral("dock-plot"));
        QVERIFY(troubled.program.window->tabifiedDockWidgets(dockOf(troubled)).contains(plot));
        QVERIFY(isSeen(*plot));
        QVERIFY(!isSeen(*dockOf(troubled)));
        troubled.showHealth();
        QVERIFY(isSeen(*dockOf(troubled)));
        QVERIFY(!isSeen(*plot));
        troubled.program.window->close();
    }
    TroubledWindow again;
    QVERIFY(again.program.open(writeCube(folder_)));
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(*dockOf(again)), kPatience);
    QVERIFY(!again.program.engine.overridesCeiling());
}

TACTUM_GUI_TEST(TestHealth)

} // namespace test_health

#include "test_health.moc"
