// The estimators on rows whose answer is known in closed form.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/self_test/identify.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_identify {

using namespace tactum;

namespace {

/// Rows a millisecond apart.
std::vector<TrialRow> rowsOf(int count, double (*along)(int)) {
    std::vector<TrialRow> rows(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        rows[std::size_t(i)].time = 1e-3 * i;
        rows[std::size_t(i)].position.x() = along(i);
        rows[std::size_t(i)].valid = true;
    }
    return rows;
}

} // namespace

class TestIdentify : public QObject {
    Q_OBJECT

private slots:
    void aPaceIsThatOfNewReadings() {
        auto rows = rowsOf(1001, [](int) { return 0.0; });
        QVERIFY(std::abs(paceOf(rows).rate - 1000) < 1e-6);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].valid = i % 2 == 0; // every other one
        rows[500].valid = false;
        const Pace pace = paceOf(rows);
        QVERIFY(std::abs(pace.rate - 499) < 1e-6);
        QVERIFY(std::abs(pace.median - 2e-3) < 1e-9);
        QVERIFY(std::abs(pace.worst - 4e-3) < 1e-9);
        QCOMPARE(paceOf({}).rate, 0.0);
    }

    void noiseIsWhatIsNoDrift() {
        // A drift of 1 mm/s, and a sine of whole turns: its rms is its height by the root of two.
        const auto rows =
            rowsOf(2000, [](int i) { return 1e-6 * i + 3e-5 * std::sin(2 * std::numbers::pi * i / 20); });
        QVERIFY(std::abs(noiseOf(rows) - 3e-5 / std::numbers::sqrt2) < 1e-7);
        QCOMPARE(noiseOf({}), 0.0);
    }

    void resolutionIsTheStepOfTheEncoder() {
        const auto rows = rowsOf(2000, [](int i) { return 5e-5 * std::round(200 * std::sin(0.01 * i)); });
        QVERIFY(std::abs(resolutionOf(rows) - 5e-5) < 1e-9);
        QCOMPARE(resolutionOf(rowsOf(100, [](int) { return 0.01; })), 0.0);
    }

    /// m a + b v + c sgn v = F exactly, of a motion that is given, and a force that was asked for 5 ms
    /// before.
    void dynamicsAreThoseOfTheEquation() {
        constexpr double m = 0.2, b = 1.5, c = 0.3, delay = 5e-3;
        auto rows = rowsOf(5000, [](int) { return 0.0; });
        for (TrialRow& row : rows) {
            const auto sum = [](double t, int derivative) {
                double value = 0;
                for (const double w : {17.0, 41.0, 83.0})
                    value += 0.06 / w * std::pow(w, derivative) *
                             std::sin(w * t + derivative * std::numbers::pi / 2);
                return value;
            };
            row.position.x() = sum(row.time, 0);
            const double then = row.time + delay + 0.5e-3; // a command holds for a tick
            row.force.x() = m * sum(then, 2) + b * sum(then, 1) + std::copysign(c, sum(then, 1));
        }
        const auto found = dynamicsOf(rows, 0);
        QVERIFY(found);
        QVERIFY(std::abs(found->mass.value - m) < 0.01 * m);
        QVERIFY(std::abs(found->damping.value - b) < 0.03 * b);
        QVERIFY(std::abs(found->friction.value - c) < 0.03 * c);
        QVERIFY(std::abs(found->delay.value - delay) < 2e-4);
        QVERIFY(found->unexplained < 0.05);
        QVERIFY(!dynamicsOf(rows, 1)); // nothing moved there
        QVERIFY(!dynamicsOf({}, 0));
    }
};

TACTUM_TEST(TestIdentify)

} // namespace test_identify

#include "test_identify.moc"
