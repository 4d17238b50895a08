// Devices in the window: connecting one step by step, losing it and getting it back.
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <unistd.h>

#include "core/recording/events.h"
#include "core/recording/recording_file.h"
#include "core/safety/inhibit_words.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/device_desk.h"
#include "tests/ui/window/file_dialogs.h"
#include "ui/base/preferences.h"
#include "ui/engine/axis_capture.h"
#include "ui/engine/device_link.h"
#include "ui/engine/device_settings.h"
#include "ui/engine/device_trial.h"
#include "ui/engine/health_words.h"
#include "ui/engine/usb_permission.h"
#include "ui/panels/device_panel.h"
#include "ui/showing/recording_saver.h"
#include "ui/view/scene_view.h"

namespace test_device {

using namespace tactum;

class TestDevice : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { beginDeviceTest(folder_); }

    void withoutACatalogueAllIsAsBefore();
    void theListSaysWhatIsThereAndWhyNot();
    void theListIsMadeAgainEverySecond();
    void everyStepIsShown();
    void aFailingStepIsNamedAndTriedAgain();
    void aDeviceThatDoesNotOpenLeavesTheSimulatedHand();
    void givingUpLeavesTheSimulatedHand();
    void givingUpIsSeenUntilItIsDone();
    void whatAHiddenDockAsksForIsSaid();
    void disconnectingWhileItIsMadeReadyGivesUp();
    void aBrokenDriverIsOpenedAgain_data();
    void aBrokenDriverIsOpenedAgain();
    void closingTheWindowGivesUp();
    void theMouseDoesNotLeadARealDevice();
    void disconnectingGivesItBack();
    void aLostDeviceIsSaidAndComesBackWithoutForce();
    void aLossIsNoticedWithForcesOffToo();
    void aDeviceThatIsOnlyHiddenIsNotLost();
    void anotherDeviceIsFreedFirst();
    void theChoiceIsRemembered();
    void noDeviceGivesMoreThanThePersonPrefers();
    void theRuleForUsbIsOffered();
    void aFileThatADeviceLacksIsChosen();
    void everythingHasAName();
};

void TestDevice::withoutACatalogueAllIsAsBefore() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.engine.armed());
    QVERIFY(!program.window->devices().hasCatalogue());
    QVERIFY(!program.command("device-connect").isEnabled());
    QVERIFY(!program.command("device-disconnect").isEnabled());
    program.window->view().showStandardView(StandardView::Front);
    program.press(program.centre());
    QTRY_VERIFY_WITH_TIMEOUT(program.touch().contacts == 1, kPatience);
}

void TestDevice::theListSaysWhatIsThereAndWhyNot() {
    Desk desk;
    desk.catalogue->locked = true;
    QVERIFY(desk.listed("Locked arm"));
    const QString all = desk.rows().join(u'\n');
    COMPARE_CONTAINS(all, QStringLiteral("Simulated hand \u00b7 in use"));
    COMPARE_CONTAINS(all, QStringLiteral("Locked arm \u00b7 not usable\nAt USB 1-3; you have no permission"));
    desk.chooseRow("Locked arm");
    QVERIFY(!desk.widget("device-connect-button").isEnabled());
    QVERIFY(!desk.program.command("device-connect").isEnabled());
    QCOMPARE(desk.program.command("device-connect").toolTip(),
             QStringLiteral("What is chosen cannot be used; its row says why."));
    QCOMPARE(desk.program.command("device-disconnect").toolTip(), QStringLiteral("No device is connected."));
    QVERIFY(static_cast<QMenu*>(&desk.widget("Device"))->toolTipsVisible());
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
    QVERIFY(desk.widget("device-give-up").isVisible());
    QVERIFY(!desk.widget("device-again").isVisible());
    QCOMPARE(desk.text("device-request"), QString());
    desk.desk->go = 1;
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-request"), QStringLiteral("Push the grip in and out."),
                              kPatience);
    QCOMPARE(steps(), QStringLiteral("Load the firmware done, Find home now, Rest"));
    desk.desk->go = 3;
    QVERIFY(desk.ready());
    QVERIFY(!desk.widget("device-give-up").isVisible());
    QVERIFY(!desk.widget("device-preparing").isVisible());
    // The forces are off until a person arms; the window offers it.
    QCOMPARE(desk.engine().device().name, std::string("Example arm"));
    QVERIFY(!desk.engine().armed());
    QVERIFY(!desk.program.command("armed").isChecked());
    COMPARE_BEGINS(desk.text("notice-text"), QStringLiteral("Example arm is ready. The forces are off"));
    COMPARE_CONTAINS(desk.rows().join(u'\n'), QStringLiteral("Example arm \u00b7 in use"));
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-name"), QStringLiteral("Example arm"), kPatience);
    desk.click("notice-act");
    QVERIFY(desk.engine().armed());
    QVERIFY(desk.program.command("armed").isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("device-state").startsWith(QStringLiteral("forces on")), kPatience);
    desk.click("device-arm");
    QVERIFY(!desk.engine().armed());
    QVERIFY(!desk.program.command("armed").isChecked());
}

void TestDevice::aFailingStepIsNamedAndTriedAgain() {
    Desk desk(true);
    desk.desk->go = 1;
    desk.desk->failAt = 1;
    desk.begin();
    const QString sentence = QStringLiteral("The grip did not move: pull it all the way out.");
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-failure"), sentence, kPatience);
    QCOMPARE(desk.steps(), QStringLiteral("Load the firmware done, Find home failed, Rest"));
    QCOMPARE(desk.text("notice-text"), QStringLiteral("Example arm, step \"Find home\": ") + sentence);
    QCOMPARE(desk.text("device-preparing"), QStringLiteral("Example arm could not be made ready"));
    QVERIFY(desk.engine().running());
    QCOMPARE_EQ(desk.link().current(), kSimulatedDevice);
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
    QVERIFY(desk.engine().running());
    QVERIFY(!desk.engine().armed());
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    QCOMPARE(desk.desk->made.load(), 0);
}

void TestDevice::givingUpLeavesTheSimulatedHand() {
    Desk desk(true);
    desk.begin();
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing, kPatience);
    desk.click("device-give-up");
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-again").isVisible(), kPatience);
    QCOMPARE(desk.text("device-preparing"), QStringLiteral("Example arm: given up"));
    QVERIFY(!desk.desk->preparing);
    QCOMPARE_EQ(desk.desk->made, 0);
    QVERIFY(!desk.widget("device-failure").isVisible()); // nothing failed
    QCOMPARE(desk.link().current(), kSimulatedDevice);
    const int lists = desk.catalogue->lists;
    QTRY_VERIFY_WITH_TIMEOUT(desk.catalogue->lists > lists + 1, kPatience);
    QVERIFY(!desk.link().preparing());
}

void TestDevice::givingUpIsSeenUntilItIsDone() {
    Desk desk;
    desk.desk->stubborn = true;
    desk.begin();
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->preparing && desk.steps().contains(QStringLiteral("now")), kPatience);
    desk.click("device-give-up");
    QCOMPARE(desk.text("device-give-up"), QStringLiteral("Giving up"));
    QVERIFY(!desk.widget("device-give-up").isEnabled());
    desk.desk->stubborn = false;
    QTRY_VERIFY_WITH_TIMEOUT(!desk.link().preparing(), kPatience);
    COMPARE_LACKS(desk.steps(), QStringLiteral("now"));
}

/// As of a device that was remembered and is made ready by itself.
void TestDevice::whatAHiddenDockAsksForIsSaid() {
    Desk desk;
    desk.desk->go = 1;
    desk.begin();
    desk.program.window->findChild<QWidget*>(QStringLiteral("dock-device"))->hide();
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("notice-text").contains(QStringLiteral("Push the grip in and out.")),
                             kPatience);
    desk.click("notice-act");
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-request"), QStringLiteral("Push the grip in and out."),
                              kPatience);
    desk.desk->go = 3;
    QVERIFY(desk.ready());
    COMPARE_LACKS(desk.text("notice-text"), QStringLiteral("Push the grip"));
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

/// No arming helps there: whatever arms opens it again, the message's button among them.
void TestDevice::aBrokenDriverIsOpenedAgain_data() {
    QTest::addColumn<QByteArray>("pressed");
    QTest::newRow("in the message") << QByteArray("notice-act");
    QTest::newRow("in the status line") << QByteArray("arm-again");
    QTest::newRow("in the dock") << QByteArray("device-arm");
}

void TestDevice::aBrokenDriverIsOpenedAgain() {
    QFETCH(const QByteArray, pressed);
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.08);
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
    desk.desk->broken = true;
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("notice-act"), QStringLiteral("Open again"), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("arm-again"), QStringLiteral("Open again"), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-arm"), QStringLiteral("Open again"), kPatience);
    QVERIFY(!desk.engine().armed());
    COMPARE_CONTAINS(desk.text("notice-text"), QStringLiteral("The driver crashed."));
    desk.click(pressed.constData());
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
    QCOMPARE_EQ(desk.program.hand->read().position, before.position);
    QCOMPARE(desk.program.finger().z(), 0.04);
    desk.click("device-disconnect-button");
    desk.program.press(desk.program.centre());
    desk.program.moveTo(desk.program.centre() + QPoint(80, 0));
    desk.program.frames(20);
    desk.program.release(desk.program.centre());
    QCOMPARE_NE(desk.program.finger().z(), 0.04);
}

void TestDevice::disconnectingGivesItBack() {
    Desk desk(true);
    QVERIFY(desk.connectIt());
    QCOMPARE(desk.desk->made.load(), 1);
    desk.engine().setArmed(true);
    desk.program.command("device-disconnect").trigger();
    QCOMPARE(desk.desk->made.load(), 0);
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QVERIFY(desk.engine().running());
    QVERIFY(!desk.engine().armed());
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
    QDir(RecordingSaver::folder()).removeRecursively();
    desk.desk->plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(
        desk.text("notice-text").startsWith(QStringLiteral("Example arm is not there any more")), kPatience);
    QVERIFY(desk.link().lost());
    QVERIFY(!desk.engine().armed());
    QCOMPARE(desk.engine().device().name, std::string("Simulated hand"));
    QCOMPARE(desk.desk->made.load(), 0);
    // The recording of the fault is the one of the device that was lost, and not of the hand that took its
    // place.
    QTRY_COMPARE_WITH_TIMEOUT(QDir(RecordingSaver::folder()).entryList(QDir::Files).size(), 1, kPatience);
    desk.program.frames(20); // it does not push the sentence away
    QVERIFY2(desk.text("notice-text").contains(QStringLiteral("is not there any more")),
             qPrintable(desk.text("notice-text")));
    const QString saved = QDir(RecordingSaver::folder()).entryInfoList(QDir::Files).first().filePath();
    const auto recording = readRecording(saved.toStdString());
    VERIFY_RESULT(recording);
    QCOMPARE(recording->run.device.name, std::string("Example arm"));
    // It was away before its silence had become a fault.
    const QString silent = QString::fromUtf8(inhibitWords(InhibitReason::Stall).brief);
    QVERIFY(std::ranges::any_of(eventsOf(recording->run), [&](const RecordedEvent& event) {
        return event.fault || QString::fromStdString(event.text).contains(silent, Qt::CaseInsensitive);
    }));
    desk.engine().setArmed(true); // the simulated hand meanwhile
    desk.desk->plugged = true;
    QVERIFY(desk.ready());
    QCOMPARE(desk.desk->prepared.load(), 2);
    QVERIFY(!desk.link().lost());
    QVERIFY(!desk.engine().armed());
    QVERIFY(!desk.program.command("armed").isChecked());
    COMPARE_BEGINS(desk.text("notice-text"), QStringLiteral("Example arm is there and ready"));
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
        Desk desk(true);
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

/// Whatever hand comes: the device's own limit is 6 N.
void TestDevice::noDeviceGivesMoreThanThePersonPrefers() {
    Preferences::instance().set(Preferred::LargestForce, 2.5);
    {
        Desk desk;
        QVERIFY(desk.connectIt());
        QCOMPARE(desk.engine().device().maxForce, 2.5);
        desk.click("device-disconnect-button"); // the simulated hand comes back, for which the same holds
        QTRY_COMPARE_WITH_TIMEOUT(desk.link().current(), kSimulatedDevice, kPatience);
        QCOMPARE(desk.engine().device().maxForce, 2.5);
    }
    Preferences::instance().set(Preferred::LargestForce, 0);
    Desk desk;
    QVERIFY(desk.connectIt());
    QCOMPARE(desk.engine().device().maxForce, 6.0);
}

void TestDevice::theRuleForUsbIsOffered() {
    // Whatever kind of thing the rule names has to be looked at anew: serial ports as well.
    QFile shipped(QStringLiteral(TACTUM_RESOURCES "/udev/70-tactum.rules"));
    QVERIFY(shipped.open(QIODevice::ReadOnly));
    QStringList kinds;
    static const QRegularExpression kKind(QStringLiteral("SUBSYSTEM==\"(\\w+)\""));
    for (const auto& found : kKind.globalMatch(QString::fromUtf8(shipped.readAll())))
        kinds.append(found.captured(1));
    QVERIFY2(kinds.contains(QStringLiteral("tty")), qPrintable(kinds.join(u' ')));
    Desk desk;
    QVERIFY(desk.listed("Example arm"));
    QVERIFY(!desk.widget("device-permit").isVisible());
    desk.catalogue->locked = true;
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-permit").isVisible(), kPatience);
    const QDir share(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/tactum/udev"));
    QVERIFY(share.mkpath(QStringLiteral(".")));
    QFile rule(share.filePath(QStringLiteral("70-tactum.rules")));
    QVERIFY(rule.open(QIODevice::WriteOnly));
    QCOMPARE_GT(rule.write("# nothing\n"), 0);
    rule.close();
    const QByteArray path = qgetenv("PATH");
    // Nobody to ask for consent: the line to be run.
    qputenv("PATH", folder_.path().toLocal8Bit());
    desk.click("device-permit");
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("device-permit-command").isVisible(), kPatience);
    const QString line = static_cast<QLineEdit&>(desk.widget("device-permit-command")).text();
    QVERIFY2(line.startsWith(QStringLiteral("sudo ")) &&
                 line.contains(QStringLiteral("/etc/udev/rules.d/")) &&
                 line.contains(QStringLiteral("/etc/security/limits.d/tactum-%1.conf").arg(geteuid())) &&
                 line.contains(QFileInfo(rule).canonicalFilePath()),
             qPrintable(line));
    for (const QString& kind : kinds)
        QVERIFY2(line.contains(QStringLiteral("--subsystem-match=") + kind), qPrintable(kind));
    desk.click("device-permit-copy");
    QCOMPARE(QApplication::clipboard()->text(), line);
    // With somebody to ask: told which rule, and believed only when it says yes.
    const auto answer = [&](int code) {
        const QString asker = folder_.filePath(QStringLiteral("pkexec"));
        QFile script(asker);
        if (!script.open(QIODevice::WriteOnly | QIODevice::Truncate)) qFatal("no script");
        script.write("#!/bin/sh\necho \"$5\" > '" + folder_.filePath(QStringLiteral("asked")).toLocal8Bit() +
                     "'\nexit " + QByteArray::number(code) + "\n");
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

void TestDevice::aFileThatADeviceLacksIsChosen() {
    Desk desk;
    QVERIFY(desk.listed("Example arm"));
    QVERIFY(!desk.widget("device-supply").isVisible());
    desk.catalogue->lacking = true;
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-supply"), QStringLiteral("Choose firmware..."), kPatience);
    desk.desk->failAt = 0; // without it
    desk.begin();
    QTRY_COMPARE_WITH_TIMEOUT(desk.link().preparation().state, Preparation::State::Failed, kPatience);
    const auto answer = [&](const char* name) {
        answerFileDialog(writeFile(folder_, QString::fromLatin1(name), "bytes"));
        desk.click("device-supply");
    };
    answer("readme.txt");
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("notice-text").contains(QStringLiteral("no firmware")), kPatience);
    QVERIFY(desk.widget("device-supply").isVisible());
    desk.desk->failAt = -1;
    desk.desk->go = 3;
    QSignalSpy kept(&desk.link(), &DeviceLink::supplied);
    answer("nvent.bin");
    QTRY_COMPARE_WITH_TIMEOUT(kept.count(), 1, kPatience);
    COMPARE_CONTAINS(kept.front().front().toString(), QStringLiteral("nvent.bin is kept"));
    QVERIFY(desk.ready()); // by itself: the file was what failed
    QTRY_VERIFY_WITH_TIMEOUT(!desk.widget("device-supply").isVisible(), kPatience);
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

TACTUM_GUI_TEST(TestDevice)

} // namespace test_device

#include "test_device.moc"
