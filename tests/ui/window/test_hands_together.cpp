// Two devices in the window: added and removed, felt, stopped together, and lost one by one.
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/drawn_hand.h"
#include "tests/ui/window/two_arms.h"
#include "ui/base/hand_colours.h"
#include "ui/controllers/command_reasons.h"
#include "ui/showing/playback.h"
#include "ui/showing/recording_saver.h"
#include "ui/view/scene_view.h"

namespace test_hands_together {

using namespace tactum;

namespace {

/// The keys of hands: H with these.
void pressH(TwoArms& two, Qt::KeyboardModifiers with) {
    QTest::keyClick(&two.program().window->view(), Qt::Key_H, with);
}

bool isDrawn(TouchedWindow& program, std::size_t hand) {
    return tactum::isDrawn(program.window->view(), hand);
}

} // namespace

class TestHandsTogether : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { beginDeviceTest(folder_); }

    void aSecondDeviceIsAddedAndRemoved();
    void eachForceArrivesAtItsDevice();
    void theChosenHandIsShown();
    void oneIsUnpluggedWhileTheOtherHolds_data();
    void oneIsUnpluggedWhileTheOtherHolds();
    void whatIsLostWithoutForceGoesAtOnce();
    void theSimulatedHandBesideADevice();
    void whatDoesNotStartLeavesTheFirst();
    void aSecondOneThatFailedIsOpenedAgain();
    void bothAreDrawn();
    void aRecordingHoldsBoth();
    void handsHaveKeys();
    void commandsSayWhyTheyCannot();
};

void TestHandsTogether::aSecondDeviceIsAddedAndRemoved() {
    TwoArms two(folder_);
    Desk& desk = two.desk;
    desk.chooseRow("Simulated hand"); // the first has it
    QVERIFY(!desk.widget("device-add-button").isEnabled());
    QVERIFY(desk.connectIt());
    QVERIFY(!desk.widget("hand-list").isVisible());
    QVERIFY(!desk.widget("device-add-button").isEnabled()); // it is chosen and in use
    QVERIFY(two.addOther());
    COMPARE_BEGINS(desk.text("notice-text"), QStringLiteral("Other arm is ready. The forces are off"));
    QCOMPARE(two.engine().hand(0).device().name, std::string("Example arm"));
    QCOMPARE(two.engine().hand(1).device().name, std::string("Other arm"));
    QCOMPARE(desk.link().current(), kFake);
    QCOMPARE(desk.link().idOf(1), kOther);
    COMPARE_CONTAINS(desk.rows().join(u'\n'), QStringLiteral("Other arm \u00b7 in use"));
    QVERIFY(!desk.widget("device-add-button").isEnabled());
    QVERIFY(!desk.widget("device-connect-button").isEnabled());
    const auto row = [&](const char* name) {
        return static_cast<QAbstractButton&>(desk.widget(name)).text();
    };
    QTRY_VERIFY_WITH_TIMEOUT(desk.widget("hand-list").isVisible(), kPatience);
    QCOMPARE(row("hand-0"), QStringLiteral("Example arm \u00b7 forces off"));
    QCOMPARE(row("hand-1"), QStringLiteral("Other arm \u00b7 forces off"));
    desk.click("notice-act"); // Arm
    QTRY_COMPARE_WITH_TIMEOUT(row("hand-1"), QStringLiteral("Other arm \u00b7 forces on"), kPatience);
    QVERIFY(two.engine().hand(0).armed());
    desk.click("hand-remove-1");
    QCOMPARE(two.engine().hands(), std::size_t(1));
    QVERIFY(!two.program().command("armed").isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.widget("hand-list").isVisible(), kPatience);
    QCOMPARE(two.other->made, 0);
    QCOMPARE(desk.link().current(), kFake);
}

void TestHandsTogether::eachForceArrivesAtItsDevice() {
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    QVERIFY(two.press());
    QVERIFY(two.program().command("stop").isEnabled());
    two.desk.click("stop");
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.desk->force == 0 && two.other->force == 0, kPatience);
    QVERIFY(!two.program().command("armed").isChecked());
    QVERIFY(!two.program().command("stop").isEnabled());
    QVERIFY(two.press());
    two.desk.click("device-arm");
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.desk->force == 0 && two.other->force == 0, kPatience);
}

void TestHandsTogether::theChosenHandIsShown() {
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    QVERIFY(two.press());
    const auto status = [&] { return two.desk.text("status-device"); };
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith(QStringLiteral("Example arm")), kPatience);
    two.desk.click("hand-1");
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith(QStringLiteral("Other arm")), kPatience);
    QCOMPARE(two.desk.text("device-name"), QStringLiteral("Other arm"));
    COMPARE_NEAR(two.engine().servo().force.norm(), 2 * TwoArms::kForce, 0.02, "N");
    // Its settings are its own, and so is their memory.
    two.desk.page(DevicePanel::Page::Live);
    two.desk.pick("device-stop-button", 2);
    QCOMPARE(two.desk.link().stop(1).buttons.load(), std::uint32_t(2));
    QCOMPARE(two.desk.link().stop(0).buttons.load(), std::uint32_t(0));
    two.desk.click("hand-0");
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith(QStringLiteral("Example arm")), kPatience);
    // The button of either stops both.
    two.other->buttons = 2;
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.desk->force == 0 && two.other->force == 0, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!two.program().command("armed").isChecked(), kPatience);
}

void TestHandsTogether::oneIsUnpluggedWhileTheOtherHolds_data() {
    QTest::addColumn<int>("lost");
    QTest::newRow("the first") << 0;
    QTest::newRow("the second") << 1;
}

void TestHandsTogether::oneIsUnpluggedWhileTheOtherHolds() {
    QFETCH(int, lost);
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    QVERIFY(two.press());
    FakeDesk& gone = lost == 0 ? *two.desk.desk : *two.other;
    FakeDesk& there = lost == 0 ? *two.other : *two.desk.desk;
    const std::size_t other = 1 - std::size_t(lost);
    gone.plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.link().gone(std::size_t(lost)), kPatience);
    COMPARE_CONTAINS(two.desk.text("notice-text"), QStringLiteral("the other hand goes on"));
    QVERIFY(two.holds(there, other, lost == 0 ? 2 * TwoArms::kForce : TwoArms::kForce));
    QCOMPARE(gone.force.load(), 0.0);
    QVERIFY(two.program().command("stop").isEnabled());
    QCOMPARE(two.engine().hands(), std::size_t(2));
    two.desk.click("stop");
    QTRY_VERIFY_WITH_TIMEOUT(gone.made == 0, kPatience);
    QCOMPARE(there.force.load(), 0.0);
    // The first has a hand always, led by the mouse meanwhile; a second goes.
    QCOMPARE(two.engine().hands(), std::size_t(lost == 0 ? 2 : 1));
    QCOMPARE(two.desk.link().current(), lost == 0 ? kSimulatedDevice : kFake);
    if (lost != 0) return;
    gone.plugged = true;
    QVERIFY(two.desk.ready());
    QCOMPARE(two.engine().hands(), std::size_t(2));
    QVERIFY(two.press());
}

void TestHandsTogether::whatIsLostWithoutForceGoesAtOnce() {
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    two.other->plugged = false;
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(1), kPatience);
    COMPARE_CONTAINS(two.desk.text("notice-text"), QStringLiteral("its hand went with it"));
    QCOMPARE(two.desk.link().current(), kFake);
    QVERIFY(two.engine().running());
}

/// Anybody may try it with one device.
void TestHandsTogether::theSimulatedHandBesideADevice() {
    TwoArms two(folder_);
    QVERIFY(two.desk.connectIt());
    two.desk.chooseRow("Simulated hand");
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.widget("device-add-button").isEnabled(), kPatience);
    two.desk.click("device-add-button");
    QCOMPARE(two.engine().hands(), std::size_t(2));
    QCOMPARE(two.desk.link().simulatedHand().value_or(0), std::size_t(1));
    two.program().window->view().showStandardView(StandardView::Front);
    two.program().command("armed").trigger();
    two.program().press(two.program().centre());
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hand(1).touch().output.contacts, 1, kPatience);
    QCOMPARE(two.engine().hand(0).touch().output.contacts, 0);
    two.program().release(two.program().centre());
    // Disconnecting the device leaves one simulated hand, not two.
    two.program().command("device-disconnect").trigger();
    QCOMPARE(two.engine().hands(), std::size_t(1));
    QCOMPARE(two.desk.link().current(), kSimulatedDevice);
    QVERIFY(two.engine().running());
}

void TestHandsTogether::whatDoesNotStartLeavesTheFirst() {
    TwoArms two(folder_);
    QVERIFY(two.desk.connectIt());
    two.other->failOpen = true;
    two.askForOther();
    QTRY_COMPARE_WITH_TIMEOUT(two.desk.link().preparation().state, Preparation::State::Failed, kPatience);
    COMPARE_CONTAINS(two.desk.text("notice-text"), QStringLiteral("The arm did not wake"));
    QCOMPARE(two.engine().hands(), std::size_t(1));
    QCOMPARE(two.desk.link().current(), kFake);
    QVERIFY(two.engine().running());
    two.other->failOpen = false;
    two.desk.click("device-again");
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(2), kPatience);
}

void TestHandsTogether::aSecondOneThatFailedIsOpenedAgain() {
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    QVERIFY(two.press());
    two.desk.chooseRow("Other arm");
    QVERIFY(!two.desk.widget("device-connect-button").isEnabled());
    two.other->broken = true;
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.widget("device-connect-button").isEnabled(), kPatience);
    two.desk.click("device-connect-button");
    QTRY_COMPARE_WITH_TIMEOUT(two.other->prepared, 2, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(2), kPatience);
    QCOMPARE(two.engine().hand(1).trouble(), std::string());
    QVERIFY(two.press());
}

void TestHandsTogether::bothAreDrawn() {
    TwoArms two(folder_);
    QVERIFY(two.desk.connectIt());
    QVERIFY(!isDrawn(two.program(), 1));
    const int before = two.program().window->view().actorCount();
    QVERIFY(two.addOther());
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(two.program(), 1), kPatience);
    QVERIFY(isDrawn(two.program(), 0));
    two.program().command("overlay").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn(two.program(), 1), kPatience);
    two.program().command("overlay").trigger();
    two.desk.click("hand-1"); // the same colours whoever is chosen
    two.program().frames(5);
    QVERIFY(isDrawn(two.program(), 0));
    QVERIFY(isDrawn(two.program(), 1));
    two.desk.click("hand-remove-1");
    QTRY_COMPARE_WITH_TIMEOUT(two.program().window->view().actorCount(), before, kPatience);
    QVERIFY(!isDrawn(two.program(), 1));
}

void TestHandsTogether::aRecordingHoldsBoth() {
    TwoArms two(folder_);
    QVERIFY(two.bothAreThere());
    QVERIFY(two.press());
    auto* saver = two.program().window->findChild<RecordingSaver*>();
    const RecordingSaver::Taken taken = saver->take(QStringLiteral("a test wanted it"));
    QVERIFY(taken);
    QCOMPARE(taken->run.hands(), std::size_t(2));
    const QString file = folder_.filePath(QStringLiteral("both.tactum-recording"));
    saver->save(file, taken);
    QVERIFY(test::waitFor([&] { return !saver->saving() && QFile::exists(file); }));
    two.desk.click("hand-remove-1"); // what is played does not need it
    two.program().window->open(file);
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.widget("playback").isVisible(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(two.program(), 1), kPatience);
    COMPARE_CONTAINS(two.desk.widget("playback-event").toolTip(), QStringLiteral("those of Example arm"));
    // Its end, where both press; the hand is chosen by its key or in the bar.
    auto* playback = two.program().window->findChild<Playback*>();
    playback->seek(1e9, true);
    const auto force = [&] { return playback->player().servo(playback->hand()).force.norm(); };
    COMPARE_NEAR(force(), TwoArms::kForce, 0.02 * TwoArms::kForce, "N");
    pressH(two, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(playback->hand(), std::size_t(1), kPatience);
    COMPARE_NEAR(force(), 2 * TwoArms::kForce, 0.04 * TwoArms::kForce, "N");
    COMPARE_NEAR(playback->player().proxy().output.force.norm(), 2 * TwoArms::kForce, 0.04 * TwoArms::kForce,
                 "N");
    const auto status = [&] { return two.desk.text("status-device"); };
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith(QStringLiteral("Other arm")), kPatience);
    QVERIFY(isDrawn(two.program(), 0) && isDrawn(two.program(), 1));
    two.desk.pick("playback-hand", 0);
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith(QStringLiteral("Example arm")), kPatience);
    two.desk.click("playback-back");
    QTRY_VERIFY_WITH_TIMEOUT(!isDrawn(two.program(), 1), kPatience);
}

void TestHandsTogether::handsHaveKeys() {
    TwoArms two(folder_);
    QVERIFY(two.desk.connectIt());
    two.other->go = 3;
    two.desk.chooseRow("Other arm");
    pressH(two, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(test::waitFor([&] { return two.engine().hands() == 2 && !two.desk.link().preparing(); }));
    pressH(two, Qt::ControlModifier);
    QCOMPARE(two.desk.link().hands().chosen(), std::size_t(1));
    pressH(two, Qt::ControlModifier);
    QCOMPARE(two.desk.link().hands().chosen(), std::size_t(0));
    pressH(two, Qt::ControlModifier | Qt::AltModifier); // the first stays
    QCOMPARE(two.engine().hands(), std::size_t(2));
    pressH(two, Qt::ControlModifier);
    pressH(two, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(two.engine().hands(), std::size_t(1));
    QCOMPARE(two.desk.link().current(), kFake);
}

void TestHandsTogether::commandsSayWhyTheyCannot() {
    TwoArms two(folder_);
    QVERIFY(two.desk.connectIt());
    const auto off = [&](const char* command) {
        return two.program().command(command).isEnabled() ? QString()
                                                          : whyOff(QString::fromLatin1(command), false);
    };
    const auto& add = two.program().command("hand-add");
    const QString taken = QStringLiteral("A hand has this device already.");
    QVERIFY(!add.isEnabled()); // it is the first's
    COMPARE_CONTAINS(add.toolTip(), taken);
    COMPARE_BEGINS(off("hand-next"), QStringLiteral("There is one hand"));
    COMPARE_BEGINS(off("hand-remove"), QStringLiteral("The first hand is chosen"));
    two.desk.chooseRow("Other arm");
    QVERIFY(add.isEnabled());
    QVERIFY(two.addOther());
    COMPARE_CONTAINS(add.toolTip(), taken);
    QCOMPARE(off("hand-next"), QString());
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.widget("hand-list").isVisible(), kPatience);
    two.desk.click("hand-1");
    QCOMPARE(off("hand-remove"), QString());
}

TACTUM_GUI_TEST(TestHandsTogether)

} // namespace test_hands_together

#include "test_hands_together.moc"
