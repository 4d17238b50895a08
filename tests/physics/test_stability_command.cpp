// What leaves: newtons a tick, sideways, and of what an encoder makes up. Judged on the command, after all
// that is added.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/as_connected.h"
#include "tests/physics/event.h"
#include "tests/physics/hand_script.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_stability_command {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMaxChange = 0.3; ///< of the limit, that a tick may change the command by

/// A finger on a wall that is as stiff as the device bears.
struct OnTheWall {
    OnTheWall(const Connected& device, const HandProfile& hand, int axes)
        : model(wall(5000)), servo(connectedInfo(device), model),
          loop(benchOf(device, hand), servo.control(), axes) {}

    GivenModel model;
    Servo servo;
    ClosedLoop loop;
};

/// What the command does from tick to tick.
struct Leaving {
    double change = 0;      ///< N a tick, largest
    double unexplained = 0; ///< N a tick, beyond stiffness times the way that was read
    double sideways = 0;    ///< N, largest, along the wall
    int large = 0;          ///< ticks with more than kMaxChange of the limit

    void add(const ClosedLoop& loop, double stiffness) {
        const Vec3 step = loop.command - last_;
        change = std::max(change, step.norm());
        unexplained = std::max(unexplained, step.norm() - stiffness * (loop.reading - read_).norm());
        sideways = std::max(sideways, std::hypot(loop.command.x(), loop.command.y()));
        large += step.norm() > kMaxChange * loop.bench().device.maxForce;
        last_ = loop.command;
        read_ = loop.reading;
    }

private:
    Vec3 last_ = Vec3::Zero(), read_ = Vec3::Zero();
};

void addDevices() {
    for (int i = 0; i < int(kConnected.size()); ++i)
        QTest::newRow(kConnected[std::size_t(i)].plant.name) << i;
}

} // namespace

class TestStabilityCommand : public QObject {
    Q_OBJECT

private slots:
    void anEncoderThatFlipsMakesNoForce_data() {
        QTest::addColumn<int>("device");
        QTest::addColumn<double>("flip");
        for (int i = 0; i < int(kConnected.size()); ++i)
            for (const double flip : {0.2e-3, 0.5e-3, 1e-3})
                QTest::addRow("%s, %g mm", kConnected[std::size_t(i)].plant.name, 1e3 * flip) << i << flip;
    }

    /// Bad cable or bad interpolation: every other reading is off.
    void anEncoderThatFlipsMakesNoForce() {
        QFETCH(int, device);
        QFETCH(double, flip);
        OnTheWall on(kConnected[std::size_t(device)], kPinch, 1);
        on.loop.plant.voluntary.z() = -2;
        on.loop.warmUp();
        on.loop.run(2);
        bool odd = false;
        on.loop.tamper = [&](DeviceSample& sample) {
            if ((odd = !odd)) sample.position.z() += flip;
        };
        Leaving leaving;
        on.loop.run(0.01);
        leaving.add(on.loop, 1e9);
        leaving = {};
        const double limit = on.loop.bench().device.maxForce;
        bool first = true;
        on.loop.run(2, [&](const ClosedLoop& now) {
            Leaving fresh = leaving;
            fresh.add(now, on.servo.state.transition.rendered().stiffness);
            if (first) fresh.change = fresh.unexplained = fresh.large = 0;
            first = false;
            leaving = fresh;
        });
        qInfo("%.2f N a tick, %.2f unexplained, %d of 2000 above %.2f, fault %d", leaving.change,
              leaving.unexplained, leaving.large, kMaxChange * limit, int(on.servo.state.gate.inhibit()));
        QCOMPARE(leaving.large, 0);
        QCOMPARE_LE(leaving.unexplained, 0.05 * limit);
    }

    void tenMinutesAreCalm_data() {
        QTest::addColumn<int>("device");
        addDevices();
    }

    /// Strokes, taps and holds with edits between 300 N/m and more than the device bears: no tick that the
    /// finger does not explain, no softened contact, no fault. Clamped rigidly, which is no hand, it may be
    /// softened.
    void tenMinutesAreCalm() {
        QFETCH(int, device);
        const Connected& connected = kConnected[std::size_t(device)];
        const double limit = connected.plant.maxForce;
        for (const HandProfile& hand : {kPinch, kGrasp, kFirm, kRigid}) {
            OnTheWall on(connected, hand, 3);
            HandScript script(std::uint64_t(70 + device), 0, 0.25);
            on.loop.plant.place({0, 0, 0.01});
            on.loop.warmUp();
            Leaving leaving;
            Rng random(std::uint64_t(device + 1));
            double softest = 1, next = 5;
            bool sound = true;
            on.loop.run(longOnly(600), [&](ClosedLoop& now) {
                now.plant.setGoal(script.goal(1e-3));
                leaving.add(now, on.servo.state.transition.rendered().stiffness);
                softest = std::min(softest, on.servo.state.schedule.scale());
                sound = sound && now.command.allFinite() && now.command.norm() <= limit * (1 + 1e-12);
                if (now.time < next) return;
                next += uniform(random, 1, 5);
                on.model.model.stiffness = uniform(random, 300, 5000);
                ++on.model.model.revision;
            });
            qInfo("%s: softest %.3f, %.2f N a tick beyond the finger's way", hand.name, softest,
                  leaving.unexplained);
            QVERIFY(sound);
            QCOMPARE_LE(leaving.unexplained, kMaxChange * limit);
            QCOMPARE(on.servo.state.gate.faults(), 0u);
            QCOMPARE(on.servo.state.schedule.oscillations(), 0u);
            if (!hand.rigid) QCOMPARE_GE(softest, 0.9);
        }
    }

    void tapsAndStrokesDoNotKick_data() {
        QTest::addColumn<int>("device");
        addDevices();
    }

    /// On a frictionless wall at the ceiling nothing pushes sideways, and what is new in a tick is the
    /// finger's own way.
    void tapsAndStrokesDoNotKick() {
        QFETCH(int, device);
        const Connected& connected = kConnected[std::size_t(device)];
        Leaving leaving;
        double given = 0;
        for (const HandProfile& hand : {kPinch, kGrasp, kFirm}) {
            OnTheWall on(connected, hand, 3);
            HandScript script(std::uint64_t(7 + device), 0, 0.25);
            on.loop.plant.place({0, 0, 0.01});
            on.loop.warmUp();
            double before = 0, most = 0, softest = 1, fastest = 0;
            on.loop.run(60, [&](ClosedLoop& now) {
                now.plant.setGoal(script.goal(1e-3));
                leaving.add(now, on.servo.state.transition.rendered().stiffness);
                if (now.command.z() == 0) before = now.plant.given();
                most = std::max(most, now.plant.given() - before);
                fastest = std::max(fastest, now.plant.velocity().norm());
                softest = std::min(softest, on.servo.state.schedule.scale());
            });
            given = std::max(given, most);
            QCOMPARE(softest, 1.0);
            qInfo("%s: softened %d, faults %d, ceiling %.0f, %.2f mJ a contact, softest %.3f, %.2f m/s",
                  hand.name, int(on.servo.state.schedule.oscillations()), int(on.servo.state.gate.faults()),
                  on.servo.state.schedule.ceiling().value, 1e3 * most, softest, fastest);
            QCOMPARE(on.servo.state.gate.faults(), 0u);
            QCOMPARE(on.servo.state.schedule.oscillations(), 0u);
        }
        qInfo("%.2f N a tick, %.2f unexplained, %.2f N sideways, %.2f mJ a contact", leaving.change,
              leaving.unexplained, leaving.sideways, 1e3 * given);
        QCOMPARE_LE(leaving.sideways, 1e-9);
        QCOMPARE_LE(leaving.unexplained, 0.055 * connected.plant.maxForce);
        QCOMPARE_LE(given, 2e-3); // strokes of up to 1 m/s; the damping across all of the way gave as much
    }
};

TACTUM_TEST(TestStabilityCommand)

} // namespace test_stability_command

#include "test_stability_command.moc"
