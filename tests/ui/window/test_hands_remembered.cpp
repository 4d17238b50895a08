// Which devices were hands is known at the next start: they come back, and what is missing is said.
//
// Each TwoArms is a start of the program, with the settings that the one before left.
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/two_arms.h"

namespace test_hands_remembered {

using namespace tactum;

class TestHandsRemembered : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        beginDeviceTest(folder_);
        TwoArms two(folder_);
        QVERIFY(two.bothAreThere());
    }

    void bothAreThereAfterAStart();
    void whatIsMissingIsSaid();
    void whatWasRemovedStaysAway();
    void theSimulatedHandComesBackBesideItsDevice();
    void whatIsLostComesBack();
    void whatFailsIsNotTriedWithoutEnd();
    void nobodyLosesForceToWhatComesBack();
};

namespace {

bool areBothThere(TwoArms& two) {
    return test::waitFor([&] {
        return two.engine().hands() == 2 && two.desk.link().current() == kFake &&
               two.desk.link().idOf(1) == kOther && !two.desk.link().preparing() &&
               two.program().window->findChild<QWidget*>(QStringLiteral("hand-remove-1")); // and shown
    });
}

/// The devices do what they are asked to.
void letThemStart(TwoArms& two) {
    two.desk.desk->go = 3;
    two.other->go = 3;
}

} // namespace

void TestHandsRemembered::bothAreThereAfterAStart() {
    TwoArms two(folder_);
    letThemStart(two);
    QVERIFY(areBothThere(two));
    QVERIFY(!two.engine().hand(0).armed() && !two.engine().hand(1).armed());
    QVERIFY(!two.desk.text("notice-text").startsWith(QStringLiteral("Not there")));
    QVERIFY(two.press());
}

void TestHandsRemembered::whatIsMissingIsSaid() {
    TwoArms two(folder_, false);
    QTRY_VERIFY_WITH_TIMEOUT(
        two.desk.text("notice-text").startsWith(QStringLiteral("Not there since last time: Other arm.")),
        kPatience);
    letThemStart(two);
    QVERIFY(two.desk.ready());
    QCOMPARE(two.engine().hands(), std::size_t(1));
    two.other->plugged = true;
    QVERIFY(areBothThere(two));
}

void TestHandsRemembered::whatWasRemovedStaysAway() {
    {
        TwoArms two(folder_);
        letThemStart(two);
        QVERIFY(areBothThere(two));
        two.desk.click("hand-remove-1");
    }
    TwoArms two(folder_);
    letThemStart(two);
    QVERIFY(two.desk.ready());
    const int lists = two.desk.catalogue->lists;
    QVERIFY(test::waitFor([&] { return two.desk.catalogue->lists > lists + 1; }));
    QCOMPARE(two.engine().hands(), std::size_t(1));
    QVERIFY(!two.desk.link().preparing());
}

void TestHandsRemembered::theSimulatedHandComesBackBesideItsDevice() {
    {
        TwoArms two(folder_);
        letThemStart(two);
        QVERIFY(areBothThere(two));
        two.desk.click("hand-remove-1");
        two.desk.chooseRow("Simulated hand");
        QTRY_VERIFY_WITH_TIMEOUT(two.desk.widget("device-add-button").isEnabled(), kPatience);
        two.desk.click("device-add-button");
        QCOMPARE(two.engine().hands(), std::size_t(2));
    }
    TwoArms two(folder_);
    letThemStart(two);
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(2), kPatience);
    QCOMPARE(two.desk.link().current(), kFake);
    QCOMPARE(two.desk.link().simulatedHand().value_or(0), std::size_t(1));
}

void TestHandsRemembered::whatIsLostComesBack() {
    TwoArms two(folder_);
    letThemStart(two);
    QVERIFY(areBothThere(two));
    two.other->plugged = false;
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(1), kPatience);
    two.other->plugged = true;
    QVERIFY(areBothThere(two));
}

// The test is wrong if nothing is listed meanwhile: then nobody could have tried again.
void TestHandsRemembered::whatFailsIsNotTriedWithoutEnd() {
    TwoArms two(folder_);
    int failures = 0;
    connect(&two.desk.link(), &DeviceLink::failed, this, [&failures] { ++failures; });
    two.other->failAt = 0;
    two.desk.desk->go = 3;
    QTRY_COMPARE_WITH_TIMEOUT(failures, 1, kPatience);
    const int lists = two.desk.catalogue->lists;
    QVERIFY(test::waitFor([&] { return two.desk.catalogue->lists > lists + 3; }));
    QCOMPARE(failures, 1);
    QCOMPARE(two.engine().hands(), std::size_t(1));
    two.other->plugged = false; // pulled out and plugged in again it is
    QTRY_VERIFY_WITH_TIMEOUT(!two.desk.link().find(kOther), kPatience);
    two.other->failAt = -1;
    two.other->go = 3;
    two.other->plugged = true;
    QVERIFY(areBothThere(two));
}

void TestHandsRemembered::nobodyLosesForceToWhatComesBack() {
    TwoArms two(folder_);
    letThemStart(two);
    QVERIFY(areBothThere(two));
    QVERIFY(two.press());
    two.other->plugged = false;
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.link().gone(1), kPatience);
    two.desk.click("stop");
    QTRY_COMPARE_WITH_TIMEOUT(two.engine().hands(), std::size_t(1), kPatience);
    two.program().command("armed").trigger();
    QVERIFY(two.holds(*two.desk.desk, 0, TwoArms::kForce));
    two.other->plugged = true;
    QTRY_VERIFY_WITH_TIMEOUT(two.desk.link().preparation().request.startsWith(QStringLiteral("It is ready")),
                             kPatience);
    QVERIFY(two.holds(*two.desk.desk, 0, TwoArms::kForce));
    QCOMPARE(two.engine().hands(), std::size_t(1));
    two.desk.click("stop");
    QVERIFY(areBothThere(two));
}

TACTUM_GUI_TEST(TestHandsRemembered)

} // namespace test_hands_remembered

#include "test_hands_remembered.moc"
