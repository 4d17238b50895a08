// T7: an edit in contact. T8: a scene swap, or an object that lands on the finger. Both move the hand no
// faster than it can bear; done at once, or by slowing the force, they do not.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/event.h"
#include "tests/physics/press.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_changes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kFastest = 0.05; ///< m/s, of the hand in any event

/// A finger that rests on a wall under a force.
struct Resting {
    Resting(const Bench& bench, double stiffness, double force, double depth = 0)
        : model(wall(stiffness)), servo(infoOf(bench), model), loop(bench, servo.control()) {
        loop.plant.place({0, 0, -depth});
        loop.plant.voluntary.z() = -force;
        loop.warmUp();
        loop.run(3);
    }

    GivenModel model;
    Servo servo;
    ClosedLoop loop;
};

/// J, that the person's side holds: muscles as a constant force, and the arm's spring.
double held(const ClosedLoop& loop) {
    const Plant& plant = loop.plant;
    const HandProfile& hand = loop.bench().hand;
    const double stretch = plant.handX[2] - plant.goal[2];
    return -plant.voluntary.z() * plant.handX[2] + 0.5 * hand.armStiffness * stretch * stretch +
           0.5 * hand.gripStiffness * std::pow(plant.x[2] - plant.handX[2], 2);
}

/// A wall that may move, become stiffer and be slewed: what the product does not do.
struct WorseWall {
    double stiffness = 500, height = 0;
    double slew = 0; ///< N/s; 0: none
    Vec3 last = Vec3::Zero();

    Vec3 operator()(const DeviceSample& sample, double dt) {
        const double wanted = std::max(0.0, stiffness * (height - sample.position.z()));
        const double change = slew > 0 ? slew * dt : 1e9;
        last.z() += std::clamp(wanted - last.z(), -change, change);
        return last;
    }
};

} // namespace

class TestStabilityChanges : public QObject {
    Q_OBJECT

private slots:
    void editIsGentle_data() {
        QTest::addColumn<int>("hand");
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        for (const int hand : {0, 1})
            for (const double force : {1.0, 3.0}) {
                QTest::addRow("%s, %g N, stiffer", kHands[std::size_t(hand)].name, force)
                    << hand << force << 500.0 << 2000.0;
                QTest::addRow("%s, %g N, softer", kHands[std::size_t(hand)].name, force)
                    << hand << force << 2000.0 << 500.0;
            }
    }

    /// T7.
    void editIsGentle() {
        QFETCH(int, hand);
        QFETCH(double, force);
        QFETCH(double, from);
        QFETCH(double, to);
        const Bench bench{kFalcon, kHands[std::size_t(hand)], {}};
        Resting resting(bench, from, force);
        const double before = held(resting.loop);
        resting.model.model.stiffness = to;
        ++resting.model.model.revision;
        const Event event = watchEvent(resting.loop, 4);
        const double rise = held(resting.loop) - before;
        qInfo("%.3f m/s, %.2f mJ of %.2f, %.3f N in a tick", event.speed, 1e3 * event.given, 1e3 * rise,
              event.jump);
        QCOMPARE(resting.servo.state.transition.easing(), false);
        QCOMPARE_LE(event.speed, kFastest);
        QCOMPARE_LE(event.given, std::max(rise, 0.0) + 5e-3);
        QCOMPARE_LE(event.jump, std::max(from, to) * kFalcon.resolution + 0.05);
    }

    void editAtOnceIsNot() {
        for (const HandProfile& hand : {kPinch, kGrasp}) {
            WorseWall worse;
            ClosedLoop loop({kFalcon, hand, {}}, std::ref(worse));
            loop.plant.place(Vec3::Zero());
            loop.plant.voluntary.z() = -3;
            loop.run(3);
            worse.stiffness = 2000;
            const Event event = watchEvent(loop, 1);
            qInfo("%.3f m/s, %.1f mJ, %.2f N in a tick", event.speed, 1e3 * event.given, event.jump);
            QCOMPARE_GT(event.speed, 2 * kFastest);
        }
    }

    void aCeilingThatRisesIsGentle_data() {
        QTest::addColumn<bool>("override");
        QTest::newRow("a machine that is in time again") << false;
        QTest::newRow("a person who knows better, from the next contact on") << true;
    }

    void aCeilingThatRisesIsGentle() {
        QFETCH(bool, override);
        double fastest = 0;
        for (const PlantProfile& device : kDevices)
            for (const double force : {1.0, 3.0}) {
                if (force > device.maxForce) continue;
                const Bench bench{device, kPinch, {.delay = 1}};
                GivenModel model(wall(6000));
                Servo servo(infoOf(bench), model);
                ClosedLoop loop(bench, servo.control());
                servo.settings.period = override ? 0 : 4e-3;
                loop.plant.place({0, 0, 0});
                loop.plant.voluntary.z() = -force;
                loop.warmUp();
                loop.run(3);
                const double before = servo.state.transition.rendered().stiffness;
                servo.settings.period = 0;
                servo.settings.overrideCeiling = override;
                const Event event = watchEvent(loop, 3);
                fastest = std::max(fastest, event.speed);
                QCOMPARE_LE(event.speed, kFastest);
                QVERIFY(servo.state.previous.touching);
                QCOMPARE_NE(servo.state.transition.rendered().stiffness > 1.2 * before, override);
                loop.plant.place({0, 0, 0.005});
                loop.plant.voluntary.z() = 0;
                loop.run(0.01);
                loop.plant.place({0, 0, -1e-4});
                loop.tick();
                QCOMPARE_GT(servo.state.transition.rendered().stiffness, 1.2 * before);
            }
        qInfo("%.3g m/s", fastest);
    }

    void surfaceThatLandsOnTheFingerComesGently_data() {
        QTest::addColumn<int>("hand");
        QTest::addColumn<double>("depth");
        for (const int hand : {0, 1, 2})
            for (const double depth : {0.001, 0.005, 0.019})
                QTest::addRow("%s, %g mm", kHands[std::size_t(hand)].name, 1e3 * depth) << hand << depth;
    }

    /// T8: the wall was not there, and then it is, with the finger in it.
    void surfaceThatLandsOnTheFingerComesGently() {
        QFETCH(int, hand);
        QFETCH(double, depth);
        const Bench bench{kFalcon, kHands[std::size_t(hand)], {}};
        GivenModel model(wall(1500));
        model.model.planes = 0;
        Servo servo(infoOf(bench), model);
        ClosedLoop loop(bench, servo.control());
        loop.plant.place({0, 0, -depth});
        loop.warmUp();
        loop.run(0.1);
        model.model.planes = 1;
        ++model.model.restarts;
        ++model.model.revision;
        const Event event = watchEvent(loop, 3);
        qInfo("%.3f m/s, %.3f N in a tick", event.speed, event.jump);
        QCOMPARE_LE(event.speed, kFastest);
        QCOMPARE_LE(event.jump, 1500 * kFalcon.resolution + 0.05);
        QCOMPARE_GT(loop.plant.x[2], -1e-3 + 0.2 * (1e-3 - depth)); // it did come
    }

    void lostInsideComesBackGently_data() {
        QTest::addColumn<int>("hand");
        QTest::addColumn<double>("moved");
        for (const int hand : {0, 1, 2})
            for (const double moved : {0.0, 0.015})
                QTest::addRow("%s, %g mm on", kHands[std::size_t(hand)].name, 1e3 * moved) << hand << moved;
    }

    /// A device that is lost while the finger presses a closed body: armed again, the finger is led out of it
    /// as slowly as by a surface that lands on it. While it is lost it sinks in, and may be `moved`.
    void lostInsideComesBackGently() {
        QFETCH(int, hand);
        QFETCH(double, moved);
        constexpr double kRadius = 1e-3, kBall = 0.05;
        const Bench bench{kFalcon, kHands[std::size_t(hand)], {}};
        Material material = frictionless();
        material.stiffness = 1500;
        const Pose below{Quat::Identity(), Vec3(0, 0, -kBall - kRadius)}; // its proxy rests at z = 0
        Proxy proxy(worldOf(ball(kBall, 4), material, kRadius, below), 1000);
        Servo servo(infoOf(bench), proxy);
        ClosedLoop loop(bench, servo.control(), 3);
        loop.plant.place({0, 0, 0.002});
        loop.plant.setGoal({0, 0, -0.01});
        loop.warmUp();
        loop.run(1);
        QCOMPARE_GT(proxy.output.contacts, 0);
        QCOMPARE_GT(loop.command.z(), 0.1);

        loop.tamper = [](DeviceSample& sample) { sample.valid = false; };
        loop.plant.setGoal({moved, 0, -0.01});
        loop.run(1);
        QCOMPARE(servo.state.gate.inhibit(), InhibitReason::DeviceLost);
        QCOMPARE_LT(loop.plant.position().z(), -0.004); // deep, and without force
        loop.tamper = nullptr;
        servo.settings.armed = false;
        loop.run(0.05);
        servo.settings.armed = true;
        const Vec3 centre = below.translation;
        double innermost = 1;
        const Event event = watchEvent(loop, 4, [&](const ClosedLoop&) {
            innermost = std::min(innermost, (proxy.state.proxy.position - centre).norm());
        });
        qInfo("%.3f m/s, %.3f N in a tick, proxy at %.2f mm, finger at %.2f mm, force %.2f N", event.speed,
              event.jump, 1e3 * innermost, 1e3 * loop.plant.position().z(), loop.command.norm());
        QCOMPARE_GT(innermost, kBall);
        QCOMPARE_LE(event.speed, kFastest);
        // A count, and what the damping of a force that comes back may change by.
        QCOMPARE_LE(event.jump,
                    1500 * bench.device.resolution + 0.05 + kAddedRate * bench.device.maxForce * 1e-3);
        QCOMPARE_GT(proxy.output.contacts, 0);
        QCOMPARE_GT(loop.command.norm(), 0.1);                              // it is felt again
        QCOMPARE_GT((loop.plant.position() - centre).norm(), kBall - 2e-3); // and was led to the surface
    }

    /// A rough surface lands on a finger that then goes sideways. The proxy sticks, deep as the finger is,
    /// and the surface that is felt slips: when it has come back, friction pulls no farther back than it did.
    void slippedOnTheWayBackIsSlipped() {
        constexpr double kStiffness = 300, kDepth = 0.012, kAside = 0.01;
        GivenModel model(wall(kStiffness));
        model.model.friction[0].coefficient = 1;
        model.model.planes = 0;
        Servo servo(infoOf({kFalcon, kFirm, {}}), model);
        DeviceSample finger;
        finger.valid = true;
        finger.position = {0, 0, -kDepth};
        const auto stay = [&](double seconds) {
            for (double t = 0; t < seconds; t += 1e-3)
                servo(finger, 1e-3);
            return servo.output.force;
        };
        stay(1);
        model.model.planes = 1;
        ++model.model.restarts;
        ++model.model.revision;
        stay(0.1);
        for (; finger.position.x() < kAside; finger.position.x() += 1e-4)
            servo(finger, 1e-3);
        const Vec3 aside = stay(1e-3), back = stay(1);
        qInfo("%.2f N aside, %.2f N when it is back, under %.2f N", -aside.x(), -back.x(), back.z());
        QCOMPARE_GT(std::abs(aside.x()), 0.9 * aside.z()); // it slipped
        COMPARE_NEAR(back.z(), kStiffness * kDepth, 1e-3, "N");
        QVERIFY2(std::abs(back.x()) <= std::abs(aside.x()) + 0.01, "pulled back");
        // What the proxy then slips by itself is no new way, and what it slips beyond is.
        model.model.proxy.x() = 0.5 * kAside;
        const Vec3 same = stay(0.1);
        COMPARE_NEAR(same, back, 1e-3, "N");
        model.model.proxy.x() = finger.position.x();
        QCOMPARE_LT(std::abs(stay(1).x()), 1e-3);
    }

    /// Rules 1 and 2 switched off: a faster return, a jump, a ramp of the stiffness alone.
    void surfaceThatComesOtherwiseDoesNot() {
        const auto speedWith = [](double returnSpeed, double ramp) {
            WorseWall worse;
            worse.stiffness = ramp > 0 ? 0 : 1500;
            worse.height = returnSpeed > 0 ? -0.019 : 0;
            ClosedLoop loop({kFalcon, kPinch, {}}, std::ref(worse));
            loop.plant.place({0, 0, -0.019});
            return watchEvent(loop, 3,
                              [&](const ClosedLoop&) {
                                  if (returnSpeed > 0)
                                      worse.height = std::min(0.0, worse.height + returnSpeed * 1e-3);
                                  if (ramp > 0)
                                      worse.stiffness =
                                          std::min(1500.0, worse.stiffness + 1500 * 1e-3 / ramp);
                              })
                .speed;
        };
        qInfo("10 mm/s %.3f, 20 mm/s %.3f, 50 mm/s %.3f, jump %.3f, ramp of 2 s %.3f m/s", speedWith(0.01, 0),
              speedWith(0.02, 0), speedWith(0.05, 0), speedWith(0, 0), speedWith(0, 2));
        QCOMPARE_LE(speedWith(0.02, 0), kFastest);
        QCOMPARE_GT(speedWith(0.05, 0), kFastest);
        QCOMPARE_GT(speedWith(0, 0), kFastest);
        QCOMPARE_GT(speedWith(0, 2), kFastest);
    }

    /// Rule 1 switched off: a force that is slowed down makes a limit cycle.
    void slowedForceSwings() {
        const auto swing = [](double slew) {
            WorseWall worse{.stiffness = 2000, .slew = slew};
            ClosedLoop loop({kLowFriction, kPinch, {}}, std::ref(worse));
            loop.plant.place({0, 0, 0.002}, {0, 0, -0.3});
            loop.plant.voluntary.z() = -1;
            loop.run(2);
            double low = 1, high = -1, given = loop.plant.given();
            loop.run(0.5, [&](const ClosedLoop& now) {
                low = std::min(low, now.plant.x[2]);
                high = std::max(high, now.plant.x[2]);
            });
            qInfo("%g N/s: %.1f mm, %.0f mJ", slew, 1e3 * (high - low), 1e3 * given);
            return high - low;
        };
        QCOMPARE_LE(swing(0), 2 * kLowFriction.resolution);
        QCOMPARE_GT(swing(100), 0.01);
        QCOMPARE_GT(swing(20), 0.01);
    }
};

TACTUM_TEST(TestStabilityChanges)

} // namespace test_stability_changes

#include "test_stability_changes.moc"
