// The simulated hand against the closed forms of a damped oscillator.
#include <cmath>
#include <random>

#include <QTest>

#include "device/simulated_hand.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_simulated_hand {

using namespace tactum;

namespace {

struct Hand {
    explicit Hand(SimulatedHandProfile profile = {}) : device(target, profile) { device.open(); }

    void leadTo(const Vec3& position) { target->write({.position = position}); }
    void teleportTo(const Vec3& position, std::uint32_t sequence) {
        target->write({position, true, sequence});
    }
    DeviceSample go(double seconds, const Vec3& force = Vec3::Zero(), double dt = 1e-3) {
        DeviceSample sample = device.exchange({force}, 0);
        for (double t = 0; t < seconds - 0.5 * dt; t += dt)
            sample = device.exchange({force}, dt);
        return sample;
    }

    std::shared_ptr<HandTarget> target = std::make_shared<HandTarget>();
    SimulatedHand device;
};

/// Response at time t of m x" + c x' + k x = k, from rest at 0: the textbook's three cases.
double stepResponse(const SimulatedHandProfile& p, double t) {
    const double w0 = std::sqrt(p.stiffness / p.mass);
    const double zeta = p.damping / (2 * std::sqrt(p.stiffness * p.mass));
    if (std::abs(zeta - 1) < 1e-9) return 1 - std::exp(-w0 * t) * (1 + w0 * t);
    if (zeta < 1) {
        const double wd = w0 * std::sqrt(1 - zeta * zeta);
        return 1 - std::exp(-zeta * w0 * t) * (std::cos(wd * t) + zeta * w0 / wd * std::sin(wd * t));
    }
    const double root = std::sqrt(zeta * zeta - 1);
    const double a = w0 * (zeta - root), b = w0 * (zeta + root);
    return 1 - (b * std::exp(-a * t) - a * std::exp(-b * t)) / (b - a);
}

} // namespace

class TestSimulatedHand : public QObject {
    Q_OBJECT

private slots:
    void itsButtonIsDownWhileTheGoalIsHeld() {
        Hand hand;
        QCOMPARE_EQ(hand.device.info().buttons, 1);
        for (const bool held : {false, true, false}) {
            hand.target->write({.position = Vec3::Zero(), .held = held});
            QCOMPARE(hand.go(0.01).buttons, held ? 1u : 0u);
        }
    }

    void followsAGoalStepAsADampedOscillator_data() {
        QTest::addColumn<double>("damping");
        QTest::newRow("underdamped") << 1.0;
        QTest::newRow("as delivered") << SimulatedHandProfile{}.damping;
        QTest::newRow("critical") << 2 * std::sqrt(250 * 0.1);
        QTest::newRow("overdamped") << 40.0;
    }

    void followsAGoalStepAsADampedOscillator() {
        QFETCH(double, damping);
        const SimulatedHandProfile profile{.damping = damping};
        const Vec3 goal(0.03, -0.02, 0.05);
        for (const double dt : {1e-3, 2.5e-4, 7e-3}) {
            Hand hand(profile);
            hand.leadTo(goal);
            for (int n = 1; n <= 60; ++n) {
                const Vec3 x = hand.device.exchange({}, dt).position;
                COMPARE_NEAR(x, goal * stepResponse(profile, n * dt), 1e-9, "m");
            }
        }
    }

    /// Against the same oscillator in a thousand steps a tick, led along the polynomial.
    void isLedWithTheLeastJerk() {
        const SimulatedHandProfile profile;
        const double way = 0.04, time = 0.1, h = 1e-6;
        Hand hand;
        hand.target->write({.position = {way, 0, 0}, .time = time});
        double x = 0, v = 0;
        for (int tick = 0; tick < 300; ++tick) {
            const Vec3 there = hand.device.exchange({}, 1e-3).position;
            for (int i = 0; i < 1000; ++i) {
                const double s = std::min(1.0, (tick * 1e-3 + (i + 0.5) * h) / time);
                const double led = way * s * s * s * (10 - 15 * s + 6 * s * s);
                v += h * (profile.stiffness * (led - x) - profile.damping * v) / profile.mass;
                x += h * v;
            }
            COMPARE_NEAR(there.x(), x, 1e-5, "m");
        }
        COMPARE_NEAR(x, way, 1e-5, "m");
    }

    /// Led to and fro on its way: what moves a hand is the spring of its grip, and one whose end jumps by the
    /// whole way would pull with 250 m/s2.
    void isLedElsewhereWithoutAJerk() {
        Hand hand;
        Vec3 before = Vec3::Zero();
        double hardest = 0;
        for (int tick = 0; tick < 600; ++tick) {
            if (tick % 40 == 0)
                hand.target->write(
                    {.position = {tick % 80 == 0 ? 0.05 : -0.05, 1e-4 * tick, 0}, .time = 0.1});
            const Vec3 velocity = hand.device.exchange({}, 1e-3).velocity;
            hardest = std::max(hardest, (velocity - before).norm() / 1e-3);
            before = velocity;
        }
        QCOMPARE_LT(hardest, 60);
    }

    void aTimeThatMakesNoSenseIsNone() {
        for (const double time : {std::nan(""), -1.0, double(INFINITY)}) {
            Hand odd, plain;
            odd.target->write({.position = {0.05, 0, 0}, .time = time});
            plain.leadTo({0.05, 0, 0});
            QCOMPARE(odd.go(0.02).position, plain.go(0.02).position);
        }
        Hand late;
        late.target->write({.position = {0.05, 0, 0}, .time = 1e9});
        COMPARE_NEAR(late.go(3).position.x(), 0.05, 1e-6, "m");
    }

    void velocityIsTheDerivativeOfPosition() {
        Hand hand;
        hand.leadTo({0.05, 0, 0});
        hand.go(0.01);
        const double h = 1e-6;
        const double before = hand.device.exchange({}, 0).position.x();
        const double velocity = hand.device.exchange({}, h).velocity.x();
        const double after = hand.device.exchange({}, h).position.x();
        QCOMPARE_GT(velocity, 0.1);
        COMPARE_NEAR((after - before) / (2 * h), velocity, 1e-4, "m/s");
    }

    void forcePushesTheHandByForceOverStiffness() {
        Hand hand;
        hand.leadTo({0.01, 0.02, 0});
        const Vec3 force(1, -2, 3);
        const DeviceSample sample = hand.go(3, force);
        COMPARE_NEAR(sample.position - Vec3(0.01, 0.02, 0), force / SimulatedHandProfile{}.stiffness, 1e-12,
                     "");
        QCOMPARE_LT(sample.velocity.norm(), 1e-9);
    }

    void jitterOfTheClockChangesNothing() {
        Hand even, uneven;
        std::mt19937 random(7);
        even.leadTo({0.05, 0, 0});
        uneven.leadTo({0.05, 0, 0});
        double t = 0;
        DeviceSample sample;
        while (t < 0.05) {
            const double dt = std::uniform_real_distribution(1e-6, 5e-3)(random);
            sample = uneven.device.exchange({}, dt);
            t += dt;
        }
        for (int i = 0; i < 10; ++i)
            even.device.exchange({}, t / 10);
        COMPARE_NEAR(even.device.exchange({}, 0).position, sample.position, 1e-12, "m");
    }

    void longSleepOfTheMachineCountsAsTwentyMilliseconds() {
        Hand slept, steady;
        slept.leadTo({0.05, 0, 0});
        steady.leadTo({0.05, 0, 0});
        QCOMPARE(slept.device.exchange({}, 3600).position, steady.device.exchange({}, 0.02).position);
    }

    void teleportJumpsOnceAndRests() {
        Hand hand;
        hand.leadTo({0.05, 0, 0});
        hand.go(0.02);
        hand.teleportTo({0, 0.03, 0}, 1);
        DeviceSample sample = hand.device.exchange({}, 1e-3);
        COMPARE_NEAR(sample.position, Vec3(0, 0.03, 0), 1e-12, "m");
        QCOMPARE_LT(sample.velocity.norm(), 1e-12);
        // The same teleport seen again, with the hand pushed aside: it stays where it was pushed.
        hand.teleportTo({0, 0.03, 0}, 1);
        sample = hand.go(0.05, {2, 0, 0});
        QCOMPARE_GT(sample.position.x(), 1e-3);
    }

    void wallOfTheWorkspaceHoldsTheHand() {
        Hand hand;
        hand.leadTo({1, 0, 0});
        const double radius = SimulatedHandProfile{}.workspaceRadius;
        double farthest = 0;
        for (int i = 0; i < 2000; ++i)
            farthest = std::max(farthest, hand.device.exchange({}, 1e-3).position.norm());
        const DeviceSample sample = hand.device.exchange({}, 1e-3);
        QCOMPARE_LE(farthest, radius * (1 + 1e-15));
        COMPARE_NEAR(sample.position.x(), radius, 1e-12, "m");
        QCOMPARE_LT(sample.velocity.norm(), 1e-12);
    }

    void wallLetsTheHandSlideAlong() {
        Hand hand;
        hand.leadTo({0.3, 0, 0});
        hand.go(1);
        hand.leadTo({0, 0.3, 0});
        const Vec3 x = hand.go(2).position;
        COMPARE_NEAR(x, Vec3(0, SimulatedHandProfile{}.workspaceRadius, 0), 1e-3, "m");
    }

    void nonsenseLeavesTheHandWhereItIs() {
        const Vec3 place(0.02, 0, 0), nonsense = Vec3::Constant(std::nan(""));
        Hand hand;
        hand.leadTo(place);
        hand.go(2);
        COMPARE_NEAR(hand.device.exchange({nonsense}, 1e-3).position, place, 1e-9, "m");
        hand.leadTo(nonsense);
        COMPARE_NEAR(hand.device.exchange({}, 1e-3).position, place, 1e-9, "m");
        hand.teleportTo(nonsense, 1);
        COMPARE_NEAR(hand.device.exchange({}, 1e-3).position, place, 1e-9, "m");
    }
};

TACTUM_TEST(TestSimulatedHand)

} // namespace test_simulated_hand

#include "test_simulated_hand.moc"
