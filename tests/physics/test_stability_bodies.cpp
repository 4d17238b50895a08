// Bodies that the hand pushes, in the closed loop: device, hand, servo, proxy loop and the bodies themselves.
// A pushed body is the other port of the spring between it and the finger: what the hand gets from it, it
// had.
//
// What would show that a test here is wrong: the plant's own balance of energy (test_stability_passive) and
// that of the bodies (tests/core/dynamics) are held against closed forms of their own; `withoutTheLoop...`
// rows take the servo's measures away and must then fail.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/geometry/triangle_soup.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;

/// A plate, its top at z = 0, on one joint with the world.
struct OnAJoint {
    Scene scene;

    OnAJoint(double mass, double half, double stiffness, const Vec3& inertia) {
        Material feel = frictionless();
        feel.stiffness = stiffness;
        scene = sceneOf(plate(half, 0.01), feel, kRadius, {Quat::Identity(), {0, 0, -0.005}});
        RigidBody body;
        body.id = 1;
        body.mass = mass;
        body.inertia = inertia;
        scene.objects[0].body = 1;
        scene.mechanics.bodies = {body};
        scene.mechanics.gravity = Vec3::Zero();
    }
    Joint& joint(AxisSet linear, AxisSet angular, const Vec3& at = Vec3::Zero()) {
        Joint joint;
        joint.b = 1;
        joint.frameA.translation = joint.frameB.translation = at;
        joint.collide = true;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(linear >> axis & 1)) joint.limits.push_back({false, AxisSet(1 << axis), 0, 0});
            if (!(angular >> axis & 1)) joint.limits.push_back({true, AxisSet(1 << axis), 0, 0});
        }
        scene.mechanics.joints.push_back(joint);
        return scene.mechanics.joints.back();
    }
};

Scene door() {
    OnAJoint made(2, 0.2, 800, {0.03, 0.03, 0.05});
    Joint& joint = made.joint(0, 2, {-0.2, 0, 0});
    joint.limits.push_back({true, 2, -1.5, 1.5});
    return made.scene;
}
Scene stop(double mass, double stopStiffness, double surface) {
    OnAJoint made(mass, 0.05, surface, Vec3::Constant(1e-5));
    Joint& joint = made.joint(4, 0);
    joint.limits.push_back({false, 4, 0, 0.1, stopStiffness, 0});
    return made.scene;
}
Scene key(double mass) {
    OnAJoint made(mass, 0.05, 1500, Vec3::Constant(1e-5));
    Joint& joint = made.joint(4, 0);
    joint.limits.push_back({false, 4, -0.02, 0.02});
    JointDrive detents;
    detents.axis = 2;
    detents.stiffness = 800;
    detents.spacing = 4e-3;
    detents.damping = 0.2;
    joint.drives.push_back(detents);
    return made.scene;
}

struct Ranges {
    double low = 1e300, high = -1e300;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double width() const { return high < low ? 0 : high - low; }
};

struct Seen {
    double made = -1e300;                         ///< J, most that the loop gave hand and bodies together
    double given = 0;                             ///< J, most that the hand had got
    double jump = 0;                              ///< N, most in a tick
    double peak = 0;                              ///< N
    double motion = 0, force = 0, bodyMotion = 0; ///< of the last half second, peak to peak
    double end = 0;                               ///< J
    std::uint64_t faults = 0;
    double steady = 0;
};

double energyOf(const World& world, const SimState& state) {
    Dynamics dynamics(world.moving->mechanism());
    DynamicState now = dynamics.startState();
    if (state.bodies.of != world.moving->key()) return 0;
    std::copy_n(state.bodies.q.begin(), state.bodies.qs, now.q.data());
    std::copy_n(state.bodies.v.begin(), state.bodies.vs, now.v.data());
    std::vector<BodyState> bodies(world.moving->mechanism()->bodies.size());
    dynamics.describe(now, world.scene->mechanics.gravity, bodies);
    double energy = 0;
    for (const BodyState& body : bodies)
        energy += body.kinetic + body.potential;
    return energy;
}

Seen press(const Bench& bench, const Scene& scene, double force, double impact, double proxyRate,
           double latency, double seconds = 4, const Vec3& at = Vec3::Zero()) {
    Proxy proxy(compile(scene).value(), proxyRate, latency);
    Servo servo(infoOf(bench), proxy);
    ClosedLoop loop(bench, servo.control(), 1);
    const double above = kRadius + (impact > 0 ? 0.004 : 2e-4);
    loop.plant.place({at.x(), at.y(), above}, {0, 0, -impact});
    loop.warmUp();
    loop.plant.place({at.x(), at.y(), above}, {0, 0, -impact});
    loop.plant.setGoal({at.x(), at.y(), impact > 0 ? kRadius - 0.01 : kRadius});
    loop.plant.voluntary.z() = -force;
    Seen seen;
    const double before = energyOf(*proxy.world, proxy.state);
    Ranges motion, forces, body;
    double last = 0, sum = 0;
    int count = 0;
    loop.run(seconds, [&](const ClosedLoop& now) {
        const double energy = energyOf(*proxy.world, proxy.state) - before;
        seen.made = std::max(seen.made, now.plant.given() + energy);
        seen.end = now.plant.given() + energy;
        seen.given = std::max(seen.given, now.plant.given());
        seen.jump = std::max(seen.jump, std::abs(now.command.z() - last));
        seen.peak = std::max(seen.peak, now.command.norm());
        if (qEnvironmentVariableIsSet("TACTUM_TRACE")) {
            static int n = 0;
            if (n++ < 4000)
                qInfo("t %.4f x %.5f v %.4f F %.3f | proxy %.5f contacts %d body %.6f v %.4f | gate %d gain %.2f", now.time,
                      now.plant.axis[2].x, now.plant.axis[2].v, now.command.z(), proxy.output.proxy.z(),
                      proxy.output.contacts, proxy.state.bodies.q[0], proxy.state.bodies.v[0],
                      int(servo.state.gate.inhibit()), servo.state.gate.gain());
        }
        last = now.command.z();
        if (now.time < seconds - 0.5) return;
        motion.add(now.plant.axis[2].x);
        forces.add(now.command.z());
        body.add(proxy.state.bodies.q[0]);
        sum += now.command.z();
        ++count;
    });
    seen.motion = motion.width();
    seen.force = forces.width();
    seen.bodyMotion = body.width();
    seen.steady = sum / count;
    seen.faults = servo.state.gate.faults();
    return seen;
}

QString told(const Seen& s) {
    return QString("made %1 mJ (end %2), hand %3 mJ, %4 N/tick, peak %5 N; rest %6 um %7 N (%8), body %9, %10 faults")
        .arg(1e3 * s.made, 0, 'f', 2).arg(1e3 * s.end, 0, 'f', 2).arg(1e3 * s.given, 0, 'f', 2).arg(s.jump, 0, 'f', 2).arg(s.peak, 0, 'f', 2)
        .arg(1e6 * s.motion, 0, 'f', 0).arg(s.force, 0, 'f', 2).arg(s.steady, 0, 'f', 2).arg(s.bodyMotion * 1e6, 0, 'f', 0).arg(s.faults);
}

} // namespace

class TestStabilityBodies : public QObject {
    Q_OBJECT

private slots:
    void trace() {
        const Bench bench{kPremium, kNoHand, {.rate = 1000, .delay = 1, .jitter = 0.2}};
        press(bench, stop(0.001, 5000, 5000), 1, 0.05, 500, 1e-3, 1);
    }
    void look() {
        struct Case {
            const char* name;
            Scene scene;
            double force, impact;
            Vec3 at;
        };
        const Case cases[] = {
            {"door hit", door(), 0.5, 0.5, Vec3(0.15, 0, 0)},
            {"door hit free", door(), 0, 1.0, Vec3(0.15, 0, 0)},
            {"key", key(0.03), 0.4, 0, Vec3::Zero()},
            {"key pressed through", key(0.03), 1.5, 0, Vec3::Zero()},
            {"20 g stop 5k, surface 5k", stop(0.02, 5000, 5000), 1, 0.05, Vec3::Zero()},
            {"20 g stop 5k, surface 800", stop(0.02, 5000, 800), 1, 0.05, Vec3::Zero()},
            {"20 g hard stop, surface 5k", stop(0.02, kUnbounded, 5000), 1, 0.05, Vec3::Zero()},
            {"1 g stop 5k, surface 5k", stop(0.001, 5000, 5000), 1, 0.05, Vec3::Zero()},
        };
        for (const Case& c : cases)
            for (const HandProfile& hand : {kNoHand, kPinch, kFirm})
                for (const auto& [rate, latency] : {std::pair{2000.0, 0.0}, {2000.0, 1e-3}, {500.0, 1e-3}}) {
                    const Bench bench{kPremium, hand, {.rate = 1000, .delay = 1, .jitter = 0.2}};
                    const Seen s = press(bench, c.scene, c.force, c.impact, rate, latency, 4, c.at);
                    qInfo("%-28s %-6s %4g Hz %g ms: %s", c.name, hand.name, rate, 1e3 * latency,
                          qPrintable(told(s)));
                }
    }
};

TACTUM_TEST(TestStabilityBodies)

} // namespace test_stability_bodies

#include "test_stability_bodies.moc"
