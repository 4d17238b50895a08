#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/motion/motion_build.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/shown_ball.h"
#include "ui/base/theme.h"
#include "ui/view/hand_tool.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_scene_view {

using namespace tactum;
using namespace tactum::testing;

namespace {

/// How often a widget is painted.
class PaintCount : public QObject {
public:
    explicit PaintCount(QWidget& widget) { widget.installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        paints += event->type() == QEvent::Paint;
        return false;
    }
    int paints = 0;
};

double difference(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

std::vector<Vec3> goals(const QSignalSpy& spy) {
    std::vector<Vec3> list;
    for (const auto& signal : spy)
        list.push_back(signal[0].value<Vec3>());
    return list;
}

} // namespace

class TestSceneView : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void showsTheModelBeforeABackground() {
        ShownBall shown;
        const QImage picture = shown.view.grabPicture();
        QCOMPARE(picture.size(), kBallView * shown.view.devicePixelRatioF());
        QCOMPARE_GT(difference(shown.colourAt(kBallCentre), shown.colourAt({12, 240})), 120);
        QCOMPARE_LT(difference(shown.colourAt({12, 240}), shown.colourAt({12, 236})), 12);
    }

    void itsColourIsTheSurfaces() {
        ShownBall shown;
        shown.scene.objects[0].surfaces[kUpper].colour = {0.6f, 0.05f, 0.05f};
        shown.view.setScene(shown.scene);
        QCOMPARE_GT(shown.colourAt({320, 180}).red(), 2 * shown.colourAt({320, 180}).green());
        QCOMPARE_LT(shown.colourAt({320, 300}).red(), 1.3 * shown.colourAt({320, 300}).green());
    }

    // Looked at from the front with the front cut off: a disc of one plain tone, unlike the lit outside. A
    // click there meets the far side from within, and the finger before it is not cut.
    void aSectionShowsTheInsideInAPlainTone() {
        ShownBall shown;
        shown.view.setOverlayVisible(false);
        const auto inDisc = [&](double x, double y) {
            return shown.colourAt(shown.pixelOf(kBallRadius * Vec3(x, y, 0)));
        };
        const Vec3 aside = kBallRadius * Vec3(0.45, 0.4, 0); // beside the handles
        const QColor outside = inDisc(0.45, 0.4);
        shown.view.setSection(SectionPlane{});
        const QColor inside = inDisc(0.45, 0.4);
        QCOMPARE_GT(difference(inside, outside), 120);
        QCOMPARE_GT(inside.red(), inside.blue() + 30); // of rust
        for (const auto& [x, y] : {std::pair{0.5, 0.3}, {-0.7, 0.2}, {0.1, -0.8}})
            QCOMPARE_LT(difference(inDisc(x, y), inside), 40);
        shown.view.setTool(ViewTool::Select);
        QSignalSpy picked(&shown.view, &SceneView::picked);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, shown.pixelOf(aside));
        QCOMPARE(picked.size(), 1);
        const auto hit = picked[0][0].value<std::optional<PickHit>>();
        QVERIFY(hit);
        QCOMPARE_LT(hit->point.z(), 0);
        shown.view.setSection(std::nullopt);
        QCOMPARE_LT(difference(inDisc(0.45, 0.4), outside), 6);
    }

    void theHandlesOfASectionLeadIt() {
        ShownBall shown;
        shown.view.showStandardView(StandardView::Right); // the normal lies in the picture, to the left
        shown.view.setSection(SectionPlane{});
        std::optional<SectionPlane> led;
        QSignalSpy arranged(&shown.view, &SceneView::arrangeDragged),
            mapped(&shown.view, &SceneView::mappingDragged);
        connect(&shown.view, &SceneView::sectionDragged, &shown.view, [&](const SectionPlane& plane) {
            led = plane;
            shown.view.setSection(plane);
        });
        const auto& handles = shown.view.sectionHandles();
        const QPointF tip = *handles.placeOf(SectionHandle::Move, shown.view.camera());
        const double pixel = shown.view.camera().pixelSize(Vec3::Zero());
        shown.drag(tip.toPoint(), tip.toPoint() - QPoint(60, 0));
        QVERIFY(led);
        COMPARE_NEAR(led->frame.translation.z(), 60 * pixel, 2 * pixel, "m");
        COMPARE_NEAR(led->normal().z(), 1, 1e-12, "");
        const QPointF turn = *handles.placeOf(SectionHandle::TurnX, shown.view.camera());
        shown.drag(turn.toPoint(), turn.toPoint() + QPoint(30, -30), Qt::LeftButton, Qt::ControlModifier);
        const double angle = std::acos(std::clamp(led->normal().z(), -1.0, 1.0));
        QCOMPARE_GT(angle, 0.2);
        COMPARE_NEAR(std::remainder(angle, EIGEN_PI / 12), 0, 1e-9, "rad");
        COMPARE_NEAR(led->normal().x(), 0, 1e-12, "");
        QCOMPARE(arranged.size() + mapped.size(), 0); // nothing else was led
    }

    void bodiesThatMoveAreShownWhereTheyAre() {
        ShownBall shown;
        const Track<Vec3> aside{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0.12, 0, 0}}, {}, {}};
        shown.scene.objects[0].motion = std::make_shared<const Motion>(makeMotion(aside, {}, 2));
        shown.view.setScene(shown.scene);
        const QColor ball = shown.colourAt(kBallCentre);
        ProxyTelemetry proxy;
        proxy.updates = 1;
        proxy.finger = proxy.output.proxy = {0, 1, 0}; // out of sight
        for (const double time : {1.0, 2.0, 0.0}) {
            proxy.time = time;
            shown.view.setHaptics(proxy, {}, 8, false);
            const QPoint there = shown.pixelOf({0.06 * time, 0, kBallRadius});
            if (there.x() < kBallView.width()) QCOMPARE_LT(difference(shown.colourAt(there), ball), 40);
            QCOMPARE(difference(shown.colourAt(kBallCentre), ball) < 40, time == 0);
        }
    }

    // Pushed by its start velocity of 0.06 m/s: after a second it is seen there, and picked there.
    void whatForcesMoveIsShownAndPickedWhereItIs() {
        ShownBall shown;
        RigidBody body;
        body.id = 1;
        body.velocity = {0.06, 0, 0};
        shown.scene.objects[0].body = 1;
        shown.scene.mechanics.bodies = {body};
        shown.scene.mechanics.gravity = Vec3::Zero();
        const auto world = compile(shown.scene).value();
        shown.view.setScene(shown.scene);
        shown.view.setWorld(world);
        shown.view.setTool(ViewTool::Select);
        const QColor ball = shown.colourAt(kBallCentre);
        SimState state;
        for (int i = 0; i < 1000; ++i)
            hapticStep(*world, state, {.finger = {0, 1, 0}}, 1e-3);
        ProxyTelemetry proxy;
        proxy.updates = 1;
        proxy.finger = proxy.output.proxy = {0, 1, 0}; // out of sight
        proxy.bodies = state.bodies;
        shown.view.setHaptics(proxy, {}, 8, false);
        const QPoint there = shown.pixelOf({0.06, 0, kBallRadius});
        QCOMPARE_LT(difference(shown.colourAt(there), ball), 40);
        QCOMPARE_GT(difference(shown.colourAt(kBallCentre), ball), 40);
        QSignalSpy picked(&shown.view, &SceneView::picked);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, there);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre);
        QCOMPARE(picked.size(), 2);
        const auto hit = [&](int i) { return picked[i][0].value<std::optional<PickHit>>(); };
        QVERIFY(hit(0));
        COMPARE_NEAR(hit(0)->point.x(), 0.06, 1e-3, "m");
        QVERIFY(!hit(1));
    }

    void themesDiffer() {
        ShownBall shown;
        shown.view.setTheme(false);
        const int light = shown.colourAt({12, 12}).lightness();
        shown.view.setTheme(true);
        QCOMPARE_GT(light, shown.colourAt({12, 12}).lightness() + 100);
    }

    void aClickChoosesTheSurfaceThatIsThere() {
        ShownBall shown;
        shown.view.setTool(ViewTool::Select);
        const ObjectId ball = shown.scene.objects[0].id;
        QSignalSpy picked(&shown.view, &SceneView::picked);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre - QPoint(0, 60));
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre + QPoint(40, 60));
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, QPoint(10, 10));
        QCOMPARE(picked.size(), 3);
        const auto hit = [&](int i) { return picked[i][0].value<std::optional<PickHit>>(); };
        QVERIFY(hit(0)->surface == (SurfaceRef{ball, kUpper}));
        QVERIFY(hit(1)->surface == (SurfaceRef{ball, kLower}));
        QVERIFY(!hit(2));
    }

    void aDragChoosesNothing() {
        ShownBall shown;
        shown.view.setTool(ViewTool::Select);
        QSignalSpy picked(&shown.view, &SceneView::picked);
        shown.drag(kBallCentre, kBallCentre + QPoint(50, 20));
        QVERIFY(picked.isEmpty());
    }

    void aBoxThatWasToBeDrawnEndsWithItsTool() {
        ShownBall shown;
        QSignalSpy drawn(&shown.view, &SceneView::boxDrawn);
        for (const ViewTool tool : {ViewTool::Select, ViewTool::Touch}) {
            shown.view.setTool(ViewTool::Select);
            shown.view.beginRegion(RegionShape::Box);
            shown.view.setTool(tool);
            shown.drag({5, 5}, {60, 80});
            QCOMPARE(drawn.size(), 1);
        }
    }

    // A painter has drawn over the frames before, and left the context as it likes it.
    void edgesAreSmoothAtRest() {
        ShownBall shown;
        QImage moving, resting;
        for (int i = 0; i < 3; ++i) {
            shown.view.moveCamera(0.1, 0);
            moving = shown.view.grabFramebuffer();
            resting = shown.view.grabPicture();
        }
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws smooth edges in motion, too");
        int smoothed = 0;
        for (int y = 0; y < moving.height(); ++y)
            for (int x = 0; x < moving.width(); ++x)
                smoothed += difference(moving.pixelColor(x, y), resting.pixelColor(x, y)) > 10;
        QCOMPARE_GT(smoothed, 100);
    }

    void anEditLeavesTheHoverAlone() {
        ShownBall shown;
        const QPoint upper = kBallCentre - QPoint(0, 60);
        QSignalSpy hovered(&shown.view, &SceneView::surfaceHovered);
        QTRY_VERIFY((shown.move(upper, Qt::NoButton), !hovered.isEmpty()));
        const QColor lit = shown.colourAt(upper);
        shown.scene.objects[0].surfaces[kUpper].material.damping = 0.5;
        shown.view.setScene(shown.scene);
        QCOMPARE(hovered.size(), 1);
        QCOMPARE_LT(difference(shown.colourAt(upper), lit), 3);
        shown.view.setScene(Scene{});
        QCOMPARE(hovered.size(), 2);
    }

    void selectionIsOutlinedInTheAccent() {
        ShownBall shown;
        const QPoint rim = shown.pixelOf({0, kBallRadius, 0}) - QPoint(0, 1);
        const QColor before = shown.colourAt(rim);
        shown.view.setSelection({{shown.scene.objects[0].id, kUpper}});
        double nearest = 1e3;
        for (int dy = -6; dy <= 6; ++dy)
            nearest = std::min(nearest, difference(shown.colourAt(rim + QPoint(0, dy)), kDarkTheme.accent));
        QCOMPARE_LT(nearest, 60);
        shown.wheel(kBallCentre, -4); // the outline goes with the model
        nearest = 1e3;
        for (int dy = -6; dy <= 6; ++dy)
            nearest = std::min(nearest, difference(shown.colourAt(rim + QPoint(0, dy)), kDarkTheme.accent));
        QCOMPARE_GT(nearest, 100);
        shown.view.setSelection({});
        shown.view.fit();
        QCOMPARE_LT(difference(shown.colourAt(rim), before), 3);
    }

    /// Of two balls, the farther of which is seen within the other: as many pixels as of each alone. That
    /// none of them has the accent without a selection shows that nothing else is counted.
    void eachSelectedObjectHasAnOutline() {
        ShownBall shown;
        SceneObject behind = shown.scene.objects[0];
        behind.id = 0;
        behind.pose.translation = {0, 0.5 * kBallRadius, -3 * kBallRadius};
        shown.scene.add(behind);
        shown.view.setScene(shown.scene);
        const auto outlined = [&](const std::vector<SurfaceRef>& selection) {
            shown.view.setSelection(selection);
            const QImage picture = shown.view.grabPicture();
            int count = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    count += difference(picture.pixelColor(x, y), kDarkTheme.accent) < 60;
            return count;
        };
        const SurfaceRef near{shown.scene.objects[0].id, kUpper}, far{shown.scene.objects[1].id, kUpper};
        QCOMPARE(outlined({}), 0);
        const int one = outlined({near}), other = outlined({far});
        QCOMPARE_GT(other, 200);
        COMPARE_NEAR(outlined({near, far}), one + other, 0.05 * other, "pixels");
    }

    // While nothing else changes: finger and proxy span a box in which the ball moves.
    void theOutlineGoesWithItsBody() {
        ShownBall shown;
        const Track<Vec3> aside{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0.12, 0, 0}}, {}, {}};
        shown.scene.objects[0].motion = std::make_shared<const Motion>(makeMotion(aside, {}, 2));
        shown.view.setScene(shown.scene);
        ProxyTelemetry proxy;
        proxy.updates = 1;
        proxy.finger = {1, 1, 1};
        proxy.output.proxy = {-1, 1, -1};
        shown.view.setHaptics(proxy, {}, 8, false);
        shown.view.setSelection({{shown.scene.objects[0].id, kUpper}});
        const auto outlinedAt = [&](double x) {
            double nearest = 1e3;
            for (int dy = -6; dy <= 6; ++dy) {
                const QPoint rim = shown.pixelOf({x, kBallRadius, 0}) + QPoint(0, dy);
                nearest = std::min(nearest, difference(shown.colourAt(rim), kDarkTheme.accent));
            }
            return nearest < 60;
        };
        QVERIFY(outlinedAt(0));
        proxy.time = 1;
        shown.view.setHaptics(proxy, {}, 8, false);
        QVERIFY(outlinedAt(0.06));
        QVERIFY(!outlinedAt(0));
    }

    void draggingTheFingerMovesItInTheCamerasPlane() {
        ShownBall shown;
        const Vec3 start(0, 0, 0.09);
        shown.touch(start, start);
        QSignalSpy moved(&shown.view, &SceneView::handGoalMoved),
            grabbed(&shown.view, &SceneView::handGrabbed);
        shown.drag(kBallCentre + QPoint(5, 5), kBallCentre + QPoint(65, -25));
        QVERIFY(!moved.isEmpty());
        const Vec3 goal = goals(moved).back();
        QCOMPARE(shown.view.handGoal().x(), goal.x());
        COMPARE_NEAR(goal - start, shown.camera().pixelSize(start) * Vec3(60, 30, 0), 1e-9, "m");
        QCOMPARE(grabbed.size(), 2);
        QVERIFY(grabbed[0][0].toBool());
        QVERIFY(!grabbed[1][0].toBool());
    }

    void wheelAndControlDragMoveTheHeldFingerInDepth() {
        ShownBall shown;
        const Vec3 start(0, 0, 0.09);
        shown.touch(start, start);
        QTest::mousePress(&shown.view, Qt::LeftButton, {}, kBallCentre);
        shown.wheel(kBallCentre, 3);
        const double notch = 0.005 * boundsOf(shown.scene).diagonal();
        COMPARE_NEAR(shown.view.handGoal(), Vec3(0, 0, 0.09 - 3 * notch), 1e-9, "m");
        const Vec3 before = shown.view.handGoal();
        shown.move(kBallCentre - QPoint(0, 20), Qt::LeftButton, Qt::ControlModifier);
        const double pixel = shown.camera().pixelSize(before);
        QCOMPARE_LT((shown.view.handGoal() - before + 20 * pixel * Vec3::UnitZ()).norm(), 1e-9);
        QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, kBallCentre);
    }

    void aPressOnTheModelTouchesItAndADragStrokesIt() {
        ShownBall shown;
        const double depth = HandTool::kPressDepth * boundsOf(shown.scene).diagonal();
        shown.touch({0.09, 0.05, 0.1}, {0.09, 0.05, 0.1});
        QTest::mousePress(&shown.view, Qt::LeftButton, {}, kBallCentre);
        shown.waitForHand();
        COMPARE_NEAR(shown.view.handGoal(), Vec3(0, 0, kBallRadius - depth), 1e-4, "m");
        shown.move(kBallCentre + QPoint(60, 0), Qt::LeftButton);
        const Vec3 goal = shown.view.handGoal();
        QCOMPARE_GT(goal.x(), 0.01);
        QCOMPARE_LT(goal.norm(), kBallRadius);
        QCOMPARE_GT(goal.z(), 0);
        const auto seen = shown.camera().project(goal);
        COMPARE_NEAR(seen->x(), 380, 1, "pixels");
        COMPARE_NEAR(seen->y(), 240, 1, "pixels");
        QTest::mouseRelease(&shown.view, Qt::LeftButton, {}, kBallCentre + QPoint(60, 0));
        QCOMPARE_GT(shown.view.handGoal().norm(), kBallRadius); // it lifts off
    }

    void aFingerBehindTheModelComesAroundIt() {
        ShownBall shown;
        shown.touch({0, 0, -0.08}, {0, 0, -0.08});
        QSignalSpy moved(&shown.view, &SceneView::handGoalMoved);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre + QPoint(0, 40));
        shown.waitForHand();
        QCOMPARE_GT(shown.view.handGoal().z(), 0.03);
        QCOMPARE_GT(shown.view.handGoal().norm(), kBallRadius); // it was a tap
        bool touched = false;
        for (const Vec3& goal : goals(moved)) {
            if (!(goal.z() > 0.03)) QCOMPARE_GT(goal.norm(), kBallRadius);
            touched = touched || goal.norm() < kBallRadius;
        }
        QVERIFY(touched);
    }

    void gLetsTheFingerFollowUntilAClickOrEsc() {
        ShownBall shown;
        shown.touch({0, 0, 0.09}, {0, 0, 0.09});
        QSignalSpy grabbed(&shown.view, &SceneView::handGrabbed);
        QTest::mouseMove(&shown.view, kBallCentre);
        QTest::keyClick(&shown.view, Qt::Key_G);
        shown.move(kBallCentre, Qt::NoButton);
        const Vec3 before = shown.view.handGoal();
        shown.move(kBallCentre + QPoint(40, 0), Qt::NoButton);
        const double pixel = shown.camera().pixelSize(before);
        COMPARE_NEAR(shown.view.handGoal() - before, 40 * pixel * Vec3::UnitX(), 1e-9, "m");
        QTest::keyClick(&shown.view, Qt::Key_Escape);
        shown.move(kBallCentre, Qt::NoButton);
        COMPARE_NEAR(shown.view.handGoal() - before, 40 * pixel * Vec3::UnitX(), 1e-9, "m");
        QCOMPARE(grabbed.size(), 2);
        QTest::keyClick(&shown.view, Qt::Key_G);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre);
        QCOMPARE(grabbed.size(), 4);
        QVERIFY(!grabbed.last()[0].toBool());
    }

    void arrowKeysNudgeTheFinger() {
        ShownBall shown;
        shown.touch({0, 0, 0.09}, {0, 0, 0.09});
        QTest::keyClick(&shown.view, Qt::Key_Right);
        QTest::keyClick(&shown.view, Qt::Key_PageUp);
        const double step = 0.005 * boundsOf(shown.scene).diagonal();
        COMPARE_NEAR(shown.view.handGoal(), Vec3(step, 0, 0.09 - step), 1e-9, "m");
    }

    void theSelectToolLeavesTheFingerAlone() {
        ShownBall shown;
        shown.view.setTool(ViewTool::Select);
        shown.touch({0, 0, 0.09}, {0, 0, 0.09});
        shown.drag(kBallCentre, kBallCentre + QPoint(80, 0));
        COMPARE_NEAR(shown.view.handGoal(), Vec3(0, 0, 0.09), 1e-12, "m");
    }

    void wheelZoomsToTheCursorAndHomeFits() {
        ShownBall shown;
        const QPoint edge = shown.pixelOf({0, kBallRadius, 0}) - QPoint(0, 14);
        const QColor sky = shown.colourAt(edge);
        shown.wheel(kBallCentre, 4);
        QCOMPARE_GT(difference(shown.colourAt(edge), sky), 60); // the ball has grown over it
        QTest::keyClick(&shown.view, Qt::Key_Home);
        QCOMPARE_LT(difference(shown.colourAt(edge), sky), 3);
    }

    void orbitAndPanTurnAndMoveThePicture() {
        ShownBall shown;
        shown.scene.objects[0].surfaces[kUpper].colour = {0.6f, 0.05f, 0.05f};
        shown.view.setScene(shown.scene);
        const QPoint low = kBallCentre + QPoint(0, 50);
        QCOMPARE_LT(shown.colourAt(low).red(), 1.3 * shown.colourAt(low).green());
        shown.drag(kBallCentre, kBallCentre + QPoint(0, 150), Qt::MiddleButton); // look from above
        QCOMPARE_GT(shown.colourAt(low).red(), 2 * shown.colourAt(low).green());
        shown.view.showStandardView(StandardView::Front);
        shown.drag(kBallCentre, kBallCentre + QPoint(0, 120), Qt::MiddleButton, Qt::ShiftModifier);
        QCOMPARE_GT(shown.colourAt(low).red(), 2 * shown.colourAt(low).green());
    }

    void theProxyIsShownAndCanBeHidden() {
        ShownBall shown;
        const Vec3 proxy(0, 0.02, 0.06);
        const QPoint pixel = shown.pixelOf(proxy);
        const QColor without = shown.colourAt(pixel);
        shown.touch({0.02, 0.03, 0.06}, proxy);
        const QColor with = shown.colourAt(pixel);
        QCOMPARE_GT(with.red(), 1.5 * with.blue());
        QCOMPARE_GT(difference(with, without), 60);
        shown.view.setOverlayVisible(false);
        QCOMPARE_LT(difference(shown.colourAt(pixel), without), 3);
    }

    void whatCannotBeSeenIsNotDrawnAgain() {
        ShownBall shown;
        const Vec3 finger(0, 0, 0.045), proxy(0, 0, 0.051), force(0, 0, 4);
        const Vec3 little = 0.04 * shown.camera().pixelSize(proxy) * Vec3::UnitX();
        shown.touch(finger, proxy, force);
        // It is drawn once more, smoothly, and when it is known what is dark.
        QVERIFY(test::waitFor([&] { return shown.view.rests() && !shown.view.makesFelt(); }));
        PaintCount count(shown.view);
        for (int i = 0; i < 20; ++i) {
            shown.touch(finger + (i % 2) * little, proxy - (i % 2) * little,
                        force + (i % 3) * 1e-3 * force / 4);
            QTest::qWait(5);
        }
        QCOMPARE(count.paints, 0);
        // What creeps is seen in the end.
        for (int i = 0; i < 20; ++i)
            shown.touch(finger + i * little, proxy, force);
        QTRY_VERIFY(count.paints > 0);
    }

    void aFingerInsideTheModelIsSeenThroughIt() {
        ShownBall shown;
        const QPoint pixel = shown.pixelOf({0.01, 0.01, 0.03});
        const QColor without = shown.colourAt(pixel);
        shown.touch({0.01, 0.01, 0.03}, {0.03, 0.04, 0.05});
        const QColor with = shown.colourAt(pixel);
        QCOMPARE_GT(with.blue(), with.red() + 30);
        QCOMPARE_GT(difference(with, without), 40);
    }

    void theForceIsWrittenBesideItsArrow() {
        ShownBall shown;
        shown.touch({0, 0, 0.045}, {0, 0, 0.051}, {1.5, 0, 0});
        const QImage with = shown.view.grabPicture();
        shown.touch({0, 0, 0.045}, {0, 0, 0.051}, {0, 0, 0});
        const QImage without = shown.view.grabPicture();
        int changed = 0;
        const double ratio = with.devicePixelRatio();
        for (int x = 380; x < 460; ++x) // beyond the tip of the arrow
            for (int y = 225; y < 260; ++y)
                changed += difference(with.pixelColor(int(x * ratio), int(y * ratio)),
                                      without.pixelColor(int(x * ratio), int(y * ratio))) > 30;
        QCOMPARE_GT(changed, 200);
    }

    void survivesAFloatingDock() {
        QMainWindow window;
        auto* dock = new QDockWidget(&window);
        auto* view = new SceneView;
        dock->setWidget(view);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        view->setScene(ballScene());
        window.resize(900, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        view->setSelection({{1, kUpper}});
        for (bool floating : {true, false, true}) {
            dock->setFloating(floating);
            QTest::qWait(150);
            const QImage picture = view->grabPicture();
            const QColor middle = picture.pixelColor(picture.width() / 2, picture.height() / 2);
            QVERIFY2(difference(middle, picture.pixelColor(4, picture.height() / 2)) > 100,
                     qPrintable(middle.name()));
        }
    }

    void followsItsSize() {
        ShownBall shown;
        shown.view.resize(300, 500);
        QTest::qWait(50);
        const QImage picture = shown.view.grabPicture();
        QCOMPARE(picture.size(), QSize(300, 500) * shown.view.devicePixelRatioF());
        shown.view.fit();
        QCOMPARE_GT(difference(shown.colourAt({150, 250}), shown.colourAt({4, 250})), 100);
    }

    void goesInAnyOrder() {
        { SceneView never; }
        {
            SceneView hidden;
            hidden.setScene(ballScene());
            hidden.setSelection({{1, kUpper}});
        }
        auto window = std::make_unique<QWidget>();
        auto* child = new SceneView(window.get());
        child->setScene(ballScene());
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));
        window.reset();
        auto shown = std::make_unique<ShownBall>();
        shown->touch({0, 0, 0.045}, {0, 0, 0.051}, {0, 0, 1});
        shown->view.grabPicture();
        shown.reset();
    }

    void anEmptySceneIsShown() {
        ShownBall shown;
        shown.view.setScene(Scene{});
        shown.view.fit();
        QCOMPARE_LT(difference(shown.colourAt(kBallCentre), shown.colourAt({12, 240})), 12);
        QTest::mouseClick(&shown.view, Qt::LeftButton, {}, kBallCentre);
    }

    void largeModelsGetTheirNormalsLater() {
        ShownBall shown;
        shown.view.setScene(ballScene(300, 150)); // 90 000 triangles
        QCOMPARE_GT(difference(shown.colourAt(kBallCentre), shown.colourAt({12, 240})), 120);
        QTest::qWait(600);
        QCOMPARE_GT(difference(shown.colourAt(kBallCentre), shown.colourAt({12, 240})), 120);
    }
};

TACTUM_GUI_TEST(TestSceneView)

} // namespace test_scene_view

#include "test_scene_view.moc"
