// The moving samples under the finger of their own paths: each does what it is for. What would show that a
// test here is wrong: without the finger (`alone`) none of it happens, or the motor wins.
#include <functional>
#include <numbers>

#include <QTest>

#include "core/dynamics/dynamics.h"
#include "core/dynamics/mechanism_build.h"
#include "core/files/load_scene.h"
#include "core/haptics/body_places.h"
#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_sample_worlds {

using namespace tactum;

namespace {

/// A sample stepped along its path, and for a second more with the finger gone.
class Play {
public:
    explicit Play(const std::string& name, bool alone = false) : alone_(alone) {
        auto loaded = loadScene(std::string(SAMPLES "/moving/") + name + ".glb");
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        scene_ = std::move(loaded->scene);
        world_ = compile(scene_).value();
        places_.emplace(world_.get());
    }

    const RigidBody& body(const std::string& name) const {
        const auto& all = scene_.mechanics.bodies;
        return *std::ranges::find(all, name, &RigidBody::name);
    }
    /// Of the object of this name, now.
    Pose at(const std::string& name) {
        const auto object = std::ranges::find(scene_.objects, name, &SceneObject::name);
        for (const PlacedObject& placed : places_->at(state_.bodies))
            if (placed.object == object->id) return placed.pose;
        return object->pose;
    }
    /// How far it has turned since the beginning about an axis of the world, rad.
    double turn(const std::string& name, const Vec3& axis) {
        const Quat by = at(name).rotation * body(name).pose.rotation.conjugate();
        return 2 * std::atan2(by.vec().dot(axis), by.w());
    }
    double way(const std::string& name, const Vec3& along) {
        return (at(name).translation - body(name).pose.translation).dot(along);
    }

    void run(const std::function<void(double t)>& look = {}) {
        constexpr double kStep = 5e-4;
        const auto& path = *scene_.finger;
        const double end = path.back().t + 1;
        for (double t = kStep; t <= end; t += kStep) {
            const std::size_t row = std::min(path.size() - 1, std::size_t(t * 1000));
            HapticInput input;
            input.finger = alone_ || row + 1 == path.size() ? Vec3(0, 1, 0) : path[row].position;
            input.restart = input.finger.y() == 1;
            hapticStep(*world_, state_, input, kStep);
            if (look) look(t);
        }
    }

private:
    bool alone_;
    Scene scene_;
    std::shared_ptr<const World> world_;
    std::optional<BodyPlaces> places_;
    SimState state_;
};

constexpr double degrees = std::numbers::pi / 180;

} // namespace

class TestSampleWorlds : public QObject {
    Q_OBJECT

private slots:
    void theWindIsHeldByTheFinger() {
        Play touched("windmill"), alone("windmill", true);
        double least = 0;
        touched.run([&](double) { least = std::min(least, touched.turn("sails", Vec3::UnitZ())); });
        QCOMPARE_LT(least, -20 * degrees); // against the wind
        bool back = false;
        alone.run([&](double t) { back |= t < 1.5 && alone.turn("sails", Vec3::UnitZ()) < 0; });
        QVERIFY(!back);
    }

    void theKnobDrivesThePiston() {
        Play play("crank");
        double low = 0, high = 0;
        play.run([&](double) {
            const double x = play.way("piston", Vec3::UnitX());
            low = std::min(low, x), high = std::max(high, x);
        });
        QCOMPARE_GT(high - low, 0.0395); // twice the crank's 20 mm
        QCOMPARE_LT(high - low, 0.0400001);
        Play alone("crank", true);
        alone.run();
        QCOMPARE_LT(std::abs(alone.way("piston", Vec3::UnitX())), 1e-6);
    }

    void theFingerBrakesTheRecord() {
        Play play("turntable");
        double before = 0, slowest = 1e9, last = 0;
        play.run([&](double t) {
            const double turned = play.turn("record", Vec3::UnitY());
            const double rate = std::abs(std::remainder(turned - last, 2 * std::numbers::pi)) / 5e-4;
            last = turned;
            if (t < 0.3) before = rate;
            if (t > 1 && t < 2) slowest = std::min(slowest, rate);
        });
        QCOMPARE_GT(before, 2);
        QCOMPARE_LT(slowest, 0.1);
    }

    void theCarIsPushedBack() {
        Play play("rocket-car");
        double farthest = 0, back = 1;
        play.run([&](double t) {
            const double x = play.way("car", Vec3::UnitX());
            if (t < 0.5) farthest = std::max(farthest, x);
            if (t > 0.5) back = std::min(back, x);
        });
        COMPARE_NEAR(farthest, 0.1, 1e-4, "m");
        QCOMPARE_LT(back, 0.05);
        COMPARE_NEAR(play.way("car", Vec3::UnitX()), 0.1, 1e-4, "m"); // and goes again
    }

    void theTrainIsPushedOverTheHill() {
        Play play("roller-coaster"), alone("roller-coaster", true);
        double hill = 0, loop = 0;
        play.run([&](double) {
            const Vec3 at = play.at("car 1").translation;
            if (at.z() > 0.03) hill = std::max(hill, at.y());
            if (at.z() < -0.03) loop = std::max(loop, at.y());
        });
        QCOMPARE_GT(hill, 0.084);
        QCOMPARE_GT(loop, 0.062); // its top is at 64 mm
        alone.run();              // it settles in its valley
        QCOMPARE_LT((alone.at("car 1").translation - alone.body("car 1").pose.translation).norm(), 0.012);
    }

    // Without friction and air the height alone says how fast it is: v^2 = v0^2 + 2 g (h0 - h).
    void heightBecomesSpeed() {
        Mechanics track = loadScene(SAMPLES "/moving/roller-coaster.glb")->scene.mechanics;
        QCOMPARE_GT(track.airDensity, 0);
        track.airDensity = 0;
        track.bodies.resize(1), track.joints.resize(1), track.colliders.clear();
        track.joints[0].frictions.clear();
        RigidBody& car = track.bodies[0];
        car.centre = Vec3::Zero();
        car.inertia = Vec3::Constant(1e-12);
        car.velocity = 1.3 * (car.pose.rotation * Vec3::UnitX());
        Dynamics dynamics(std::make_shared<const Mechanism>(
            compileMechanism(track.bodies, track.joints, track.colliders).value()));
        DynamicState state = dynamics.startState();
        BodyState now;
        dynamics.describe(state, track.gravity, {&now, 1});
        const double start = now.velocity.squaredNorm(), height = now.centre.y();
        COMPARE_NEAR(std::sqrt(start), 1.3, 1e-6, "m/s");
        double highest = 0;
        for (int i = 0; i < 4000; ++i) {
            dynamics.step(state, track.gravity, {}, 5e-4);
            dynamics.describe(state, track.gravity, {&now, 1});
            highest = std::max(highest, now.centre.y());
            COMPARE_NEAR(now.velocity.squaredNorm(), start + 2 * 9.81 * (height - now.centre.y()),
                         1e-4 * start, "m^2/s^2");
        }
        QCOMPARE_GT(highest, 0.0849);
        QCOMPARE_GT(state.q[0], 1.5); // more than twice around
    }

    void doorAndDrawerAreShutAndStayShut() {
        Play play("cabinet");
        play.run();
        // Both rest in a detent: every quarter of a radian, every centimetre.
        const double turned = play.turn("door", Vec3::UnitY()),
                     pushed = -play.way("upper drawer", Vec3::UnitZ());
        COMPARE_NEAR(turned, 0.25 * std::max(1.0, std::round(turned / 0.25)), 0.08, "rad");
        COMPARE_NEAR(pushed, 0.01 * std::max(1.0, std::round(pushed / 0.01)), 0.003, "m");
        Play alone("cabinet", true);
        alone.run();
        QCOMPARE_LT(std::abs(alone.turn("door", Vec3::UnitY())), 1e-6);
        QCOMPARE_LT(std::abs(alone.way("upper drawer", Vec3::UnitZ())), 1e-6);
    }

    void aKeyGoesToItsStopAndComesBack() {
        Play play("keyboard");
        double deepest = 0, neighbour = 0;
        play.run([&](double) {
            deepest = std::max(deepest, play.turn("C", Vec3::UnitX()));
            neighbour = std::max(neighbour, play.turn("D", Vec3::UnitX()));
        });
        QCOMPARE_GT(deepest, 0.03);
        QCOMPARE_LE(deepest, 0.0901);
        QCOMPARE_LT(neighbour, 1e-6);
        QCOMPARE_LT(play.turn("C", Vec3::UnitX()), 1e-6);
    }

    void theLidIsLiftedAndFalls() {
        Play play("kettle");
        double highest = 0;
        play.run([&](double) { highest = std::max(highest, play.turn("lid", Vec3::UnitZ())); });
        QCOMPARE_GT(highest, 40 * degrees);
        QCOMPARE_LT(play.turn("lid", Vec3::UnitZ()), 1e-4);
    }

    void theFlexuresAreSoftInOneDirection() {
        Play play("micro-sensor");
        double down = 0, aside = 0;
        play.run([&](double) {
            down = std::max(down, -play.way("test mass", Vec3::UnitY()));
            aside = std::max(aside, std::abs(play.way("test mass", Vec3::UnitX())));
        });
        QCOMPARE_GT(down, 3e-3);
        QCOMPARE_LT(aside, 1e-3);
        QCOMPARE_LT(std::abs(play.way("test mass", Vec3::UnitY())), 1e-5); // back in its place
    }

    void theCueBallBreaksTheOthers() {
        Play play("ball-table");
        play.run();
        for (int i = 1; i <= 6; ++i) {
            const std::string name = "ball " + std::to_string(i);
            QVERIFY2((play.at(name).translation - play.body(name).pose.translation).norm() > 1e-3,
                     name.c_str());
            COMPARE_NEAR(play.at(name).translation.y(), 0.011, 1e-4, "m"); // on the cloth
        }
    }

    void oneBlowFellsAllDominoes() {
        Play play("dominoes"), alone("dominoes", true);
        play.run(), alone.run();
        for (int i = 1; i <= 16; ++i) {
            const std::string name = "domino " + std::to_string(i);
            QVERIFY2((play.at(name).rotation * Vec3::UnitY()).y() < std::cos(45 * degrees), name.c_str());
            QVERIFY2((alone.at(name).rotation * Vec3::UnitY()).y() > 0.99999, name.c_str());
        }
    }

    void theBellSwingsOnItsRope() {
        Play play("bell");
        double farthest = 0, lowest = 0;
        play.run([&](double) {
            farthest = std::max(farthest, -play.way("bell", Vec3::UnitX()));
            lowest = std::min(lowest, play.way("bell", Vec3::UnitY()));
        });
        QCOMPARE_GT(farthest, 0.02);
        QCOMPARE_GT(lowest, -1e-5); // the rope does not give
    }

    void theStringsHoldThePuppet() {
        Play play("marionette");
        double lowest = 0, arm = 0;
        play.run([&](double) {
            lowest = std::min(lowest, play.way("head", Vec3::UnitY()));
            arm = std::max(
                arm, (play.at("right arm").translation - play.body("right arm").pose.translation).norm());
        });
        QCOMPARE_GT(lowest, -3e-3);
        QCOMPARE_GT(arm, 5e-3);
    }
};

TACTUM_TEST(TestSampleWorlds)

} // namespace test_sample_worlds

#include "test_sample_worlds.moc"
