// The device's workspace in the scene: frames, clutch and bump.
#include <random>

#include <QTest>

#include "core/port/workspace.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_workspace {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3;
constexpr std::uint32_t kClutch = 2;
const Vec3 kCentre = Vec3::Zero();

/// All 48 ways to lay axes onto axes.
std::vector<AxisMap> everyMapping() {
    std::vector<AxisMap> mappings;
    AxisMap order = kSameAxes;
    do {
        for (int signs = 0; signs < 8; ++signs) {
            AxisMap axes = order;
            for (int i = 0; i < 3; ++i)
                if (signs >> i & 1) axes[std::size_t(i)] = std::int8_t(-axes[std::size_t(i)]);
            mappings.push_back(axes);
        }
    } while (std::ranges::next_permutation(order).found);
    return mappings;
}

Vec3 anyVector(std::mt19937_64& random) {
    std::uniform_real_distribution<double> at(-1, 1);
    return {at(random), at(random), at(random)};
}

DeviceSample reading(const Vec3& position, std::uint32_t buttons = 0) {
    DeviceSample sample;
    sample.position = position;
    sample.buttons = buttons;
    sample.valid = true;
    return sample;
}

DeviceInfo withRadius(double radius) {
    DeviceInfo device;
    device.workspaceRadius = radius;
    return device;
}

/// A tracker whose device goes where the test says, and the finger's place in the scene.
struct Tracked {
    explicit Tracked(const Workspace& workspace, double radius = 0.1) : tracker(withRadius(radius)) {
        tracker.decide(workspace);
    }
    Vec3 finger(const Vec3& device, std::uint32_t buttons = 0, bool pushing = false) {
        return tracker.follow(reading(device, buttons), {.pushing = pushing}, kTick).pointInWorld(device);
    }
    WorkspaceTracker tracker;
};

} // namespace

class TestWorkspace : public QObject {
    Q_OBJECT

private slots:
    void framesLeadThereAndBack() {
        std::mt19937_64 random(1);
        for (const AxisMap& axes : everyMapping()) {
            const DeviceFrame frame{3.5, axes, anyVector(random)};
            for (int i = 0; i < 20; ++i) {
                const Vec3 p = anyVector(random), v = anyVector(random), force = anyVector(random);
                COMPARE_NEAR(frame.pointInDevice(frame.pointInWorld(p)), p, 1e-14, "m");
                COMPARE_NEAR(frame.wayInDevice(frame.wayInWorld(v)), v, 1e-14, "m/s");
                QCOMPARE(frame.turnedBack(frame.turned(force)), force);
                QCOMPARE(frame.turned(force).squaredNorm() > 0, true);
                // What the hand does in its measure is what the scene gives in its own, divided by the scale.
                const double scene = frame.turned(force).dot(frame.wayInWorld(v));
                COMPARE_NEAR(scene, 3.5 * force.dot(v), 1e-14, "");
            }
        }
    }

    void whatCannotBeIsRefused() {
        VERIFY_RESULT(checkWorkspace({}));
        for (const AxisMap& axes : everyMapping())
            VERIFY_RESULT(checkWorkspace({.axes = axes}));
        for (const AxisMap& axes :
             {AxisMap{1, 1, 3}, AxisMap{0, 2, 3}, AxisMap{1, 2, 4}, AxisMap{1, -1, 3}, AxisMap{-128, 2, 3}})
            QVERIFY(!checkWorkspace({.axes = axes}));
        for (const double scale : {0.0, -1.0, std::nan(""), 1e9, 1e-9})
            QVERIFY(!checkWorkspace({.scale = scale}));
        QVERIFY(!checkWorkspace({.offset = Vec3(0, std::nan(""), 0)}));
        QVERIFY(!checkWorkspace(
            {.reach = {ReachMode(kReachModes), kUsualShell}})); // a later client's, for instance
        for (const double shell : {0.0, 0.9 * kMinShell, 1.1 * kMaxShell, std::nan("")})
            QVERIFY(!checkWorkspace({.reach = {ReachMode::Rate, shell}}));
    }

    void underTheClutchTheFingerRests() {
        std::mt19937_64 random(2);
        Tracked hand({.scale = 4, .axes = {-2, 3, 1}, .offset = {0.3, 0, -1}, .clutch = kClutch});
        Vec3 device = 0.01 * anyVector(random);
        const Vec3 begin = hand.finger(device);
        COMPARE_NEAR(hand.finger(device, kClutch), begin, 1e-15, "m");
        for (int i = 0; i < 200; ++i) {
            device = 0.05 * anyVector(random);
            COMPARE_NEAR(hand.finger(device, kClutch | 8), begin, 1e-12, "m");
            QVERIFY(hand.tracker.clutched());
        }
        // Let go, it goes on from there.
        COMPARE_NEAR(hand.finger(device, 8), begin, 1e-12, "m");
        QVERIFY(!hand.tracker.clutched());
        const Vec3 way(0.001, 0, 0);
        const Vec3 moved = hand.finger(device + way) - begin;
        COMPARE_NEAR(moved, 4 * Vec3(0, 0, 0.001), 1e-12, "m");
    }

    void aLostReadingMovesNothing() {
        Tracked hand({.clutch = kClutch});
        const Vec3 begin = hand.finger({0.01, 0, 0}, kClutch);
        DeviceSample lost;
        hand.tracker.follow(lost, {}, kTick);
        COMPARE_NEAR(hand.finger({0.02, 0, 0}, kClutch), begin, 1e-15, "m");
    }

    /// Else the finger that is still believed would stand elsewhere without a jump that anybody is told.
    void aDecisionWaitsForAReading() {
        Tracked hand({.clutch = kClutch});
        hand.finger(kCentre);
        hand.tracker.decide({.offset = {0.01, 0, 0}, .clutch = kClutch});
        const DeviceFrame& frame = hand.tracker.follow(DeviceSample{}, {}, kTick);
        QCOMPARE(frame.offset, Vec3(0, 0, 0));
        QVERIFY(!hand.tracker.jumped());
        QCOMPARE(hand.finger(kCentre), Vec3(kCentre + Vec3(0.01, 0, 0)));
        QVERIFY(hand.tracker.jumped());
    }

    void theEdgeTakesTheWorkspaceAlong() {
        Tracked hand({.scale = 2, .bump = true}, 0.1);
        const Vec3 inside(0.08, 0, 0), edge(0, 0.1, 0);
        QCOMPARE(hand.finger(inside), Vec3(2 * inside));
        Vec3 finger;
        for (int i = 0; i < 1000; ++i)
            finger = hand.finger(edge);
        // In the hand's measure kBumpSpeed for a second.
        COMPARE_NEAR(finger, 2 * (edge + Vec3(0, kBumpSpeed, 0)), 1e-9, "m");
        const Vec3 before = finger;
        QCOMPARE(hand.finger(edge, 0, true), before); // it pushes against something
    }

    /// Also of a machine that slept for a night with the handle at the edge.
    void aLoopThatStoodStillTookNothingAlong() {
        WorkspaceTracker tracker(withRadius(0.1));
        tracker.decide({.bump = true});
        DeviceSample edge;
        edge.position = {0, 0.1, 0};
        edge.valid = true;
        const Vec3 before = tracker.follow(edge, {}, kTick).offset;
        const Vec3 after = tracker.follow(edge, {}, 8 * 3600).offset;
        QCOMPARE_LE((after - before).norm(), kBumpSpeed * 0.01 + 1e-12);
    }

    void aStepAtTheEdgeIsNotFelt() {
        Tracked hand({.bump = true}, 0.1);
        Vec3 last = hand.finger({0.08, 0, 0});
        double fastest = 0;
        for (int i = 1; i <= 200; ++i) { // 0.1 m/s outward
            const Vec3 next = hand.finger({0.08 + 1e-4 * i, 0, 0});
            fastest = std::max(fastest, (next - last).norm() / kTick);
            last = next;
        }
        QCOMPARE_LE(fastest, 0.1 + kBumpSpeed + 1e-9);
        QCOMPARE_GT(fastest, 0.1 + 0.9 * kBumpSpeed);
    }

    void aDecisionThatMovesTheFingerIsAJump() {
        Tracked hand({.clutch = kClutch});
        hand.finger(kCentre);
        QVERIFY(!hand.tracker.jumped());
        hand.tracker.decide({.scale = 2, .clutch = kClutch});
        hand.finger(kCentre);
        QVERIFY(hand.tracker.jumped());
        hand.finger(kCentre);
        QVERIFY(!hand.tracker.jumped());
        hand.tracker.decide({.scale = 2, .clutch = 1, .bump = true}); // moves nothing
        hand.finger(kCentre);
        QVERIFY(!hand.tracker.jumped());
    }

    void whatTheClutchMovedStaysUntilAnotherPlaceIsChosen() {
        Tracked hand({.clutch = kClutch});
        hand.finger({0, 0, 0}, kClutch);
        hand.finger({-0.05, 0, 0}, kClutch);
        COMPARE_NEAR(hand.finger(kCentre), Vec3(0.05, 0, 0), 1e-15, "m");
        hand.tracker.decide({.clutch = kClutch, .bump = true});
        COMPARE_NEAR(hand.finger(kCentre), Vec3(0.05, 0, 0), 1e-15, "m");
        hand.tracker.decide({.clutch = kClutch, .bump = true, .centring = 1});
        COMPARE_NEAR(hand.finger(kCentre), kCentre, 1e-15, "m");
        hand.finger({0, 0, 0}, kClutch);
        hand.finger({-0.05, 0, 0}, kClutch);
        hand.tracker.decide({.offset = {0, 1e-3, 0}, .clutch = kClutch, .centring = 1});
        COMPARE_NEAR(hand.finger(kCentre), Vec3(0, 1e-3, 0), 1e-15, "m");
    }
};

TACTUM_TEST(TestWorkspace)

} // namespace test_workspace

#include "test_workspace.moc"
