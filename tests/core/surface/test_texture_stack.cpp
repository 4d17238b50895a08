// Layers as an author stacks them: blending, masks, planes of their own, modulation, and sharing.

#include <QTest>

#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_texture_stack {

using namespace tactum;
using namespace tactum::test;

namespace {

/// The same value everywhere.
Image even(double value) {
    return imageOf(1, 1, [&](double, double) { return value; });
}

TextureLayer evenLayer(double value, TextureTarget target, double strength,
                       TextureBlend blend = TextureBlend::Add) {
    TextureLayer layer = imageLayer(even(value), TextureMapping::Planar, 0.01, strength);
    layer.target = target;
    layer.blend = blend;
    return layer;
}

TextureFeel felt(std::vector<TextureLayer> layers, const Vec3& position = {0.003, 0.004, 0}) {
    TexturePoint point;
    point.position = position;
    return feel(*stackOf(std::move(layers)), point, 0);
}

/// How near a texel of 16 bits comes to a value.
double texel(double value) {
    return 2e-5 * std::max(1.0, std::abs(value));
}

/// A square of 10 mm with the coordinates 0 to 1, or none.
Soup square(bool withUvs) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}, {0, 0.01, 0}};
    soup->triangles = {{0, 1, 2}, {0, 2, 3}};
    soup->surfaceOf = {0, 0};
    if (withUvs) soup->cornerUvs = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    return soup;
}

} // namespace

class TextureStackTest : public QObject {
    Q_OBJECT

private slots:
    void heightsBlend();
    void factorsBlend();
    void opacityAndMaskScaleTheLayer();
    void ownPlanesStayApart();
    void aGrooveOfTwoLayersHasTwoFlanks();
    void modulationStaysInsideTheRanges();
    void whatCannotBeFeltIsLeftOut();
    void layersBeyondTheBoundAreLeftOut();
    void unchangedLayersShareTheirStack();
    void levelsKeepTheMean();
    void scaleOfUvsIsThatOfTheSurface();
};

void TextureStackTest::heightsBlend() {
    const auto of = [](TextureBlend blend) {
        return felt({evenLayer(0.5, TextureTarget::Height, 1e-3),
                     evenLayer(0.25, TextureTarget::Height, 8e-4, blend)})
                   .height /
               1e-3;
    };
    COMPARE_NEAR(of(TextureBlend::Add), 0.7, texel(0.7), "");
    COMPARE_NEAR(of(TextureBlend::Subtract), 0.3, texel(0.3), "");
    COMPARE_NEAR(of(TextureBlend::Multiply), 0.125, texel(0.125), "");
    COMPARE_NEAR(of(TextureBlend::Maximum), 0.5, texel(0.5), "");
    COMPARE_NEAR(of(TextureBlend::Minimum), 0.2, texel(0.2), "");
    COMPARE_NEAR(of(TextureBlend::Replace), 0.2, texel(0.2), "");
}

void TextureStackTest::factorsBlend() {
    const auto of = [](TextureBlend blend) {
        return felt({evenLayer(1, TextureTarget::Viscosity, 1),
                     evenLayer(0.5, TextureTarget::Viscosity, 0.8, blend)})
            .viscosity;
    };
    COMPARE_NEAR(of(TextureBlend::Add), 2.4, texel(2.4), "");
    COMPARE_NEAR(of(TextureBlend::Subtract), 1.6, texel(1.6), "");
    COMPARE_NEAR(of(TextureBlend::Multiply), 2.8, texel(2.8), "");
    COMPARE_NEAR(of(TextureBlend::Maximum), 2, texel(2), "");
    COMPARE_NEAR(of(TextureBlend::Minimum), 1.4, texel(1.4), "");
    COMPARE_NEAR(of(TextureBlend::Replace), 1.4, texel(1.4), "");
    // Each target has a sum of its own.
    const TextureFeel one = felt({evenLayer(1, TextureTarget::Stiffness, -0.5)});
    COMPARE_NEAR(one.stiffness, 0.5, texel(0.5), "N/m");
    QCOMPARE_EQ(one.viscosity, 1);
    QCOMPARE_EQ(one.staticFriction, 1);
    QCOMPARE_EQ(one.height, 0);
}

void TextureStackTest::opacityAndMaskScaleTheLayer() {
    TextureLayer layer = evenLayer(1, TextureTarget::Height, 1e-3);
    layer.opacity = 0.5;
    layer.mask = evenLayer(0.5, TextureTarget::Height, 1).pattern;
    COMPARE_NEAR(felt({layer}).height / 1e-3, 0.25, texel(0.25), "");
    // Under a replacing layer that counts for a quarter, three quarters of the lower one stay.
    layer.blend = TextureBlend::Replace;
    COMPARE_NEAR(felt({evenLayer(1, TextureTarget::Height, 2e-3), layer}).height / 1e-3, 1.75, texel(1.75),
                 "");
}

void TextureStackTest::ownPlanesStayApart() {
    std::vector<TextureLayer> layers;
    for (int i = 0; i < kMaxOwnPlanes + 1; ++i) {
        layers.push_back(imageLayer(ramp(), TextureMapping::Planar, 0.01, 1e-4 * (i + 1)));
        layers.back().ownPlane = true;
    }
    const TextureFeel all = felt(layers);
    QCOMPARE(all.ownPlanes, kMaxOwnPlanes);
    for (int i = 0; i < kMaxOwnPlanes; ++i)
        COMPARE_NEAR(all.ownSlopes[std::size_t(i)].x(), 0.01 * (i + 1), texel(0.01 * (i + 1)), "");
    COMPARE_NEAR(all.slope.x(), 0.01 * (kMaxOwnPlanes + 1), texel(0.01 * (kMaxOwnPlanes + 1)),
                 ""); // one too many: it joins the blend
    // A plane for a layer that is no height is none.
    TextureLayer friction = evenLayer(1, TextureTarget::DynamicFriction, 1);
    friction.ownPlane = true;
    QCOMPARE(felt({friction}).ownPlanes, 0);
    COMPARE_NEAR(felt({friction}).dynamicFriction, 2, texel(2), "");
}

// A V along x = 5 mm: one layer falls to the right, the other rises. In the valley both flanks are there.
void TextureStackTest::aGrooveOfTwoLayersHasTwoFlanks() {
    TextureLayer down = imageLayer(ramp(), TextureMapping::Planar, 0.01, -1e-3), up = down;
    up.strength = 1e-3;
    down.ownPlane = up.ownPlane = true;
    const TextureFeel valley = felt({down, up}, {0.005, 0.002, 0});
    QCOMPARE(valley.ownPlanes, 2);
    QCOMPARE_EQ(valley.slope, Vec3(0, 0, 0));
    const Vec3 left = bumpedNormal(Vec3::UnitZ(), valley.ownSlopes[0]),
               right = bumpedNormal(Vec3::UnitZ(), valley.ownSlopes[1]);
    COMPARE_NEAR(left.x() / left.z(), 0.1, 5e-4, "");
    COMPARE_NEAR(right.x() / right.z(), -0.1, 5e-4, "");
}

void TextureStackTest::modulationStaysInsideTheRanges() {
    Material material;
    material.stiffness = 2000;
    material.staticFriction = 0.6;
    material.dynamicFriction = 0.5;
    material.viscosity = 10;
    QCOMPARE(modulated(material, {}), material);
    const TextureFeel strong =
        felt({evenLayer(1, TextureTarget::Stiffness, 9), evenLayer(1, TextureTarget::StaticFriction, 9),
              evenLayer(1, TextureTarget::Viscosity, 9)});
    const Material most = modulated(material, strong);
    QCOMPARE(most.stiffness, kStiffness.maximum);
    QCOMPARE(most.staticFriction, kStaticFriction.maximum);
    QCOMPARE(most.dynamicFriction, 0.5);
    QCOMPARE(most.viscosity, kViscosity.maximum);
    const Material least = modulated(material, felt({evenLayer(1, TextureTarget::Stiffness, -1),
                                                     evenLayer(1, TextureTarget::StaticFriction, -0.5)}));
    QCOMPARE(least.stiffness, kStiffness.minimum);
    COMPARE_NEAR(least.staticFriction, 0.3, texel(0.3), "");
    QCOMPARE_EQ(least.dynamicFriction, least.staticFriction);
}

void TextureStackTest::whatCannotBeFeltIsLeftOut() {
    const TextureLayer good = heightLayer(TextureSource::Noise, TextureMapping::Planar, 0.01, 1e-3);
    TextureLayer off = good, noImage = good, needsUv = good, badMask = good;
    off.enabled = false;
    noImage.pattern.source = TextureSource::Image;
    needsUv.pattern.mapping = TextureMapping::Uv;
    badMask.mask = noImage.pattern;
    for (const TextureLayer& layer : {off, noImage, needsUv, badMask}) {
        QVERIFY(!compileTextures({layer}, square(false), 0));
        QCOMPARE(compileTextures({layer, good}, square(false), 0)->layers.size(), std::size_t(1));
    }
    QVERIFY(compileTextures({needsUv}, square(true), 0));
    QVERIFY(!compileTextures({needsUv}, square(true), 1)); // another surface
    QVERIFY(!compileTextures({}, square(true), 0));
}

void TextureStackTest::layersBeyondTheBoundAreLeftOut() {
    const std::vector<TextureLayer> many(100, evenLayer(1, TextureTarget::Height, 1e-4));
    QCOMPARE(stackOf(many)->layers.size(), std::size_t(kMaxTextureLayers));
    COMPARE_NEAR(felt(many).height / 1e-4, kMaxTextureLayers, texel(kMaxTextureLayers), "");
}

void TextureStackTest::unchangedLayersShareTheirStack() {
    const Soup soup = square(true);
    TextureLayer layer = imageLayer(ramp(), TextureMapping::Uv, 0.005, 1e-3);
    const std::vector<Stack> first{nullptr, compileTextures({layer}, soup, 0)};
    QCOMPARE_EQ(compileTextures({layer}, soup, 0, first), first[1]);
    QCOMPARE_NE(compileTextures({layer}, square(true), 0, first), first[1]);
    layer.strength = 2e-3;
    const Stack second = compileTextures({layer}, soup, 0, first);
    QCOMPARE_NE(second, first[1]);
    QCOMPARE_EQ(second->layers[0].pattern.image, first[1]->layers[0].pattern.image);
    QCOMPARE(second->metresPerUv, first[1]->metresPerUv);
}

// 5 x 3 texels: 3 x 2, 2 x 1, 1 x 1; every level has the mean of the image, but for what the kernel cuts at 0
// and 1.
void TextureStackTest::levelsKeepTheMean() {
    Rng rng(4);
    for (const auto& [width, height] : {std::pair{5, 3}, {8, 8}, {1, 7}, {100, 37}, {1, 1}}) {
        const Image image = imageOf(width, height, [&](double, double) { return uniform(rng, 0, 1); });
        const auto mean = [&](int level) {
            double sum = 0;
            const TextureImage::Level& l = image->level(level);
            for (int y = 0; y < l.height; ++y)
                for (int x = 0; x < l.width; ++x)
                    sum += image->texel(l, x, y);
            return sum / (l.width * l.height);
        };
        const TextureImage::Level& last = image->level(image->levelCount() - 1);
        QCOMPARE_EQ(last.width, 1);
        QCOMPARE_EQ(last.height, 1);
        for (int i = 1; i < image->levelCount(); ++i) {
            QCOMPARE(image->level(i).width, (image->level(i - 1).width + 1) / 2);
            COMPARE_NEAR(mean(i), mean(0), 5e-4, "");
        }
    }
    const Image grey = imageOf(13, 7, [](double, double) { return 0.3; });
    for (int i = 1; i < grey->levelCount(); ++i)
        COMPARE_NEAR(grey->texel(grey->level(i), 0, 0), 0.3, 1e-5, "");
}

void TextureStackTest::scaleOfUvsIsThatOfTheSurface() {
    COMPARE_NEAR(metresPerUvOf(*square(true), 0) / 0.01, 1, texel(1), "");
    QCOMPARE(metresPerUvOf(*square(true), 1), 0.0);
    QCOMPARE(metresPerUvOf(*square(false), 0), 0.0);
    auto same = std::make_shared<TriangleSoup>(*square(true));
    for (auto& uv : same->cornerUvs)
        uv = {0.5f, 0.5f};
    QCOMPARE(metresPerUvOf(*same, 0), 0.0);
}

TACTUM_TEST(TextureStackTest)

} // namespace test_texture_stack

#include "test_texture_stack.moc"
