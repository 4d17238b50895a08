// How much light comes to a place of a surface: against closed forms of half spaces, walls and balls, and in
// the picture. A form that is wrong would show itself in the plain and the ball alone, which must be white.
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/soups.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/occlusion_bake.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_occlusion {

using namespace tactum;
using namespace tactum::testing;

namespace {

/// A rectangle of two triangles.
std::shared_ptr<const TriangleSoup> rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {corner, corner + u, corner + u + v, corner + v};
    soup->triangles = {{0, 1, 2}, {0, 2, 3}};
    soup->surfaceOf = {0, 0};
    return soup;
}

ShadowCaster standing(std::shared_ptr<const TriangleSoup> soup) {
    return {std::move(soup), {true, true}, Pose{}, false};
}

/// Of 0.2 m about the origin, facing up.
ShadowCaster plate() {
    return standing(rectangle({-0.1, 0, -0.1}, {0, 0, 0.2}, {0.2, 0, 0}));
}

ShadowCaster ballOver(double height, bool moves = false) {
    ShadowCaster ball{ballSoup(64, 32), {true, true}, Pose{}, moves};
    ball.X_WB.translation.y() = height;
    return ball;
}

/// Fine, and of what is as far as the scene is wide.
OcclusionVolume volumeOf(const std::vector<ShadowCaster>& casters) {
    return occlusionOf(casters, {}, {.along = 96, .reach = 10}).value();
}

SceneObject objectOf(const char* name, std::shared_ptr<const TriangleSoup> soup, std::size_t surfaces) {
    SceneObject object;
    object.name = name;
    object.geometry = std::move(soup);
    object.surfaces.resize(surfaces);
    return object;
}

} // namespace

class TestOcclusion : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void aPlainIsOpenOnBothSides() {
        const OcclusionVolume volume = volumeOf({plate()});
        for (const double x : {-0.06, -0.0113, 0.0, 0.0427})
            for (const double side : {-1.0, 1.0})
                COMPARE_NEAR(volume.openness({x, 0, 0.3 * x}, {0, side, 0}), 1.0, 0.03, "");
    }

    void aPlainThatLeansIsOpen() {
        for (const double lean : {0.1, 0.3, 0.6, 1.0}) {
            ShadowCaster leaning = plate();
            leaning.X_WB.rotation = Quat(Eigen::AngleAxisd(lean, Vec3(1, 0, 0.5).normalized()));
            const OcclusionVolume volume = volumeOf({leaning});
            for (const double x : {-0.05, -0.0113, 0.0, 0.0427})
                COMPARE_NEAR(
                    volume.openness(leaning.X_WB.apply({x, 0, 0.3 * x}), leaning.X_WB.rotate(Vec3::UnitY())),
                    1.0, 0.05, "");
        }
    }

    void aBallAloneIsOpen() {
        const OcclusionVolume volume = volumeOf({ballOver(0)});
        for (int i = 0; i < 40; ++i) {
            const double y = 1 - (2 * i + 1) / 40.0, across = std::sqrt(1 - y * y);
            const Vec3 out(across * std::cos(2.4 * i), y, across * std::sin(2.4 * i));
            COMPARE_NEAR(volume.openness(kBallRadius * out, out), 1.0, 0.06, "");
        }
    }

    // Without a grid, which takes a third of a second: exactly white. Whatever is added to it or taken off it
    // makes one.
    void aConvexBodyAloneHasNoGrid() {
        const auto caster = [](std::shared_ptr<const TriangleSoup> soup) {
            return ShadowCaster{std::move(soup), {true, true}, Pose{}, false};
        };
        const ShadowCaster round = caster(test::ball(0.05, 3));
        QVERIFY(volumeOf({round}).empty());
        TriangleSoup open = *round.soup;
        open.triangles.pop_back();
        open.surfaceOf.pop_back();
        QVERIFY(!volumeOf({caster(std::make_shared<const TriangleSoup>(open))}).empty());
        TriangleSoup dented = *round.soup;
        dented.positions[dented.triangles[40][0]] *= 0.9;
        QVERIFY(!volumeOf({caster(std::make_shared<const TriangleSoup>(dented))}).empty());
        TriangleSoup inside = *round.soup;
        for (auto& triangle : inside.triangles)
            std::swap(triangle[1], triangle[2]);
        QVERIFY(!volumeOf({caster(std::make_shared<const TriangleSoup>(inside))}).empty());
        QVERIFY(!volumeOf({round, plate()}).empty());
        ShadowCaster moving = plate();
        moving.moves = true; // it takes none, nor does it keep the other from being alone
        QVERIFY(volumeOf({round, moving}).empty());
        TriangleSoup halves = *round.soup;
        std::fill_n(halves.surfaceOf.begin(), halves.surfaceOf.size() / 2, 1);
        ShadowCaster half = caster(std::make_shared<const TriangleSoup>(halves));
        QVERIFY(volumeOf({half}).empty());
        half.seen = {true, false};
        QVERIFY(!volumeOf({half}).empty());
        ShadowCaster cut = round;
        cut.section = SectionPlane{};
        QVERIFY(!volumeOf({cut}).empty());
    }

    /// The form factor of a wall of height h from a floor at the distance d: (1 - d / sqrt(d^2 + h^2)) / 2.
    void aWallTakesItsFormFactor() {
        constexpr double kHeight = 0.1;
        const OcclusionVolume volume =
            volumeOf({standing(rectangle({0, 0, -0.4}, {0, 0, 0.8}, {0.3, 0, 0})),
                      standing(rectangle({0, 0, -0.4}, {0, kHeight, 0}, {0, 0, 0.8}))});
        for (const double d : {0.03, 0.06, 0.12, 0.2}) {
            const double open = 0.5 * (1 + d / std::hypot(d, kHeight));
            COMPARE_NEAR(volume.openness({d, 0, 0.013}, Vec3::UnitY()), open, 0.05, "");
        }
    }

    /// With the harmonics up to l = 1 a ball of the solid angle w at the angle t off the normal takes
    /// w (1 + 2 cos t) / (4 pi).
    void aBallTakesItsSolidAngle() {
        constexpr double kHeight = 0.09;
        const OcclusionVolume volume = volumeOf({plate(), ballOver(kHeight)});
        for (const double x : {0.0, 0.03, 0.06, 0.09}) {
            const double far = std::hypot(x, kHeight), part = kBallRadius / far;
            const double angle = 2 * std::numbers::pi * (1 - std::sqrt(1 - part * part));
            const double taken = angle * (1 + 2 * kHeight / far) / (4 * std::numbers::pi);
            COMPARE_NEAR(volume.openness({x, 0, 0}, Vec3::UnitY()), 1 - taken, 0.04, "");
        }
    }

    /// What lies about the scene, as a body that has gone there, is as bright as under the open sky,
    /// whichever way it faces.
    void allIsOpenBeyondTheScene() {
        const OcclusionVolume volume = volumeOf({ballOver(0)});
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-0.5, 0.5})
                for (const Vec3& normal : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitY()), Vec3(Vec3::UnitZ())})
                    COMPARE_NEAR(volume.openness(side * Vec3::Unit(axis), normal), 1, 0.01, "");
    }

    void whatMovesTakesNone() {
        const OcclusionVolume volume = volumeOf({plate(), ballOver(0.06, true)});
        COMPARE_NEAR(volume.openness(Vec3::Zero(), Vec3::UnitY()), 1.0, 0.03, "");
        QVERIFY(volumeOf({ballOver(0, true)}).empty());
        QCOMPARE(OcclusionVolume{}.openness(Vec3::Zero(), Vec3::UnitY()), 1.0);
    }

    /// All that is above the plate.
    void whatASectionCutsAwayTakesNone() {
        ShadowCaster ball = ballOver(0.06);
        ball.section = SectionPlane{{Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY()), Vec3(0, 0.001, 0)}};
        COMPARE_NEAR(volumeOf({plate(), ball}).openness(Vec3::Zero(), Vec3::UnitY()), 1.0, 0.03, "");
    }

    /// However far its other side is: a place that is looked up beyond a wall must not be bright.
    void theInsideOfABallIsDark() {
        const auto volume =
            occlusionOf(std::vector<ShadowCaster>{ballOver(0)}, {}, {.along = 64, .reach = 0.1});
        for (const Vec3& out : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, 0.8)})
            QCOMPARE_LT(volume->openness(kBallRadius * out, -out), 0.15);
    }

    void theReachEndsIt() {
        const std::vector<ShadowCaster> casters{plate(), ballOver(0.09)};
        const auto near = occlusionOf(casters, {}, {.along = 64, .reach = 0.15}).value();
        COMPARE_NEAR(near.openness(Vec3::Zero(), Vec3::UnitY()), 1.0, 0.03, "");
    }

    void cancelledWorkMakesNothing() {
        const std::atomic<bool> cancelled{true};
        QVERIFY(!occlusionOf(std::vector<ShadowCaster>{plate()}, {.report = {}, .cancelled = &cancelled}));
    }

    /// A table of two triangles is dark beneath a ball that stands on it, and where the ball goes it follows.
    void isSeenOnTheCoarsestTable() {
        Scene scene;
        scene.add(objectOf("table", rectangle({-0.2, 0, -0.2}, {0, 0, 0.4}, {0.4, 0, 0}), 1));
        SceneObject ball = objectOf("ball", ballSoup(64, 32), 2);
        ball.pose.translation.y() = kBallRadius;
        scene.add(ball);
        SceneView view;
        view.resize(500, 380);
        view.setScene(scene);
        view.show();
        QVERIFY2(QTest::qWaitForWindowExposed(&view), "the view is seen");
        const auto lightAt = [&](double x) {
            if (!test::waitFor([&] { return !view.makesFelt(); })) qFatal("it is never made");
            const QPointF pixel = *view.camera().project({x, 0, 0.02}) * view.devicePixelRatioF();
            return view.grabPicture().pixelColor(pixel.toPoint()).lightness();
        };
        const double side = 0.6 * kBallRadius + 0.03;
        const int beside = lightAt(side), far = lightAt(0.17);
        QCOMPARE_LT(beside, far - 8);
        scene.objects[1].pose.translation.x() = -0.1;
        view.setScene(scene);
        QCOMPARE_GT(lightAt(side), beside + 6);
        scene.objects[1].visible = false;
        view.setScene(scene);
        QCOMPARE_LE(std::abs(lightAt(side) - lightAt(0.17)), 4);
    }
};

TACTUM_GUI_TEST(TestOcclusion)

} // namespace test_occlusion

#include "test_occlusion.moc"
