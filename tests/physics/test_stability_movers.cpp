// Bodies that move by themselves push as hard as their spring does: what they do on the hand is their own
// work, and no mistake of the loop that is eased away.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/movers.h"
#include "tests/support/test_program.h"

namespace test_stability_movers {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kTick = 1e-3, kRadius = 1e-3; ///< s, m
constexpr double kStiff = 800, kDepth = 3e-3;  ///< N/m, m
constexpr double kHigh = 0.01;                 ///< m

/// A finger that is led over a sheet that rises, and the servo that answers.
struct OnALift {
    OnALift(double speed, double proxyRate, double theLatency)
        : lift(speed), latency(theLatency),
          proxy(compile(sceneOf({bodyOf(sheet(0.1), material(), sliding({0, 0, speed}))})).value(), proxyRate,
                theLatency),
          servo(info(), proxy) {
        servo.settings.overrideCeiling = true;
        while (time < 1)
            to(kHigh);
    }
    static Material material() {
        Material result = frictionless();
        result.stiffness = kStiff;
        return result;
    }
    static DeviceInfo info() {
        DeviceInfo info;
        info.maxForce = 20;
        return info;
    }
    double surface() const { return lift * time; }
    /// Down into it, as a hand does.
    void press() {
        for (int i = 0; i < 500; ++i)
            to(kHigh - (kHigh + kDepth) * i / 500);
    }
    /// The next tick, `height` above where the proxy rests.
    void to(double height) { at(surface() + kRadius + height); }
    void at(double z) {
        time += kTick;
        DeviceSample sample;
        sample.position.z() = z;
        sample.valid = true;
        proxy.latency = uniform(random, 0, latency);
        servo(sample, kTick);
    }

    double lift;    ///< m/s
    double latency; ///< s, of the proxy's answers, at most
    Rng random{7};
    double time = 0;
    Proxy proxy;
    Servo servo;
};

} // namespace

class TestStabilityMovers : public QObject {
    Q_OBJECT

private slots:
    void aLiftPushesWithItsSpring_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("latency");
        for (const double speed : {-0.1, 0.01, 0.03, 0.1, 0.3})
            for (const double rate : {2000.0, 1000.0, 700.0, 300.0})
                for (const double latency : {0.0, 1e-3})
                    QTest::addRow("%g m/s, %g Hz, up to %g s late", speed, rate, latency)
                        << speed << rate << latency;
    }

    /// Whether the hand rides along or is held still.
    void aLiftPushesWithItsSpring() {
        QFETCH(double, speed);
        QFETCH(double, rate);
        QFETCH(double, latency);
        // What the answer is late by, the surface goes meanwhile.
        const double late = kStiff * std::abs(speed) * (3 * kTick + 1 / rate + latency);
        OnALift riding(speed, rate, latency);
        riding.press();
        for (int i = 0; i < 500; ++i) {
            riding.to(-kDepth);
            const double off = riding.servo.output.force.z() - kStiff * kDepth;
            QVERIFY2(std::abs(off) <= late + 0.02, qPrintable(QString("%1 N after %2 ms").arg(off).arg(i)));
        }
        if (speed < 0) return;
        OnALift still(speed, rate, latency);
        const double z = still.surface() + kRadius + kHigh;
        while (still.surface() < z + 0.01) {
            still.at(z);
            const double wanted = kStiff * std::max(0.0, still.surface() + kRadius - z);
            const double off = still.servo.output.force.z() - wanted;
            QVERIFY2(std::abs(off) <= late + 0.02, qPrintable(QString("%1 N of %2").arg(off).arg(wanted)));
        }
    }

    /// What is not there any more stands still: nothing is rubbed or damped as if it went on.
    void whatIsGoneMovesNoMore() {
        OnALift hand(-0.1, 1000, 0);
        hand.press();
        hand.proxy.world = compile(Scene{}).value();
        const double z = hand.surface() + kRadius - kDepth;
        for (int i = 1; i <= 100; ++i) {
            hand.at(z - 2e-5 * i);
            QCOMPARE_EQ(hand.servo.state.passivity.lastDamping(), 0);
        }
        QCOMPARE(hand.servo.state.schedule.goal(), 1.0);
    }
};

TACTUM_TEST(TestStabilityMovers)

} // namespace test_stability_movers

#include "test_stability_movers.moc"
