// Painted values: linear on triangles and segments, left out where they do not fit, and images painted in
// part.
#include <QTest>

#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_painted_values {

using namespace tactum;
using namespace tactum::test;

namespace {

SharedPaint painted(std::vector<float> values) {
    return {std::make_shared<const PaintedValues>(std::move(values))};
}

TextureLayer paintedLayer(SharedPaint paint, double height) {
    TextureLayer layer = heightLayer(TextureSource::Painted, TextureMapping::Triplanar, 0.01, height);
    layer.pattern.painted = std::move(paint);
    return layer;
}

TexturePoint pointOn(const TriangleSoup& soup, Index triangle, const Vec3& weights, const Vec3& normal) {
    const Triangle t = triangleOf(soup, triangle);
    TexturePoint point;
    point.position = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
    point.normal = normal;
    point.triangle = triangle;
    point.weights = weights;
    return point;
}

Vec3 randomWeights(Rng& rng) {
    Vec3 weights(uniform(rng, 0, 1), uniform(rng, 0, 1), uniform(rng, 0, 1));
    return weights / weights.sum();
}

} // namespace

class TestPaintedValues : public QObject {
    Q_OBJECT

private slots:
    /// Values of a function that is linear in space are that function, and its gradient along the triangle.
    void linearOnATriangle() {
        Rng rng(3);
        for (int round = 0; round < 500; ++round) {
            const Vec3 gradient = uniform(rng, 0.1, 2) * direction(rng);
            auto soup = std::make_shared<TriangleSoup>();
            std::vector<float> values;
            for (int i = 0; i < 5; ++i) {
                soup->positions.push_back(inBox(rng, 0.1));
                values.push_back(float(0.5 + gradient.dot(soup->positions.back())));
            }
            soup->triangles = {{0, 1, 2}, {4, 3, 1}};
            soup->surfaceOf = {0, 0};
            const auto stack = stackOf({paintedLayer(painted(values), 0.01)}, soup);
            for (Index triangle = 0; triangle < 2; ++triangle) {
                const Triangle t = triangleOf(*soup, triangle);
                const Vec3 across = (t.b - t.a).cross(t.c - t.a);
                if (across.norm() < 1e-3) continue; // single precision of the values over a sliver
                const Vec3 normal = across.normalized();
                const TexturePoint point = pointOn(*soup, triangle, randomWeights(rng), normal);
                const TextureFeel touch = feel(*stack, point, 1e-3);
                COMPARE_NEAR(touch.height, 0.01 * (0.5 + gradient.dot(point.position)), 1e-8, "m");
                const Vec3 expected = 0.01 * (gradient - gradient.dot(normal) * normal);
                QVERIFY2((touch.slope - expected).norm() < 1e-6,
                         qPrintable(QString::number((touch.slope - expected).norm())));
            }
        }
    }

    void segmentsAndPoints() {
        auto soup = std::make_shared<TriangleSoup>();
        soup->positions = {{0, 0, 0}, {0.02, 0, 0}, {0, 0.01, 0}};
        soup->triangles = {{0, 1, 1}, {2, 2, 2}};
        soup->surfaceOf = {0, 0};
        const auto stack = stackOf({paintedLayer(painted({0.25F, 0.75F, 1}), 0.01)}, soup);
        const TextureFeel along = feel(*stack, pointOn(*soup, 0, {0.5, 0.2, 0.3}, Vec3::UnitZ()), 0);
        COMPARE_NEAR(along.height, 0.005, 1e-9, "m");
        COMPARE_NEAR(along.slope, Vec3(0.01 * 0.5 / 0.02, 0, 0), 1e-9, "");
        const TextureFeel there = feel(*stack, pointOn(*soup, 1, {0, 0, 1}, Vec3::UnitZ()), 0);
        COMPARE_NEAR(there.height, 0.01, 1e-9, "m");
        QCOMPARE_EQ(there.slope.norm(), 0);
    }

    /// The product rule of a mask holds, whatever the two are made of.
    void aMaskIsPaintedToo() {
        Rng rng(4);
        const Soup soup = std::make_shared<const TriangleSoup>(uvSquare(0.1));
        TextureLayer layer = heightLayer(TextureSource::Noise, TextureMapping::Planar, 0.02, 2e-4);
        const auto bare = stackOf({layer}, soup);
        layer.mask = paintedLayer(painted({0, 1, 0.5F, 0.25F}), 0).pattern;
        const auto masked = stackOf({layer}, soup);
        const TextureLayer alone = paintedLayer(layer.mask->painted, 1e-3);
        const auto mask = stackOf({alone}, soup);
        for (int i = 0; i < 100; ++i) {
            const TexturePoint point = pointOn(*soup, Index(rng() % 2), randomWeights(rng), Vec3::UnitZ());
            const TextureFeel h = feel(*bare, point, 0), m = feel(*mask, point, 0),
                              both = feel(*masked, point, 0);
            const double part = m.height / 1e-3;
            COMPARE_NEAR(both.height, part * h.height, 1e-12, "m");
            COMPARE_NEAR(both.slope, part * h.slope + h.height / 1e-3 * m.slope, 1e-9, "");
        }
    }

    void whatDoesNotFitIsLeftOut() {
        const Soup soup = std::make_shared<const TriangleSoup>(uvSquare(0.1));
        QVERIFY(stackOf({paintedLayer(painted({0, 1, 0, 1}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer(painted({0, 1, 0}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer(painted({0, 1, 0, 1, 0}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer({}, 1e-4)}, soup));
        TextureLayer masked = heightLayer(TextureSource::Noise, TextureMapping::Planar, 0.02, 2e-4);
        masked.mask = paintedLayer(painted({1}), 0).pattern;
        QVERIFY(!stackOf({masked}, soup));
        // It asks for no coordinates, whatever its mapping says.
        auto bare = std::make_shared<TriangleSoup>(*soup);
        bare->cornerUvs.clear();
        TextureLayer layer = paintedLayer(painted({0, 1, 0, 1}), 1e-4);
        layer.pattern.mapping = TextureMapping::Uv;
        QVERIFY(stackOf({layer}, bare));
    }

    void equalWhereTheValuesAre() {
        const TextureLayer one = paintedLayer(painted({0.5F, 0.25F}), 1e-4);
        TextureLayer other = paintedLayer(painted({0.5F, 0.25F}), 1e-4);
        QVERIFY(one == other);
        other.pattern.painted = painted({0.5F, 0.5F});
        QVERIFY(!(one == other));
        other.pattern.painted = {};
        QVERIFY(!(one == other));
        const PaintedValues safe({-1, 2, std::numeric_limits<float>::quiet_NaN(), 0.5F});
        QCOMPARE_EQ(safe.all(), std::vector<float>({0, 1, 0, 0.5F}));
    }

    /// Every level, to the bit, for sizes that are no powers of two.
    void anImagePaintedInPartIsThatBuiltWhole() {
        Rng rng(5);
        for (int round = 0; round < 200; ++round) {
            const int width = 1 + int(rng() % 70), height = 1 + int(rng() % 70);
            const auto before = imageOf(width, height, [&](double, double) { return uniform(rng, 0, 1); });
            std::vector<std::uint16_t> texels(before->row(0), before->row(0) + width * height);
            std::vector<TextureImage::Region> regions;
            for (int i = int(rng() % 4); i > 0; --i) {
                TextureImage::Region region{int(rng() % unsigned(width)), int(rng() % unsigned(height)), 0,
                                            0};
                region.width = int(rng() % unsigned(width - region.x + 1));
                region.height = int(rng() % unsigned(height - region.y + 1));
                regions.push_back(region);
                for (int y = region.y; y < region.y + region.height; ++y)
                    for (int x = region.x; x < region.x + region.width; ++x)
                        texels[std::size_t(y * width + x)] = std::uint16_t(rng());
            }
            const auto after = before->withRegions(regions, texels);
            const TextureImage whole(width, height, texels, "formula");
            QCOMPARE(after->levelCount(), whole.levelCount());
            QCOMPARE(after->name(), before->name());
            for (int i = 0; i < whole.levelCount(); ++i)
                for (int y = 0; y < whole.level(i).height; ++y)
                    for (int x = 0; x < whole.level(i).width; ++x)
                        QCOMPARE_EQ(after->texel(after->level(i), x, y), whole.texel(whole.level(i), x, y));
        }
    }
};

TACTUM_TEST(TestPaintedValues)

} // namespace test_painted_values

#include "test_painted_values.moc"
