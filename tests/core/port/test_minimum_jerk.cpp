// The course of least jerk against its closed forms, and where one follows another.
#include <QTest>

#include "core/port/minimum_jerk.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_minimum_jerk {

using namespace tactum;

namespace {

const Vec3 kFrom(0.01, -0.02, 0.03), kTo(-0.05, 0.04, 0.1);
constexpr double kTime = 0.12; // s

const MinimumJerk::State kMoving{kFrom, {0.3, -0.1, 0.2}, {4, 5, -6}};

} // namespace

class TestMinimumJerk : public QObject {
    Q_OBJECT

private slots:
    /// Flash and Hogan (1985), equation of a movement from rest to rest.
    void fromRestItIsThePolynomial() {
        const MinimumJerk course({.position = kFrom}, kTo, kTime);
        for (double s = 0; s < 1; s += 0.01) {
            const Vec3 there =
                kFrom + (10 * s * s * s - 15 * s * s * s * s + 6 * s * s * s * s * s) * (kTo - kFrom);
            COMPARE_NEAR(course.at(s * kTime).position, there, 1e-15, "m");
        }
    }

    /// Halfway, 1.875 of the mean speed; the acceleration 10 / sqrt(3) of the way over the time squared.
    void speedAndAccelerationKeepTheirBounds() {
        const MinimumJerk course({.position = kFrom}, kTo, kTime);
        const double way = (kTo - kFrom).norm();
        double fastest = 0, hardest = 0;
        for (int i = 0; i <= 10000; ++i) {
            const auto now = course.at(1e-4 * i * kTime);
            fastest = std::max(fastest, now.velocity.norm());
            hardest = std::max(hardest, now.acceleration.norm());
        }
        COMPARE_NEAR(fastest, MinimumJerk::kPeakSpeed * way / kTime, 1e-9, "m/s");
        COMPARE_NEAR(course.at(0.5 * kTime).velocity.norm(), fastest, 1e-9, "m/s");
        COMPARE_NEAR(hardest, 10 / std::sqrt(3) * way / (kTime * kTime), 1e-5, "m/s2");
    }

    void itBeginsAsItIsAndEndsAtRest() {
        const MinimumJerk course(kMoving, kTo, kTime);
        const auto first = course.at(0), last = course.at(kTime * (1 - 1e-9)), after = course.at(5);
        COMPARE_NEAR(first.position, kMoving.position, 1e-15, "m");
        COMPARE_NEAR(first.velocity, kMoving.velocity, 1e-12, "m/s");
        COMPARE_NEAR(first.acceleration, kMoving.acceleration, 1e-12, "m/s2");
        COMPARE_NEAR(last.position, kTo, 1e-12, "m");
        COMPARE_NEAR(last.velocity, Vec3::Zero(), 1e-8, "m/s");
        COMPARE_NEAR(last.acceleration, Vec3::Zero(), 1e-6, "m/s2");
        QCOMPARE_EQ(after.position, kTo);
        QCOMPARE_EQ(after.velocity, Vec3(0, 0, 0));
    }

    void speedIsTheDerivativeOfPlace() {
        const MinimumJerk course(kMoving, kTo, kTime);
        const double h = 1e-6;
        for (double t = 0.001; t < kTime - 0.001; t += 0.007) {
            const auto before = course.at(t - h), now = course.at(t), after = course.at(t + h);
            COMPARE_NEAR((after.position - before.position) / (2 * h), now.velocity, 1e-8, "m/s");
            COMPARE_NEAR((after.velocity - before.velocity) / (2 * h), now.acceleration, 1e-6, "m/s2");
        }
    }

    void withoutTimeItIsThere() {
        for (const double none : {0.0, -1.0}) {
            const MinimumJerk course(kMoving, kTo, none);
            QCOMPARE_EQ(course.at(0).position, kTo);
            QCOMPARE_EQ(course.at(0).velocity, Vec3(0, 0, 0));
        }
    }
};

TACTUM_TEST(TestMinimumJerk)

} // namespace test_minimum_jerk

#include "test_minimum_jerk.moc"
