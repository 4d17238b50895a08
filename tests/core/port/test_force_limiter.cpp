// Whatever comes in, what goes to the device is finite, within the limit and in the same direction.
#include <cmath>
#include <limits>
#include <random>

#include <QTest>

#include "core/port/force_limiter.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_force_limiter {

using namespace tactum;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Any magnitude from denormal to overflowing, now and then a value that is no number.
double anyNumber(std::mt19937_64& random) {
    static constexpr double kSpecial[] = {0.0,
                                          -0.0,
                                          kInfinity,
                                          -kInfinity,
                                          kNan,
                                          std::numeric_limits<double>::max(),
                                          std::numeric_limits<double>::denorm_min()};
    if (random() % 8 == 0) return kSpecial[random() % std::size(kSpecial)];
    const double exponent = std::uniform_real_distribution(-320.0, 308.0)(random);
    return std::pow(10.0, exponent) * (random() % 2 ? 1 : -1);
}

double ordinaryNumber(std::mt19937_64& random) {
    return std::uniform_real_distribution(-20.0, 20.0)(random);
}

/// Long double: the check must not overflow where the limiter does not.
long double magnitude(const Vec3& f) {
    const long double x = f.x(), y = f.y(), z = f.z();
    return std::sqrt(x * x + y * y + z * z);
}

long double cosine(const Vec3& a, const Vec3& b) {
    long double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += (a[i] / magnitude(a)) * (b[i] / magnitude(b));
    return sum;
}

} // namespace

class TestForceLimiter : public QObject {
    Q_OBJECT

private slots:
    void outputIsFiniteWithinLimitAndSameDirection_data() {
        QTest::addColumn<bool>("extreme");
        QTest::newRow("forces around the limit") << false;
        QTest::newRow("any numbers there are") << true;
    }

    void outputIsFiniteWithinLimitAndSameDirection() {
        QFETCH(bool, extreme);
        std::mt19937_64 random(2001);
        std::uint64_t notFinite = 0, clamped = 0;
        ForceLimiter limiter;
        for (int i = 0; i < 1'000'000; ++i) {
            limiter.maxForce = std::uniform_real_distribution(0.1, 20.0)(random);
            const Vec3 in =
                Vec3::NullaryExpr([&] { return extreme ? anyNumber(random) : ordinaryNumber(random); });
            const Vec3 out = limiter(in);
            if (!out.allFinite() || magnitude(out) > limiter.maxForce) QFAIL("above the limit");
            if (!in.allFinite()) {
                ++notFinite;
                if (!out.isZero(0)) QFAIL("a force out of no number");
            } else if (magnitude(in) <= limiter.maxForce * (1 - 1e-15L)) {
                if (out != in) QFAIL("an allowed force was changed");
            } else if (magnitude(in) > limiter.maxForce * (1 + 1e-15L)) {
                ++clamped;
                if (magnitude(out) < limiter.maxForce * (1 - 1e-14L)) QFAIL("shortened too much");
                if (cosine(in, out) < 1 - 1e-14L) QFAIL("turned");
            }
        }
        QCOMPARE(limiter.notFinite, notFinite);
        QCOMPARE_GE(limiter.clamped, clamped);
        QCOMPARE_LE(limiter.clamped, clamped + 10);
        QCOMPARE_GT(clamped, 100'000);
        QCOMPARE(notFinite > 0, extreme);
    }

    void limitThatIsNoLimitGivesNoForce() {
        for (const double limit : {0.0, -1.0, kNan}) {
            ForceLimiter limiter{.maxForce = limit};
            QCOMPARE_EQ(limiter(Vec3(1, 2, 3)), Vec3(0, 0, 0));
            QCOMPARE_EQ(limiter(Vec3::Zero()), Vec3(0, 0, 0));
        }
    }
};

TACTUM_TEST(TestForceLimiter)

} // namespace test_force_limiter

#include "test_force_limiter.moc"
