// The ground beneath a scene: where its shadow is dark, when there is none, and what it follows.
#include <numeric>

#include <QTest>

#include "core/motion/motion_build.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/base/theme.h"
#include "ui/view/contact_shadow.h"
#include "ui/view/ground_layer.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_ground {

using namespace tactum;
using namespace tactum::testing;

namespace {

ShadowCaster ballAt(double height, bool moves = false) {
    Pose pose;
    pose.translation.y() = height;
    return {ballSoup(64, 32), {true, true}, pose, moves};
}

GroundShadow shadowBeneath(const std::vector<ShadowCaster>& casters, bool standing = false) {
    return shadowOf(casters, standing, {}).value();
}

/// 0 to 255, at a place of the ground.
int darkAt(const GroundShadow& ground, double x, double z) {
    const auto texel = [&](double p, double corner) {
        return std::size_t((p - corner) / ground.side * ground.texels);
    };
    return ground
        .dark[texel(z, ground.corner.z()) * std::size_t(ground.texels) + texel(x, ground.corner.x())];
}

int sumOf(const GroundShadow& ground) {
    return std::accumulate(ground.dark.begin(), ground.dark.end(), 0);
}

struct GroundView {
    explicit GroundView(const Scene& shown) : scene(shown) {
        view.resize(500, 380);
        show();
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        view.moveCamera(0, 0, 1.6); // room for the ground
        proxy.updates = servo.ticks = 1;
    }

    void show() {
        view.setScene(scene);
        settle();
    }
    void settle() {
        if (!test::waitFor([&] { return !view.makesFelt(); })) qFatal("it is never made");
    }
    QImage picture() { return view.grabPicture(); }
    /// How light the ground is beneath the middle of the ball, seen from the side of it.
    int lightnessAt(const Vec3& p_W) {
        const auto pixel = view.camera().project(p_W);
        return picture().pixelColor((*pixel * view.devicePixelRatioF()).toPoint()).lightness();
    }
    void ground(bool on) {
        FeltOptions options = view.felt();
        options.ground = on;
        view.setFelt(options);
    }
    void at(double time) {
        proxy.time = time;
        view.setHaptics(proxy, servo, 8, true);
    }

    Scene scene;
    SceneView view;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
};

} // namespace

class TestGround : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    // Half the ball is cut away: its half of the ground is bright, and the ground lies where it lay.
    void whatASectionCutsAwayCastsNoShadow() {
        ShadowCaster ball = ballAt(0);
        const GroundShadow whole = shadowBeneath({ball});
        ball.section = SectionPlane{{Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitX()), Vec3::Zero()}};
        const GroundShadow half = shadowBeneath({ball});
        QCOMPARE(half.corner, whole.corner);
        QCOMPARE(half.side, whole.side);
        COMPARE_NEAR(sumOf(half), 0.5 * sumOf(whole), 0.05 * sumOf(whole), "");
        COMPARE_NEAR(darkAt(half, -0.02, 0), darkAt(whole, -0.02, 0), 12, "");
        QCOMPARE_LT(darkAt(half, 0.04, 0), darkAt(whole, 0.04, 0) / 3);
    }

    void isDarkestWhereItIsTouched() {
        const GroundShadow ground = shadowBeneath({ballAt(0)});
        QVERIFY(ground.corner.y() < -kBallRadius); // a plate on it is not cut
        QCOMPARE_GT(ground.corner.y(), -1.02 * kBallRadius);
        // In the middle of a texel, as the place opposite is: between two, left and right read another one.
        const double aside = 0.6 * kBallRadius + 0.5 * ground.side / ground.texels;
        const int middle = darkAt(ground, 0, 0), half = darkAt(ground, aside, 0),
                  rim = darkAt(ground, 1.2 * kBallRadius, 0);
        QCOMPARE_GT(middle, 100);
        QCOMPARE_GT(middle, half);
        QCOMPARE_GT(half, rim);
        COMPARE_NEAR(double(darkAt(ground, -aside, 0)), double(half), 1.5, "");
        for (int i = 0; i < ground.texels; ++i)
            QCOMPARE(ground.dark[std::size_t(i)], 0); // nothing is cut off at the edge
    }

    void isWeakerAndWiderTheHigherItsCasterIs() {
        // A second ball keeps the ground where it is.
        ShadowCaster far = ballAt(0);
        far.X_WB.translation.x() = 0.4;
        const GroundShadow low = shadowBeneath({ballAt(0), far}), high = shadowBeneath({ballAt(0.06), far});
        QCOMPARE_GT(darkAt(low, 0, 0), 2 * darkAt(high, 0, 0));
        QCOMPARE_GT(darkAt(high, 0, 0), 0);
    }

    void whatMovesIsLeftOutUntilItRests() {
        ShadowCaster aside = ballAt(0.05, true);
        aside.X_WB.translation.x() = 0.2;
        const std::vector<ShadowCaster> casters{ballAt(0), aside};
        QCOMPARE_GT(sumOf(shadowBeneath(casters, false)), sumOf(shadowBeneath(casters, true)));
        QCOMPARE(sumOf(shadowBeneath({ballAt(0, true)}, true)), 0);
    }

    // Where nothing is yet there is a ground to put something on, without any shadow.
    void anEmptySceneHasAGrid() {
        GroundView shown{Scene()};
        COMPARE_NEAR(shown.view.gridStep(), 0.01, 1e-12, "m");
        shown.view.showStandardView(StandardView::Isometric);
        const QImage with = shown.picture();
        shown.ground(false);
        QCOMPARE(shown.view.gridStep(), 0.0);
        QVERIFY2(with != shown.picture(), "no line of it is seen");
        shown.ground(true);
        shown.scene = ballScene();
        shown.show();
        COMPARE_NEAR(shown.view.gridStep(), gridStep(shadowBeneath({ballAt(0)}).side), 1e-12, "m");
        shown.scene = {};
        shown.show();
        COMPARE_NEAR(shown.view.gridStep(), 0.01, 1e-12, "m");
    }

    void whatIsHiddenCastsNone() {
        ShadowCaster ball = ballAt(0);
        ball.seen = {false, false};
        QVERIFY(shadowBeneath({ball}).casters.empty());
        QVERIFY(shadowBeneath({}).casters.empty());
    }

    void cancelledWorkGivesNothing() {
        std::atomic<bool> cancelled = true;
        QVERIFY(!shadowOf(std::vector{ballAt(0)}, false, Progress{{}, &cancelled}));
    }

    void theGridGoesInPowersOfTen() {
        COMPARE_NEAR(gridStep(0.2), 0.01, 1e-9, "m");
        COMPARE_NEAR(gridStep(0.03), 0.001, 1e-9, "m");
        COMPARE_NEAR(gridStep(3), 0.1, 1e-9, "m");
    }

    void theViewShowsIt_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("dark") << true;
        QTest::newRow("light") << false;
    }
    void theViewShowsIt() {
        QFETCH(bool, dark);
        GroundView shown(ballScene());
        shown.view.setTheme(dark);
        const Vec3 beside(0.3 * kBallRadius, -1.012 * kBallRadius, 0.75 * kBallRadius);
        const int with = shown.lightnessAt(beside);
        COMPARE_NEAR(shown.view.gridStep(), 0.01, 1e-9, "m");
        shown.ground(false);
        QCOMPARE_GT(shown.lightnessAt(beside), with + 5);
        QCOMPARE(shown.view.gridStep(), 0.0);
    }

    // One sees through what would cast it; the grid is there.
    void aWireframeCastsNone() {
        GroundView shown(ballScene());
        const Vec3 beside(0.3 * kBallRadius, -1.012 * kBallRadius, 0.75 * kBallRadius);
        const int solid = shown.lightnessAt(beside);
        FeltOptions options = shown.view.felt();
        options.wireframe = true;
        shown.view.setFelt(options);
        const int wires = shown.lightnessAt(beside);
        COMPARE_NEAR(shown.view.gridStep(), 0.01, 1e-9, "m");
        shown.ground(false);
        QCOMPARE_GT(wires, solid + 5);
        COMPARE_NEAR(wires, shown.lightnessAt(beside), 3, "");
    }

    void isNotSeenFromBelow() {
        GroundView shown(ballScene());
        shown.view.moveCamera(0, -1.2);
        const QImage with = shown.picture();
        shown.ground(false);
        QVERIFY(with == shown.picture());
    }

    void aPlateThatLiesThereHasNone() {
        Scene flat = ballScene();
        auto soup = std::make_shared<TriangleSoup>(*flat.objects[0].geometry);
        for (Vec3& p : soup->positions)
            p.y() *= 0.02;
        flat.objects[0].geometry = soup;
        GroundView shown(flat);
        shown.picture();
        QCOMPARE(shown.view.gridStep(), 0.0);
    }

    void followsAnEdit() {
        GroundView shown(ballScene());
        const Vec3 beneath(0, -1.016 * kBallRadius, 1.1 * kBallRadius);
        const int before = shown.lightnessAt(beneath);
        shown.scene.objects[0].surfaces[kLower].visible = false; // the ground comes up to the rest
        shown.show();
        QCOMPARE_NE(shown.lightnessAt(beneath), before);
    }

    void aBodyHasItsShadowWhenItRests() {
        Scene scene = ballScene();
        SceneObject still = scene.objects[0];
        still.id = 0;
        still.pose.translation.x() = 0.3;
        scene.add(still);
        const Track<Vec3> back{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0, 0, -0.1}}, {}, {}};
        scene.objects[0].motion = std::make_shared<const Motion>(makeMotion(back, {}, 2));
        GroundView shown(scene);
        const Vec3 first(0.3 * kBallRadius, -1.012 * kBallRadius, 0.75 * kBallRadius);
        const Vec3 later = first - Vec3(0, 0, 0.05);
        const int shadowed = shown.lightnessAt(first);
        shown.at(1);
        shown.settle();
        QCOMPARE_GT(shown.lightnessAt(first), shadowed);
        const int moving = shown.lightnessAt(later);
        QVERIFY(test::waitFor([&] { return shown.lightnessAt(later) < moving - 2; }));
    }
};

TACTUM_GUI_TEST(TestGround)

} // namespace test_ground

#include "test_ground.moc"
