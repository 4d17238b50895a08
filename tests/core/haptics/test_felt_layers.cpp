// Layers joined by each blend and under a mask, and layers that change friction, viscosity and stiffness:
// what of them is in the forces of a stroke.
//
// The judges are the formulas of texture_layer.h, written anew, and for heights a proxy that goes by a
// micrometre at a time (SlowSlide). They would be wrong where the program's layers were: nothing of
// core/surface is asked but the numbers of a material.

#include <QTest>

#include "tests/core/haptics/wave_stroke.h"
#include "tests/support/compare.h"
#include "tests/support/slow_slide.h"
#include "tests/support/test_program.h"

namespace test_felt_layers {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr Wave kLow{20e-3, 0.8e-3}, kHigh{13e-3, 0.5e-3}, kMask{31e-3, 1};
constexpr double kOpacity = 0.8;
const StrokeSettings kStroke{.speed = 0.05, .from = -0.08, .to = 0.02, .told = -0.06};

double joined(TextureBlend blend, double low, double high, double value, double weight) {
    switch (blend) {
    case TextureBlend::Add:
        return low + weight * high;
    case TextureBlend::Subtract:
        return low - weight * high;
    case TextureBlend::Multiply:
        return low * (1 - weight + weight * value);
    case TextureBlend::Maximum:
        return (1 - weight) * low + weight * std::max(low, high);
    case TextureBlend::Minimum:
        return (1 - weight) * low + weight * std::min(low, high);
    case TextureBlend::Replace:
        return (1 - weight) * low + weight * high;
    }
    return 0;
}

TexturePattern patternOf(const Wave& wave) {
    return pictureOf(wave, 1024).pattern;
}

/// A layer that scales `target` by 1 + strength x the wave.
TextureLayer scaling(TextureTarget target, double strength) {
    TextureLayer layer = pictureOf(kLow, 1024);
    layer.target = target;
    layer.strength = strength;
    return layer;
}

double valueAt(double x) {
    return kLow.heightAt(x) / kLow.height;
}

} // namespace

class FeltLayersTest : public QObject {
    Q_OBJECT

private slots:
    void joinedHeightsAreFelt_data();
    void joinedHeightsAreFelt();
    void aLayerScalesFriction_data();
    void aLayerScalesFriction();
    void whatALayerTakesAwayStaysAway_data();
    void whatALayerTakesAwayStaysAway();
    void aLayerScalesViscosity();
    void aLayerScalesStiffness();
};

void FeltLayersTest::joinedHeightsAreFelt_data() {
    QTest::addColumn<TextureBlend>("blend");
    QTest::addColumn<bool>("masked");
    QTest::addColumn<double>("friction");
    for (std::size_t blend = 0; blend < kTextureBlends.size(); ++blend)
        for (const bool masked : {false, true})
            for (const double friction : {0.0, 0.3})
                QTest::addRow("%s%s, mu %g", kTextureBlends[blend].label.data(), masked ? ", masked" : "",
                              friction)
                    << TextureBlend(blend) << masked << friction;
}

void FeltLayersTest::joinedHeightsAreFelt() {
    QFETCH(TextureBlend, blend);
    QFETCH(bool, masked);
    QFETCH(double, friction);
    TextureLayer low = pictureOf(kLow, 1024), high = pictureOf(kHigh, 1024);
    high.blend = blend;
    high.opacity = kOpacity;
    if (masked) high.mask = patternOf(kMask);
    const auto heightAt = [&](double x) {
        return joined(blend, kLow.heightAt(x), kHigh.heightAt(x), kHigh.heightAt(x) / kHigh.height,
                      kOpacity * (masked ? kMask.heightAt(x) : 1));
    };
    constexpr double kStep = 1e-7;
    // Where two waves cross, the proxy waits in the crease: whether it has stuck there is not asked here.
    const Material material = rough(friction, friction);
    SlowSlide slow(
        [&](const auto& at) {
            return Vector2d((heightAt(at.x() + kStep) - heightAt(at.x() - kStep)) / (2 * kStep), 0);
        },
        [&](const auto&) { return material; });
    std::vector<double> felt, right;
    for (double x = kStroke.from; x < kStroke.told; x += kStroke.speed * kMillisecond)
        slow.to({x, 0}, kStroke.depth);
    strokeAlong(flatCourse(sheet(0.5)), {low, high}, material, kStroke, [&](const StrokeTick& tick) {
        felt.push_back(tick.along);
        right.push_back(material.stiffness * slow.to({tick.finger, 0}, kStroke.depth).x());
    });
    double off = 0;
    for (std::size_t i = 1; i + 1 < felt.size(); ++i) {
        const auto [least, most] = std::minmax({right[i - 1], right[i], right[i + 1]});
        off = std::max(off, std::abs(felt[i] - std::clamp(felt[i], least, most)));
    }
    const auto [lowest, highest] = std::ranges::minmax(right);
    qInfo("%.4f N off where it goes from %.3f to %.3f N", off, lowest, highest);
    QCOMPARE_LT(off, 0.02 * (highest - lowest));
}

void FeltLayersTest::aLayerScalesFriction_data() {
    QTest::addColumn<TextureTarget>("target");
    QTest::addColumn<double>("speed");
    for (const TextureTarget target : {TextureTarget::DynamicFriction, TextureTarget::StaticFriction})
        for (const double speed : {0.01, 0.05, 0.15})
            QTest::addRow("%s, %g m/s", kTextureTargets[std::size_t(target)].label.data(), speed)
                << target << speed;
}

// Static friction is not felt by what slides, but holds dynamic friction below it.
void FeltLayersTest::aLayerScalesFriction() {
    QFETCH(TextureTarget, target);
    QFETCH(double, speed);
    const bool isStatic = target == TextureTarget::StaticFriction;
    const Material material = isStatic ? rough(0.5, 0.5) : rough(0.9, 0.3);
    const double strength = isStatic ? -0.5 : 1;
    StrokeSettings how = kStroke;
    how.speed = speed;
    double worst = 0;
    strokeAlong(flatCourse(sheet(0.5)), {scaling(target, strength)}, material, how,
                [&](const StrokeTick& tick) {
                    const double right = material.dynamicFriction * (1 + strength * valueAt(tick.x));
                    worst = std::max(worst, std::abs(tick.ratio() / right - 1));
                });
    qInfo("%.3f %% off at most", 100 * worst);
    QCOMPARE_LT(worst, 0.01);
}

void FeltLayersTest::whatALayerTakesAwayStaysAway_data() {
    QTest::addColumn<bool>("shaded");
    QTest::addColumn<double>("speed");
    for (const bool shaded : {false, true})
        for (const double speed : {0.05, 0.15})
            QTest::addRow("%s, %g m/s", shaded ? "shaded" : "plain", speed) << shaded << speed;
}

// Around the inside of a pipe a slide comes to faces that it does not touch yet: they rub as the layer says.
void FeltLayersTest::whatALayerTakesAwayStaysAway() {
    QFETCH(bool, shaded);
    QFETCH(double, speed);
    constexpr double kBody = 0.03, kFriction = 0.8, kFactor = 0.5;
    // The same at every vertex: nothing changes along the way.
    Course course = roundCourse(pipe(kBody, 0.05, 600), kBody, -1);
    const auto upright = std::make_shared<TriangleSoup>(*course.soup); // a pipe along y
    for (Vec3& p : upright->positions)
        p = Vec3(p.z(), p.x(), p.y());
    course.soup = upright;
    course.shading.on = shaded;
    course.shading.normals = NormalSource::Computed;
    std::vector<TextureLayer> layers;
    for (const auto target : {TextureTarget::StaticFriction, TextureTarget::DynamicFriction}) {
        TextureLayer layer = scaling(target, kFactor - 1);
        layer.pattern.source = TextureSource::Painted;
        layer.pattern.painted = {
            std::make_shared<const PaintedValues>(std::vector<float>(course.soup->positions.size(), 1.0F))};
        layers.push_back(std::move(layer));
    }
    double worst = 0;
    int stops = 0;
    strokeAlong(course, layers, rough(kFriction, kFriction),
                {.radius = 2e-3, .speed = speed, .from = -0.02, .to = 0.02, .told = -0.005},
                [&](const StrokeTick& tick) {
                    worst = std::max(worst, std::abs(tick.ratio() / (kFactor * kFriction) - 1));
                    stops += tick.way < 0.01 * speed * kMillisecond;
                });
    qInfo("%.2f %% off at most, %d stops", 100 * worst, stops);
    QCOMPARE(stops, 0);
    QCOMPARE_LT(worst, 0.05);
}

// The force of friction, and that of viscosity at the proxy's speed.
void FeltLayersTest::aLayerScalesViscosity() {
    Material material = rough(0.3, 0.3);
    material.viscosity = 2;
    StrokeSettings how = kStroke;
    how.speed = 0.15;
    double worst = 0;
    strokeAlong(flatCourse(sheet(0.5)), {scaling(TextureTarget::Viscosity, 1)}, material, how,
                [&](const StrokeTick& tick) {
                    const double viscosity = material.viscosity * (1 + valueAt(tick.x));
                    const double right =
                        material.dynamicFriction * tick.push + viscosity * tick.way / kMillisecond;
                    worst = std::max(worst, std::abs(-tick.along / right - 1));
                });
    qInfo("%.3f %% off at most", 100 * worst);
    QCOMPARE_LT(worst, 0.01);
}

void FeltLayersTest::aLayerScalesStiffness() {
    const Material material = rough(0.4, 0.3);
    double worst = 0;
    strokeAlong(flatCourse(sheet(0.5)), {scaling(TextureTarget::Stiffness, -0.6)}, material, kStroke,
                [&](const StrokeTick& tick) {
                    const double right = material.stiffness * (1 - 0.6 * valueAt(tick.x)) * kStroke.depth;
                    worst = std::max(worst, std::abs(tick.push / right - 1));
                });
    qInfo("%.3f %% off at most", 100 * worst);
    QCOMPARE_LT(worst, 0.01);
}

TACTUM_TEST(FeltLayersTest)

} // namespace test_felt_layers

#include "test_felt_layers.moc"
