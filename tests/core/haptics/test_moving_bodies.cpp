// Bodies that move by themselves, through whole haptic steps: their time and their poses.

#include <QTest>

#include "core/haptics/replay.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/movers.h"
#include "tests/support/test_program.h"

namespace test_moving_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
constexpr double kDepth = 1e-3; // of the finger below where the proxy rests: 0.8 N at 800 N/m
constexpr double kPart = 0.005; // every law holds to half a percent
const Vec3 kFarAway(0, 0, 1);

/// A finger that has come down onto a moving sheet, to the depth.
Hand pressedOn(SharedMotion motion, const Material& material, double half = 1) {
    Hand hand(compile(sceneOf({bodyOf(sheet(half), material, std::move(motion))})).value());
    hand.to({0, 0, 0.003});
    hand.go({0, 0, kRadius - kDepth}, 0.05);
    return hand;
}

double tangential(const Hand& hand) {
    return hand.output().force.head<2>().norm();
}

} // namespace

namespace {

Pose bodyNow(const Hand& hand) {
    return hand.world().movers[0].poseAt(hand.state.time);
}

} // namespace

class MovingBodiesTest : public QObject {
    Q_OBJECT

private slots:
    void bodiesAreWhereTheirTimePutsThem();
    void aSwapOfWorldsKeepsTheTime();
    void badInputKeepsTheTime();
    void ofManyMoversEachIsFeltAsAlone();
    void anotherMotionIsAnotherShape();
    void plateRisesUnderARestingFinger_data();
    void plateRisesUnderARestingFinger();
    void plateOscillatesUnderARestingFinger();
    void staticFrictionCarriesUpToTheCone();
    void conveyorDragsAtDynamicFrictionAndViscosity_data();
    void conveyorDragsAtDynamicFrictionAndViscosity();
    void turntableDragsByTheSpeedAtTheContact();
    void dampingIsRelativeToTheSurface();
    void shakenLoopsGiveNoEnergyToAHandThatMovesAlong();
    void aReplayPlaysTheFilesAnimation();
};

void MovingBodiesTest::bodiesAreWhereTheirTimePutsThem() {
    const Pose rest{Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX())), {0.1, 0, 0}};
    const auto world =
        compile(sceneOf({bodyOf(sheet(0.05), frictionless()),
                         bodyOf(sheet(0.05), frictionless(), turning(Vec3::UnitZ(), 3), rest)}))
            .value();
    Hand hand(world);
    hand.to(kFarAway);
    for (int i = 2; i <= 5000; ++i) {
        const double before = hand.state.time;
        hand.to(kFarAway);
        const StepMotions movers(world->movers, before, hand.state.time);
        const BodyMotion body = movers.of(0);
        QCOMPARE(body.before, world->movers[0].poseAt(before));
        const Quat turned = rest.rotation * Quat(Eigen::AngleAxisd(3e-3 * i, Vec3::UnitZ()));
        QCOMPARE_LT(body.now.rotation.angularDistance(turned), 1e-9);
        COMPARE_NEAR(body.now.translation, rest.translation, 1e-15, "m");
        QVERIFY(!body.jumped);
    }
    COMPARE_NEAR(hand.state.time, 5, 1e-9, "s");
}

// An edit of a material, and even one of the shape, finds the bodies where they were.
void MovingBodiesTest::aSwapOfWorldsKeepsTheTime() {
    Scene scene = sceneOf({bodyOf(sheet(0.05), frictionless(), sliding({0, 0, 0.01}))});
    auto world = compile(scene).value();
    Hand hand(world);
    for (int i = 0; i < 100; ++i)
        hand.to(kFarAway);
    scene.objects[0].surfaces[0].material.stiffness = 1234;
    const auto edited = compile(scene, world.get()).value();
    QCOMPARE(edited->shapeRevision, world->shapeRevision);
    hand.take(edited);
    hand.to(kFarAway);
    COMPARE_NEAR(bodyNow(hand).translation.z(), 0.01 * 0.101, 1e-12, "m");
    scene.objects[0].pose.translation.x() = 0.01;
    hand.take(compile(scene, edited.get()).value());
    hand.to(kFarAway);
    COMPARE_NEAR(bodyNow(hand).translation.z(), 0.01 * 0.102, 1e-12, "m");
}

void MovingBodiesTest::badInputKeepsTheTime() {
    Hand hand(compile(sceneOf({bodyOf(sheet(0.05), frictionless(), sliding({0, 0, 0.01}))})).value());
    hand.to(kFarAway);
    const double before = hand.state.time;
    hapticStep(hand.world(), hand.state, {Vec3::Constant(std::nan("")), Vec3::Zero()}, kMillisecond);
    QCOMPARE(hand.state.time, before);
}

// A thousand plates in a row, each with its own swing: what is felt on one is what is felt where it is alone.
void MovingBodiesTest::ofManyMoversEachIsFeltAsAlone() {
    constexpr int kMovers = 1000, kEvery = 97;
    Scene all;
    const auto body = [](int i) {
        return bodyOf(sheet(0.005), rough(0.4, 0.3), swinging({0.001, 0, 0.002}, 1 + 0.01 * i),
                      {Quat::Identity(), {0.012 * i, 0, 0}});
    };
    for (int i = 0; i < kMovers; ++i)
        all.add(body(i));
    const auto world = compile(all).value();
    QCOMPARE(world->movers.size(), std::size_t(kMovers));
    for (int i = 0; i < kMovers; i += kEvery) {
        Hand among(world), alone(compile(sceneOf({body(i)})).value());
        double most = 0;
        for (int step = 0; step < 800; ++step) {
            const Vec3 finger(0.012 * i, 0, 0.003 - 1e-5 * std::min(step, 350));
            among.to(finger);
            alone.to(finger);
            QCOMPARE_EQ(among.output().force, alone.output().force);
            most = std::max(most, alone.output().force.norm());
        }
        QCOMPARE_GT(most, 1);
    }
}

void MovingBodiesTest::anotherMotionIsAnotherShape() {
    Scene scene = sceneOf({bodyOf(sheet(0.05), frictionless(), sliding({0, 0, 0.01}))});
    const auto first = compile(scene).value();
    scene.objects[0].motion = sliding({0, 0, 0.01}); // equal
    const auto same = compile(scene, first.get()).value();
    QCOMPARE(same->shapeRevision, first->shapeRevision);
    scene.objects[0].motion = sliding({0, 0, 0.02});
    const auto other = compile(scene, same.get()).value();
    QCOMPARE_NE(other->shapeRevision, same->shapeRevision);
    scene.objects[0].motion = nullptr;
    QCOMPARE_NE(compile(scene, other.get()).value()->shapeRevision, other->shapeRevision);
}

void MovingBodiesTest::plateRisesUnderARestingFinger_data() {
    QTest::addColumn<double>("speed");
    for (double speed : {0.05, 0.5, 5.0})
        QTest::addRow("%g m/s", speed) << speed;
}

// Both sides, and a plate of two thin walls: the proxy rests at r from it and the force is that of the depth.
void MovingBodiesTest::plateRisesUnderARestingFinger() {
    QFETCH(double, speed);
    for (double side : {1.0, -1.0})
        for (const Soup& soup : {sheet(0.05), plate(0.05, 1e-4)}) {
            const double top = soup->triangles.size() > 2 ? 5e-5 : 0;
            const Pose rest{Quat::Identity(), {0, 0, -side * 0.004}};
            Hand hand(compile(sceneOf({bodyOf(soup, frictionless(), sliding({0, 0, side * speed}), rest)}))
                          .value());
            for (int i = 1; i <= int(0.02 / (speed * kMillisecond)); ++i) {
                hand.to(Vec3::Zero());
                const double surface = side * bodyNow(hand).translation.z() + top;
                const double expected = std::max(0.0, surface + kRadius);
                COMPARE_NEAR(side * hand.output().proxy.z(), expected, kMicrometre, "m");
                COMPARE_NEAR(side * hand.output().force.z(), 800 * expected, 800 * kMicrometre, "N");
            }
            QCOMPARE_GT(side * hand.output().force.z(), 10);
        }
}

void MovingBodiesTest::plateOscillatesUnderARestingFinger() {
    for (double hertz : {1.0, 7.0, 60.0})
        for (double mu : {0.0, 0.6}) {
            Hand hand = pressedOn(swinging({0.004, 0, 0.006}, hertz), rough(mu, 0.7 * mu));
            for (int i = 0; i < 3000; ++i) {
                hand.to({0, 0, 0});
                const double surface = bodyNow(hand).translation.z();
                const double z = hand.output().proxy.z();
                QCOMPARE_GE(z, surface + kRadius - kMicrometre);
                if (surface + kRadius > 0) QCOMPARE_LE(z, surface + kRadius + kMicrometre);
            }
        }
}

// Held on a plate that goes sideways the proxy goes with it, to the last nanometre, until the spring's pull
// leaves the static cone; then it is dragged at the dynamic one.
void MovingBodiesTest::staticFrictionCarriesUpToTheCone() {
    constexpr double mu = 0.6, speed = 0.001; // 0.17 % of the cone in a step
    Hand hand = pressedOn(sliding({0.6 * speed, 0.8 * speed, 0}), rough(mu, 0.5 * mu));
    const Vec3 held = bodyNow(hand).applyInverse(hand.output().proxy);
    const Vec3 finger = hand.output().proxy - Vec3(0, 0, kDepth); // from here on the hand stands still
    double largest = 0;
    int carried = 0;
    for (int i = 0; i < 2000; ++i) {
        hand.to(finger);
        const bool slips = hand.output().contact[0].slipping;
        if (!slips) {
            const Vec3 now = bodyNow(hand).applyInverse(hand.output().proxy);
            COMPARE_NEAR(now, held, 3e-9, "m");
            largest = std::max(largest, tangential(hand) / hand.output().force.z());
            ++carried;
        }
    }
    COMPARE_NEAR(largest, mu, kPart * mu, "");
    QCOMPARE_LE(largest, mu * (1 + 1e-6));
    QCOMPARE_GT(carried, 400);
    COMPARE_NEAR(tangential(hand) / hand.output().force.z(), 0.5 * mu, kPart * 0.5 * mu, "");
    COMPARE_NEAR(hand.output().force.x() / tangential(hand), 0.6, kPart * 0.6, ""); // the way the plate goes
}

void MovingBodiesTest::conveyorDragsAtDynamicFrictionAndViscosity_data() {
    QTest::addColumn<double>("viscosity");
    QTest::addColumn<double>("speed");
    for (double viscosity : {0.0, 0.5, 3.0})
        for (double speed : {0.02, 0.2, 2.0})
            QTest::addRow("b = %g N s/m at %g m/s", viscosity, speed) << viscosity << speed;
}

// f_t = mu_d f_n + b v, with v between hand and belt: a hand at rest, one that goes along, one against it.
void MovingBodiesTest::conveyorDragsAtDynamicFrictionAndViscosity() {
    QFETCH(double, viscosity);
    QFETCH(double, speed);
    const Material material = rough(0.5, 0.3, viscosity);
    for (double along : {0.0, 0.5, -1.0, 1.5}) {
        Hand hand = pressedOn(sliding({speed, 0, 0}), material, 10);
        for (int i = 0; i < 2000; ++i)
            hand.to(hand.finger() + Vec3(along * speed * kMillisecond, 0, 0));
        const double relative = (1 - along) * speed; // of the belt under the hand
        const double expected = 0.3 * 800 * kDepth + viscosity * std::abs(relative);
        COMPARE_NEAR(hand.output().force.z(), 800 * kDepth, kPart * 800 * kDepth, "N");
        COMPARE_NEAR(hand.output().force.x(), relative > 0 ? expected : -expected, kPart * expected, "N");
        QCOMPARE_LT(std::abs(hand.output().force.y()), 1e-6);
        QVERIFY(hand.output().contact[0].slipping);
    }
}

void MovingBodiesTest::turntableDragsByTheSpeedAtTheContact() {
    constexpr double viscosity = 2;
    for (double turns : {3.0, -3.0})
        for (double away : {0.02, 0.05}) {
            Hand hand(compile(sceneOf({bodyOf(sheet(0.1), rough(0.3, 0.3, viscosity),
                                              turning(Vec3::UnitZ(), turns))}))
                          .value());
            hand.to({away, 0, 0.003});
            hand.go({away, 0, kRadius - kDepth}, 0.05);
            for (int i = 0; i < 4000; ++i)
                hand.to(hand.finger());
            // Where the proxy is, a little downstream and inward of the finger.
            const double speed = std::abs(turns) * hand.output().proxy.head<2>().norm();
            const double expected = 0.3 * 800 * kDepth + viscosity * speed;
            COMPARE_NEAR(tangential(hand), expected, kPart * expected, "N");
            QCOMPARE_GT(hand.output().force.y() * turns, 0);
        }
}

void MovingBodiesTest::dampingIsRelativeToTheSurface() {
    Material material = frictionless();
    material.damping = 10;
    Hand hand(compile(sceneOf({bodyOf(sheet(0.05), material, sliding({0, 0, 0.1}))})).value());
    hand.to({0, 0, 0.003});
    const auto excess = [&] {
        return hand.output().force.z() - 800 * (hand.output().proxy.z() - hand.finger().z());
    };
    for (int i = 0; i < 30; ++i)
        hand.to({0, 0, 0.003});
    COMPARE_NEAR(excess(), 10 * 0.1, kPart * 10 * 0.1, "N"); // the surface comes toward a hand at rest
    hand.to(hand.finger() + Vec3(0, 0, 0.1 * kMillisecond));
    QCOMPARE_LT(std::abs(excess()), 1e-9); // and goes with it
    hand.to(hand.finger() - Vec3(0, 0, 0.1 * kMillisecond));
    COMPARE_NEAR(excess(), 10 * 0.2, kPart * 10 * 0.2, "N");
}

// What the hand does relative to a plate that is shaken sideways costs as on one at rest: on closed loops in
// the plate's frame friction only takes. Forces are the same to the bit of what frames can be.
void MovingBodiesTest::shakenLoopsGiveNoEnergyToAHandThatMovesAlong() {
    Rng rng(111);
    for (double viscosity : {0.0, 1.0})
        for (int run = 0; run < 10; ++run) {
            const SharedMotion motion = swinging({0.01, -0.004, run % 2 ? 0.003 : 0.0}, 2.0 + run);
            Hand hand(
                compile(sceneOf({bodyOf(sheet(1, 5), rough(0.6, run % 3 ? 0.4 : 0.6, viscosity), motion)}))
                    .value());
            Vec3 finger_B(0, 0, 0.004), before_B = finger_B, force = Vec3::Zero();
            double given = 0, taken = 0;
            const auto goTo = [&](const Vec3& target, double speed) {
                const Vec3 from = finger_B;
                const int steps = std::max(1, int((target - from).norm() / (speed * kMillisecond)));
                for (int i = 1; i <= steps; ++i) {
                    finger_B = from + (target - from) * (double(i) / steps);
                    hand.to(finger_B + motion->at(hand.state.time + kMillisecond).translation);
                    const double work = 0.5 * (force + hand.output().force).dot(finger_B - before_B);
                    (work > 0 ? given : taken) += work;
                    before_B = finger_B;
                    force = hand.output().force;
                }
            };
            goTo({0, 0, 0.004}, 0.1);
            goTo({0, 0, 0}, 0.05);
            for (int k = 0; k < 6; ++k)
                goTo({uniform(rng, -0.006, 0.006), uniform(rng, -0.006, 0.006), 0}, uniform(rng, 0.01, 0.2));
            goTo(Vec3::Zero(), 0.1);
            goTo({0, 0, 0.004}, 0.05);
            QCOMPARE(hand.output().force.norm(), 0.0);
            QVERIFY2(given + taken <= 1e-9,
                     qPrintable(QString("run %1 gives %2 J").arg(run).arg(given + taken)));
            QCOMPARE_LT(taken, -1e-5);
        }
}

// A lift from bytes, and a path that begins at another time than 0: row by row the proxy is where lift and
// finger put it at the row's time.
void MovingBodiesTest::aReplayPlaysTheFilesAnimation() {
    TriangleSoup lift = *sheet(0.0625);
    const WrittenChannel up{
        0, "translation", "LINEAR", {0, 0.5, 1}, {{0, 0, -0.01}, {0, 0, 0.02}, {0, 0, -0.01}}};
    const FileFolder folder;
    auto loaded = folder.load("lift.glb", asAnimatedGlb(lift, R"("nodes":[{"mesh":0}])", {up}));
    QVERIFY(loaded.has_value());
    loaded->scene.objects[0].surfaces[0].material = frictionless();
    std::vector<FingerPoint> path;
    for (int i = 0; i < 3000; ++i)
        path.push_back({0.05 + 0.001 * i, Vec3(0.01, 0.02, 0)});
    const auto world = compile(loaded->scene).value();
    const TouchTrace rows = replay(*world, path), again = replay(*world, path);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double phase = std::fmod(rows[i].t, 1.0);
        const double surface = -0.01 + 0.06 * std::min(phase, 1 - phase);
        const double expected = std::max(0.0, surface + kRadius);
        // Before the first touch it is not known on which side the finger is: the lift begins below it.
        QVERIFY2(
            std::abs(rows[i].proxy.z() - expected) <= kMicrometre,
            qPrintable(
                QString("at %1 s: %2 instead of %3").arg(rows[i].t).arg(rows[i].proxy.z()).arg(expected)));
        QCOMPARE(rows[i].proxy, again[i].proxy);
        QCOMPARE(rows[i].force, again[i].force);
    }
}

TACTUM_TEST(MovingBodiesTest)

} // namespace test_moving_bodies

#include "test_moving_bodies.moc"
