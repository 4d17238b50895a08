// Edits of shape under the finger: where the same body is still there the contact stays, and the difference
// comes in at 15 mm/s. A finger that presses never falls into what it presses on.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/as_connected.h"
#include "tests/physics/event.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_shapes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3, kHalf = 0.03; ///< m
/// N: a hand that is led at 15 mm/s is braked by itself and by the device, and gathers way.
constexpr double kOfTheWay = 0.45;
constexpr double kFrame = 1.0 / 60; ///< s
/// A grasp whose muscles push with one force wherever the hand is.
constexpr HandProfile kLed{"led", 0.3, 1000, 4, 0, 5};

/// A solid cube of 6 cm whose top is z = `top`, shifted aside.
Soup box(double top, double aside = 0) {
    const Vec3 low(-kHalf + aside, -kHalf, top - 2 * kHalf), high(kHalf + aside, kHalf, top);
    const auto corner = [&](int i) {
        return Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
    };
    SoupBuilder builder;
    builder.quad(corner(0), corner(2), corner(3), corner(1)).quad(corner(4), corner(5), corner(7), corner(6));
    builder.quad(corner(0), corner(1), corner(5), corner(4)).quad(corner(2), corner(6), corner(7), corner(3));
    builder.quad(corner(0), corner(4), corner(6), corner(2)).quad(corner(1), corner(3), corner(7), corner(5));
    return builder.build();
}

Material material(double friction) {
    Material result = rough(friction, 0.8 * friction);
    result.stiffness = 800;
    return result;
}

/// A finger that presses on the cube; its muscles hold it straight.
struct Pressing {
    Pressing(double force, double theFriction = 0.3)
        : friction(theFriction), world(compile(scene(0, 0, kRadius)).value()), proxy(world, 2000),
          servo(connectedInfo(kOmegaConnected), proxy),
          loop(benchOf(kOmegaConnected, kLed), servo.control(), 3) {
        loop.plant.place({0, 0, kRadius + 1e-3});
        loop.warmUp();
        loop.plant.voluntary.z() = -force;
        loop.run(5);
        pressed = loop.command.z();
        resting = loop.plant.position().z();
    }
    Scene scene(double top, double aside, double radius) const {
        return sceneOf(box(top, aside), material(friction), radius);
    }
    void edit(double top, double aside = 0, double radius = kRadius) {
        world = compile(scene(top, aside, radius), world.get()).value();
        proxy.world = world;
    }

    double friction;
    std::shared_ptr<const World> world;
    Proxy proxy;
    Servo servo;
    ClosedLoop loop;
    double pressed = 0, resting = 0; ///< N, m
};

/// What the finger felt while something was edited.
struct Felt {
    double weakest = 1e9, strongest = 0; ///< N
    double lowest = 1e9;                 ///< m
    double jump = 0;                     ///< N a tick
    double speed = 0;                    ///< m/s

    void watch(ClosedLoop& loop, double seconds) {
        Vec3 last = loop.command;
        loop.run(seconds, [&](const ClosedLoop& now) {
            weakest = std::min(weakest, now.command.z());
            strongest = std::max(strongest, now.command.norm());
            lowest = std::min(lowest, now.plant.position().z());
            jump = std::max(jump, (now.command - last).norm());
            speed = std::max(speed, now.plant.velocity().norm());
            last = now.command;
        });
    }
    void tell(const Pressing& on) const {
        qInfo("pressed with %.2f N: %.2f to %.2f N, %.3f mm lower at most, %.3f N a tick, %.3f m/s",
              on.pressed, weakest, strongest, 1e3 * (on.resting - lowest), jump, speed);
    }
};

} // namespace

class TestStabilityShapes : public QObject {
    Q_OBJECT

private slots:
    void aBodyThatIsMovedStays_data() {
        QTest::addColumn<double>("force");
        QTest::addColumn<double>("by");
        for (const double force : {1.0, 2.0, 4.0})
            for (const double by : {1e-3, 5e-3, -1e-3, 20e-3})
                QTest::addRow("%g N, %g mm", force, 1e3 * by) << force << by;
    }

    /// Up or down by so much at once.
    void aBodyThatIsMovedStays() {
        QFETCH(double, force);
        QFETCH(double, by);
        Pressing on(force);
        COMPARE_NEAR(on.pressed, force, 0.1 * force, "N");
        on.edit(by);
        Felt felt;
        felt.watch(on.loop, std::abs(by) / kReturnSpeed + 2);
        felt.tell(on);
        // The way back is pushed before the hand, or the hand follows it down.
        QCOMPARE_GE(felt.weakest, on.pressed - kOfTheWay);
        QCOMPARE_LE(felt.jump, 0.2);
        QCOMPARE_LE(felt.speed, 0.05);
        QCOMPARE_LE(on.resting - felt.lowest, std::max(0.0, -by) + 3e-4);
        COMPARE_NEAR(on.loop.plant.position().z() - on.resting, by, 3e-4, "m");
        COMPARE_NEAR(on.loop.command.z(), force, 0.1 * force, "N");
        QCOMPARE(on.servo.state.gate.faults(), 0u);
    }

    /// Of a finger that touched nothing: the first push of what was moved over it, and no throw.
    void whatComesIsFeltSoon() {
        for (const double by : {1.5e-3, 3e-3, 10e-3}) {
            Pressing on(0);
            QCOMPARE(on.pressed, 0.0);
            const double begun = on.loop.time;
            on.edit(by);
            double felt = 1e9, speed = 0;
            on.loop.run(1, [&](const ClosedLoop& now) {
                if (now.command.z() > 0.05) felt = std::min(felt, now.time - begun);
                speed = std::max(speed, now.plant.velocity().norm());
            });
            qInfo("%g mm: after %.1f ms, %.3f m/s", 1e3 * by, 1e3 * felt, speed);
            QCOMPARE_LE(felt, 0.15);
            QCOMPARE_LE(speed, 0.05);
        }
    }

    void aDraggedBodyPushesOn_data() {
        QTest::addColumn<Vec3>("way");
        QTest::newRow("up") << Vec3(0, 0, 0.01);
        QTest::newRow("down") << Vec3(0, 0, -0.01);
        QTest::newRow("aside") << Vec3(0.01, 0, 0);
    }

    /// Sixty edits in a second, as the mouse makes them; m/s.
    void aDraggedBodyPushesOn() {
        QFETCH(Vec3, way);
        Pressing on(2);
        Felt felt;
        for (int i = 1; i <= 60; ++i) {
            on.edit(way.z() * i * kFrame, way.x() * i * kFrame);
            felt.watch(on.loop, kFrame);
        }
        felt.tell(on);
        QCOMPARE_GE(felt.weakest, on.pressed - kOfTheWay);
        QCOMPARE_LE(felt.jump, 0.2);
        felt.watch(on.loop, 2);
        COMPARE_NEAR(on.loop.command.z(), 2, 0.2, "N");
        COMPARE_NEAR(on.loop.plant.position().z() - on.resting, way.z(), 5e-4, "m");
        QCOMPARE(on.servo.state.gate.faults(), 0u);
    }

    void aProxyOfAnotherRadiusPushesOn() {
        for (const double radius : {0.5e-3, 3e-3}) {
            Pressing on(2);
            on.edit(0, 0, radius);
            Felt felt;
            felt.watch(on.loop, 2);
            felt.tell(on);
            QCOMPARE_GE(felt.weakest, on.pressed - kOfTheWay);
            QCOMPARE_LE(felt.jump, 0.2);
            COMPARE_NEAR(on.loop.plant.position().z() - on.resting, radius - kRadius, 3e-4, "m");
        }
    }

    void leavingABodyOnItsFarSideIsNoStep_data() {
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("rate");
        for (const double friction : {0.0, 0.5})
            for (const double rate : {2000.0, 100.0})
                QTest::addRow("mu %g, %g Hz", friction, rate) << friction << rate;
    }

    /// Pressed in through the top and out again through the bottom, then aside until the proxy falls around
    /// the edge.
    void leavingABodyOnItsFarSideIsNoStep() {
        QFETCH(double, friction);
        QFETCH(double, rate);
        Proxy proxy(compile(sceneOf(box(0), material(friction), kRadius)).value(), rate);
        DeviceInfo info = connectedInfo(kOmegaConnected);
        Servo servo(info, proxy);
        Vec3 at(0.01, 0.003, 0.01), last = Vec3::Zero();
        double jump = 0, strongest = 0;
        const auto go = [&](const Vec3& to, double speed) {
            const Vec3 from = at;
            const int ticks = std::max(1, int((to - from).norm() / speed * 1e3));
            for (int i = 1; i <= ticks; ++i) {
                at = from + (to - from) * (double(i) / ticks);
                DeviceSample sample;
                sample.position = at;
                sample.valid = true;
                const Vec3 force = servo(sample, 1e-3);
                const double explained = servo.state.transition.rendered().stiffness * speed * 1e-3;
                jump = std::max(jump, (force - last).norm() - explained);
                strongest = std::max(strongest, force.norm());
                last = force;
            }
        };
        go(at + Vec3(0, 0, 1e-5), 1e-5); // until the force is there
        go({0.01, 0.003, -0.07}, 0.1);
        go({0.05, 0.003, -0.07}, 0.1);
        go({0.05, 0.003, 0.01}, 0.1);
        qInfo("%.2f N, %.2f N in a tick", strongest, jump);
        QCOMPARE_GT(strongest, 10);
        QCOMPARE_LE(jump, 0.3 * info.maxForce);
        QCOMPARE(servo.state.gate.faults(), 0u);
    }

    /// What is not there any more fades, and the hand is not thrown.
    void aBodyThatIsGoneFades() {
        Pressing on(2);
        on.edit(-0.02, 0.2);
        Felt felt;
        felt.watch(on.loop, 0.15);
        felt.tell(on);
        QCOMPARE_LE(felt.jump, 0.2);
    }
};

TACTUM_TEST(TestStabilityShapes)

} // namespace test_stability_shapes

#include "test_stability_shapes.moc"
