// What the view shows of how things feel: pixels of the meaning's colour at the place that means it.
#include <QApplication>
#include <QTest>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/base/theme.h"
#include "ui/view/colour_map.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_felt_view {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr QSize kSize(640, 480);
/// Before the ball, a little to the left.
const Vec3 kProxy(-0.02, 0, 0.056);

struct Shown {
    explicit Shown(const Scene& shownScene = ballScene()) : scene(shownScene), world(compile(scene).value()) {
        view.resize(kSize);
        view.setScene(scene);
        view.setWorld(world);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        view.showStandardView(StandardView::Front);
        options.normals = options.planes = false;
        show();
    }

    void show() {
        view.setFelt(options);
        if (!test::waitFor([&] { return !view.makesFelt(); })) qFatal("it is never made");
    }

    ViewCamera camera() const {
        ViewCamera camera;
        camera.fieldOfView = EIGEN_PI / 6;
        camera.size = kSize;
        camera.fit(spanningPoints(scene));
        return camera;
    }
    QPointF pixelOf(const Vec3& p) const { return *camera().project(p); }

    /// A contact with a wall on the left, that is pushed with 4 of 8 N.
    static HapticOutput touchOf(bool slips) {
        HapticOutput touch;
        touch.proxy = kProxy;
        touch.force = {4, 0, 0};
        touch.contacts = 1;
        touch.contact[0] = {.point = kProxy, .normal = Vec3::UnitX(), .normalForce = 4, .slipping = slips};
        touch.contact[0].staticFriction = 0.5;
        touch.contact[0].dynamicFriction = 0.25;
        return touch;
    }
    void touch(bool slips) {
        ProxyTelemetry proxy;
        proxy.updates = 1;
        proxy.output = touchOf(slips);
        ServoTelemetry servo;
        servo.ticks = 1;
        servo.finger = kProxy - Vec3(0.005, 0, 0);
        servo.force = proxy.output.force;
        view.setHaptics(proxy, servo, 8, true);
    }

    QImage picture() { return view.grabPicture(); }

    Scene scene;
    std::shared_ptr<const World> world;
    SceneView view;
    FeltOptions options;
};

/// Ridges of 1 mm, 30 mm apart; and texture coordinates, the same everywhere.
Scene groovedBall() {
    Scene scene = ballScene();
    TextureLayer layer;
    layer.pattern.source = TextureSource::Grooves;
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.size = 0.03;
    layer.strength = 1e-3;
    for (Surface& surface : scene.objects[0].surfaces)
        surface.layers = {layer};
    auto soup = std::make_shared<TriangleSoup>(*scene.objects[0].geometry);
    soup->cornerUvs.assign(3 * soup->triangles.size(), {0.5F, 0.5F});
    scene.objects[0].geometry = soup;
    return scene;
}

/// How many pixels around a place have about the hue of a colour.
int hued(const QImage& picture, QPointF at, const QColor& colour, double reach = 3) {
    const double ratio = picture.devicePixelRatio();
    int count = 0;
    for (double dx = -reach; dx <= reach; dx += 1 / ratio)
        for (double dy = -reach; dy <= reach; dy += 1 / ratio) {
            const QPoint p = ((at + QPointF(dx, dy)) * ratio).toPoint();
            if (!picture.rect().contains(p)) continue;
            const QColor seen = picture.pixelColor(p);
            const int apart = std::abs(seen.hsvHue() - colour.hsvHue());
            count += seen.hsvSaturation() > 70 && std::min(apart, 360 - apart) < 18;
        }
    return count;
}

/// Pixels that differ, as a share of all.
double changedShare(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return 1;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                         std::abs(p.blue() - q.blue()) >
                     12;
        }
    return double(count) / (double(a.width()) * a.height());
}

TracePoint placeAt(double t, const Vec3& proxy) {
    TracePoint point;
    point.t = t;
    point.proxy = proxy;
    point.touching = true;
    return point;
}

} // namespace

class TestFeltView : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    // 4 of 8 N are an arrow of 120 pixels: so high is the cone, and half as wide where 0.5 holds.
    void theConeEndsWhereFrictionDoes() {
        Scene dark = ballScene(); // the cone is seen through, and what is behind it has no hue
        for (Surface& surface : dark.objects[0].surfaces)
            surface.colour = {0.02F, 0.02F, 0.02F};
        Shown shown(dark);
        shown.touch(false);
        const QPointF apex = shown.pixelOf(kProxy);
        const QPointF atStatic = apex + QPointF(120, -60), atDynamic = apex + QPointF(120, -30);
        QCOMPARE(hued(shown.picture(), atStatic, kDarkTheme.stick), 0);
        shown.options.cone = true;
        shown.show();
        const QImage sticks = shown.picture();
        QCOMPARE_GT(hued(sticks, atStatic, kDarkTheme.stick), 3);
        QCOMPARE_GT(hued(sticks, apex + QPointF(120, 60), kDarkTheme.stick), 3);
        QCOMPARE(hued(sticks, apex + QPointF(120, -70), kDarkTheme.stick), 0);
        shown.touch(true);
        const QImage slips = shown.picture();
        QCOMPARE_GT(hued(slips, atDynamic, kDarkTheme.slip), 3);
        QCOMPARE(hued(slips, atStatic, kDarkTheme.slip), 0);
        shown.options.cone = false;
        shown.show();
        QCOMPARE(hued(shown.picture(), atDynamic, kDarkTheme.slip), 0);
    }

    void marksOfContactsAreSwitchedOneByOne() {
        Shown shown;
        shown.touch(false);
        const QPointF tip = shown.pixelOf(kProxy) + QPointF(38, 0);
        const QImage bare = shown.picture();
        shown.options.planes = true;
        shown.show();
        const QImage planes = shown.picture();
        QCOMPARE_GT(changedShare(bare, planes), 1e-4);
        shown.options.planes = false;
        shown.options.normals = true;
        shown.show();
        // Beside the arrow of the force, which lies along it.
        QCOMPARE_GT(hued(shown.picture(), tip, kDarkTheme.contact, 6),
                    hued(bare, tip, kDarkTheme.contact, 6));
        shown.options.normals = false;
        shown.show();
        QCOMPARE(changedShare(bare, shown.picture()), 0.0);
    }

    void theTrailIsVioletWhereItSlippedWithABeadWhereItStuck() {
        Shown shown;
        shown.options.trail = true;
        shown.show();
        std::vector<TracePoint> slide, rest;
        for (int i = 0; i <= 200; ++i)
            slide.push_back(placeAt(1e-3 * i, kProxy + Vec3(2e-4 * i, 0, 0)));
        for (int i = 1; i <= 300; ++i)
            rest.push_back(placeAt(0.2 + 1e-3 * i, kProxy + Vec3(0.04, 0, 0)));
        shown.view.addTrail(slide, Shown::touchOf(true));
        shown.view.addTrail(rest, Shown::touchOf(false));
        const QImage picture = shown.picture();
        QCOMPARE_GT(hued(picture, shown.pixelOf(kProxy + Vec3(0.03, 0, 0)), kDarkTheme.slip), 5);
        QCOMPARE_GT(hued(picture, shown.pixelOf(kProxy + Vec3(0.04, 0, 0)), kDarkTheme.stick, 4), 20);
        QCOMPARE(hued(picture, shown.pixelOf(kProxy + Vec3(0.03, 0, 0)), kDarkTheme.stick), 0);
        shown.options.trail = false;
        shown.show();
        QCOMPARE(hued(shown.picture(), shown.pixelOf(kProxy + Vec3(0.03, 0, 0)), kDarkTheme.slip), 0);
    }

    void theTrailFades() {
        Shown shown;
        shown.options.trail = true;
        shown.show();
        std::vector<TracePoint> slide;
        for (int i = 0; i <= 200; ++i)
            slide.push_back(placeAt(1e-3 * i, kProxy + Vec3(2e-4 * i, 0, 0)));
        shown.view.addTrail(slide, Shown::touchOf(true));
        const QPointF middle = shown.pixelOf(kProxy + Vec3(0.02, 0, 0));
        QCOMPARE_GT(hued(shown.picture(), middle, kDarkTheme.slip), 5);
        std::vector<TracePoint> later;
        for (int i = 1; i <= 5000; ++i)
            later.push_back(placeAt(0.2 + 1e-3 * i, kProxy + Vec3(0.04, 0, 0)));
        shown.view.addTrail(later, Shown::touchOf(false));
        QCOMPARE(hued(shown.picture(), middle, kDarkTheme.slip), 0);
    }

    void spheresHideNothingAndGoAgain() {
        Shown shown;
        const QImage bare = shown.picture();
        shown.options.spheres = true;
        shown.options.sphereLevel = 0;
        shown.show();
        const QImage coarse = shown.picture();
        QCOMPARE_GT(changedShare(bare, coarse), 0.05);
        // Around the ball as well: the coarse spheres reach beyond it.
        QCOMPARE_GT(hued(coarse, shown.pixelOf({0, kBallRadius, 0}) - QPointF(0, 10), kDarkTheme.accent, 8),
                    0);
        shown.options.sphereLevel = 2;
        shown.show();
        QCOMPARE_GT(changedShare(coarse, shown.picture()), 0.05);
        shown.options.spheres = false;
        shown.show();
        QCOMPARE(changedShare(bare, shown.picture()), 0.0);
    }

    void noLevelIsDeeperThanTheTree() {
        Shown shown;
        shown.options.spheres = true;
        shown.show();
        shown.options.sphereLevel = kDeepestLevel;
        shown.show();
        QCOMPARE_LT(shown.view.felt().sphereLevel, 6);
    }

    void feltNormalsStandOnTheModel() {
        Shown shown;
        const QPointF above = shown.pixelOf({0, kBallRadius, 0}) - QPointF(0, 5);
        QCOMPARE(hued(shown.picture(), above, kDarkTheme.contact, 4), 0);
        shown.options.feltNormals = true;
        shown.show();
        QCOMPARE_GT(hued(shown.picture(), above, kDarkTheme.contact, 4), 0);
        shown.options.feltNormals = false;
        shown.show();
        QCOMPARE(hued(shown.picture(), above, kDarkTheme.contact, 4), 0);
    }

    void aMapColoursEachSurfaceByItsValue() {
        Scene scene = ballScene();
        scene.objects[0].surfaces[kLower].material.stiffness = 200;
        scene.objects[0].surfaces[kUpper].material.stiffness = 1000;
        Shown shown(scene);
        const QImage bare = shown.picture();
        shown.options.map = FeltValue::Stiffness;
        shown.show();
        const QImage map = shown.picture();
        const QPointF upper(320, 170), lower(320, 310);
        QCOMPARE_GT(hued(map, upper, QColor(253, 231, 37)), 40); // the upper end of the scale
        QCOMPARE_GT(hued(map, lower, QColor(68, 1, 84)), 40);    // and its lower one
        // The scale itself, in the lower left corner.
        const QRectF edge(12, 240, 40, 230);
        int yellow = 0;
        for (double y = edge.top(); y < edge.bottom(); y += 4)
            for (double x = edge.left(); x < edge.right(); x += 4)
                yellow += hued(map, {x, y}, QColor(253, 231, 37), 0) > 0;
        QCOMPARE_GT(yellow, 0);
        // An edit of a value is seen at once.
        shown.scene.objects[0].surfaces[kLower].material.stiffness = 1800;
        shown.view.setScene(shown.scene);
        shown.view.setWorld(compile(shown.scene, shown.world.get()).value());
        const QImage edited = shown.picture();
        QCOMPARE_GT(hued(edited, lower, QColor(253, 231, 37)), 40);
        QCOMPARE_GT(hued(edited, upper, QColor(68, 1, 84)), 40);
        shown.options.map.reset();
        shown.show();
        QCOMPARE(changedShare(bare, shown.picture()), 0.0);
    }

    // Without being asked for, from where the program looks first.
    void heightLayersAreSeenInLightAndShade() {
        Shown smooth, grooved(groovedBall());
        const QImage plain = smooth.picture();
        QCOMPARE_GT(changedShare(grooved.picture(), plain), 0.05);
        grooved.options.relief = false;
        grooved.show();
        QCOMPARE(changedShare(grooved.picture(), plain), 0.0);
    }

    /// A highlight on what slips, none on what holds on; both are drawn alike, alone or in a crowd.
    void whatIsSlipperyShines() {
        for (const Index rings : {32, 8}) {
            const auto brightest = [&](double friction) {
                Scene scene = ballScene(2 * rings, rings);
                for (Surface& surface : scene.objects[0].surfaces)
                    surface.material.staticFriction = friction;
                Shown shown(scene);
                const QImage picture = shown.picture();
                const QPoint centre = picture.rect().center();
                int most = 0;
                for (int y = -centre.y() / 2; y < centre.y() / 2; ++y)
                    for (int x = -centre.y() / 2; x < centre.y() / 2; ++x)
                        most = std::max(most, picture.pixelColor(centre + QPoint(x, y)).lightness());
                return most;
            };
            QCOMPARE_GT(brightest(0.05), brightest(1) + 15);
        }
    }

    // As a brush paints: nothing but the World changes, and the picture is that of what is felt now.
    void aHeightThatIsPaintedIsSeenAtOnce() {
        Scene scene = ballScene();
        TextureLayer painted;
        painted.pattern.source = TextureSource::Painted;
        painted.strength = 5e-3;
        for (Surface& surface : scene.objects[0].surfaces)
            surface.layers = {painted};
        const auto paint = [&](double ridge) {
            std::vector<float> values;
            for (const Vec3& p : scene.objects[0].geometry->positions)
                values.push_back(std::abs(p.x()) < ridge ? 1 : 0);
            for (Surface& surface : scene.objects[0].surfaces)
                surface.layers[0].pattern.painted.values = std::make_shared<const PaintedValues>(values);
        };
        paint(0);
        Shown shown(scene);
        const QImage flat = shown.picture();
        paint(0.01);
        shown.view.setWorld(compile(scene).value());
        const QImage painting = shown.picture();
        QCOMPARE_GT(changedShare(painting, flat), 0.01);
        Shown fresh(scene);
        QCOMPARE(changedShare(painting, fresh.picture()), 0.0);
    }

    void bumpsAreDrawnAsManyTimesAsHigh() {
        Shown shown(groovedBall());
        const QImage bare = shown.picture();
        shown.options.bumps = 1;
        shown.show();
        const double once = changedShare(bare, shown.picture());
        shown.options.bumps = 10;
        shown.show();
        const QImage tenfold = shown.picture();
        QCOMPARE_GT(once, 1e-3);
        QCOMPARE_GT(changedShare(bare, tenfold), 1.2 * once);
        // A ridge runs over the middle: the ball is 10 mm higher there.
        const QPointF ridge = shown.pixelOf({0, kBallRadius + 8e-3, 0});
        const auto at = [&](const QImage& p) {
            return p.pixelColor((ridge * p.devicePixelRatio()).toPoint());
        };
        QCOMPARE_GT(std::abs(at(tenfold).lightness() - at(bare).lightness()), 25);
        shown.options.bumps = 0;
        shown.show();
        QCOMPARE(changedShare(bare, shown.picture()), 0.0);
    }

    // What is painted is seen where bumps are drawn over the surface that it lies on: on a ridge, and between
    // two.
    void paintLiesOnTheBumps_data() {
        QTest::addColumn<bool>("picture");
        QTest::addRow("values at the corners") << false;
        QTest::addRow("a picture") << true;
    }
    void paintLiesOnTheBumps() {
        QFETCH(bool, picture);
        Shown shown(groovedBall());
        const SceneObject& ball = shown.scene.objects[0];
        PaintedPart part;
        part.surface = kUpper;
        if (picture)
            part.image = std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{65535});
        else
            part.values = std::make_shared<const PaintedValues>(
                std::vector<float>(ball.geometry->positions.size(), 1.0F));
        const QColor painted = mapColour(1);
        const auto seen = [&](double y) {
            return hued(shown.picture(), shown.pixelOf({0, y, std::sqrt(2.5e-3 - y * y)}), painted, 2);
        };
        const std::array<double, 3> heights{0.012, 0.02, 0.03};
        for (const double bumps : {0.0, 10.0}) {
            shown.options.bumps = bumps;
            shown.show();
            for (const double y : heights)
                QCOMPARE(seen(y), 0);
            shown.view.setPainted({ball.id, ball.geometry, {part}});
            for (const double y : heights)
                QCOMPARE_GT(seen(y), 20);
            QCOMPARE(seen(-0.02), 0); // the lower half has no paint
            shown.view.setPainted({});
        }
    }

    void switchingOnAndOffLeavesNothingBehind() {
        Shown shown;
        shown.touch(false);
        const auto round = [&] {
            FeltOptions all;
            all.cone = all.trail = all.spheres = all.feltNormals = true;
            all.map = FeltValue::Height;
            all.bumps = 10;
            shown.options = all;
            shown.show();
            (void)shown.picture();
            shown.options = {};
            shown.show();
            (void)shown.picture();
            return shown.view.actorCount();
        };
        const int once = round();
        for (int i = 0; i < 5; ++i)
            QCOMPARE(round(), once);
        shown.options.spheres = shown.options.feltNormals = true;
        shown.show();
        const int with = shown.view.actorCount();
        for (int i = 0; i < 3; ++i) {
            shown.world = compile(ballScene(48, Index(24 + i))).value();
            shown.view.setWorld(shown.world);
            shown.show();
            QCOMPARE(shown.view.actorCount(), with);
        }
    }
};

TACTUM_GUI_TEST(TestFeltView)

} // namespace test_felt_view

#include "test_felt_view.moc"
