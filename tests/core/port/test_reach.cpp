// Rate control beyond the shell, and drift: how far the workspace goes, and where it does not.
#include <random>

#include <QTest>

#include "core/port/workspace.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_reach {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3, kShell = 0.03, kScale = 4;
constexpr Reach kRate{ReachMode::Rate, kShell}, kDrift{ReachMode::Drift, kShell};

/// A hand that is held where the test says, in a device like a Falcon.
struct Hand {
    explicit Hand(const Reach& reach, double resolution = 0) : tracker(device(resolution)) {
        tracker.decide({.scale = kScale, .axes = {-2, 3, 1}, .reach = reach});
        around.forces = true;
    }
    static DeviceInfo device(double resolution) {
        DeviceInfo info;
        info.workspaceRadius = 0.04;
        info.positionResolution = resolution;
        return info;
    }
    /// Where the workspace is then, and the finger.
    Vec3 goTo(const Vec3& position, double dt = kTick, std::uint32_t buttons = 0) {
        DeviceSample sample;
        sample.position = at = position;
        sample.buttons = buttons;
        sample.valid = true;
        return tracker.follow(sample, around, dt).offset;
    }
    Vec3 stay(int ticks) {
        Vec3 offset;
        for (int i = 0; i < ticks; ++i)
            offset = goTo(at);
        return offset;
    }
    /// From the device's centre outward along an axis, and held there.
    Vec3 pullTo(const Vec3& position, int ticks) {
        for (int i = 0; i < ticks; ++i)
            goTo(position * i / ticks);
        return goTo(position);
    }
    /// Of the workspace, in the hand's measure.
    Vec3 wayFrom(const Vec3& before) {
        return DeviceFrame{kScale, {-2, 3, 1}, {}}.wayInDevice(goTo(at) - before);
    }

    WorkspaceTracker tracker;
    AroundHand around;
    Vec3 at = Vec3::Zero();
};

} // namespace

class TestReach : public QObject {
    Q_OBJECT

private slots:
    void withinTheShellNothingChanges() {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> part(-1, 1);
        Hand rate(kRate), position({});
        for (int i = 0; i < 5000; ++i) {
            const Vec3 p = kShell / std::sqrt(3.0) * Vec3(part(random), part(random), part(random));
            QCOMPARE(rate.goTo(p), position.goTo(p)); // bit for bit
            QCOMPARE(rate.tracker.border(), kShell);
            QCOMPARE(position.tracker.border(), 0.0);
        }
    }

    void theWayIsTheIntegralOfTheSpeed_data() {
        QTest::addColumn<double>("excess");
        QTest::addColumn<double>("speed");
        QTest::newRow("a millimetre beyond") << 1e-3 << 0.02;
        QTest::newRow("five") << 5e-3 << 0.1;
        QTest::newRow("as fast as it goes") << 0.015 << 0.2;
        QTest::newRow("no faster") << 0.03 << 0.2;
    }
    void theWayIsTheIntegralOfTheSpeed() {
        QFETCH(double, excess);
        QFETCH(double, speed);
        Hand hand(kRate);
        const Vec3 out = Vec3(1, 2, -2) / 3;
        const Vec3 begin = hand.pullTo((kShell + excess) * out, 400);
        hand.stay(1999);
        COMPARE_NEAR(hand.wayFrom(begin), Vec3(speed * 2.0 * out), 1e-9, "m");
    }

    /// x = u t beyond the border gives s = slope u t^2 / 2.
    void aHandThatGoesOutIsTakenAlongEverFaster() {
        Hand hand(kRate);
        const Vec3 begin = hand.pullTo({0, kShell, 0}, 100);
        const double speed = 0.02, seconds = 0.4;
        for (double t = kTick; t < seconds; t += kTick)
            hand.goTo({0, kShell + speed * t, 0});
        const double way = hand.wayFrom(begin).y();
        COMPARE_NEAR(way, 0.5 * kRateSlope * speed * seconds * seconds, 2e-4 * seconds, "m");
    }

    void theBorderIsNoStepOfTheSpeed() {
        Hand hand(kRate);
        Vec3 last = hand.pullTo({0, 0, 0.99 * kShell}, 100);
        double before = 0, largest = 0;
        for (int i = 0; i < 12000; ++i) { // a micrometre a tick
            const Vec3 next = hand.goTo({0, 0, 0.99 * kShell + 1e-6 * i});
            const double speed = (next - last).norm() / kScale / kTick;
            largest = std::max(largest, std::abs(speed - before));
            before = speed, last = next;
        }
        COMPARE_NEAR(before, kRateMost, 1e-9, "m/s");
        QCOMPARE_LE(largest, kRateSlope * 1e-6 + 1e-9);
    }

    void theShellLeavesRoomInTheDevice() {
        Hand hand({ReachMode::Rate, 0.2});
        hand.goTo({0, 0, 0});
        COMPARE_NEAR(hand.tracker.border(), 0.9 * 0.04, 1e-12, "m");
    }

    void withoutForcesNothingMoves() {
        for (const Reach& reach : {kRate, kDrift}) {
            Hand hand(reach);
            hand.around.forces = false;
            const Vec3 begin = hand.goTo({0, 0, 0});
            QCOMPARE(hand.pullTo({0, 0.039, 0}, 300), begin);
            QCOMPARE(hand.stay(300), begin);
        }
    }

    /// Else the workspace would run away, and the handle be pushed, when the forces come on.
    void whoIsBeyondItWhenTheForcesComeHasTheBorderWithHim() {
        Hand hand(kRate);
        hand.around.forces = false;
        const Vec3 begin = hand.pullTo({0.038, 0, 0}, 100);
        hand.around.forces = true;
        QCOMPARE(hand.stay(500), begin);
        QCOMPARE(hand.tracker.border(), 0.038);
        QCOMPARE(hand.goTo({0.034, 0, 0}), begin);
        QCOMPARE(hand.tracker.border(), 0.034);
        QVERIFY(hand.goTo({0.036, 0, 0}) != begin); // out again: from there
        hand.goTo({0.01, 0, 0});
        QCOMPARE(hand.tracker.border(), kShell);
    }

    void underTheClutchTheFingerRests() {
        Hand hand(kRate);
        hand.tracker.decide({.scale = kScale, .clutch = 2, .reach = kRate});
        const Vec3 begin = hand.pullTo({0, 0.02, 0}, 100) + kScale * hand.at;
        for (int i = 0; i < 200; ++i) {
            const Vec3 offset = hand.goTo({0, 0.02 + 1e-4 * i, 0}, kTick, 2);
            COMPARE_NEAR(offset + kScale * hand.at, begin, 1e-12, "m");
        }
    }

    void whatIsTouchedIsReachedAndNotPassed() {
        Hand hand(kRate);
        hand.around.wall[0] = {Vec3::UnitY(), -0.4}; // a ground below; the device's z is up
        hand.around.walls = 1;
        hand.pullTo({0.02, 0, -0.04}, 300);
        hand.stay(3000);
        const Vec3 offset = hand.goTo(hand.at);
        const Vec3 finger = DeviceFrame{kScale, {-2, 3, 1}, offset}.pointInWorld(hand.at);
        COMPARE_NEAR(finger.y(), -0.4, 1e-9, "m");
        QCOMPARE_GT(finger.z(), 0.4); // along it, it goes on
    }

    void theHandPressesAndTheWorkspaceDoesNot() {
        Hand hand(kRate);
        hand.around.wall[0] = {Vec3::UnitY(), 0};
        hand.around.walls = 1;
        const Vec3 begin = hand.pullTo({0, 0, -0.04}, 100); // far into it, by hand
        QCOMPARE(hand.stay(1000), begin);
    }

    void inACornerItStops() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> part(-1, 1);
        for (int round = 0; round < 2000; ++round) {
            std::array<Wall, 3> walls;
            for (Wall& wall : walls)
                wall.normal = Vec3(part(random), part(random), part(random)).normalized();
            const Vec3 way = 1e-3 * Vec3(part(random), part(random), part(random));
            const Vec3 along = wayAlong(way, Vec3::Zero(), walls);
            for (const Wall& wall : walls)
                QCOMPARE_GE(wall.normal.dot(along), -1e-12);
            QCOMPARE_LE(along.norm(), way.norm() * (1 + 1e-9));
        }
    }

    void aSleepMovesItByNoMoreThanATick() {
        Hand hand(kRate);
        const Vec3 begin = hand.pullTo({0, 0, 0.04}, 100);
        QCOMPARE_LE((hand.goTo(hand.at, 8 * 3600) - begin).norm(), kScale * kRateMost * 0.01 + 1e-12);
    }

    /// As much as kDriftPart of the hand's way at the edge, and to where the hand is.
    void driftIsAPartOfTheWayOfTheHand() {
        Hand hand(kDrift, 1e-6);
        const Vec3 begin = hand.pullTo({0, 0.02, 0}, 200);
        double way = 0;
        const int ticks = 2000;
        for (int i = 1; i <= ticks; ++i) { // around the centre, half of the way to the edge
            const double turn = 0.5 * M_PI * std::sin(2 * M_PI * i / ticks);
            const Vec3 next = 0.02 * Vec3(0, std::cos(turn), std::sin(turn));
            way += (next - hand.at).norm();
            hand.goTo(next);
        }
        const Vec3 drifted = hand.wayFrom(begin);
        QCOMPARE_GT(drifted.y(), 0.2 * kDriftPart * way);
        QCOMPARE_LE(drifted.norm(), 0.5 * kDriftPart * way * (1 + 1e-6));
        COMPARE_NEAR(drifted.z(), 0.0, 0.02 * drifted.y(), "m");
        QCOMPARE(hand.tracker.border(), 0.0); // no wall is felt
    }

    void aHandAtRestDoesNotDrift() {
        Hand hand(kDrift, 6e-5);
        const Vec3 begin = hand.pullTo({0, 0.035, 0}, 100), place = hand.at;
        const Vec3 settled = hand.stay(1);
        for (int i = 0; i < 4000; ++i) // between two counts
            QCOMPARE(hand.goTo(place + Vec3(0, i % 2 * 6e-5, 0)), settled);
        QVERIFY(settled.allFinite() && begin.allFinite());
    }
};

TACTUM_TEST(TestReach)

} // namespace test_reach

#include "test_reach.moc"
