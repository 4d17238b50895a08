// The slide that friction allows, against the equation of section 4.2 integrated in small steps.

#include <QTest>

#include "core/surface/friction.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_friction {

using namespace tactum;
using namespace tactum::test;

namespace {

// b x' = k (e - mu depth) with e growing at the finger's speed: fourth-order Runge-Kutta, sticking below the
// cone. All in metres: the spring cancels, lag = b / k.
double integrated(const FrictionLimit& limit, double excess, double depth, double speed, double dt) {
    constexpr int steps = 20000;
    const double h = dt / steps, start = excess - speed * dt;
    auto rate = [&](double t, double slid) {
        const double over = start + speed * t - slid - limit.coefficient * depth;
        return over > 0 ? over / limit.lag : 0;
    };
    double x = 0;
    for (int i = 0; i < steps; ++i) {
        const double t = i * h;
        const double k1 = rate(t, x), k2 = rate(t + h / 2, x + h / 2 * k1),
                     k3 = rate(t + h / 2, x + h / 2 * k2), k4 = rate(t + h, x + h * k3);
        x += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return x;
}

} // namespace

class FrictionTest : public QObject {
    Q_OBJECT

private slots:
    void followsTheEquation();
    void splitsIntoShorterTimes();
    void holdsInsideTheCone();
    void withoutViscosityEndsOnTheCone();
    void smallViscosityTendsToNone();
    void steadySlideLagsByViscosity();
    void stickingContactObeysStaticFriction();
    void aSlopeTurnsTheCone();
};

void FrictionTest::followsTheEquation() {
    Rng rng(21);
    for (int i = 0; i < 300; ++i) {
        const FrictionLimit limit{uniform(rng, 0, 1), std::pow(10, uniform(rng, -4, -1))};
        const double depth = uniform(rng, 0, 2e-3), dt = std::pow(10, uniform(rng, -4, -2));
        // From outside the cone, and from inside it when the finger pulls out during the time.
        const double speed = uniform(rng, 0, 0.5);
        const double excess = limit.coefficient * depth + uniform(rng, 0, 1.5) * speed * dt;
        const double slide = allowedSlide(limit, excess, depth, speed, dt);
        QVERIFY2(std::abs(slide - integrated(limit, excess, depth, speed, dt)) < 1e-6 * speed * dt,
                 qPrintable(QString("case %1").arg(i)));
    }
}

// Two half steps give what one step gives: the answer does not depend on the servo's rate.
void FrictionTest::splitsIntoShorterTimes() {
    const FrictionLimit limit{0.3, 0.004};
    const double depth = 1e-3, speed = 0.1, dt = 1e-3, before = 0.45e-3;
    const double whole = allowedSlide(limit, before + speed * dt, depth, speed, dt);
    const double first = allowedSlide(limit, before + speed * dt / 2, depth, speed, dt / 2);
    const double second = allowedSlide(limit, before + speed * dt - first, depth, speed, dt / 2);
    COMPARE_NEAR(first + second, whole, 1e-15, "m");
}

void FrictionTest::holdsInsideTheCone() {
    for (double lag : {0.0, 0.01}) {
        QCOMPARE(allowedSlide({0.5, lag}, 0.5e-3, 1e-3, 0.1, 1e-3), 0.0);
        QCOMPARE(allowedSlide({0.5, lag}, 0.4e-3, 1e-3, 0.1, 1e-3), 0.0);
        QCOMPARE(allowedSlide({0.5, lag}, 0, 1e-3, -0.1, 1e-3), 0.0);
    }
}

void FrictionTest::withoutViscosityEndsOnTheCone() {
    for (double speed : {-0.2, 0.0, 0.2})
        COMPARE_NEAR(allowedSlide({0.5, 0}, 0.9e-3, 1e-3, speed, 1e-3), 0.4e-3, 1e-18, "m");
    QCOMPARE(allowedSlide({0, 0}, 0.9e-3, 1e-3, 0.2, 1e-3), 0.9e-3);
}

void FrictionTest::smallViscosityTendsToNone() {
    for (double lag : {1e-6, 1e-9, 1e-12, 1e-300}) {
        const double slide = allowedSlide({0.5, lag}, 0.9e-3, 1e-3, 0.1, 1e-3);
        QVERIFY(std::isfinite(slide));
        QCOMPARE_LE(slide, 0.4e-3);
        QCOMPARE_LE(0.4e-3 - slide, 1.001 * 0.1 * lag + 1e-18);
    }
}

// Where the finger moves at constant speed the excess settles at mu depth + speed b / k, without overshoot.
void FrictionTest::steadySlideLagsByViscosity() {
    const FrictionLimit limit{0.4, 0.01};
    const double depth = 1e-3, speed = 0.2, dt = 1e-3;
    double excess = 0, last = 0;
    for (int i = 0; i < 300; ++i) {
        excess += speed * dt;
        excess -= allowedSlide(limit, excess, depth, speed, dt);
        QCOMPARE_GE(excess, last - 1e-18);
        last = excess;
    }
    COMPARE_NEAR(excess, limit.coefficient * depth + speed * limit.lag, 1e-9, "m");
    // The finger comes back at the same speed: what is outside the cone goes on sliding, and never back.
    for (int i = 0; i < 300; ++i) {
        excess -= speed * dt;
        const double slide = allowedSlide(limit, excess, depth, -speed, dt);
        QCOMPARE_GE(slide, 0);
        QCOMPARE_LE(slide, std::max(0.0, excess - limit.coefficient * depth) + 1e-18);
        excess -= slide;
    }
}

void FrictionTest::stickingContactObeysStaticFriction() {
    Material material;
    material.stiffness = 500;
    material.staticFriction = 0.8;
    material.dynamicFriction = 0.3;
    material.viscosity = 2;
    QCOMPARE(frictionLimit(material, false).coefficient, 0.8);
    QCOMPARE(frictionLimit(material, false).lag, 0.0);
    QCOMPARE(frictionLimit(material, true).coefficient, 0.3);
    QCOMPARE(frictionLimit(material, true).lag, 0.004);
}

// By a block on a slope s, pushed along the horizontal plane: up (s + mu) / (1 - s mu), down, and across by
// the normal force on the slope, which is (1 + s^2)^(1/2) of the one on the flat.
void FrictionTest::aSlopeTurnsTheCone() {
    for (const double s : {0.0, 0.1, 0.5})
        for (const double mu : {0.1, 0.3, 0.6}) {
            const double lean = 1 / std::sqrt(1 + s * s), up = s * lean;
            COMPARE_NEAR(s + mu * slopeFactor(lean, -up, mu), (s + mu) / (1 - s * mu), 1e-12, "");
            COMPARE_NEAR(-s + mu * slopeFactor(lean, up, mu), (mu - s) / (1 + s * mu), 1e-12, "");
            COMPARE_NEAR(slopeFactor(lean, 0, mu), std::sqrt(1 + s * s), 1e-12, "");
        }
    QCOMPARE(slopeFactor(0.707, -0.707, 0.99), kMaxSlopeFactor);           // it would jam
    QCOMPARE(slopeFactor(0, -std::nextafter(1, 2), 0.5), kMaxSlopeFactor); // and rounding is no cosine
}

TACTUM_TEST(FrictionTest)

} // namespace test_friction

#include "test_friction.moc"
