// Haptic texture (section 4.3) through whole haptic steps: slopes, valleys and maps of friction in newtons.

#include <QTest>

#include "core/haptics/replay.h"
#include "tests/core/surface/spectrum.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

Q_DECLARE_METATYPE(tactum::TextureMapping)

namespace test_texture_step {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 1e-3;
constexpr double kDepth = 1e-3;
constexpr double kRepeat = 0.02; // m

std::shared_ptr<const World> texturedWorld(Soup soup, std::vector<TextureLayer> layers,
                                           const Material& material = frictionless()) {
    Scene scene = sceneOf(std::move(soup), material, kRadius);
    scene.objects[0].surfaces[0].layers = std::move(layers);
    return compile(scene).value();
}

// The plane z = 0 in 20 x 20 quads, with coordinates uv = linear (x, y).
Soup laidOut(const Eigen::Matrix2d& linear) {
    auto soup = std::make_shared<TriangleSoup>(*sheet(0.05, 20));
    for (const auto& triangle : soup->triangles)
        for (Index corner : triangle)
            soup->cornerUvs.push_back((linear * soup->positions[corner].head<2>()).cast<float>());
    return soup;
}

Hand pressedAt(const std::shared_ptr<const World>& world, double x, double y, double dt = kMillisecond) {
    Hand hand(world, dt);
    hand.to({x, y, 3e-3});
    hand.go({x, y, kRadius - kDepth}, 0.05);
    for (int i = 0; i < 5; ++i)
        hand.to(hand.finger());
    return hand;
}

// Tangential over normal force: minus the slope, as it pushes downhill.
Vec3 ratio(const Hand& hand) {
    const Vec3 force = hand.output().force;
    return {force.x() / force.z(), force.y() / force.z(), 0};
}

QString text(const Vec3& v) {
    return QString("(%1 %2 %3)").arg(v.x()).arg(v.y()).arg(v.z());
}

// From the finger to the side, in steps of a micrometre.
double wentWith(Hand& hand, double side) {
    const double before = hand.output().proxy.x();
    hand.go(hand.finger() + Vec3(side, 0, 0), 1e-3);
    for (int i = 0; i < 20; ++i)
        hand.to(hand.finger());
    return hand.output().proxy.x() - before;
}

// value(x, y) from 0 to 1 at the positions of the sheet.
template <class Value> SharedPaint paintedOn(const Soup& soup, Value&& value) {
    std::vector<float> values;
    for (const Vec3& p : soup->positions)
        values.push_back(float(value(p.x(), p.y())));
    return {std::make_shared<const PaintedValues>(std::move(values))};
}

TextureLayer paintedLayer(SharedPaint paint, TextureTarget target, double strength) {
    TextureLayer layer;
    layer.pattern.source = TextureSource::Painted;
    layer.pattern.painted = std::move(paint);
    layer.target = target;
    layer.strength = strength;
    return layer;
}

// How far the proxy is above a ball and below its surface, m, at random strokes along it.
std::pair<double, double> gapsOverABall(const TextureLayer& layer, unsigned seed) {
    const Soup soup = ball(0.03, 3);
    Hand hand(texturedWorld(soup, {layer}, layer.ownPlane ? rough(0.2, 0.1, 0.5) : frictionless()));
    hand.to({0, 0, 0.04});
    hand.go({0, 0.003, 0.029}, 0.05);
    Rng rng(seed);
    double highest = 0, deepest = 0;
    for (int i = 0; i < 12; ++i)
        hand.go(0.0285 * (hand.finger().normalized() + 0.5 * direction(rng)).normalized(),
                uniform(rng, 0.02, 0.3), [&](const Hand& h) {
                    const double gap = clearance(*soup, h.output().proxy) - kRadius;
                    highest = std::max(highest, gap);
                    deepest = std::max(deepest, -gap);
                });
    return {highest, deepest};
}

} // namespace

class TextureStepTest : public QObject {
    Q_OBJECT

private slots:
    void forceFollowsTheSlope_data();
    void forceFollowsTheSlope();
    void uvsMayLieAnyWay_data();
    void uvsMayLieAnyWay();
    void valleyOfTwoPlanesHolds();
    void valleyOfTwoFlanksHolds();
    void frictionFollowsItsMap();
    void stiffnessFollowsItsMap();
    void paintedFrictionRampsOverThePlane();
    void paintedHeightTiltsTheForce();
    void paintedMaskFadesABump();
    void nothingIsLifted();
    void aSlideIsLookedOnAside();
    void roughGroundTakesFewRounds_data();
    void roughGroundTakesFewRounds();
    void comesToRest();
    void servoFeelsTheSame();
    void aliasOfASlide_data();
    void aliasOfASlide();
};

void TextureStepTest::forceFollowsTheSlope_data() {
    QTest::addColumn<TextureMapping>("mapping");
    QTest::newRow("planar") << TextureMapping::Planar;
    QTest::newRow("triplanar") << TextureMapping::Triplanar;
    QTest::newRow("uv") << TextureMapping::Uv;
    QTest::newRow("uv unit square") << TextureMapping::UvUnit;
}

void TextureStepTest::forceFollowsTheSlope() {
    QFETCH(TextureMapping, mapping);
    const Soup soup = laidOut(Eigen::Matrix2d::Identity() / kRepeat);
    for (double s : {0.01, 0.05, 0.1, 0.3})
        for (double turn : {0.0, 0.5 * kPi, 2.5}) {
            TextureLayer layer = imageLayer(ramp(), mapping, kRepeat, s * kRepeat);
            layer.pattern.rotation = turn;
            layer.pattern.offsetU = -0.4 * kRepeat; // the ramp's end is far
            Hand hand = pressedAt(texturedWorld(soup, {layer}), 0.0013, 0.0007);
            const Vec3 expected = -s * Vec3(std::cos(turn), std::sin(turn), 0);
            // The image of the source proportions: 256 x 4 texels make the repeat low, never the slope
            // steeper.
            QVERIFY2((ratio(hand) - expected).norm() < 0.02 * s,
                     qPrintable(QString("%1: %2 instead of %3, at %4")
                                    .arg(s)
                                    .arg(text(ratio(hand)), text(expected), text(hand.output().proxy))));
        }
}

void TextureStepTest::uvsMayLieAnyWay_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("c");
    QTest::addColumn<double>("d");
    QTest::newRow("large") << 5.0 << 0.0 << 0.0 << 5.0;
    QTest::newRow("stretched") << 30.0 << 0.0 << 0.0 << 5.0;
    QTest::newRow("mirrored") << -25.0 << 0.0 << 0.0 << 25.0;
    QTest::newRow("skewed") << 20.0 << 14.0 << 0.0 << 20.0;
}

// Heights are strength x u: the slope is known from the coordinates alone.
void TextureStepTest::uvsMayLieAnyWay() {
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, c);
    QFETCH(double, d);
    Eigen::Matrix2d linear;
    linear << a, b, c, d;
    const double height = 5e-3;
    TextureLayer layer = imageLayer(ramp(), TextureMapping::UvUnit, kRepeat, height);
    layer.pattern.offsetU = 0.4 * kRepeat;
    Hand hand = pressedAt(texturedWorld(laidOut(linear), {layer}), 0.0013, 0.0007);
    const Vec3 expected = -height * Vec3(a, b, 0);
    QVERIFY2((ratio(hand) - expected).norm() < 0.02 * expected.norm(),
             qPrintable(text(ratio(hand)) + " instead of " + text(expected)));
}

// One layer rises to the left and one to the right, everywhere: the two planes make a valley wherever the
// proxy is.
void TextureStepTest::valleyOfTwoPlanesHolds() {
    const double s = 0.3;
    const auto rising = [&](double sign) {
        TextureLayer layer =
            imageLayer(imageOf(256, 4, [&](double x, double) { return sign > 0 ? x : 1 - x; }),
                       TextureMapping::Planar, kRepeat, s * kRepeat);
        layer.ownPlane = true;
        return layer;
    };
    const auto world = texturedWorld(sheet(0.05), {rising(1), rising(-1)});
    for (double sign : {1.0, -1.0}) {
        Hand held = pressedAt(world, 0.009, 0.002);
        const double kept = wentWith(held, sign * 0.98 * s * kDepth);
        QCOMPARE_LT(std::abs(kept), 1e-9);
        Hand loose = pressedAt(world, 0.009, 0.002);
        const double went = wentWith(loose, sign * (s * kDepth + 2e-4));
        COMPARE_NEAR(sign * went, 2e-4, 1e-5, "m");
        QCOMPARE_LT(std::abs(ratio(loose).x() + sign * s), 0.02 * s);
    }
}

// One layer is the left flank, the other the right one: from either side down into the valley between.
void TextureStepTest::valleyOfTwoFlanksHolds() {
    const double s = 0.3, middle = 0.5 * kRepeat, texel = kRepeat / 256;
    const auto flank = [&](double sign) {
        TextureLayer layer =
            imageLayer(imageOf(256, 4, [&](double x, double) { return std::max(0.0, sign * (x - 0.5)); }),
                       TextureMapping::Planar, kRepeat, s * kRepeat);
        layer.ownPlane = true;
        return layer;
    };
    const auto world = texturedWorld(sheet(0.05), {flank(1), flank(-1)});
    for (double side : {-2e-3, -2e-4, 2e-4, 2e-3}) {
        const Hand hand = pressedAt(world, middle + side, 0.002);
        const double fell = std::min(std::abs(side), s * kDepth);
        QVERIFY2(std::abs(hand.output().proxy.x() - (middle + side - std::copysign(fell, side))) < 2 * texel,
                 qPrintable(QString::number(hand.output().proxy.x() - middle)));
    }
    for (double sign : {1.0, -1.0}) {
        Hand held = pressedAt(world, middle, 0.002);
        QCOMPARE_LT(std::abs(wentWith(held, sign * 0.95 * s * kDepth)), 2 * texel);
        Hand loose = pressedAt(world, middle, 0.002);
        const double went = wentWith(loose, sign * (s * kDepth + 1e-3));
        COMPARE_NEAR(sign * went, 1e-3, 2 * texel, "m");
    }
}

void TextureStepTest::frictionFollowsItsMap() {
    const Image halves = imageOf(256, 4, [](double x, double) { return x < 0.5 ? 0 : 1; });
    TextureLayer sticks = imageLayer(halves, TextureMapping::Planar, kRepeat, 1);
    sticks.target = TextureTarget::StaticFriction;
    TextureLayer drags = sticks;
    drags.target = TextureTarget::DynamicFriction;
    drags.strength = 0.5;
    const auto world = texturedWorld(sheet(0.05), {sticks, drags}, rough(0.3, 0.2));
    for (bool high : {false, true}) {
        Hand hand = pressedAt(world, high ? 0.015 : 0.005, 0.002);
        double most = 0;
        hand.go(hand.finger() + Vec3(0.001, 0, 0), 1e-3,
                [&](const Hand& h) { most = std::max(most, ratio(h).norm()); });
        COMPARE_NEAR(most / (high ? 0.6 : 0.3), 1, 0.005, "");
        COMPARE_NEAR(ratio(hand).norm() / (high ? 0.3 : 0.2), 1, 0.005, "");
        // What is shown of it is what counts there.
        const ContactReport& contact = hand.output().contact[0];
        COMPARE_NEAR(contact.staticFriction, high ? 0.6 : 0.3, 0.005, "");
        COMPARE_NEAR(contact.dynamicFriction, high ? 0.3 : 0.2, 0.005, "");
    }
}

void TextureStepTest::stiffnessFollowsItsMap() {
    TextureLayer layer =
        imageLayer(imageOf(4, 4, [](double, double) { return 1; }), TextureMapping::Planar, kRepeat, -0.5);
    layer.target = TextureTarget::Stiffness;
    const Hand hand = pressedAt(texturedWorld(sheet(0.05), {layer}), 0, 0);
    COMPARE_NEAR(hand.output().force.z(), 0.5 * kStiffness.initial * kDepth, 1e-6, "N");
    COMPARE_NEAR(hand.output().contact[0].normalForce, hand.output().force.z(), 1e-9, "N");
}

// The factor rises from 1 to 2 across the sheet: so does what holds at rest.
void TextureStepTest::paintedFrictionRampsOverThePlane() {
    const Soup soup = sheet(0.05, 20);
    const SharedPaint across = paintedOn(soup, [](double x, double) { return (x + 0.05) / 0.1; });
    const auto world = texturedWorld(soup,
                                     {paintedLayer(across, TextureTarget::StaticFriction, 1),
                                      paintedLayer(across, TextureTarget::DynamicFriction, 1)},
                                     rough(0.3, 0.2));
    for (const double x : {-0.041, -0.0123, 0.0, 0.018, 0.0377}) {
        Hand hand = pressedAt(world, x, 0.002);
        double most = 0;
        hand.go(hand.finger() + Vec3(0, 6e-4, 0), 2e-4, // across the ramp: the factor stays
                [&](const Hand& h) { most = std::max(most, ratio(h).norm()); });
        const double factor = 1 + (x + 0.05) / 0.1;
        QVERIFY2(std::abs(most / (0.3 * factor) - 1) < 0.005, qPrintable(QString::number(most / 0.3)));
        const double slides = ratio(hand).norm();
        QVERIFY2(std::abs(slides / (0.2 * factor) - 1) < 0.005, qPrintable(QString::number(slides / 0.2)));
    }
}

// A painted ramp of slope s turns the force by atan(s), downhill, whichever way it lies.
void TextureStepTest::paintedHeightTiltsTheForce() {
    const Soup soup = sheet(0.05, 20);
    for (const double s : {0.01, 0.04, 0.07})
        for (const double turn : {0.0, 1.1, 2.5, -2.0}) {
            const Vec3 uphill(std::cos(turn), std::sin(turn), 0);
            const double rise =
                0.5 / (0.05 * std::sqrt(2.0)); // values per metre: 0 to 1 from corner to corner
            const SharedPaint ramped =
                paintedOn(soup, [&](double x, double y) { return 0.5 + rise * Vec3(x, y, 0).dot(uphill); });
            const Hand hand = pressedAt(
                texturedWorld(soup, {paintedLayer(ramped, TextureTarget::Height, s / rise)}), 0.0013, 0.0007);
            const Vec3 force = hand.output().force;
            const double angle = std::atan2(force.head<2>().norm(), force.z());
            COMPARE_NEAR(angle, std::atan(s), 0.01 * s, "rad");
            QCOMPARE_LT((ratio(hand) + s * uphill).norm(), 0.01 * s);
        }
}

// Under a mask m the slope is m grad h + h grad m: here h rises along x and m along y.
void TextureStepTest::paintedMaskFadesABump() {
    const Soup soup = sheet(0.05, 20);
    TextureLayer layer = paintedLayer(paintedOn(soup, [](double x, double) { return 0.5 + 10 * x; }),
                                      TextureTarget::Height, 5e-3);
    layer.mask =
        paintedLayer(paintedOn(soup, [](double, double y) { return 0.5 + 10 * y; }), TextureTarget::Height, 0)
            .pattern;
    const double x = 0.0113, y = -0.0207;
    const Hand hand = pressedAt(texturedWorld(soup, {layer}), x, y);
    const Vec3 at = hand.output().proxy;
    const Vec3 expected = -5e-3 * 10 * Vec3(0.5 + 10 * at.y(), 0.5 + 10 * at.x(), 0);
    QVERIFY2((ratio(hand) - expected).norm() < 0.01 * expected.norm(), qPrintable(text(ratio(hand))));
}

// Steep, coarse, fine and own planes, slow and fast: the proxy stays on the surface that is there. Three of
// these hands bring a step of frictionless dots to its last round, which ended in the middle of a slide, 1 to
// 4 um above.
void TextureStepTest::nothingIsLifted() {
    for (TextureSource source : {TextureSource::Noise, TextureSource::Dots, TextureSource::Grooves})
        for (double size : {5e-4, 5e-3})
            for (bool own : {false, true}) {
                TextureLayer layer = heightLayer(source, TextureMapping::Triplanar, size, 0.3 * size);
                layer.ownPlane = own;
                for (unsigned seed : {3U, 11U, 12U, 19U}) {
                    const auto [highest, deepest] = gapsOverABall(layer, seed);
                    QCOMPARE_LT(highest, kMicrometre);
                    QCOMPARE_LT(deepest, kMicrometre);
                }
            }
}

// Across grooves a wish leads on as the slope changes, along them as far as it goes. At 45 degrees the
// steepest way is neither: from round to round the proxy went from side to side of its way, each time a
// little less far.
void TextureStepTest::aSlideIsLookedOnAside() {
    const TextureLayer grooves = heightLayer(TextureSource::Grooves, TextureMapping::Planar, 5e-3, 1e-4);
    Hand hand = pressedAt(texturedWorld(sheet(0.05, 1), {grooves}), -0.02, -0.015);
    double rounds = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
        hand.to(hand.finger() + Vec3(1.5e-4, 1.5e-4, 0));
        rounds += hand.output().report.rounds;
    }
    qInfo("%.3f rounds", rounds / kSteps);
    QCOMPARE_LT(rounds / kSteps, 1.5);
}

// Deep below rough ground the proxy lies in one fold after the other, each side of which has its own grain.
// There it went from the one to the other and back, a little less far each time: 496 of 3,000 steps took more
// than twenty rounds, and 21 do now. Means are bound a tenth above what is measured. As many without grain,
// where it is three, would show that it is the ground's doing.
void TextureStepTest::roughGroundTakesFewRounds_data() {
    QTest::addColumn<bool>("rubs");
    QTest::addColumn<bool>("grain");
    QTest::addColumn<bool>("shaded");
    QTest::addColumn<double>("mean");
    QTest::addColumn<int>("many");
    QTest::newRow("smooth") << false << false << false << 4.2 << 6;
    QTest::newRow("friction") << true << false << false << 2.3 << 22;
    QTest::newRow("texture") << false << true << false << 3.4 << 14;
    QTest::newRow("shading") << false << false << true << 4.0 << 34;
    QTest::newRow("texture and friction") << true << true << false << 2.1 << 8;
    QTest::newRow("shading and friction") << true << false << true << 2.2 << 6;
    QTest::newRow("texture, shading and friction") << true << true << true << 2.2 << 6;
}

void TextureStepTest::roughGroundTakesFewRounds() {
    QFETCH(bool, rubs);
    QFETCH(bool, grain);
    QFETCH(bool, shaded);
    QFETCH(double, mean);
    QFETCH(int, many);
    Rng rng(5);
    Scene scene = sceneOf(heightField(0.03, 110,
                                      [&](double x, double y) {
                                          return 1e-3 * std::sin(400 * x) * std::sin(300 * y) +
                                                 uniform(rng, -3e-5, 3e-5);
                                      }),
                          rubs ? rough(0.4, 0.3) : frictionless(), kRadius);
    Surface& surface = scene.objects[0].surfaces[0];
    surface.shading.on = shaded;
    if (grain) surface.layers = {heightLayer(TextureSource::Noise, TextureMapping::Triplanar, 5e-3, 5e-5)};
    FingerPath path;
    for (int i = 0; i < 3000; ++i) {
        const double s = i * 0.15e-3, down = std::min(i * 0.15e-3, 0.01);
        path.push_back({i * 1e-3, {0.02 * std::sin(s / 0.02), 0.02 * std::sin(s / 0.031), 6e-3 - down}});
    }
    double sum = 0;
    int over = 0;
    for (const TouchRow& row : replay(*compile(scene).value(), path)) {
        sum += row.rounds;
        over += row.rounds > 20;
    }
    qInfo("%.2f rounds in the mean, more than 20 in %d steps", sum / double(path.size()), over);
    QCOMPARE_LT(sum / double(path.size()), mean);
    QCOMPARE_LE(over, many);
}

// A finger that holds still on the steepest of textures ends on the same bits.
void TextureStepTest::comesToRest() {
    Rng rng(31);
    int slow = 0;
    for (int run = 0; run < 200; ++run) {
        const double size = std::pow(10, uniform(rng, -3.5, -2));
        TextureLayer noise = heightLayer(TextureSource::Noise, TextureMapping::Triplanar, size, 0.5 * size);
        TextureLayer dots = heightLayer(TextureSource::Dots, TextureMapping::Triplanar, size, 0.2 * size);
        dots.ownPlane = run % 2 == 0;
        Hand hand(texturedWorld(ball(0.03, 2), {noise, dots}));
        const Vec3 way = direction(rng);
        hand.to(0.035 * way);
        hand.go((0.031 - 0.004 * uniform(rng, 0, 1)) * way + 1e-3 * direction(rng), 0.1);
        for (int i = 0; i < 60; ++i) {
            const Vec3 before = hand.output().proxy;
            hand.to(hand.finger());
            slow += i == 8 && before != hand.output().proxy;
        }
        const Vec3 rest = hand.output().proxy;
        for (int i = 0; i < 20; ++i)
            QCOMPARE(hand.to(hand.finger()).proxy, rest);
    }
    qInfo() << slow << "of 200 needed more than eight steps";
    QCOMPARE_LT(slow, 10);
}

// Between two updates of the proxy the servo renders the felt planes, not the facets.
void TextureStepTest::servoFeelsTheSame() {
    TextureLayer layer = imageLayer(ramp(), TextureMapping::Planar, kRepeat, 0.2 * kRepeat);
    const auto world = texturedWorld(sheet(0.05), {layer});
    Hand hand = pressedAt(world, 0.009, 0.002);
    for (const Vec3& way : {Vec3(0, 0, 0), Vec3(0, 0, -2e-4), Vec3(1e-4, 0, 0), Vec3(-1e-4, 1e-4, 0)}) {
        const Vec3 served = contactModelForce(hand.state.model, hand.finger() + way, Vec3::Zero());
        Hand next = hand;
        for (int i = 0; i < 5; ++i)
            next.to(hand.finger() + way);
        QVERIFY2((served - next.output().force).norm() < 0.05 * served.norm(),
                 qPrintable(text(served) + " and " + text(next.output().force)));
        if (way.isZero()) COMPARE_NEAR(served, hand.output().force, 1e-6, "N");
    }
}

void TextureStepTest::aliasOfASlide_data() {
    QTest::addColumn<double>("rate");
    for (double rate : {1000.0, 2000.0, 4000.0})
        QTest::addRow("%g kHz", rate / 1000) << rate;
}

// White grain 20 um high under a stroke of 0.15 m/s: what sounds near half of the rate, where nothing is
// rendered.
void TextureStepTest::aliasOfASlide() {
    QFETCH(double, rate);
    Rng rng(9);
    const Image grain = imageOf(512, 512, [&](double, double) { return uniform(rng, 0, 1); });
    const auto world = texturedWorld(sheet(0.08), {imageLayer(grain, TextureMapping::Planar, 0.05, 2e-5)});
    Hand hand = pressedAt(world, -0.06, 0.001, 1 / rate);
    hand.go(hand.finger() + Vec3(0.01, 0.001, 0), 0.15);
    std::vector<double> force;
    hand.go(hand.finger() + Vec3(0.1, 0.01, 0), 0.15,
            [&](const Hand& h) { force.push_back(h.output().force.x()); });
    const Spectrum ripple = spectrumOf(force, rate, 0.4 * rate);
    qInfo("force above %g Hz: %.3g mN of %.3g mN", 0.4 * rate, 1e3 * std::sqrt(ripple.above),
          1e3 * std::sqrt(ripple.whole));
    QCOMPARE_GT(ripple.whole, 0);
    QCOMPARE_LT(ripple.above, 0.08 * ripple.whole);
}

TACTUM_TEST(TextureStepTest)

} // namespace test_texture_step

#include "test_texture_step.moc"
