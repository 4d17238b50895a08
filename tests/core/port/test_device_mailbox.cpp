// What lies between the servo and a driver elsewhere, by a clock that the test holds.
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <QTest>

#include "core/port/device_mailbox.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_device_mailbox {

using namespace tactum;

namespace {
constexpr std::int64_t kMillisecond = 1'000'000, kNow = 1000 * kMillisecond;
const Vec3 kForce{0, 0, 2};
const DeviceSample kReading{.position = {1, 2, 3}, .valid = true};
} // namespace

class TestDeviceMailbox : public QObject {
    Q_OBJECT

private slots:
    void anEmptyOneHasNeitherReadingNorForce() {
        DeviceMailbox box;
        QVERIFY(!box.newest(kMillisecond).valid);
        COMPARE_NEAR(box.force(kMillisecond), Vec3(0, 0, 0), 1e-12, "N");
    }

    void aReadingIsTakenWhileItIsYoung() {
        DeviceMailbox box;
        box.measured(kReading, kNow);
        for (const int age : {0, 1, 5}) // again and again, for two clocks beat
            QVERIFY(box.newest(kNow + age * kMillisecond).valid);
        QCOMPARE(box.newest(kNow + kMillisecond).at, kNow);
        QCOMPARE(box.newest(kNow).position, kReading.position);
        QVERIFY(!box.newest(kNow + 6 * kMillisecond).valid);
        box.measured(kReading, kNow + 7 * kMillisecond);
        QVERIFY(box.newest(kNow + 8 * kMillisecond).valid);
    }

    /// One that nobody knew of yet is there at once, a new one wakes, and the moment ends it.
    void whoAwaitsAReadingIsWoken() {
        DeviceMailbox box;
        constexpr std::int64_t kLong = 60'000 * kMillisecond;
        box.measured(kReading, kNow);
        box.awaitReading(monotonicNanoseconds() + kLong);
        const std::int64_t begun = monotonicNanoseconds();
        box.awaitReading(begun + 5 * kMillisecond);
        QCOMPARE_GE(monotonicNanoseconds() - begun, 5 * kMillisecond);
        std::thread driver([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            box.measured(kReading, kNow + 7);
        });
        box.awaitReading(monotonicNanoseconds() + kLong);
        QCOMPARE(box.newest(kNow + 7).at, kNow + 7);
        driver.join();
        box.awaitReading(monotonicNanoseconds() - kMillisecond); // a moment that is over
    }

    /// The whole way: a servo that wakes with a driver's readings and announces what it makes of them. The
    /// force that answers a reading is there before the next one, and does not take another to come. The
    /// times of both are simulated.
    void theAnswerGoesOutATickLater() {
        DeviceMailbox box;
        std::atomic<bool> ended{false};
        std::thread servo([&] {
            while (!ended) {
                box.awaitReading(monotonicNanoseconds() + 100 * kMillisecond);
                const DeviceSample newest = box.newest(kNow);
                box.command(newest.position, newest.at);
            }
        });
        constexpr int kTicks = 200;
        int answered = 0;
        for (int tick = 1; tick <= kTicks && answered == tick - 1; ++tick) {
            const std::int64_t now = kNow + 2 * tick * kMillisecond;
            box.measured({.position = {double(tick), 0, 0}, .valid = true}, now);
            answered += test::eventually([&] { return box.force(now + 2 * kMillisecond).x() == tick; });
        }
        ended = true;
        servo.join();
        QCOMPARE(answered, kTicks);
    }

    /// What answers the newest reading ends the wait; what was there before it does not; the moment does.
    void whoAwaitsAnAnswerIsWoken() {
        DeviceMailbox box;
        constexpr std::int64_t kLong = 60'000 * kMillisecond;
        box.answer(kForce, kNow);
        box.measured(kReading, kNow);
        box.command(2 * kForce, kNow); // the last one once more: no answer
        const std::int64_t begun = monotonicNanoseconds();
        box.awaitAnswer(begun + 5 * kMillisecond);
        QCOMPARE_GE(monotonicNanoseconds() - begun, 5 * kMillisecond);
        std::thread servo([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            box.answer(3 * kForce, kNow + 1);
        });
        box.awaitAnswer(monotonicNanoseconds() + kLong);
        COMPARE_NEAR(box.force(kNow + 2), 3 * kForce, 1e-12, "N");
        servo.join();
    }

    void aReadingThatWasNoneStaysNone() {
        DeviceMailbox box;
        DeviceSample none = kReading;
        none.valid = false;
        box.measured(none, kNow);
        QVERIFY(!box.newest(kNow).valid);
    }

    /// The guard calls a device lost after three readings that are none: at a kilohertz within 10 ms.
    void aDeviceThatStandsStillIsLostInTime() {
        QCOMPARE_LE(kOldestReading + 3 * kMillisecond, 10 * kMillisecond);
    }

    void aCommandFadesWhenNoneFollows() {
        DeviceMailbox box;
        box.command(kForce, kNow, {Vec3(0, 0.2, 0), 3});
        QCOMPARE(box.handleForce(kNow).torque, Vec3(0, 0.2, 0));
        COMPARE_NEAR(box.handleForce(kNow + kOldestCommand + kCommandFade / 2).pinch, 1.5, 1e-9, "N");
        QCOMPARE(box.handleForce(kNow + kOldestCommand + kCommandFade).torque, Vec3(0, 0, 0));
        QCOMPARE(box.force(kNow), kForce);
        QCOMPARE(box.force(kNow + kOldestCommand), kForce);
        const Vec3 half = box.force(kNow + kOldestCommand + kCommandFade / 2);
        COMPARE_NEAR(half, 0.5 * kForce, 1e-9, "N");
        COMPARE_NEAR(box.force(kNow + kOldestCommand + kCommandFade), Vec3(0, 0, 0), 1e-12, "N");
        COMPARE_NEAR(box.force(kNow + 1'000'000 * kMillisecond), Vec3(0, 0, 0), 1e-12, "N");
        QCOMPARE_LE(kOldestCommand + kCommandFade, 300 * kMillisecond);
    }

    void aStopHoldsForWhatWasCommandedBefore() {
        DeviceMailbox box;
        box.command(kForce, kNow);
        box.stop(kNow + kMillisecond);
        COMPARE_NEAR(box.force(kNow + 2 * kMillisecond), Vec3(0, 0, 0), 1e-12, "N");
        box.command(kForce, kNow + 3 * kMillisecond);
        QCOMPARE(box.force(kNow + 3 * kMillisecond), kForce);
    }
};

TACTUM_TEST(TestDeviceMailbox)

} // namespace test_device_mailbox

#include "test_device_mailbox.moc"
