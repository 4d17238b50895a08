// The shadow of finger and stylus: where the light's way is barred, by rays in closed form and in the
// picture. If this test itself were wrong: a sheet that lay anywhere would pass `aBallOverAPlane` only if its
// plane, which the test alone knows, were another.
#include <cmath>

#include <QElapsedTimer>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/scene_view.h"
#include "ui/view/studio_light.h"
#include "ui/view/surface_format.h"
#include "ui/view/touch_shadow.h"

namespace test_touch_shadow {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr double kPixel = 2e-4; ///< m
const Vec3 kToLight = Vec3(-0.3, 0.8, 0.5).normalized();

/// Planes across Y: at 0 where x is below `edge`, and `lower` m deeper beyond it; none there when negative.
Drop planes(double edge = HUGE_VAL, double lower = -1) {
    return [=](const Ray& ray, double reach) -> std::optional<double> {
        const double upper = -ray.origin.y() / ray.direction.y();
        std::optional<double> met;
        if (ray.at(upper).x() < edge)
            met = upper;
        else if (lower >= 0)
            met = (-lower - ray.origin.y()) / ray.direction.y();
        return met && *met <= reach ? met : std::nullopt;
    };
}

/// Mean of the points, each as much as it is dark.
Vec3 middleOf(const ShadowSheet& sheet) {
    Vec3 sum = Vec3::Zero();
    double all = 0;
    for (std::size_t i = 0; i < sheet.points.size(); ++i) {
        sum += sheet.dark[i] * sheet.points[i];
        all += sheet.dark[i];
    }
    return sum / all;
}

double darkestOf(const ShadowSheet& sheet) {
    return *std::ranges::max_element(sheet.dark);
}

/// Of the sheet's point that is nearest to a place.
double darkAt(const ShadowSheet& sheet, const Vec3& place) {
    const auto nearest =
        std::ranges::min_element(sheet.points, {}, [&](const Vec3& p) { return (p - place).norm(); });
    return sheet.dark[std::size_t(nearest - sheet.points.begin())];
}

constexpr double kOver = 0.01; ///< m, from the plate to the finger

/// A grey plate across Z that fills the view, and a finger over it.
struct Plate {
    Plate() {
        auto soup = std::make_shared<TriangleSoup>();
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            soup->positions.push_back(0.05 * Vec3(x, y, 0));
        soup->triangles = {{0, 1, 2}, {0, 2, 3}};
        soup->surfaceOf = {0, 0};
        SceneObject plate;
        plate.geometry = soup;
        plate.surfaces.resize(1);
        plate.surfaces[0].colour = {0.6F, 0.6F, 0.6F};
        Scene scene;
        scene.add(plate);
        view.resize(800, 600);
        view.setScene(scene);
        options.normals = options.planes = options.ground = false;
        view.setFelt(options);
        view.showStandardView(StandardView::Front);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        if (!test::waitFor([&] { return !view.makesMeshes(); })) qFatal("the meshes are never made");
        proxy.updates = servo.ticks = 1;
    }
    QImage picture(const Vec3& finger) {
        servo.finger = proxy.finger = proxy.output.proxy = finger;
        view.setHaptics(proxy, servo, 8, true);
        return view.grabPicture();
    }
    /// Where the light's shadow of a point falls on the plate.
    Vec3 foot(const Vec3& p) const {
        const Vec3 light = towardKeyLight(view.camera());
        return p - p.z() / light.z() * light;
    }
    int lightAt(const QImage& picture, const Vec3& p) const {
        const QPointF at = *view.camera().project(p) * picture.devicePixelRatio();
        return qGray(picture.pixel(at.toPoint()));
    }

    SceneView view;
    FeltOptions options;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
};

} // namespace

class TestTouchShadow : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void aBallOverAPlane_data() {
        QTest::addColumn<double>("height");
        for (const double height : {0.0, 0.002, 0.012, 0.03})
            QTest::addRow("%g mm", 1e3 * height) << height;
    }
    void aBallOverAPlane() {
        QFETCH(double, height);
        const TouchCaster caster{.middle = {0.01, height, 0.02}, .radius = 0.0012};
        const ShadowSheet sheet = shadowSheet(caster, kToLight, kPixel, planes());
        const double way = height / kToLight.y();
        const Vec3 foot = caster.middle - way * kToLight;
        // Where the plane is nearer to the light it is a little darker.
        COMPARE_NEAR((middleOf(sheet) - foot).norm(), 0, 0.3 * kPixel, "m");
        const double far = way / (60 * kPixel); // where half is left
        COMPARE_NEAR(darkestOf(sheet), ShadowSheet::kDarkest / (1 + far * far), 1e-9, "");
        QCOMPARE_GT(sheet.cells.size(), std::size_t(10));
    }

    void aRodIsAsLongAsTheLightSeesIt() {
        const Vec3 middle(0, 0.001, 0), end(0.012, 0.011, 0.004);
        const TouchCaster caster{.middle = middle, .radius = 8e-4, .end = end, .rodRadius = 8e-4};
        const ShadowSheet sheet = shadowSheet(caster, kToLight, kPixel, planes());
        const auto foot = [](const Vec3& p) { return Vec3(p - p.y() / kToLight.y() * kToLight); };
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec3 on = middle + part * (end - middle);
            const double far = on.y() / kToLight.y() / (60 * kPixel);
            COMPARE_NEAR(darkAt(sheet, foot(on)), ShadowSheet::kDarkest / (1 + far * far), 0.12, "");
        }
        const Vec3 aside = kToLight.cross(end - middle).normalized();
        COMPARE_NEAR(darkAt(sheet, foot(middle + 0.5 * (end - middle) + 1.6e-3 * aside)), 0, 0.02, "");
        COMPARE_NEAR(darkAt(sheet, foot(middle + 1.2 * (end - middle))), 0, 0.02, "");
    }

    void nothingBridgesAStep() {
        const TouchCaster caster{.middle = {0, 0.001, 0}, .radius = 0.0012};
        const double edge = (caster.middle - 0.001 / kToLight.y() * kToLight).x();
        for (const double lower : {0.02, -1.0}) {
            const ShadowSheet sheet = shadowSheet(caster, kToLight, kPixel, planes(edge, lower));
            QCOMPARE_GT(sheet.cells.size(), std::size_t(4));
            for (const auto& cell : sheet.cells) {
                const auto isUp = [&](int i) { return std::abs(sheet.points[std::size_t(i)].y()) < 1e-9; };
                QCOMPARE(std::ranges::all_of(cell, isUp), std::ranges::any_of(cell, isUp));
            }
            // And it ends softly: at the last points before the step there is nothing of it.
            double last = -HUGE_VAL, dark = 1;
            for (const auto& cell : sheet.cells)
                for (const int i : cell)
                    if (const Vec3& p = sheet.points[std::size_t(i)]; std::abs(p.y()) < 1e-9 && p.x() > last)
                        last = p.x(), dark = sheet.dark[std::size_t(i)];
            COMPARE_NEAR(dark, 0.0, 1e-12, "");
        }
    }

    void nothingIsUnderIt() {
        const TouchCaster caster{.middle = {0, 0.01, 0}, .radius = 0.0012};
        const Drop clear = [](const Ray&, double) -> std::optional<double> { return {}; };
        QCOMPARE(shadowSheet(caster, kToLight, kPixel, clear).cells.size(), std::size_t(0));
        const TouchCaster high{.middle = {0, 1, 0}, .radius = 0.0012}; // farther than it is looked for
        QCOMPARE(shadowSheet(high, kToLight, kPixel, planes()).cells.size(), std::size_t(0));
    }

    void itIsSeenOnTheModel() {
        Plate shown;
        const Vec3 here(-0.01, 0.01, kOver), there(0.02, -0.01, kOver);
        const QImage first = shown.picture(here), second = shown.picture(there);
        for (const auto& [with, without, finger] :
             {std::tuple(first, second, here), {second, first, there}}) {
            const Vec3 foot = shown.foot(finger);
            const int dark = shown.lightAt(with, foot), bright = shown.lightAt(without, foot);
            COMPARE_NEAR(dark / double(bright), 0.6, 0.25, "");
        }
    }

    void aStylusCastsItsOwn() {
        Plate shown;
        const Vec3 finger(-0.01, 0.005, 0.002);
        const ViewCamera& camera = shown.view.camera();
        // A third of the pen's way, which leads up, to the right and to the eye.
        const Vec3 along = (0.5 * camera.right() + 0.8 * camera.up() - 0.45 * camera.forward()).normalized();
        const Vec3 foot = shown.foot(finger + 43 * camera.pixelSize(finger) * along);
        const int bright = shown.lightAt(shown.picture(finger), foot);
        shown.options.stylus = true;
        shown.view.setFelt(shown.options);
        const int dark = shown.lightAt(shown.picture(finger), foot);
        COMPARE_NEAR(dark / double(bright), 0.7, 0.25, "");
        if (const QString to = qEnvironmentVariable("TACTUM_PICTURE"); !to.isEmpty())
            shown.picture(finger).save(to);
    }

    void whatIsOutOfSightHasNone() {
        Plate shown;
        const Vec3 finger(-0.01, 0.01, kOver);
        const int dark = shown.lightAt(shown.picture(finger), shown.foot(finger));
        shown.view.setOverlayVisible(false);
        QCOMPARE_GT(shown.lightAt(shown.picture(finger), shown.foot(finger)), dark + 10);
    }

    /// Of one picture, beside all else that a touch costs.
    void figures() {
        const int triangles = qEnvironmentVariableIntValue("TACTUM_TRIANGLES");
        if (triangles < 8) QSKIP("TACTUM_TRIANGLES says of how many");
        const auto rings = Index(std::sqrt(triangles / 4.0));
        ScenePicker picker;
        picker.setScene(ballScene(2 * rings, rings));
        (void)picker.cast({{0, 0, 1}, -Vec3::UnitZ()}, ScenePicker::Patience::Wait);
        const Drop drop = [&](const Ray& ray, double reach) -> std::optional<double> {
            const auto hit = picker.cast(ray, ScenePicker::Patience::Now, reach);
            return hit ? std::optional(hit->distance) : std::nullopt;
        };
        for (const bool rod : {false, true}) {
            TouchCaster caster{.middle = {0, 0, kBallRadius + 0.001}, .radius = 0.0012};
            caster.end = caster.middle + 130 * kPixel * Vec3(0.5, 0.8, 0.45).normalized();
            if (rod) caster.rodRadius = 4.5 * kPixel;
            QElapsedTimer clock;
            clock.start();
            constexpr int kRuns = 200;
            for (int run = 0; run < kRuns; ++run)
                (void)shadowSheet(caster, Vec3(-0.44, 0.66, 0.61).normalized(), kPixel, drop);
            qInfo("%s: %.2f ms a picture", rod ? "stylus" : "ball  ",
                  1e-6 * double(clock.nsecsElapsed()) / kRuns);
        }
    }
};

TACTUM_GUI_TEST(TestTouchShadow)

} // namespace test_touch_shadow

#include "test_touch_shadow.moc"
