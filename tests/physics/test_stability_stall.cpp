// T9: the servo or the device stands still in contact. What comes after is gentle.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/event.h"
#include "tests/physics/press.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_stability_stall {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kWall = 1500, kArrival = 0.56; // N/m, m/s

double kineticEnergy(const ClosedLoop& loop, bool outward) {
    const Plant& plant = loop.plant;
    const Bench& bench = loop.bench();
    const auto of = [=](double mass, double v) { return outward && v < 0 ? 0 : 0.5 * mass * v * v; };
    const double hand = bench.hand.rigid ? plant.v[2] : plant.handV[2];
    return of(bench.device.mass, plant.v[2]) + of(bench.hand.mass, hand);
}

/// A hand that hits the wall, and the stall at that moment.
struct Stalled {
    double before = 0, outward = 0; ///< J, of device and hand
    Event after;
};

Stalled stallAtImpact(ClosedLoop& loop, double length) {
    loop.plant.place({0, 0, 0.002}, {0, 0, -kArrival});
    loop.plant.setGoal(Vec3::Zero());
    loop.plant.voluntary.z() = -1;
    loop.warmUp();
    while (loop.plant.x[2] > -0.0005)
        loop.tick();
    Stalled result;
    result.before = kineticEnergy(loop, false);
    const double force = loop.command.z();
    loop.tick(length);
    const double jump = std::abs(loop.command.z() - force);
    result.after = watchEvent(loop, 3, [&](const ClosedLoop& now) {
        result.outward = std::max(result.outward, kineticEnergy(now, true));
    });
    result.after.jump = std::max(result.after.jump, jump);
    return result;
}

constexpr std::array kStalls{0.011, 0.02, 0.05, 0.1, 0.3};

} // namespace

class TestStabilityStall : public QObject {
    Q_OBJECT

private slots:
    void afterAStallItIsGentle_data() {
        QTest::addColumn<int>("hand");
        QTest::addColumn<double>("length");
        for (int hand = 0; hand < int(kHands.size()); ++hand)
            for (const double length : kStalls)
                QTest::addRow("%s, %g ms", kHands[std::size_t(hand)].name, 1e3 * length) << hand << length;
    }

    void afterAStallItIsGentle() {
        QFETCH(int, hand);
        QFETCH(double, length);
        for (const PlantProfile& device : {kFalcon, kHeavy, kPremium}) {
            const Bench bench{device, kHands[std::size_t(hand)], {}};
            GivenModel model(wall(kWall));
            Servo servo(infoOf(bench), model);
            ClosedLoop loop(bench, servo.control());
            const Stalled stalled = stallAtImpact(loop, length);
            qInfo("%s: %.1f mJ came, %.1f mJ went, %.2f N in a tick, %.2f m/s", device.name,
                  1e3 * stalled.before, 1e3 * stalled.outward, stalled.after.jump, stalled.after.speed);
            QCOMPARE_LE(stalled.outward, 0.25 * stalled.before + 5e-3);
            QCOMPARE_LE(stalled.after.jump, kArrivalDamping * kArrival + 0.1);
            QCOMPARE(servo.state.gate.gain(), 1.0); // and all is well again
        }
    }

    void shortStallIsNothing() {
        const Bench bench{kFalcon, kPinch, {}};
        GivenModel model(wall(kWall));
        Servo servo(infoOf(bench), model);
        ClosedLoop loop(bench, servo.control());
        const Stalled stalled = stallAtImpact(loop, 0.005);
        QCOMPARE(servo.state.gate.gain(), 1.0);
        QCOMPARE_LE(stalled.outward, stalled.before);
    }

    /// Without the watchdog, and with the whole force back at once.
    void goingOnAsIfNothingHadBeenIsNot() {
        Stalled worst;
        for (const HandProfile& hand : {kPinch, kGrasp}) {
            ClosedLoop loop({kFalcon, hand, {}}, [model = wall(kWall)](const DeviceSample& s, double) {
                return contactModelForce(model, s.position, s.velocity);
            });
            loop.watchdog = 1;
            const Stalled stalled = stallAtImpact(loop, 0.05);
            qInfo("%.1f mJ came, %.1f mJ went, %.2f N in a tick, %.2f m/s", 1e3 * stalled.before,
                  1e3 * stalled.outward, stalled.after.jump, stalled.after.speed);
            QCOMPARE_GT(stalled.outward, 0.25 * stalled.before + 5e-3);
            QCOMPARE_GT(stalled.after.jump, kArrivalDamping * kArrival + 0.1);
        }
    }
};

TACTUM_TEST(TestStabilityStall)

} // namespace test_stability_stall

#include "test_stability_stall.moc"
