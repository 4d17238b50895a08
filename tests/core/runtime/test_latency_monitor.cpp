// Whose a missed tick is: the loop's own where it worked for too long, the machine's or the device's where it
// waited.
#include <thread>

#include <QTest>

#include "core/base/clock.h"
#include "core/runtime/latency_monitor.h"
#include "tests/support/test_program.h"

namespace test_latency_monitor {

using namespace tactum;

namespace {

constexpr double kPeriod = 1e-3; // s
std::int64_t used = 0;           // ns, of a clock that the test sets

std::int64_t setClock() noexcept {
    return used;
}

} // namespace

class TestLatencyMonitor : public QObject {
    Q_OBJECT

private slots:
    /// The bound from both sides, and each tick for itself.
    void workOfTwoPeriodsIsOwn() {
        used = 123;
        LatencyMonitor monitor(setClock);
        for (const double periods : {0.0, 1.99, 2.01, 1.99, 1.99, 5.0, 0.1}) {
            used += std::int64_t(1e9 * periods * kPeriod);
            QCOMPARE(monitor.isOwn(kPeriod), periods > 2);
        }
    }

    /// With the machine's own clock: who works counts, who sleeps or is blocked does not, however busy others
    /// are.
    void onlyWorkCounts() {
        LatencyMonitor monitor;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        QVERIFY(!monitor.isOwn(kPeriod));
        for (const std::int64_t until = threadNanoseconds() + 3'000'000; threadNanoseconds() < until;) {
        }
        QVERIFY(monitor.isOwn(kPeriod));
        QVERIFY(!monitor.isOwn(kPeriod));
    }
};

TACTUM_TEST(TestLatencyMonitor)

} // namespace test_latency_monitor

#include "test_latency_monitor.moc"
