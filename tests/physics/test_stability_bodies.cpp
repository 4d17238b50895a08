// Bodies that the hand pushes, in the closed loop: device, hand, servo, proxy loop and the bodies themselves.
// A pushed body is the other port of the spring between it and the finger: what the hand gets from it, it
// had.
//
// What would show that a test here is wrong: the plant's balance of energy (test_stability_passive) and that
// of the bodies (tests/core/dynamics) are held against closed forms elsewhere; and
// `withoutTheCouplingEnergyIsMade` runs the same cases with bodies that get what the model says, as they did
// once, and must find energy.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/geometry/triangle_soup.h"
#include "tests/physics/as_connected.h"
#include "tests/physics/hand_script.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_stability_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3; ///< m
/// J, that a loop may give in a hit: what it gives where a wall of the same stiffness stands still, and a
/// fifth more.
constexpr double kGiven = 6e-3;
/// Of the device's limit, in a tick: what a newer model may turn the force by, and what added damping may
/// change.
constexpr double kJump = kMaxTurn + 0.02;

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

/// Where the hand is when it meets the body, and how.
struct Meeting {
    const char* name;
    Scene scene;
    double force;                  ///< N, of the muscles
    double impact;                 ///< m/s
    double aside;                  ///< m, from the middle of the plate
    double tapped = longOnly(100); ///< s
};

std::vector<Meeting> meetings() {
    const double briefly = isLong() ? 20 : 10; // a gram took two fifths of the time of all
    return {{"a door hit hard", door(), 0.5, 0.5, 0.15},
            {"a door hit very hard and left", door(), 0, 1, 0.15},
            {"a key at its detent", key(0.03), 0.4, 0, 0},
            {"a key pressed through its detents", key(0.03), 1.5, 0, 0},
            {"20 g on 5 kN/m", stop(0.02, 5000, 5000), 1, 0.05, 0},
            {"20 g on 5 kN/m, softer surface", stop(0.02, 5000, 800), 1, 0.05, 0},
            {"20 g on a hard stop", stop(0.02, kUnbounded, 5000), 1, 0.05, 0},
            {"1 g on 5 kN/m", stop(0.001, 5000, 5000), 1, 0.05, 0, briefly},
            {"a hundred tonnes", stop(1e5, 5000, 5000), 1, 0.05, 0}};
}

/// The proxy loop beside the servo.
struct Beside {
    double rate;    ///< Hz
    double latency; ///< s
};

/// Of all bodies of a proxy's world, with what their springs hold.
class Energy {
public:
    explicit Energy(const Proxy& proxy)
        : proxy_(proxy), moving_(*proxy.world->moving), dynamics_(moving_.mechanism()),
          bodies_(moving_.mechanism()->bodies.size()) {}

    /// J
    double operator()() {
        now_ = start_;
        if (const auto& state = proxy_.state.bodies; state.of == moving_.key()) {
            std::copy_n(state.q.begin(), state.qs, now_.q.data());
            std::copy_n(state.v.begin(), state.vs, now_.v.data());
        }
        dynamics_.describe(now_, moving_.gravity(), bodies_);
        double energy = dynamics_.springEnergy(now_);
        for (const BodyState& body : bodies_)
            energy += body.kinetic + body.potential;
        return energy;
    }

private:
    const Proxy& proxy_;
    const MovingBodies& moving_;
    Dynamics dynamics_;
    const DynamicState start_ = dynamics_.startState();
    DynamicState now_ = start_;
    std::vector<BodyState> bodies_;
};

/// A top that spins under the finger, beside its axis.
Scene top() {
    OnAJoint made(0.2, 0.05, 800, {1e-4, 1e-4, 2e-4});
    Material& feel = made.scene.objects[0].surfaces[0].material;
    feel.staticFriction = 0.5;
    feel.dynamicFriction = 0.4;
    made.joint(0, 7, {0, 0, -0.005});
    made.scene.mechanics.bodies[0].angularVelocity = {0, 0, 100};
    return made.scene;
}

struct Range {
    double low = 1e300, high = -1e300;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double width() const { return high < low ? 0 : high - low; }
};

struct Seen {
    double given = -1e300; ///< J, most that the hand had got beyond what the bodies had lost
    double jump = 0;       ///< N, most in a tick
    double motion = 0;     ///< m, of the device in the last half second, peak to peak
    double force = 0;      ///< N, likewise
    double bodies = 0;     ///< m or rad, likewise: of the body's joint
    std::uint64_t faults = 0;
};

/// The third axis of a device in a hand that meets a plate.
Seen meet(const Bench& bench, const Beside& beside, const Meeting& meeting, bool coupled = true,
          double seconds = 3) {
    Proxy proxy(compile(meeting.scene).value(), beside.rate, beside.latency);
    proxy.coupled = coupled;
    Servo servo(infoOf(bench), proxy);
    ClosedLoop loop(bench, servo.control(), 1);
    const Vec3 above(meeting.aside, 0, kRadius + (meeting.impact > 0 ? 0.004 : 2e-4));
    loop.plant.place(above);
    loop.warmUp();
    loop.plant.place(above, {0, 0, -meeting.impact});
    loop.plant.setGoal({meeting.aside, 0, meeting.impact > 0 ? kRadius - 0.01 : kRadius});
    loop.plant.voluntary.z() = -meeting.force;
    Energy energy(proxy);
    const double before = energy();
    Seen seen;
    Range motion, force, body;
    double last = 0;
    loop.run(seconds, [&](const ClosedLoop& now) {
        const double lost = before - energy();
        seen.given = std::max(seen.given, now.plant.given() - std::max(lost, 0.0));
        seen.jump = std::max(seen.jump, std::abs(now.command.z() - last));
        last = now.command.z();
        if (now.time < seconds - 0.5) return;
        motion.add(now.plant.x[2]);
        force.add(last);
        body.add(proxy.state.bodies.q[0]);
    });
    seen.motion = motion.width();
    seen.force = force.width();
    seen.bodies = body.width();
    seen.faults = servo.state.gate.faults();
    return seen;
}

/// What hand, bodies and the spring between them have together and should not: the two-port that the servo
/// renders, weighed at both of its ports.
struct Made {
    double contact = 0;  ///< J, the largest rise within a contact, from whenever in it on
    double power = 0;    ///< W, most over a tenth of a second
    double touching = 0; ///< part of the time
    std::uint64_t faults = 0;
};

/// A hand that taps, shakes and holds a plate.
Made work(const Connected& device, const HandProfile& hand, const Meeting& met, double seconds) {
    const Bench bench = benchOf(device, hand);
    Proxy proxy(compile(met.scene).value(), 2 * bench.timing.rate);
    DeviceInfo info = connectedInfo(device);
    info.continuousForce = 0; // warm motors give way to a press, which is no energy
    Servo servo(info, proxy);
    ClosedLoop loop(bench, servo.control(), 1);
    const Vec3 above(met.aside, 0, kRadius + 2e-4);
    loop.plant.place(above);
    loop.warmUp();
    HandScript script(7, kRadius, 0.25);
    Made made;
    Energy energy(proxy);
    constexpr std::size_t kWindow = 100; // ticks
    std::array<double, kWindow> before{};
    double least = 0;
    std::size_t ticks = 0, touching = 0;
    loop.run(seconds, [&](ClosedLoop& now) {
        now.plant.setGoal({met.aside, 0, script.goal(1 / bench.timing.rate).z()});
        RenderedSpring spring;
        spring.stiffness = std::max(1.0, servo.state.transition.rendered().stiffness);
        spring.stretch = servo.state.previous.load / spring.stiffness;
        spring.limit = bench.device.maxForce;
        const double all = now.plant.given() + energy() + spring.stored();
        const bool free = now.command.isZero(0);
        least = free ? all : std::min(least, all);
        touching += !free;
        made.contact = std::max(made.contact, all - least);
        double& old = before[ticks % kWindow];
        if (ticks++ >= kWindow)
            made.power = std::max(made.power, (all - old) * bench.timing.rate / double(kWindow));
        old = all;
    });
    made.touching = double(touching) / double(ticks);
    made.faults = servo.state.gate.faults();
    return made;
}

QString told(const Bench& bench, const Beside& beside, const Meeting& meeting, const Seen& seen) {
    return QString("%1: %2 in %3, %4 Hz, %5 late; proxy %6 Hz, %7 ms: %8 mJ, %9 N a tick, %10 um, %11 N, "
                   "body %12 um, %13 faults")
        .arg(meeting.name, bench.device.name, bench.hand.name)
        .arg(bench.timing.rate)
        .arg(bench.timing.delay)
        .arg(beside.rate)
        .arg(1e3 * beside.latency)
        .arg(1e3 * seen.given, 0, 'f', 3)
        .arg(seen.jump, 0, 'f', 2)
        .arg(1e6 * seen.motion, 0, 'f', 1)
        .arg(seen.force, 0, 'f', 3)
        .arg(1e6 * seen.bodies, 0, 'f', 1)
        .arg(seen.faults);
}

/// All with TACTUM_SEEDS; the short check has no time for more than a few.
int some() {
    if (qEnvironmentVariableIsSet("TACTUM_SEEDS")) return 1;
    return isLong() ? 7 : 89;
}

/// Every hand, device, rate and delay with every proxy loop; of them each `every`-th.
template <class Each> void everyLoop(int every, Each&& each) {
    int count = 0;
    for (const PlantProfile& device : kDevices)
        for (const HandProfile& hand : kHands)
            for (const double rate : {1000.0, 4000.0})
                for (const int delay : {0, 1, 2})
                    for (const Beside& beside :
                         {Beside{2 * rate, 0}, Beside{2 * rate, 1e-3}, Beside{500, 1e-3}})
                        if (count++ % every == 0)
                            each(Bench{lagging(device), hand, {.rate = rate, .delay = delay, .jitter = 0.2}},
                                 beside);
}

} // namespace

class TestStabilityBodies : public QObject {
    Q_OBJECT

private slots:
    void nothingIsMadeAndAllRests_data() {
        QTest::addColumn<int>("meeting");
        const std::vector<Meeting> all = meetings();
        for (int i = 0; i < int(all.size()); ++i)
            QTest::newRow(all[std::size_t(i)].name) << i;
    }

    /// A 20 g body on a stop of 5 kN/m, a door that is hit, a key: to each hand of each device it is as still
    /// as a wall, and gives no more than a wall may.
    void nothingIsMadeAndAllRests() {
        QFETCH(int, meeting);
        const Meeting met = meetings()[std::size_t(meeting)];
        int cases = 0, bad = 0;
        double most = 0, jump = 0;
        everyLoop(some(), [&](const Bench& bench, const Beside& beside) {
            const Seen seen = meet(bench, beside, met);
            ++cases;
            most = std::max(most, seen.given);
            jump = std::max(jump, seen.jump / bench.device.maxForce);
            const bool still = seen.motion <= 2 * bench.device.resolution;
            if (still && seen.given <= kGiven && seen.jump <= kJump * bench.device.maxForce &&
                seen.faults == 0)
                return;
            if (++bad < 20) qWarning("%s", qPrintable(told(bench, beside, met, seen)));
        });
        qInfo("%d of %d, %.2f mJ, %.2f of the limit a tick", bad, cases, 1e3 * most, jump);
        QCOMPARE(bad, 0);
    }

    void aBodyGetsWhatTheHandGave_data() {
        QTest::addColumn<bool>("coupled");
        QTest::newRow("coupled") << true;
        QTest::newRow("as the model says") << false;
    }

    /// A blow: what the plate has after it is the impulse of what left for the device, though the surface is
    /// three times as stiff as this loop may render.
    void aBodyGetsWhatTheHandGave() {
        QFETCH(bool, coupled);
        const double mass = 0.2;
        OnAJoint plate(mass, 0.05, 3000, Vec3::Constant(1e-4));
        plate.joint(4, 0);
        const Bench bench{kPremium, kPinch, {.rate = 1000, .delay = 1}};
        Proxy proxy(compile(plate.scene).value(), 2000);
        proxy.coupled = coupled;
        Servo servo(infoOf(bench), proxy);
        ClosedLoop loop(bench, servo.control(), 1);
        const Vec3 above(0, 0, kRadius + 0.004);
        loop.plant.place(above);
        loop.warmUp();
        loop.plant.place(above, {0, 0, -0.3});
        double impulse = 0, before = 0;
        loop.run(1, [&](const ClosedLoop& now) {
            impulse += now.command.z() * (now.time - before);
            before = now.time;
        });
        const double got = -mass * proxy.state.bodies.v[0];
        QCOMPARE_GT(got, 0.01);
        qInfo("%g N s of %g", got, impulse);
        if (coupled)
            COMPARE_NEAR(got, impulse, 0.05 * impulse, "N s");
        else
            QCOMPARE_GT(got, 1.2 * impulse);
    }

    /// What the hand gets of a spinning top that it stops, the top had.
    void aSpinningTopIsCaught() {
        int cases = 0, bad = 0;
        double most = 0;
        everyLoop(isLong() ? 23 : 89, [&](const Bench& bench, const Beside& beside) {
            Proxy proxy(compile(top()).value(), beside.rate, beside.latency);
            Servo servo(infoOf(bench), proxy);
            ClosedLoop loop(bench, servo.control(), 3);
            const Vec3 above(0.02, 0, kRadius + 5e-4);
            loop.plant.place(above);
            loop.plant.setGoal(above);
            loop.warmUp();
            loop.plant.voluntary.z() = -1;
            Energy energy(proxy);
            const double before = energy();
            double given = -1e300, jump = 0;
            Vec3 last = Vec3::Zero();
            loop.run(3, [&](const ClosedLoop& now) {
                given = std::max(given, now.plant.given() - std::max(0.0, before - energy()));
                jump = std::max(jump, (now.command - last).norm());
                last = now.command;
            });
            ++cases;
            most = std::max(most, given);
            const bool touched = energy() < 0.9 * before;
            if (touched && given <= kGiven && jump <= kJump * bench.device.maxForce &&
                servo.state.gate.faults() == 0)
                return;
            ++bad;
            qWarning(
                "%s in %s, %g Hz, %d late; proxy %g Hz, %g ms: %g mJ, %g N a tick, %g of %g J, %d faults",
                bench.device.name, bench.hand.name, bench.timing.rate, bench.timing.delay, beside.rate,
                1e3 * beside.latency, 1e3 * given, jump, energy(), before, int(servo.state.gate.faults()));
        });
        qInfo("%d of %d, %g mJ", bad, cases, 1e3 * most);
        QCOMPARE(bad, 0);
    }

    /// Armed and held back nothing is pushed; with the forces off the finger is a pointer that pushes as the
    /// surface would, up to the device's force.
    void whatIsNotFeltDoesNotPush() {
        OnAJoint plate(0.2, 0.05, 800, Vec3::Constant(1e-4));
        plate.joint(4, 0);
        const Bench bench{kPremium, kNoHand, {}};
        for (const bool armed : {true, false}) {
            Proxy proxy(compile(plate.scene).value(), 2000);
            Servo servo(infoOf(bench), proxy);
            servo.settings.armed = armed;
            servo.settings.deadMan = 1; // nobody holds it
            DeviceSample sample;
            sample.valid = true;
            for (int i = 0; i < 100; ++i) {
                sample.position.z() = kRadius + 0.001 - 2e-5 * i; // 1 mm deep at the end
                servo(sample, 1e-3);
            }
            QCOMPARE(servo.output.force, Vec3(Vec3::Zero()));
            QCOMPARE_GT(proxy.output.contacts, 0);
            if (armed)
                QCOMPARE(proxy.state.bodies.v[0], 0.0);
            else
                QCOMPARE_LT(proxy.state.bodies.v[0], -1e-3);
        }
    }

    void nothingIsMadeBetweenHandAndBody_data() { nothingIsMadeAndAllRests_data(); }

    /// Tapped, shaken and held for longer than any hit lasts: what hand, body and spring have together grows
    /// by no more in a contact than where a wall stands, the last of these.
    void nothingIsMadeBetweenHandAndBody() {
        QFETCH(int, meeting);
        const Meeting met = meetings()[std::size_t(meeting)];
        double contact = 0, power = 0;
        for (const Connected& device :
             {kPremiumConnected, kOmegaConnected, kTouchConnected, kFalconConnected})
            for (const HandProfile& hand : {kPinch, kGrasp, kFirm}) {
                const Made made = work(device, hand, met, met.tapped);
                const QByteArray told = QString("%1 in %2: %3 mJ a contact, %4 mW, touching %5, %6 faults")
                                            .arg(device.key.data(), hand.name)
                                            .arg(1e3 * made.contact)
                                            .arg(1e3 * made.power)
                                            .arg(made.touching)
                                            .arg(made.faults)
                                            .toUtf8();
                contact = std::max(contact, made.contact);
                power = std::max(power, made.power);
                QVERIFY2(made.contact <= kGiven, told);
                QVERIFY2(made.faults == 0, told);
                QVERIFY2(made.touching > 0, told);
            }
        qInfo("%.2f mJ a contact, %.1f mW", 1e3 * contact, 1e3 * power);
    }

    /// Until one of each was found.
    void withoutTheCouplingEnergyIsMade() {
        int bad = 0, restless = 0;
        for (const std::vector<Meeting> all = meetings(); const Meeting& met : all)
            everyLoop(isLong() ? 23 : 89, [&](const Bench& bench, const Beside& beside) {
                if (bad > 0 && restless > 0) return;
                const Seen seen = meet(bench, beside, met, false);
                bad += seen.given > kGiven || seen.faults > 0;
                restless += seen.motion > 2 * bench.device.resolution;
            });
        QCOMPARE_GT(bad, 0);
        QCOMPARE_GT(restless, 0);
    }
};

TACTUM_TEST(TestStabilityBodies)

} // namespace test_stability_bodies

#include "test_stability_bodies.moc"
