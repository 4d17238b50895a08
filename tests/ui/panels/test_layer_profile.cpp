// What layers are along a stroke, on a flat plate whose grooves are a cosine that anybody can write down.
// Wrong itself if the pattern's own frame did not lie in the body's origin: every phase would be off.
#include <atomic>
#include <numbers>

#include <QTest>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/movers.h"
#include "tests/support/test_program.h"
#include "tests/ui/cosine_layer.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/layer_profile.h"

namespace test_layer_profile {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

constexpr double kPeriod = 8e-3, kHeight = 2e-4; // m

TextureLayer cosineAlongX(TextureTarget target = TextureTarget::Height, double strength = kHeight) {
    TextureLayer layer = cosineLayer(target, strength, kPeriod);
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.frame.rotation = Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()); // onto y
    return layer;
}

double cosineAt(double x) {
    return tactum::test::cosineAt(x, kPeriod);
}

std::shared_ptr<const World> worldOf(const Scene& scene) {
    auto world = compile(scene);
    if (!world) qFatal("%s", world.error().text.c_str());
    return *world;
}

/// Straight, at one height above the lid, whose plane is y = 0.
std::vector<StrokePoint> along(double from, double to, double y, int steps = 10) {
    std::vector<StrokePoint> stroke;
    for (int i = 0; i <= steps; ++i)
        stroke.push_back({Vec3(from + (to - from) * i / steps, y, 0.01), 0});
    return stroke;
}

} // namespace

class TestLayerProfile : public QObject {
    Q_OBJECT
private slots:
    void heightsFollowTheCosine() {
        const Scene scene = knownScene();
        const auto world = worldOf(scene);
        const LayerProfile profile = profileAlong(along(-0.02, 0.03, -scene.proxyRadius), *world, kLid,
                                                  {cosineAlongX()}, TextureTarget::Height);
        QVERIFY(profile.any());
        QCOMPARE(profile.target, TextureTarget::Height);
        QCOMPARE(profile.values.size(), 1200u);
        COMPARE_NEAR(profile.length, 0.05, 1e-12, "m");
        QCOMPARE(profile.wayOf(0), 0.0);
        COMPARE_NEAR(profile.wayOf(1199), 0.05, 1e-12, "m");
        for (std::size_t i = 0; i < profile.values.size(); ++i)
            COMPARE_NEAR(profile.values[i], kHeight * cosineAt(-0.02 + profile.wayOf(i)), 1e-9, "m");
    }

    /// Of a modulation it is the factor; what asks for another target changes nothing of this one.
    void otherTargetsAreFactors_data() {
        QTest::addColumn<int>("target");
        for (const TextureTarget target : {TextureTarget::StaticFriction, TextureTarget::DynamicFriction,
                                           TextureTarget::Viscosity, TextureTarget::Stiffness})
            QTest::addRow("%s", kTextureTargets[std::size_t(target)].key.data()) << int(target);
    }
    void otherTargetsAreFactors() {
        QFETCH(int, target);
        const auto asked = TextureTarget(target);
        const Scene scene = knownScene();
        const LayerProfile profile = profileAlong(along(-0.02, 0.03, -scene.proxyRadius), *worldOf(scene),
                                                  kLid, {cosineAlongX(asked, 0.5), cosineAlongX()}, asked);
        for (std::size_t i = 0; i < profile.values.size(); ++i)
            COMPARE_NEAR(profile.values[i], 1 + 0.5 * cosineAt(-0.02 + profile.wayOf(i)), 1e-6, "");
        for (const TextureTarget other : {TextureTarget::StaticFriction, TextureTarget::DynamicFriction,
                                          TextureTarget::Viscosity, TextureTarget::Stiffness}) {
            if (other == asked) continue;
            for (const double value : profileAlong(along(-0.02, 0.03, -scene.proxyRadius), *worldOf(scene),
                                                   kLid, {cosineAlongX(asked, 0.5)}, other)
                                          .values)
                QCOMPARE(value, 1.0);
        }
    }

    /// Places are as far apart on a way with corners and rests as on a straight one.
    void theWayIsAsLongAsTheProxyWent() {
        const Scene scene = knownScene();
        std::vector<StrokePoint> stroke = along(0, 0.01, -scene.proxyRadius, 3);
        stroke.push_back(stroke.back()); // a rest
        const std::vector<StrokePoint> back = along(0.01, -0.02, -scene.proxyRadius, 7);
        stroke.insert(stroke.end(), back.begin(), back.end());
        const LayerProfile profile =
            profileAlong(stroke, *worldOf(scene), kLid, {cosineAlongX()}, TextureTarget::Height);
        COMPARE_NEAR(profile.length, 0.04, 1e-12, "m");
        for (std::size_t i = 0; i < profile.values.size(); ++i) {
            const double way = profile.wayOf(i), x = way < 0.01 ? way : 0.02 - way;
            COMPARE_NEAR(profile.values[i], kHeight * cosineAt(x), 1e-9, "m");
        }
    }

    /// What is more than 1.2 radii from the surface was not on it, whatever else it was on.
    void onlyThisSurfaceCounts() {
        Scene scene = knownScene();
        scene.proxyRadius = 1e-3;
        const auto world = worldOf(scene);
        const auto anyAt = [&](double y, SurfaceRef surface) {
            return profileAlong(along(-0.02, 0.02, y), *world, surface, {cosineAlongX()},
                                TextureTarget::Height)
                .any();
        };
        QVERIFY(anyAt(-1.19e-3, kLid));
        QVERIFY(!anyAt(-1.21e-3, kLid));
        QVERIFY(anyAt(1e-3, kLid)); // from its back, too
        QVERIFY(!anyAt(1e-3, kFloor));
        QVERIFY(anyAt(11e-3, kFloor));
        QVERIFY(!anyAt(11e-3, kLid));
        // Over the edge there is nothing, on the plate there is.
        const LayerProfile half =
            profileAlong(along(0.03, 0.07, -1e-3, 40), *world, kLid, {cosineAlongX()}, TextureTarget::Height);
        for (std::size_t i = 0; i < half.values.size(); ++i) {
            const double x = 0.03 + half.wayOf(i);
            if (x < 0.05) COMPARE_NEAR(half.values[i], kHeight * cosineAt(x), 1e-9, "m");
            if (x > 0.051) QVERIFY2(std::isnan(half.values[i]), qPrintable(QString::number(x)));
        }
    }

    void noLayersAreFlat() {
        const Scene scene = knownScene();
        for (const auto& [target, value] :
             {std::pair(TextureTarget::Height, 0.0), {TextureTarget::Viscosity, 1.0}}) {
            const LayerProfile profile =
                profileAlong(along(-0.02, 0.02, -scene.proxyRadius), *worldOf(scene), kLid, {}, target);
            QVERIFY(profile.any());
            for (const double each : profile.values)
                QCOMPARE(each, value);
        }
    }

    /// A body that moves by its keys is stroked where it was at the time of each point.
    void aMovingBodyIsStrokedWhereItWas() {
        Scene scene = knownScene();
        scene.objects[1].motion = sliding(Vec3(0.05, 0, 0));
        const auto world = worldOf(scene);
        std::vector<StrokePoint> stroke;
        for (int i = 0; i <= 20; ++i) { // it stands still in the world while the plate goes by
            const double t = 0.02 * i;
            stroke.push_back({Vec3(0.21, -scene.proxyRadius, 0), t});
        }
        const LayerProfile profile =
            profileAlong(stroke, *world, kTop, {cosineAlongX()}, TextureTarget::Height);
        COMPARE_NEAR(profile.length, 0.05 * 0.4, 1e-9, "m");
        for (std::size_t i = 0; i < profile.values.size(); ++i)
            COMPARE_NEAR(profile.values[i], kHeight * cosineAt(0.01 - profile.wayOf(i)), 1e-9, "m");
    }

    void thereIsNoneOfWhatIsNotThere() {
        const Scene scene = knownScene();
        const auto world = worldOf(scene);
        const std::vector<StrokePoint> stroke = along(-0.02, 0.02, -scene.proxyRadius);
        const auto valuesOf = [&](const std::vector<StrokePoint>& points, SurfaceRef surface,
                                  const Progress& progress = {}) {
            return profileAlong(points, *world, surface, {cosineAlongX()}, TextureTarget::Height, progress)
                .values.size();
        };
        QCOMPARE(valuesOf(stroke, kLid), 1200u);
        QCOMPARE(valuesOf(stroke, {1, 2}), 0u); // the box has two surfaces
        QCOMPARE(valuesOf(stroke, {7, 0}), 0u); // nor is there a seventh object
        QCOMPARE(valuesOf({stroke.front()}, kLid), 0u);
        QCOMPARE(valuesOf({stroke.front(), stroke.back()}, kLid), 1200u);
        const std::atomic<bool> cancelled = true;
        QCOMPARE(valuesOf(stroke, kLid, {{}, &cancelled}), 0u);
    }
};

TACTUM_TEST(TestLayerProfile)

} // namespace test_layer_profile

#include "test_layer_profile.moc"
