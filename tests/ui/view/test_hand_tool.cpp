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
