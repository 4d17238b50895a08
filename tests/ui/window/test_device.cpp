// Devices in the window: connecting one step by step, losing it and getting it back, its workspace, its
// buttons, scenes to try it with.
#include <cmath>

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/window/fake_devices.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/axis_capture.h"
#include "ui/device_link.h"
#include "ui/device_settings.h"
#include "ui/device_trial.h"
#include "ui/health_words.h"
#include "ui/panels/device_panel.h"
#include "ui/usb_permission.h"
#include "ui/view/scene_view.h"

using namespace tactum;

namespace {

const QString kFake = QStringLiteral("fake:1-2");

/// The program with a catalogue, the dock Device in front.
struct Desk {
    Desk() : desk(std::make_shared<FakeDesk>()), catalogue(std::make_unique<FakeCatalogue>(desk, nullptr)) {
        catalogue->hand = program.hand;
        program.window->setCatalogue(*catalogue);
        program.command("device-panel").trigger();
    }

    QWidget& widget(const char* name) {
        auto* found = program.window->findChild<QWidget*>(QString::fromLatin1(name));
        if (!found) qFatal("no widget %s", name);
        return *found;
    }
    QString text(const char* name) {
        QWidget& label = widget(name);
        if (!label.isVisible()) return {};
        auto* button = qobject_cast<QPushButton*>(&label);
        return button ? button->text() : static_cast<QLabel&>(label).text();
    }
    void click(const char* name) { QTest::mouseClick(&widget(name), Qt::LeftButton); }
    QTreeWidget& list() { return static_cast<QTreeWidget&>(widget("device-list")); }
    QStringList rows() {
        QStringList texts;
        for (int i = 0; i < list().topLevelItemCount(); ++i)
            texts << list().topLevelItem(i)->text(0);
        return texts;
    }
    bool listed(const char* name) {
        return QTest::qWaitFor([&] { return !rows().filter(QString::fromLatin1(name)).isEmpty(); },
                               kPatience);
    }
    void chooseRow(const char* name) {
        if (!listed(name)) qFatal("%s is not listed", name);
        const auto found = list().findItems(QString::fromLatin1(name), Qt::MatchStartsWith);
        list().setCurrentItem(found.front());
    }
    /// Chooses it in the list and presses Connect.
    void begin() {
        chooseRow("Example arm");
        click("device-connect-button");
    }
    bool ready() {
        return QTest::qWaitFor([this] { return link().current() == kFake && !link().preparing(); },
                               kPatience);
    }
    bool connectIt() {
        desk->go = 3;
        begin();
        return ready();
    }
    void page(DevicePanel::Page page) {
        QTest::mouseClick(&widget(qPrintable(QStringLiteral("device-page-%1").arg(int(page)))),
                          Qt::LeftButton);
        program.frames(10);
    }
    void pick(const char* name, int row) {
        auto& box = static_cast<QComboBox&>(widget(name));
        box.setCurrentIndex(row);
        emit box.activated(row);
    }
    DeviceLink& link() { return program.window->devices(); }
    Engine& engine() { return program.engine; }
    bool fullForce() {
        return QTest::qWaitFor([this] { return engine().servo().gain == 1; }, kPatience);
    }
    QString steps() { return widget("device-give-up").parentWidget()->accessibleName(); }

    std::shared_ptr<FakeDesk> desk;
    std::unique_ptr<FakeCatalogue> catalogue; // outlives the window
    TouchedWindow program;
};

} // namespace

class TestDevice : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        QSettings().clear();
        QStandardPaths::setTestModeEnabled(true); // every fault is saved as a recording
    }

    void withoutACatalogueAllIsAsBefore();
    void theListSaysWhatIsThereAndWhyNot();
    void theListIsMadeAgainEverySecond();
    void everyStepIsShown();
    void aFailingStepIsNamedAndTriedAgain();
    void aDeviceThatDoesNotOpenLeavesTheSimulatedHand();
    void givingUpLeavesTheSimulatedHand();
    void disconnectingWhileItIsMadeReadyGivesUp();
    void aBrokenDriverIsOpenedAgain();
    void closingTheWindowGivesUp();
    void theMouseDoesNotLeadARealDevice();
    void disconnectingGivesItBack();
    void aLostDeviceIsSaidAndComesBackWithoutForce();
    void aLossIsNoticedWithForcesOffToo();
    void aDeviceThatIsOnlyHiddenIsNotLost();
    void anotherDeviceIsFreedFirst();
    void theChoiceIsRemembered();
    void liveFiguresFollowTheDevice();
    void aButtonEndsAllForce();
    void aButtonDoesOneThing();
    void theScaleIsTypedAndRemembered();
    void noImpossibleMappingCanBeChosen();
    void motionsSetTheAxes();
    void motionsThatAreNotClearDoNot();
    void reCentringTakesBackWhatTheClutchMoved();
    void theCeilingFallsWithTheScale();
    void undoDoesNotTouchTheDevice();
    void trialsAreFeltInsteadOfTheScene();
    void anEditEndsATrial();
    void theSpringDrawsBackToTheCentre();
    void theRuleForUsbIsOffered();
    void everythingHasAName();
};

void TestDevice::withoutACatalogueAllIsAsBefore() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.engine.armed() && !program.window->devices().hasCatalogue());
    QVERIFY(!program.command("device-connect").isEnabled() &&
            !program.command("device-disconnect").isEnabled());
    program.window->view().showStandardView(StandardView::Front);
    program.press(program.centre());
    QTRY_VERIFY_WITH_TIMEOUT(program.touch().contacts == 1, kPatience);
}

void TestDevice::theListSaysWhatIsThereAndWhyNot() {
    Desk desk;
    desk.catalogue->locked = true;
    QVERIFY(desk.listed("Locked arm"));
    const QString all = desk.rows().join(u'\n');
    QVERIFY2(all.contains(QStringLiteral("Simulated hand \u00b7 in use")), qPrintable(all));
    QVERIFY(all.contains(QStringLiteral("Locked arm \u00b7 not usable\nAt USB 1-3; you have no permission")));
    desk.chooseRow("Locked arm");
    QVERIFY(!desk.widget("device-connect-button").isEnabled());
    QVERIFY(!desk.program.command("device-connect").isEnabled());
    desk.chooseRow("Example arm");
    QVERIFY(desk.widget("device-connect-button").isEnabled());
    QVERIFY(desk.program.command("device-connect").isEnabled());
}

void TestDevice::theListIsMadeAgainEverySecond() {
    Desk desk;
    QVERIFY(desk.listed("Example arm"));
    desk.chooseRow("Example arm");
    desk.desk->plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(desk.rows().filter(QStringLiteral("Example arm")).isEmpty(), kPatience);
    desk.desk->plugged = true;
    QVERIFY(desk.listed("Example arm"));
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 1, kPatience);
}

void TestDevice::everyStepIsShown() {
    Desk desk;
    desk.program.engine.setArmed(true);
    desk.begin();
    const auto steps = [&] { return desk.steps(); };
    QTRY_COMPARE_WITH_TIMEOUT(steps(), QStringLiteral("Load the firmware now, Find home, Rest"), kPatience);
    QCOMPARE(desk.text("device-preparing"), QStringLiteral("Making Example arm ready"));
    QTRY_COMPARE_WITH_TIMEOUT(static_cast<QProgressBar&>(desk.widget("device-progress")).value(), 500,
                              kPatience);
    QVERIFY(desk.widget("device-give-up").isVisible() && !desk.widget("device-again").isVisible());
    QCOMPARE(desk.text("device-request"), QString());
    desk.desk->go = 1;
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-request"), QStringLiteral("Push the grip in and out."),
                              kPatience);
    QCOMPARE(steps(), QStringLiteral("Load the firmware done, Find home now, Rest"));
    desk.desk->go = 3;
    QVERIFY(desk.ready());
    QVERIFY(!desk.widget("device-give-up").isVisible() && !desk.widget("device-preparing").isVisible());
    // The forces are off until a person arms; the window offers it.
    QCOMPARE(desk.engine().device().name, std::string("Example arm"));
    QVERIFY(!desk.engine().armed() && !desk.program.command("armed").isChecked());
    QVERIFY2(desk.text("notice-text").startsWith(QStringLiteral("Example arm is ready. The forces are off")),
             qPrintable(desk.text("notice-text")));
    QVERIFY(desk.rows().join(u'\n').contains(QStringLiteral("Example arm \u00b7 in use")));
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-name"), QStringLiteral("Example arm"), kPatience);
    desk.click("notice-act");
    QVERIFY(desk.engine().armed() && desk.program.command("armed").isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("device-state").startsWith(QStringLiteral("forces on")), kPatience);
    desk.click("device-arm");
    QVERIFY(!desk.engine().armed() && !desk.program.command("armed").isChecked());
}

void TestDevice::aFailingStepIsNamedAndTriedAgain() {
    Desk desk;
    desk.desk->go = 1;
    desk.desk->failAt = 1;
    desk.begin();
    const QString sentence = QStringLiteral("The grip did not move: pull it all the way out.");
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-failure"), sentence, kPatience);
    QCOMPARE(desk.steps(), QStringLiteral("Load the firmware done, Find home failed, Rest"));
    QCOMPARE(desk.text("notice-text"), QStringLiteral("Example arm, step \"Find home\": ") + sentence);
    QCOMPARE(desk.text("device-preparing"), QStringLiteral("Example arm could not be made ready"));
    QVERIFY(desk.engine().running() && desk.link().current() == kSimulatedDevice);
    QCOMPARE(desk.desk->made.load(), 0); // nobody keeps it
    // What failed is not tried without end, but when the person says so.
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 2, kPatience);
    QVERIFY(!desk.link().preparing());
    desk.desk->failAt = -1;
    desk.desk->go = 3;
    desk.click("device-again");
    QVERIFY(desk.ready());
    QVERIFY(!desk.widget("device-failure").isVisible());
}

void TestDevice::aDeviceThatDoesNotOpenLeavesTheSimulatedHand() {
    Desk desk;
    desk.desk->failOpen = true;
    desk.desk->go = 3;
    desk.begin();
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-failure"),
                              QStringLiteral("The arm did not wake: switch it off and on."), kPatience);
    QVERIFY(desk.engine().running() && !desk.engine().armed());
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    QCOMPARE(desk.desk->made.load(), 0);
}

void TestDevice::givingUpLeavesTheSimulatedHand() {
    Desk desk;
    desk.begin();
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing, kPatience);
    desk.click("device-give-up");
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-again").isVisible(), kPatience);
    QCOMPARE(desk.text("device-preparing"), QStringLiteral("Example arm: given up"));
    QVERIFY(!desk.desk->preparing && desk.desk->made == 0);
    QVERIFY(!desk.widget("device-failure").isVisible()); // nothing failed
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 1, kPatience);
    QVERIFY(!desk.link().preparing());
}

void TestDevice::disconnectingWhileItIsMadeReadyGivesUp() {
    Desk desk;
    desk.begin();
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing, kPatience);
    desk.click("device-disconnect-button");
    desk.desk->go = 3; // all goes well, too late
    QTRY_VERIFY_WITH_TIMEOUT(!desk.link().preparing() && !desk.desk->preparing, kPatience);
    desk.program.frames(10);
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    QCOMPARE(desk.link().wanted(), kSimulatedDevice);
    QCOMPARE(int(desk.desk->made), 0);
}

/// No arming helps there: the message offers what does.
void TestDevice::aBrokenDriverIsOpenedAgain() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.08);
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
    desk.desk->broken = true;
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("notice-act"), QStringLiteral("Open again"), kPatience);
    QVERIFY(!desk.engine().armed());
    QVERIFY(desk.text("notice-text").contains(QStringLiteral("The driver crashed.")));
    desk.click("notice-act");
    QTRY_COMPARE_WITH_TIMEOUT(int(desk.desk->prepared), 2, kPatience);
    QVERIFY(desk.ready());
    QVERIFY(!desk.engine().armed());
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
}

void TestDevice::closingTheWindowGivesUp() {
    Desk desk;
    desk.begin();
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing, kPatience);
    desk.program.window->close();
    desk.program.window.reset();
    QVERIFY(!desk.desk->preparing);
    QCOMPARE(desk.desk->made.load(), 0);
    desk.program.window =
        std::make_unique<MainWindow>(desk.program.document, desk.program.engine, desk.program.hand);
}

void TestDevice::theMouseDoesNotLeadARealDevice() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.program.window->view().showStandardView(StandardView::Front);
    desk.desk->place(0, 0, 0.04);
    QVERIFY(desk.connectIt());
    desk.program.frames(20);
    const HandGoal before = desk.program.hand->read();
    desk.program.press(desk.program.centre());
    desk.program.moveTo(desk.program.centre() + QPoint(80, 0));
    desk.program.release(desk.program.centre() + QPoint(80, 0));
    desk.program.frames(20);
    QVERIFY(desk.program.hand->read().position == before.position);
    QCOMPARE(desk.program.finger().z(), 0.04);
    desk.click("device-disconnect-button");
    desk.program.press(desk.program.centre());
    desk.program.moveTo(desk.program.centre() + QPoint(80, 0));
    desk.program.frames(20);
    desk.program.release(desk.program.centre());
    QVERIFY(desk.program.finger().z() != 0.04);
}

void TestDevice::disconnectingGivesItBack() {
    Desk desk;
    QVERIFY(desk.connectIt());
    QCOMPARE(desk.desk->made.load(), 1);
    desk.engine().setArmed(true);
    desk.program.command("device-disconnect").trigger();
    QCOMPARE(desk.desk->made.load(), 0);
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QVERIFY(desk.engine().running() && !desk.engine().armed());
    QVERIFY(!desk.program.command("armed").isChecked());
    // It does not come back by itself.
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 2, kPatience);
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    QVERIFY(desk.connectIt());
}

void TestDevice::aLostDeviceIsSaidAndComesBackWithoutForce() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.08);
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
    desk.desk->plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.text("notice-text").startsWith(QStringLiteral("Example arm is not there any more")), kPatience);
    QVERIFY(desk.link().lost() && !desk.engine().armed());
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QCOMPARE(desk.desk->made.load(), 0);
    desk.program.frames(120); // the recording of the fault does not push the sentence away
    QVERIFY2(desk.text("notice-text").contains(QStringLiteral("is not there any more")),
             qPrintable(desk.text("notice-text")));
    desk.engine().setArmed(true); // the simulated hand meanwhile
    desk.desk->plugged = true;
    QVERIFY(desk.ready());
    QCOMPARE(desk.desk->prepared.load(), 2);
    QVERIFY(!desk.link().lost() && !desk.engine().armed() && !desk.program.command("armed").isChecked());
    QVERIFY2(desk.text("notice-text").startsWith(QStringLiteral("Example arm is there and ready")),
             qPrintable(desk.text("notice-text")));
    desk.program.frames(60);
    QVERIFY(!desk.engine().armed());
    QCOMPARE(desk.desk->force.load(), 0.0);
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
}

void TestDevice::aLossIsNoticedWithForcesOffToo() {
    Desk desk;
    QVERIFY(desk.connectIt());
    QVERIFY(!desk.engine().armed());
    desk.desk->plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.text("notice-text").startsWith(QStringLiteral("Example arm is not there any more")), kPatience);
    QCOMPARE(desk.link().current(), kSimulatedDevice);
}

void TestDevice::aDeviceThatIsOnlyHiddenIsNotLost() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.catalogue->hidden = true; // as a maker's library does with what it has opened
    QTRY_VERIFY_WITH_TIMEOUT(desk.rows().filter(QStringLiteral("Example arm")).isEmpty(), kPatience);
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 2, kPatience);
    QCOMPARE(desk.link().current(), kFake);
    QVERIFY(!desk.link().lost());
}

void TestDevice::anotherDeviceIsFreedFirst() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.catalogue->other = true;
    desk.desk->go = 0;
    desk.chooseRow("Other arm");
    desk.click("device-connect-button");
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing, kPatience);
    QCOMPARE(desk.desk->made.load(), 1); // the new one
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QVERIFY(!desk.engine().armed());
    // Thinking better of it ends the one and begins the other.
    desk.chooseRow("Example arm");
    desk.link().choose(kFake);
    desk.desk->go = 3;
    QVERIFY(desk.ready());
    QTRY_COMPARE_WITH_TIMEOUT(desk.desk->made.load(), 1, kPatience);
}

void TestDevice::theChoiceIsRemembered() {
    {
        Desk desk;
        QVERIFY(desk.connectIt());
        desk.program.window->close();
    }
    {
        Desk desk; // by itself, without force
        desk.desk->go = 3;
        QVERIFY(desk.ready());
        QVERIFY(!desk.engine().armed());
        desk.click("device-disconnect-button");
    }
    Desk desk;
    desk.desk->go = 3;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > 2, kPatience);
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    QVERIFY(!desk.link().preparing());
}

void TestDevice::liveFiguresFollowTheDevice() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Live);
    desk.desk->place(0.012, -0.003, 0.0405);
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-position"), QStringLiteral("12.0, -3.0, 40.5 mm"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("device-rate").endsWith(QStringLiteral("of 1000 Hz")), kPatience);
    QCOMPARE(desk.text("device-heat"), QStringLiteral("0 % warm"));
    const auto heard = [&](const char* name) { return desk.widget(name).accessibleName(); };
    QCOMPARE(heard("device-force"), QStringLiteral("Force 0.00 N of 6.0 N"));
    QTRY_COMPARE_WITH_TIMEOUT(
        heard("workspace-picture"),
        QStringLiteral("Handle at 12, -3, 41 mm in a workspace of 50 mm about the centre"), kPatience);
    QCOMPARE(heard("device-buttons"), QStringLiteral("No button is held"));
    desk.desk->buttons = 0b101;
    QTRY_COMPARE_WITH_TIMEOUT(heard("device-buttons"), QStringLiteral("Held buttons: 1, 3"), kPatience);
}

void TestDevice::aButtonEndsAllForce() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.08);
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Live);
    desk.pick("device-stop-button", 2);
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
    desk.desk->place(0, 0, 0.0495);
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->force > 0.1, kPatience);
    desk.desk->buttons = 0b101; // others do not
    desk.program.frames(20);
    QVERIFY(desk.desk->force > 0.1);
    // The servo has taken the force away before the window has seen anything: it does not run here.
    desk.desk->buttons = 0b010;
    desk.engine().poll();
    const std::uint64_t ticks = desk.engine().servo().ticks;
    while (desk.engine().servo().ticks < ticks + 20) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        desk.engine().poll();
    }
    QVERIFY(desk.engine().armed());
    QCOMPARE(desk.desk->force.load(), 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.engine().armed(), kPatience);
    QVERIFY(!desk.program.command("armed").isChecked());
    QVERIFY(desk.text("notice-text").startsWith(QStringLiteral("Stopped by the button of the device")));
    // It latches: letting go brings nothing back, arming does; not while it is still held.
    desk.desk->buttons = 0;
    desk.program.frames(30);
    QVERIFY(!desk.engine().armed() && desk.desk->force == 0.0);
    desk.desk->buttons = 0b010;
    desk.program.command("armed").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!desk.engine().armed(), kPatience);
    QCOMPARE(desk.desk->force.load(), 0.0);
    desk.desk->buttons = 0;
    desk.desk->place(0, 0, 0.08);
    desk.program.frames(10);
    desk.program.command("armed").trigger();
    QVERIFY(desk.fullForce());
    // It is remembered with the device.
    QCOMPARE(rememberedSettings(kFake).stopButton, 0b010u);
}

void TestDevice::aButtonDoesOneThing() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.pick("device-stop-button", 1);
    desk.pick("workspace-clutch", 1);
    QCOMPARE(desk.engine().workspace().clutch, 1u);
    QCOMPARE(desk.link().stop().buttons.load(), 0u);
    desk.pick("device-stop-button", 1);
    QCOMPARE(desk.engine().workspace().clutch, 0u);
    QCOMPARE(desk.link().stop().buttons.load(), 1u);
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-clutch")).currentIndex(), 0);
}

void TestDevice::theScaleIsTypedAndRemembered() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.program.type(QStringLiteral("workspace-scale"), QStringLiteral("2.5"));
    QCOMPARE(desk.engine().workspace().scale, 2.5);
    desk.desk->place(0.02, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.program.finger().x() - 0.05) < 1e-12, kPatience);
    desk.click("workspace-bump");
    QVERIFY(desk.engine().workspace().bump);
    // The simulated hand keeps none of it.
    desk.program.command("device-disconnect").trigger();
    QCOMPARE(desk.engine().workspace(), Workspace{});
    QVERIFY(!desk.widget("workspace-scale").isVisible());
    QVERIFY(desk.connectIt());
    QCOMPARE(desk.engine().workspace().scale, 2.5);
    QVERIFY(desk.engine().workspace().bump);
    QCOMPARE(desk.program.box(QStringLiteral("workspace-scale")).value(), 2.5);
}

void TestDevice::noImpossibleMappingCanBeChosen() {
    QCOMPARE(withAxis(kSameAxes, 0, -3), (AxisMap{-3, 2, 1}));
    QCOMPARE(withAxis({-3, 2, 1}, 1, 3), (AxisMap{2, 3, 1}));
    QCOMPARE(withAxis(kSameAxes, 2, -3), (AxisMap{1, 2, -3}));
    for (int first : {1, -1, 2, -2, 3, -3})
        for (std::size_t which = 0; which < 3; ++which)
            for (int axis : {1, -1, 2, -2, 3, -3}) {
                const AxisMap axes = withAxis(withAxis(kSameAxes, 1, first), which, axis);
                QVERIFY(checkWorkspace({.axes = axes}) && axes[which] == axis);
            }
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.pick("workspace-axis-1", 5); // the device's -z
    QCOMPARE(desk.engine().workspace().axes, (AxisMap{-3, 2, 1}));
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-axis-3")).currentIndex(), 0);
    desk.desk->place(0, 0, -0.03);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.program.finger().x() - 0.03) < 1e-12, kPatience);
}

void TestDevice::motionsSetTheAxes() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    QVERIFY(desk.engine().armed());
    desk.program.command("workspace-axes").trigger();
    QVERIFY(!desk.engine().armed() && !desk.program.command("armed").isChecked()); // nothing pushes now
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("to the right")), kPatience);
    desk.program.frames(10);
    desk.desk->place(0.002, -0.03, 0.003);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("up")), kPatience);
    desk.program.frames(10);
    desk.desk->place(0.04, 0.03, 0.003); // y is taken: however far it goes, it is not meant
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("toward you")), kPatience);
    QCOMPARE(desk.engine().workspace().axes, kSameAxes);
    desk.program.frames(10);
    desk.desk->place(0, 0, -0.03);
    QTRY_COMPARE_WITH_TIMEOUT(desk.engine().workspace().axes, (AxisMap{-2, 1, -3}), kPatience);
    QVERIFY(!desk.widget("workspace-task").isVisible());
    QCOMPARE(rememberedSettings(kFake).workspace.axes, (AxisMap{-2, 1, -3}));
    // Left in the middle, the axes stay.
    desk.program.command("workspace-axes").trigger();
    desk.program.frames(10);
    desk.desk->place(0.03, 0, -0.03);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("up")), kPatience);
    desk.click("workspace-capture");
    QVERIFY(!desk.widget("workspace-task").isVisible());
    QCOMPARE(desk.engine().workspace().axes, (AxisMap{-2, 1, -3}));
}

void TestDevice::motionsThatAreNotClearDoNot() {
    AxisCapture capture(0.02);
    QVERIFY(!capture.add({0.5, 0, 0})); // where it is does not matter
    QVERIFY(!capture.add({0.515, 0, 0}));
    QCOMPARE(std::round(100 * capture.progress()), 75.0);
    QVERIFY(!capture.add({0.53, 0.03, 0})); // askew
    QVERIFY(!capture.add(Vec3::Constant(std::nan(""))));
    QVERIFY(capture.add({0.53, 0.01, 0}));
    QCOMPARE(capture.step(), std::size_t(1));
}

void TestDevice::reCentringTakesBackWhatTheClutchMoved() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.pick("workspace-clutch", 3);
    const auto offset = [&] { return desk.engine().servo().frame.offset; };
    desk.program.frames(10);
    desk.desk->buttons = 0b100;
    desk.program.frames(10);
    desk.desk->place(0.03, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(offset().x() + 0.03) < 1e-9, kPatience);
    desk.desk->buttons = 0;
    desk.program.frames(10);
    QVERIFY(std::abs(offset().x() + 0.03) < 1e-9);
    for (int twice = 0; twice < 2; ++twice) {
        desk.program.command("workspace-centre").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(offset().norm() < 1e-9, kPatience);
        desk.desk->buttons = 0b100;
        desk.program.frames(10);
        desk.desk->place(twice ? 0.03 : 0, 0, 0);
        QTRY_VERIFY_WITH_TIMEOUT(offset().norm() > 0.02, kPatience);
        desk.desk->buttons = 0;
        desk.program.frames(10);
    }
    // The cube has a diagonal of 0.1732 m, the arm reaches 0.05 m.
    desk.program.command("workspace-fit").trigger();
    QVERIFY(std::abs(desk.engine().workspace().scale - std::sqrt(3.0)) < 1e-9);
}

void TestDevice::theCeilingFallsWithTheScale() {
    DeviceInfo device;
    device.damping = 4;
    ServoTelemetry servo;
    const CeilingNow one = ceilingNow(servo, device);
    servo.frame.scale = 4;
    QCOMPARE(ceilingNow(servo, device).value, one.value / 4);
    // What the servo says is of the scene already, and no reason to speak of a late one.
    servo.ceiling = {one.value / 4, CeilingReason::Damping};
    QCOMPARE(ceilingNow(servo, device).value, one.value / 4);
    QCOMPARE(ceilingNow(servo, device).reason, one.reason);
}

void TestDevice::undoDoesNotTouchTheDevice() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.program.type(QStringLiteral("workspace-scale"), QStringLiteral("3"));
    QVERIFY(!desk.program.document.history().canUndo() && !desk.program.document.modified());
    QCOMPARE(desk.engine().workspace().scale, 3.0);
}

void TestDevice::trialsAreFeltInsteadOfTheScene() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    const Scene before = desk.program.document.scene();
    const auto own = desk.program.window->publisher().world();
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    desk.page(DevicePanel::Page::Trial);
    const auto felt = [&] { return desk.program.window->publisher().world(); };
    const std::pair<const char*, const char*> trials[] = {{"trial-wall-button", "trial-wall"},
                                                          {"trial-friction-button", "trial-friction"},
                                                          {"trial-spring-button", "trial-spring"}};
    for (const auto& [button, id] : trials) {
        desk.click("device-arm");
        desk.click(button);
        QVERIFY(!desk.engine().armed() && !desk.program.command("armed").isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp() && felt()->bodies.size() == 1 && felt() != own,
                                 kPatience);
        QVERIFY(felt()->bodies[0].object != before.objects[0].id);
        QVERIFY(desk.program.command(id).isChecked());
        QVERIFY(desk.text("trial-limits")
                    .startsWith(QStringLiteral("At most 6.0 N, 2.0 N for ever. Stiffness up to")));
        QCOMPARE(desk.program.document.scene(), before);
    }
    // The wall pushes, once the person has armed.
    desk.click("trial-wall-button");
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.desk->place(0.0165, 0, 0);
    desk.program.frames(20);
    QCOMPARE(desk.desk->force.load(), 0.0);
    desk.desk->place(0, 0, 0);
    desk.program.frames(20);
    desk.click("device-arm");
    QVERIFY(desk.fullForce());
    desk.desk->place(0.0165, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->force > 0.3, kPatience);
    QVERIFY(desk.text("trial-state").contains(QStringLiteral("on")));
    desk.click("trial-end-button");
    QVERIFY(!desk.engine().armed());
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp() && felt()->bodies[0].object == before.objects[0].id,
                             kPatience);
    QVERIFY(felt()->bodies[0].mesh == own->bodies[0].mesh); // nothing was built anew
    QCOMPARE(desk.program.document.scene(), before);
    QVERIFY(!desk.program.document.modified() && !desk.program.command("trial-end").isEnabled());
}

void TestDevice::anEditEndsATrial() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.program.command("trial-wall").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.program.type(QStringLiteral("stiffness"), QStringLiteral("345"));
    QVERIFY(!desk.program.command("trial-wall").isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    const auto& world = *desk.program.window->publisher().world();
    QCOMPARE(world.bodies.at(0).object, desk.program.document.scene().objects[0].id);
    QCOMPARE(world.bodies.at(0).materials.at(0).stiffness, 345.0);
}

void TestDevice::theSpringDrawsBackToTheCentre() {
    Desk desk;
    desk.desk->place(0.03, 0.01, 0);
    QVERIFY(desk.connectIt());
    desk.program.command("trial-spring").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.program.command("armed").trigger();
    QVERIFY(desk.fullForce());
    // From outside nothing is felt.
    desk.program.frames(20);
    QCOMPARE(desk.desk->force.load(), 0.0);
    for (int i = 30; i >= 0; --i) {
        desk.desk->place(0.001 * i, i / 3000.0, 0);
        desk.program.frames(1);
    }
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-0.6, 0, 0.8)}) {
        for (int i = 0; i <= 40; ++i) {
            desk.desk->place(1e-3 * i * way.x(), 1e-3 * i * way.y(), 1e-3 * i * way.z());
            desk.program.frames(1);
        }
        // 40 mm of 50 at 6 N times 0.4 / 50 mm: 1.92 N, less what the ball leaves free.
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.desk->force - 1.9) < 0.15, kPatience);
        QVERIFY(desk.engine().servo().force.dot(way) < -1.5);
        for (int i = 40; i >= 0; --i) {
            desk.desk->place(1e-3 * i * way.x(), 1e-3 * i * way.y(), 1e-3 * i * way.z());
            desk.program.frames(1);
        }
    }
}

void TestDevice::theRuleForUsbIsOffered() {
    Desk desk;
    QVERIFY(desk.listed("Example arm"));
    QVERIFY(!desk.widget("device-permit").isVisible());
    desk.catalogue->locked = true;
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-permit").isVisible(), kPatience);
    const QDir share(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/tactum/udev"));
    QVERIFY(share.mkpath(QStringLiteral(".")));
    QFile rule(share.filePath(QStringLiteral("70-tactum.rules")));
    QVERIFY(rule.open(QIODevice::WriteOnly) && rule.write("# nothing\n") > 0);
    rule.close();
    const QByteArray path = qgetenv("PATH");
    // Nobody to ask for consent: the line to be run.
    qputenv("PATH", folder_.path().toLocal8Bit());
    desk.click("device-permit");
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-permit-command").isVisible(), kPatience);
    const QString line = static_cast<QLineEdit&>(desk.widget("device-permit-command")).text();
    QVERIFY2(line.startsWith(QStringLiteral("sudo ")) &&
                 line.contains(QStringLiteral("/etc/udev/rules.d/")) &&
                 line.contains(QFileInfo(rule).canonicalFilePath()),
             qPrintable(line));
    desk.click("device-permit-copy");
    QCOMPARE(QApplication::clipboard()->text(), line);
    // With somebody to ask: told which rule, and believed only when it says yes.
    const auto answer = [&](int code) {
        const QString asker = folder_.filePath(QStringLiteral("pkexec"));
        QFile script(asker);
        if (!script.open(QIODevice::WriteOnly | QIODevice::Truncate)) qFatal("no script");
        script.write("#!/bin/sh\nfor a in \"$@\"; do last=$a; done\necho \"$last\" > '" +
                     folder_.filePath(QStringLiteral("asked")).toLocal8Bit() + "'\nexit " +
                     QByteArray::number(code) + "\n");
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    };
    answer(126);
    desk.click("device-permit");
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("device-permit-sentence").contains(QStringLiteral("did not allow")),
                             kPatience);
    answer(0);
    desk.click("device-permit");
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("notice-text").contains(QStringLiteral("You may use USB devices now")),
                             kPatience);
    QFile asked(folder_.filePath(QStringLiteral("asked")));
    QVERIFY(asked.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromLocal8Bit(asked.readAll()).trimmed(), QFileInfo(rule).canonicalFilePath());
    qputenv("PATH", path);
    rule.remove();
    desk.catalogue->locked = false;
    QTRY_VERIFY_WITH_TIMEOUT(!desk.widget("device-permit").isVisible(), kPatience);
    QVERIFY(!desk.widget("device-permit-command").isVisible());
}

void TestDevice::everythingHasAName() {
    Desk desk;
    desk.catalogue->locked = true;
    QVERIFY(desk.connectIt());
    for (int page = 0; page < 4; ++page) {
        desk.page(DevicePanel::Page(page));
        for (auto* widget : desk.widget("device-panel").findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus || widget->focusProxy())
                continue;
            QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(widget);
            const bool inBox =
                qobject_cast<QLineEdit*>(widget) && qobject_cast<QAbstractSpinBox*>(widget->parentWidget());
            QVERIFY2(
                inBox || (heard && !heard->text(QAccessible::Name).trimmed().isEmpty()),
                qPrintable(widget->objectName() + u' ' + QLatin1String(widget->metaObject()->className())));
        }
    }
}

QTEST_MAIN(TestDevice)
#include "test_device.moc"
