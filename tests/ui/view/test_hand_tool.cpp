#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QTest>

#include "core/surface/material.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/hand_tool.h"
#include "ui/view/scene_picker.h"

namespace test_hand_tool {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr double kGap = 0.0012; // m, of a proxy of 1 mm

/// A hand before a ball, seen from the front.
struct Desk {
    Desk() {
        picker.setScene(ballScene());
        camera.distance = 0.4;
        camera.size = {800, 600};
        hand.setSceneSize(size());
    }
    double size() const { return picker.bounds().diagonal(); }
    void stroke(const Vec3& touched) {
        hand.beginStroke({400, 300}, touched, kGap, camera, picker.bounds(),
                         [this](const Vec3& a, const Vec3& b) { return picker.isFree(a, b); });
    }
    /// Every goal from now on until the press is down, with its time.
    std::vector<std::pair<Vec3, double>> parts(double step) {
        std::vector<std::pair<Vec3, double>> goals{{hand.goal(), hand.time()}};
        while (hand.gliding() && goals.size() < 10000) {
            hand.advance(step);
            if (hand.goal() != goals.back().first) goals.emplace_back(hand.goal(), hand.time());
        }
        return goals;
    }
    void arrive() { parts(0.01); }

    ScenePicker picker;
    ViewCamera camera;
    HandTool hand;
};

const Vec3 kFront(0, 0, kBallRadius);

} // namespace

class TestHandTool : public QObject {
    Q_OBJECT
private slots:
    void dragMovesInTheCamerasPlane() {
        Desk desk;
        const Vec3 start(0.01, 0.02, 0.1);
        desk.hand.setGoal(start);
        desk.hand.beginMove(Grip::Drag, {100, 100});
        desk.hand.moveTo({160, 70}, desk.camera, std::nullopt, false);
        const Vec3 moved = desk.hand.goal() - start;
        const double pixel = desk.camera.pixelSize(start);
        COMPARE_NEAR(moved, pixel * Vec3(60, 30, 0), 1e-12, "m");
    }

    /// Until somebody leads it: then it stays where it was led to, also inside of something.
    void whatHasLiftedOffIsUp() {
        const auto lifted = [] {
            Desk desk;
            desk.hand.lift({0, 0, 0.1});
            while (desk.hand.moves())
                desk.hand.advance(0.05);
            return desk;
        };
        QVERIFY(lifted().hand.isUp());
        Desk wheeled = lifted(), nudged = lifted(), put = lifted(), held = lifted();
        wheeled.hand.push(1, wheeled.camera);
        nudged.hand.nudge({1, 0, 0}, nudged.camera);
        put.hand.setGoal({0, 0, 0});
        held.hand.beginMove(Grip::Drag, {100, 100});
        for (const Desk* desk : {&wheeled, &nudged, &put, &held})
            QVERIFY(!desk->hand.isUp());
    }

    void dragAlongTheViewChangesOnlyDepth() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.1});
        desk.hand.beginMove(Grip::Drag, {100, 100});
        desk.hand.moveTo({140, 60}, desk.camera, std::nullopt, true);
        const double pixel = desk.camera.pixelSize({0, 0, 0.1});
        COMPARE_NEAR(desk.hand.goal(), Vec3(0, 0, 0.1 - 40 * pixel), 1e-12, "m");
    }

    void wheelPushesAwayFromTheEye() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.1});
        desk.hand.beginMove(Grip::Drag, {0, 0});
        desk.hand.push(2, desk.camera);
        COMPARE_NEAR(desk.hand.goal(), Vec3(0, 0, 0.1 - 2 * 0.005 * desk.size()), 1e-12, "m");
    }

    void strokeEndsBeneathTheTouchedPoint() {
        Desk desk;
        desk.hand.setGoal({0.02, 0, 0.12});
        desk.stroke(kFront);
        desk.arrive();
        QVERIFY(!desk.hand.gliding());
        QCOMPARE_LT((desk.hand.goal() - kFront + HandTool::kPressDepth * desk.size() * Vec3::UnitZ()).norm(),
                    1e-9);
    }

    // Deep enough to feel friction and textures. The grip of the simulated hand, 250 N/m, gives way.
    void aPressOnAFittedModelIsAFirmOne() {
        const double shared = 250 * kStiffness.initial / (250 + kStiffness.initial);
        const double force = shared * HandTool::kPressDepth * 0.2;
        QCOMPARE_GT(force, 1);
        QCOMPARE_LT(force, 3);
    }

    void strokeFollowsTheSurfaceUnderTheCursor() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.12});
        desk.stroke(kFront);
        desk.arrive();
        const Vec3 touched =
            desk.picker.cast(desk.camera.ray({430, 280}), ScenePicker::Patience::Wait)->point;
        desk.hand.moveTo({430, 280}, desk.camera, touched, false);
        COMPARE_NEAR((desk.hand.goal() - touched).norm(), HandTool::kPressDepth * desk.size(), 1e-9, "m");
        QCOMPARE_LT(desk.hand.goal().norm(), kBallRadius);
        const double depth = desk.camera.depth(desk.hand.goal());
        desk.hand.moveTo({700, 280}, desk.camera, std::nullopt, false);
        COMPARE_NEAR(desk.camera.depth(desk.hand.goal()), depth, 1e-12, "m");
    }

    void aGlideGoesAroundTheModel() {
        for (const Vec3& from :
             {Vec3(0, 0, -0.1), Vec3(0.01, 0, -0.07), Vec3(0, -0.09, -0.02), Vec3(0, 0, 0.2)}) {
            Desk desk;
            desk.hand.setGoal(from);
            desk.stroke(kFront);
            double nearest = 1;
            while (desk.hand.gliding() && desk.hand.advance(2e-4))
                if ((desk.hand.goal() - kFront).norm() > 0.02)
                    nearest = std::min(nearest, desk.hand.goal().norm());
            QCOMPARE_GT(nearest, kBallRadius);
        }
    }

    void keysStepIntoTheCamerasDirections() {
        Desk desk;
        desk.camera.yaw = 0.7;
        desk.camera.pitch = 0.3;
        desk.hand.setGoal({0, 0, 0.1});
        desk.hand.nudge({2, -3, 4}, desk.camera);
        const double step = 0.005 * desk.size();
        COMPARE_NEAR(desk.hand.goal(),
                     Vec3(0, 0, 0.1) +
                         step * (2 * desk.camera.right() - 3 * desk.camera.up() + 4 * desk.camera.forward()),
                     1e-12, "m");
        desk.stroke(kFront);
        desk.hand.nudge({0, 0, 0}, desk.camera); // ends a glide
        QVERIFY(!desk.hand.gliding());
    }

    /// Four diagonals a second, never more than 0.6 s; softly at both ends.
    void aGlideTakesItsTime() {
        for (const auto& [from, longest] : {std::pair(Vec3(0, 0, 1), 0.6), {Vec3(0, 0, 0.2), 0.6}}) {
            Desk desk;
            const Vec3 end(0, 0, kBallRadius + HandTool::kHoverHeight * desk.size());
            const double way = (end - from).norm(), duration = std::min(way / (4 * desk.size()), longest);
            desk.hand.setGoal(from);
            desk.stroke(kFront);
            QVERIFY(desk.hand.gliding());
            QCOMPARE(desk.hand.grip(), Grip::Stroke);
            double before = 0;
            for (const auto& [part, gone] :
                 {std::pair(0.25, 0.15625), {0.5, 0.5}, {0.75, 0.84375}, {1., 1.}}) {
                for (int i = 0; i < 10; ++i)
                    desk.hand.advance(0.1 * (part - before) * duration);
                before = part;
                COMPARE_NEAR((desk.hand.goal() - from).norm() / way, gone, 1e-9, "");
            }
        }
    }

    /// However late the window is: it shows every piece of the way, one after the other.
    void aLateWindowDoesNotCutCorners() {
        Desk desk;
        desk.hand.setGoal({0, 0, -0.1});
        desk.stroke(kFront);
        const int onTheWay = desk.parts(0.5).size();
        QCOMPARE_GE(onTheWay, 6);
    }

    /// To the place, nearly down to it, and down: the hand is at rest between them, and nothing is touched
    /// before the last. A hand that is there already needs no way.
    void aPressHasParts() {
        for (const bool there : {false, true}) {
            Desk desk;
            const double size = desk.size();
            desk.hand.setGoal({0, 0, kBallRadius + (there ? HandTool::kHoverHeight : 1) * size});
            desk.stroke(kFront);
            if (there) COMPARE_NEAR(desk.hand.goal(), kFront + kGap * Vec3::UnitZ(), 1e-12, "m");
            const auto parts = desk.parts(0.01);
            const auto& [down, press] = parts.back();
            const auto& [before, approach] = parts[parts.size() - 2];
            COMPARE_NEAR(down, kFront - HandTool::kPressDepth * size * Vec3::UnitZ(), 1e-12, "m");
            QCOMPARE(press, HandTool::kPressTime);
            COMPARE_NEAR(before, kFront + kGap * Vec3::UnitZ(), 1e-12, "m");
            QCOMPARE_GE(approach, HandTool::kShortestApproach);
            QCOMPARE_LE(approach, HandTool::kLongestApproach);
            QCOMPARE(parts.size() == 2, there);
        }
    }

    /// What is let go while it presses lifts off; what was let go before has touched first, half as deep.
    void whatIsLetGoLiftsOff() {
        for (const bool tapped : {false, true}) {
            Desk desk;
            const double size = desk.size();
            desk.hand.setGoal(kFront + HandTool::kHoverHeight * size * Vec3::UnitZ());
            desk.stroke(kFront);
            if (!tapped) desk.arrive();
            desk.hand.end();
            QCOMPARE(desk.hand.grip(), Grip::None);
            QCOMPARE(desk.hand.isDone(), !tapped);
            desk.arrive();
            QVERIFY(desk.hand.isDone());
            QVERIFY(!desk.hand.advance(1));
            const double depth = (tapped ? HandTool::kTapDepth : 1) * HandTool::kPressDepth * size;
            COMPARE_NEAR(desk.hand.goal(), kFront - depth * Vec3::UnitZ(), 1e-12, "m");
            QVERIFY(desk.hand.offSurface());
            COMPARE_NEAR(*desk.hand.offSurface(), kFront + HandTool::kHoverHeight * size * Vec3::UnitZ(),
                         1e-12, "m");
            desk.hand.lift(*desk.hand.offSurface());
            QCOMPARE(desk.hand.time(), HandTool::kLiftTime);
            QVERIFY(desk.hand.advance(HandTool::kLiftTime));
            QVERIFY(!desk.hand.moves());
        }
    }

    void whatIsGivenUpDoesNotTouch() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.3});
        desk.stroke(kFront);
        desk.hand.advance(0.05);
        const Vec3 now = desk.hand.goal();
        desk.hand.giveUp();
        QVERIFY(!desk.hand.moves());
        COMPARE_NEAR(desk.hand.goal(), now, 1e-12, "m");
        desk.stroke(kFront);
        while (desk.hand.time() != HandTool::kPressTime)
            desk.hand.advance(0.01);
        desk.hand.giveUp();
        QVERIFY(desk.hand.isDone());
    }

    /// The first places under a pointer that moves at once are not reached faster than a hand goes.
    void aStrokeIsNoFasterThanAHand() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.12});
        desk.stroke(kFront);
        desk.arrive();
        const Vec3 before = desk.hand.goal();
        desk.hand.moveTo({430, 280}, desk.camera, Vec3(0.04, 0, 0.03), false);
        const double way = (desk.hand.goal() - before).norm();
        COMPARE_NEAR(1.875 * way / desk.hand.time(), 4 * desk.size(), 1e-9, "m/s");
        desk.hand.moveTo({431, 280}, desk.camera, Vec3(0.0401, 0, 0.03), false);
        QCOMPARE(desk.hand.time(), HandTool::kFollowTime);
    }

    /// On its way, the end of a glide follows the cursor and the wheel.
    void aGlideIsLedElsewhere() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.3});
        desk.stroke(kFront);
        desk.hand.advance(0.05);
        const Vec3 now = desk.hand.goal();
        desk.hand.push(1, desk.camera);
        COMPARE_NEAR(desk.hand.goal(), now, 1e-12, "m"); // not yet
        desk.arrive();
        COMPARE_NEAR(desk.hand.goal(),
                     Vec3(0, 0, kBallRadius - (HandTool::kPressDepth + 0.005) * desk.size()), 1e-9, "m");
    }

    /// What the wheel pushed deeper stays deeper where the stroke goes on.
    void aStrokeKeepsItsDepth() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.12});
        desk.stroke(kFront);
        desk.arrive();
        desk.hand.push(3, desk.camera);
        const double depth = (HandTool::kPressDepth + 3 * 0.005) * desk.size();
        COMPARE_NEAR(desk.hand.goal(), Vec3(0, 0, kBallRadius - depth), 1e-9, "m");
        const Vec3 beside(0.01, 0, 0.045);
        desk.hand.moveTo({410, 300}, desk.camera, beside, false);
        COMPARE_NEAR((desk.hand.goal() - beside).norm(), depth, 1e-9, "m");
        desk.hand.beginMove(Grip::Follow, {410, 300});
        QCOMPARE(desk.hand.grip(), Grip::Follow);
        desk.hand.push(1, desk.camera); // no stroke: the depth of the next one is the usual one
        desk.stroke(kFront);
        desk.arrive();
        COMPARE_NEAR(desk.hand.goal(), Vec3(0, 0, kBallRadius - HandTool::kPressDepth * desk.size()), 1e-9,
                     "m");
    }

    void aPathIsRunThroughByItsLength() {
        GlidePath path({{0, 0, 0}, {1, 0, 0}, {1, 3, 0}});
        QCOMPARE(path.length(), 4.0);
        COMPARE_NEAR(path.at(0), Vec3(0, 0, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(0.125), Vec3(0.5, 0, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(0.25), Vec3(1, 0, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(0.5), Vec3(1, 1, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(1), Vec3(1, 3, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(7), Vec3(1, 3, 0), 1e-12, "m");
        COMPARE_NEAR(path.at(-7), Vec3(0, 0, 0), 1e-12, "m");
        path.moveEnd({1, 1, 0});
        QCOMPARE(path.length(), 2.0);
        COMPARE_NEAR(GlidePath({Vec3(1, 2, 3)}).at(0.3), Vec3(1, 2, 3), 1e-12, "m");
    }

    void theWayAroundLiesOnABall() {
        Bounds box;
        box.add({-1, -1, -1});
        box.add({1, 1, 1});
        const Vec3 from(0, 0, -3), hover(0, 0, 3), target(0, 0, 1);
        const auto straight =
            planGlide(from, hover, target, box, [](const Vec3&, const Vec3&) { return true; });
        QCOMPARE(straight.points().size(), 3u);
        COMPARE_NEAR(straight.points()[1], hover, 1e-12, "m");
        const auto around =
            planGlide(from, hover, target, box, [](const Vec3&, const Vec3&) { return false; });
        const auto& points = around.points();
        QCOMPARE(points.size(), 16u); // thirteen on the ball
        COMPARE_NEAR(points.front(), from, 1e-12, "m");
        COMPARE_NEAR(points[14], hover, 1e-12, "m");
        COMPARE_NEAR(points.back(), target, 1e-12, "m");
        const double radius = 0.6 * box.diagonal();
        for (std::size_t i = 1; i < 14; ++i)
            COMPARE_NEAR(points[i].norm(), radius, 1e-9, "m");
        COMPARE_NEAR(points[1], Vec3(0, 0, -radius), 1e-9, "m");
        COMPARE_NEAR(points[13], Vec3(0, 0, radius), 1e-9, "m");
        for (std::size_t i = 2; i < 14; ++i) // by the same angle each time
            COMPARE_NEAR((points[i] - points[i - 1]).norm(), 2 * radius * std::sin(EIGEN_PI / 24), 1e-9, "m");
        const auto side =
            planGlide({3, 0, 0}, {0, 0, 3}, target, box, [](const Vec3&, const Vec3&) { return false; });
        COMPARE_NEAR(side.points()[7], radius * Vec3(1, 0, 1).normalized(), 1e-9, "m"); // the shorter way
        const auto inside =
            planGlide({0, 0, 0}, hover, target, box, [](const Vec3&, const Vec3&) { return false; });
        COMPARE_NEAR(inside.points()[1], Vec3(0, radius, 0), 1e-9, "m"); // from the middle upward
    }

    void settingTheGoalEndsAGlide() {
        Desk desk;
        desk.stroke(kFront);
        desk.hand.setGoal({1, 2, 3});
        QVERIFY(!desk.hand.advance(0.1));
        QCOMPARE(desk.hand.goal().y(), 2.0);
    }
};

TACTUM_TEST(TestHandTool)

} // namespace test_hand_tool

#include "test_hand_tool.moc"
