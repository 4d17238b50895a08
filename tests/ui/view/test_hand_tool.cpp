#include <algorithm>
#include <cmath>

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
        hand.beginStroke({400, 300}, touched, camera, picker.bounds(),
                         [this](const Vec3& a, const Vec3& b) { return picker.isFree(a, b); });
    }

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
        for (int i = 0; i < 1000 && desk.hand.advance(1e-3); ++i) {
        }
        QVERIFY(!desk.hand.gliding());
        QCOMPARE_LT((desk.hand.goal() - kFront + HandTool::kPressDepth * desk.size() * Vec3::UnitZ()).norm(),
                    1e-9);
    }

    // Deep enough to feel friction and textures, and below what the simulated hand can give.
    void aPressOnAFittedModelIsAFirmOne() {
        const double force = kStiffness.initial * HandTool::kPressDepth * 0.2;
        QCOMPARE_GT(force, 4);
        QCOMPARE_LT(force, 8);
    }

    void strokeFollowsTheSurfaceUnderTheCursor() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.12});
        desk.stroke(kFront);
        desk.hand.advance(10);
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
            while (desk.hand.advance(2e-4))
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

    /// Four diagonals a second, but never less than 0.12 s and never more than 0.6 s; softly at both ends.
    void aGlideTakesItsTime() {
        for (const auto& [from, seconds] : {std::pair(Vec3(0, 0, 0.06), 0.12), {Vec3(0, 0, 9), 0.6}}) {
            Desk desk;
            desk.hand.setGoal(from);
            desk.stroke(kFront);
            QVERIFY(desk.hand.gliding());
            QCOMPARE(desk.hand.grip(), Grip::Stroke);
            QVERIFY(desk.hand.advance(0.999 * seconds));
            QVERIFY(desk.hand.gliding());
            QVERIFY(desk.hand.advance(0.002 * seconds));
            QVERIFY(!desk.hand.gliding());
            QVERIFY(!desk.hand.advance(1));
        }
        Desk desk;
        const Vec3 from(0, 0, 1), end = kFront - HandTool::kPressDepth * desk.size() * Vec3::UnitZ();
        desk.hand.setGoal(from);
        desk.stroke(kFront);
        const double way = (end - from).norm(), duration = std::clamp(way / (4 * desk.size()), 0.12, 0.6);
        for (const auto& [part, gone] : {std::pair(0.25, 0.15625), {0.5, 0.5}, {0.75, 0.84375}}) {
            desk.hand.setGoal(from);
            desk.stroke(kFront);
            desk.hand.advance(part * duration);
            COMPARE_NEAR((desk.hand.goal() - from).norm() / way, gone, 1e-9, "");
        }
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
        desk.hand.end();
        QCOMPARE(desk.hand.grip(), Grip::None);
        QVERIFY(desk.hand.gliding()); // a mere click brings it all the way
        desk.hand.advance(10);
        COMPARE_NEAR(desk.hand.goal(),
                     Vec3(0, 0, kBallRadius - (HandTool::kPressDepth + 0.005) * desk.size()), 1e-9, "m");
    }

    /// What the wheel pushed deeper stays deeper where the stroke goes on.
    void aStrokeKeepsItsDepth() {
        Desk desk;
        desk.hand.setGoal({0, 0, 0.12});
        desk.stroke(kFront);
        desk.hand.advance(10);
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
        desk.hand.advance(10);
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
