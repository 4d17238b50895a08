// WoodenHaptics, the driver, against an emulated one under the real libusb.
#include <QTest>
#include <sys/wait.h>
#include <unistd.h>

#include "device/wooden_haptics/wooden_haptics.h"
#include "tests/device/wooden_haptics/emulated_wooden_haptics.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_wooden_haptics {

using namespace tactum;
using namespace tactum::test;

namespace {

const DeviceInfo kProfile{
    .name = "WoodenHaptics", .maxForce = 5, .maxStiffness = 1000, .workspaceRadius = 0.1, .real = true};
constexpr double kTick = 1e-3;
const Vec3 kNoForce = Vec3::Zero();

/// Where the arm lay when it got power: its counts are not 0 in the rest position.
const Vec3 kPowerOn(0.3, 0.5, 0.4);

/// Moves the arm to the rest position while the driver waits for it. `cancelled()` is asked once a report.
class Person final : public Opening {
public:
    explicit Person(EmulatedWoodenHaptics& arm) : arm_(arm) {}

    void begin(std::string_view step, std::string_view request) override {
        begun.emplace_back(step);
        asked = asked || !request.empty();
    }
    void progress(double part) override { done = std::max(done, part); }
    bool cancelled() const override {
        ++time_;
        if (moves) arm_.hold(time_ < 500 ? Vec3(kPowerOn * (1 - time_ / 500.0)) : Vec3(Vec3::Zero()));
        if (speaks) arm_.tick();
        return time_ > patience;
    }

    bool moves = true, speaks = true;
    int patience = 10'000;
    std::vector<std::string> begun;
    bool asked = false;
    double done = 0;

private:
    EmulatedWoodenHaptics& arm_;
    mutable int time_ = 0;
};

} // namespace

class TestWoodenHaptics : public QObject {
    Q_OBJECT

private:
    std::shared_ptr<EmulatedWoodenHaptics> arm_;
    std::unique_ptr<WoodenHaptics> device_;

    void prepare() {
        Person person(*arm_);
        const auto ready = device_->prepare(person);
        VERIFY_RESULT(ready);
    }
    /// Ready, open, and the finger at `position`.
    void openAt(const Vec3& position) {
        prepare();
        QVERIFY(device_->open().has_value());
        arm_->hold(*jointsAt(arm_->arm, position));
        DeviceSample sample;
        for (int i = 0; i < 5; ++i)
            sample = exchange(kNoForce);
        QVERIFY(sample.valid);
        COMPARE_NEAR(sample.position, position, 1e-4, "m");
    }
    DeviceSample exchange(const Vec3& force) {
        arm_->tick();
        return device_->exchange({force}, kTick);
    }
    bool motorsRest() const {
        return arm_->milliamperes(0) == 0 && arm_->milliamperes(1) == 0 && arm_->milliamperes(2) == 0;
    }

private slots:
    void init() {
        arm_ = std::make_shared<EmulatedWoodenHaptics>();
        arm_->hold(kPowerOn);
        arm_->restart();
        EmulatedBus::the().plug(1, arm_);
        const UsbId wanted[] = {kWoodenHapticsId};
        device_ = std::make_unique<WoodenHaptics>(listUsb(wanted).value().at(0), kProfile);
    }
    void cleanup() {
        device_.reset();
        EmulatedBus::the().unplugAll();
        QCOMPARE(EmulatedBus::the().openDescriptors(), 0);
        QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
    }

    void asksForTheRestPosition() {
        Person person(*arm_);
        VERIFY_RESULT(device_->prepare(person));
        QVERIFY(person.begun == device_->steps());
        QVERIFY(person.asked);
        QCOMPARE(person.done, 1.0);
        QVERIFY(motorsRest());
        // It is ready now, and asks no second time.
        Person again(*arm_);
        again.patience = 0;
        VERIFY_RESULT(device_->prepare(again));
        QVERIFY(again.begun.empty());
    }

    void doesNotTakeAnArmThatNobodyMovedForOneAtRest() {
        Person person(*arm_);
        person.moves = false;
        const auto ready = device_->prepare(person);
        QVERIFY(!ready);
        COMPARE_CONTAINS(ready.error().text, "hand");
    }

    void doesNotOpenWithoutIt() {
        const auto opened = device_->open();
        QVERIFY(!opened);
        COMPARE_CONTAINS(opened.error().text, "rest position");
        prepare();
        QVERIFY(device_->open().has_value());
        device_->close();
        QVERIFY(device_->open().has_value()); // what it knows stays
    }

    void saysWhenTheBoardIsSilent() {
        Person person(*arm_);
        person.speaks = false;
        const auto ready = device_->prepare(person);
        QVERIFY(!ready);
        COMPARE_CONTAINS(ready.error().text, "nothing");
    }

    void tellsWhereTheFingerIs() {
        openAt({0, 0, 0});
        for (const Vec3& p :
             {Vec3(0.05, 0, 0), Vec3(0, 0.06, 0), Vec3(0, 0, -0.07), Vec3(-0.04, -0.03, 0.05)}) {
            arm_->hold(*jointsAt(arm_->arm, p));
            exchange(kNoForce);
            const DeviceSample sample = exchange(kNoForce);
            QVERIFY(sample.valid);
            QVERIFY2((sample.position - p).norm() < 1e-4, "one count is less than 0.05 mm");
        }
    }

    void pushesWithTheForce() {
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.06, 0.02, -0.03), Vec3(-0.03, -0.06, 0.05)}) {
            init();
            openAt(p);
            for (const Vec3& force : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, 0.5, 0.7)}) {
                exchange(force);
                exchange(force);
                QVERIFY2((arm_->motorForce() - force).norm() < 0.02 * force.norm(), "more than 2 % off");
            }
        }
    }

    void scalesDownWhatTheMotorsCannot() {
        openAt({0.02, 0.01, 0});
        const Vec3 force(30, 20, -10);
        exchange(force);
        exchange(force);
        const Vec3 felt = arm_->motorForce();
        QCOMPARE_LT(felt.norm(), force.norm());
        QCOMPARE_GT(felt.normalized().dot(force.normalized()), 0.9998);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE_LE(std::abs(arm_->milliamperes(i)), 2000);
        exchange(Vec3::Constant(std::nan("")));
        exchange(Vec3::Constant(std::nan("")));
        QVERIFY(motorsRest());
    }

    void aSpringHoldsAsStiffAsItIs_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::newRow("right") << 3.0 << 0.0 << 0.0;
        QTest::newRow("up") << 0.0 << 3.0 << 0.0;
        QTest::newRow("out") << 0.0 << 0.0 << 3.0;
        QTest::newRow("aslant") << -1.5 << -2.0 << 1.5;
    }
    void aSpringHoldsAsStiffAsItIs() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        constexpr double kStiffness = 200; // N/m
        openAt({0, 0, 0});
        arm_->letGo();
        arm_->handForce = {x, y, z};
        Vec3 force = Vec3::Zero();
        for (int tick = 0; tick < 3000; ++tick)
            force = -kStiffness * exchange(force).position;
        const Vec3 expected = arm_->handForce / kStiffness;
        QVERIFY2((arm_->finger() - expected).norm() < 0.02 * expected.norm(),
                 qPrintable(QString("off by %1 mm").arg(1e3 * (arm_->finger() - expected).norm())));
        QVERIFY(device_->trouble().empty());
    }

    void aTickWithoutAReportIsNotValidAndKeepsTheForce() {
        openAt({0, 0, 0});
        exchange({1, 0, 0});
        exchange({1, 0, 0});
        const int before = arm_->milliamperes(0);
        QCOMPARE_NE(before, 0);
        QVERIFY(!device_->exchange({Vec3(1, 0, 0)}, kTick).valid);
        QCOMPARE(arm_->milliamperes(0), before);
        QVERIFY(exchange({1, 0, 0}).valid || exchange({1, 0, 0}).valid);
    }

    void silenceTakesTheForceAway() {
        openAt({0, 0, 0});
        for (int i = 0; i < 3; ++i)
            exchange({2, 0, 0});
        for (int i = 0; i < 12; ++i)
            device_->exchange({Vec3(2, 0, 0)}, kTick);
        QVERIFY(motorsRest());
        for (int i = 0; i < 60; ++i)
            device_->exchange({Vec3(2, 0, 0)}, kTick);
        COMPARE_CONTAINS(device_->trouble(), "nothing");
        for (int i = 0; i < 3; ++i)
            exchange({2, 0, 0});
        QVERIFY(device_->trouble().empty());
        QVERIFY(!motorsRest());
    }

    void aFrozenCounterIsNoReading() {
        openAt({0, 0, 0});
        arm_->frozen = true;
        for (int i = 0; i < 5; ++i)
            exchange({2, 0, 0}); // what was under way
        for (int i = 0; i < 60; ++i)
            QVERIFY(!exchange({2, 0, 0}).valid);
        QVERIFY(motorsRest());
        COMPARE_CONTAINS(device_->trouble(), "hangs");
    }

    void aJumpingCounterMeansThatItStartedAnew() {
        openAt({0, 0, 0});
        for (int i = 0; i < 200; ++i)
            exchange({2, 0, 0});
        arm_->restart();
        for (int i = 0; i < 5; ++i)
            exchange({2, 0, 0});
        for (int i = 0; i < 300; ++i)
            QVERIFY(!exchange({2, 0, 0}).valid); // also when it counts on
        QVERIFY(motorsRest());
        COMPARE_CONTAINS(device_->trouble(), "Prepare it again");
        device_->close();
        QVERIFY(!device_->open());
        prepare();
        QVERIFY(device_->open().has_value());
        exchange(kNoForce);
        QVERIFY(exchange(kNoForce).valid);
        QVERIFY(device_->trouble().empty());
    }

    void lostReportsAreNoJump() {
        openAt({0, 0, 0});
        for (int lost = 0; lost < 60; ++lost)
            arm_->tick(); // the board keeps four of them
        exchange(kNoForce);
        QVERIFY(exchange(kNoForce).valid);
        QVERIFY(device_->trouble().empty());
    }

    void reportsOfAnotherLengthAreNone() {
        openAt({0, 0, 0});
        for (const std::size_t size : {6u, 14u}) {
            arm_->reportSize = size;
            for (int i = 0; i < 5; ++i)
                exchange(kNoForce);
            for (int i = 0; i < 20; ++i)
                QVERIFY(!exchange({2, 0, 0}).valid);
            QVERIFY(motorsRest());
        }
    }

    void unpluggedMeansGone() {
        openAt({0, 0, 0});
        exchange({1, 0, 0});
        EmulatedBus::the().unplug(1);
        for (int i = 0; i < 5; ++i)
            QVERIFY(!exchange({1, 0, 0}).valid);
        COMPARE_CONTAINS(device_->trouble(), "unplugged");
        device_->close();
        QVERIFY(!device_->open());
        // Plugged in again it counts from somewhere else, whatever was known before.
        EmulatedBus::the().plug(1, arm_);
        Person nobody(*arm_);
        nobody.patience = 0;
        QVERIFY(!device_->prepare(nobody));
        prepare();
        QVERIFY(device_->open().has_value());
        for (int i = 0; i < 3; ++i)
            exchange(kNoForce);
        QVERIFY(exchange(kNoForce).valid);
    }

    void unpluggedWhileItIsPrepared() {
        EmulatedBus::the().unplug(1);
        Person person(*arm_);
        QVERIFY(!device_->prepare(person));
    }

    void deafnessIsSaid() {
        openAt({0, 0, 0});
        UsbFaults faults;
        faults.stallOut = true;
        EmulatedBus::the().setFaults(1, faults);
        for (int i = 0; i < 60; ++i)
            QVERIFY(exchange(kNoForce).valid); // it says where it is all the time
        COMPARE_CONTAINS(device_->trouble(), "commands");
        EmulatedBus::the().setFaults(1, {});
        for (int i = 0; i < 5; ++i)
            exchange(kNoForce);
        QVERIFY(device_->trouble().empty());
    }

    void closingAndStoppingTakeTheForceAway() {
        openAt({0, 0, 0});
        exchange({2, 0, 0});
        exchange({2, 0, 0});
        QVERIFY(!motorsRest());
        device_->emergencyStop();
        QVERIFY(motorsRest());
        exchange({2, 0, 0});
        exchange({2, 0, 0});
        QVERIFY(!motorsRest());
        device_->close();
        QVERIFY(motorsRest());
        device_->emergencyStop(); // closed: nothing to stop, and no harm
    }

    void aForkedChildStopsTheMotors() {
        openAt({0, 0, 0});
        exchange({2, 0, 0});
        exchange({2, 0, 0});
        QVERIFY(!motorsRest());
        const pid_t watchdog = fork();
        if (watchdog == 0) {
            device_->emergencyStop();
            _exit(0);
        }
        int status = 0;
        QCOMPARE(waitpid(watchdog, &status, 0), watchdog);
        QCOMPARE(status, 0);
        QVERIFY(motorsRest());
    }

    void itsOwnWatchdogStopsItToo() {
        openAt({0, 0, 0});
        exchange({2, 0, 0});
        exchange({2, 0, 0});
        for (int i = 0; i < 490; ++i)
            arm_->tick();
        QVERIFY(!motorsRest());
        for (int i = 0; i < 20; ++i)
            arm_->tick();
        QVERIFY(motorsRest());
    }
};

TACTUM_TEST(TestWoodenHaptics)

} // namespace test_wooden_haptics

#include "test_wooden_haptics.moc"
