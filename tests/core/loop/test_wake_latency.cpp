// How late a loop is woken: its figures against a sorted list, and that it sees a loop that is kept from
// waking.
#include <algorithm>
#include <random>
#include <vector>

#include <QTest>

#include "core/loop/wake_latency.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_wake_latency {

using namespace tactum;

class TestWakeLatency : public QObject {
    Q_OBJECT

private slots:
    void nothingWasLate() {
        const LatencyHistogram none;
        QCOMPARE(none.ticks(), 0U);
        QCOMPARE(none.worst(), 0.0);
        QCOMPARE(none.quantile(0.5), 0.0);
        QCOMPARE(none.laterThan(0.001), 0U);
    }

    /// As the sorted list of them says, to a microsecond.
    void quantilesAreThoseOfTheList() {
        std::mt19937_64 random(7);
        std::lognormal_distribution<double> late(std::log(60e-6), 1.5);
        std::vector<double> all;
        LatencyHistogram histogram;
        for (int i = 0; i < 50'000; ++i) {
            all.push_back(late(random));
            histogram.add(all.back());
        }
        std::ranges::sort(all);
        QCOMPARE(histogram.ticks(), all.size());
        QCOMPARE(histogram.worst(), all.back());
        for (const double part : {0.1, 0.5, 0.9, 0.99, 0.999})
            COMPARE_NEAR(histogram.quantile(part), all[std::size_t(part * double(all.size())) - 1], 2e-6,
                         "s");
        QCOMPARE(histogram.quantile(1), all.back());
        for (const double limit : {1e-4, 1e-3, 1e-2}) {
            const auto counted = all.end() - std::ranges::lower_bound(all, limit);
            QCOMPARE(histogram.laterThan(limit), std::uint64_t(counted));
        }
    }

    void whatIsTooLateToTellApartIsCounted() {
        LatencyHistogram histogram;
        histogram.add(0.5);
        histogram.add(-1e-6); // a clock that was read early
        QCOMPARE(histogram.worst(), 0.5);
        QCOMPARE(histogram.laterThan(0.02), 1U);
        QCOMPARE(histogram.quantile(0.5), 1e-6);
        QCOMPARE(histogram.quantile(0.99), 0.5);
    }

    void itRunsAsLongAndAsOftenAsItIsAsked() {
        double seen = 0;
        const auto report =
            measureLatency(1000, 0.5, {.report = [&](double part) { seen = std::max(seen, part); }});
        VERIFY_RESULT(report);
        QCOMPARE_LE(report->late.ticks(), 502U); // a busy machine makes fewer
        QCOMPARE_GE(report->late.ticks(), 5U);
        QCOMPARE_GE(report->late.worst(), 0.0);
        QCOMPARE(report->rate, 1000.0);
        QCOMPARE_LE(seen, 1.0);
        QCOMPARE_GT(seen, 0.0);
    }

    void itEndsWhenItIsTold() {
        const std::atomic<bool> cancelled{true};
        const auto report = measureLatency(1000, 3600, {.report = {}, .cancelled = &cancelled});
        VERIFY_RESULT(report);
        QCOMPARE_LE(report->late.ticks(), 3600'000U / 10);
    }
};

TACTUM_TEST(TestWakeLatency)

} // namespace test_wake_latency

#include "test_wake_latency.moc"
