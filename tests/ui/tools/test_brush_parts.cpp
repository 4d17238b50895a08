// A stroke over two surfaces of a mesh at once: each gets its part, and nothing of the other's.
//
// What would show that a test here is wrong: the same stroke over the whole mesh as one surface, by
// core/paint alone.
#include <QTest>

#include "tests/core/paint/paint_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/tools/brush_stroke.h"

namespace test_brush_parts {

using namespace tactum;
using namespace tactum::test;

namespace {

/// 0.2 m wide, in squares of 0.01 m; left of x = 0 the surface 0, right of it the surface 1.
Soup halves() {
    TriangleSoup soup = *sheet(0.1, 20);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        Vec3 middle = Vec3::Zero();
        for (const Index corner : soup.triangles[i])
            middle += soup.positions[corner] / 3;
        soup.surfaceOf[i] = middle.x() > 0;
    }
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

const Brush kBrush{.radius = 0.031, .strength = 1, .falloff = 0, .value = 1, .mode = BrushMode::Add};

BrushStroke::Part painted(Index surface) {
    TexturePattern pattern;
    pattern.source = TextureSource::Painted;
    return {surface, pattern};
}

std::vector<float> valuesOf(const BrushStroke::Part& part, const Soup& soup) {
    return part.pattern.painted.values ? part.pattern.painted.values->all()
                                       : std::vector<float>(soup->positions.size());
}

} // namespace

class TestBrushParts : public QObject {
    Q_OBJECT

private slots:
    void eachSurfaceGetsItsPart() {
        const Soup soup = halves();
        BrushStroke stroke(std::make_shared<PaintGround>(soup), kBrush, {painted(0), painted(1)});
        const Vec3 at(-0.003, 0.002, 0);
        const auto& parts = stroke.work({Dab{at}});
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].surface, Index(0));
        const auto left = valuesOf(parts[0], soup), right = valuesOf(parts[1], soup);
        const auto isOf = [&](Index surface, std::size_t position) {
            for (std::size_t k = 0; k < soup->triangles.size(); ++k)
                if (soup->surfaceOf[k] == surface &&
                    std::ranges::count(soup->triangles[k], Index(position)) > 0)
                    return true;
            return false;
        };
        int onTheLeft = 0, onTheRight = 0;
        for (std::size_t i = 0; i < soup->positions.size(); ++i) {
            const Vec3& p = soup->positions[i];
            const bool within = (p - at).norm() < kBrush.radius;
            QCOMPARE_EQ(left[i] > 0, within && isOf(0, i));
            QCOMPARE_EQ(right[i] > 0, within && isOf(1, i));
            onTheLeft += left[i] > 0;
            onTheRight += right[i] > 0;
        }
        QCOMPARE_GT(onTheLeft, 10);
        QCOMPARE_GT(onTheRight, 10);
    }

    // As with one call: the pointer's places come in bits.
    void placesComeInBits() {
        const Soup soup = halves();
        const std::vector<PaintStep> places{Dab{Vec3(-0.05, 0, 0)}, Dab{Vec3(0, 0.04, 0)},
                                            Dab{Vec3(0.05, 0, 0)}};
        BrushStroke whole(std::make_shared<PaintGround>(soup), kBrush, {painted(0)});
        BrushStroke inBits(std::make_shared<PaintGround>(soup), kBrush, {painted(0)});
        const auto expected = valuesOf(whole.work(places)[0], soup);
        for (const PaintStep& place : places)
            (void)inBits.work({place});
        QVERIFY(valuesOf(inBits.work({})[0], soup) == expected);
    }

    // Where the pointer has left the surface there is no way between two places.
    void aGapStaysAGap() {
        const Soup soup = halves();
        const Vec3 a(-0.06, 0, 0), b(0.06, 0, 0);
        BrushStroke stroke(std::make_shared<PaintGround>(soup), kBrush, {painted(0), painted(1)});
        const auto& parts = stroke.work({Dab{a}, std::nullopt, Dab{b}});
        const auto left = valuesOf(parts[0], soup), right = valuesOf(parts[1], soup);
        for (std::size_t i = 0; i < soup->positions.size(); ++i) {
            const Vec3& p = soup->positions[i];
            if (std::abs((p - a).norm() - kBrush.radius) < 1e-4 ||
                std::abs((p - b).norm() - kBrush.radius) < 1e-4)
                continue;
            QCOMPARE_EQ(left[i] > 0, (p - a).norm() < kBrush.radius);
            QCOMPARE_EQ(right[i] > 0, (p - b).norm() < kBrush.radius);
        }
    }

    // What was there is painted over; what cannot be painted stays as it is.
    void itGoesOnFromWhatWasThere() {
        const Soup soup = halves();
        BrushStroke::Part before = painted(0), noise{1, TexturePattern{}};
        before.pattern.painted.values = std::make_shared<const PaintedValues>(
            PaintedValues(std::vector<float>(soup->positions.size(), 0.25F)));
        Brush half = kBrush;
        half.strength = 0.5;
        BrushStroke stroke(std::make_shared<PaintGround>(soup), half, {before, noise});
        const auto& parts = stroke.work({Dab{Vec3(-0.05, 0, 0)}});
        const auto now = valuesOf(parts[0], soup);
        int painted = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool in = (soup->positions[i] - Vec3(-0.05, 0, 0)).norm() < kBrush.radius;
            COMPARE_NEAR(now[i], in ? 0.75 : 0.25, 1e-6, "");
            painted += in;
        }
        QCOMPARE_GT(painted, 10);
        QVERIFY(parts[1].pattern == TexturePattern{});
    }

    void onlyImagesOnCoordinatesHaveTexels() {
        const Soup soup = halves();
        PaintGround ground(soup);
        TexturePattern pattern;
        QVERIFY(!texelMapOf(pattern, soup, 0));
        pattern.source = TextureSource::Image;
        pattern.mapping = TextureMapping::Planar;
        QVERIFY(!texelMapOf(pattern, soup, 0));
        QCOMPARE(ground.coverOf(0, pattern), nullptr);
        QCOMPARE(ground.reach(), ground.reach()); // worked out once
    }

    // The texels that lie on one surface are not those of another one with the same image.
    void eachSurfaceHasItsTexels() {
        TriangleSoup withUvs = *halves();
        for (const auto& triangle : withUvs.triangles)
            for (const Index corner : triangle) {
                const Vec3& p = withUvs.positions[corner];
                withUvs.cornerUvs.emplace_back(float(p.x() / 0.2 + 0.5), float(p.y() / 0.2 + 0.5));
            }
        const auto soup = std::make_shared<const TriangleSoup>(std::move(withUvs));
        PaintGround ground(soup);
        TexturePattern pattern;
        pattern.source = TextureSource::Image;
        pattern.mapping = TextureMapping::UvUnit; // both of one size
        pattern.image = std::make_shared<const TextureImage>(8, 8, std::vector<std::uint16_t>(64));
        const auto left = ground.coverOf(0, pattern), right = ground.coverOf(1, pattern);
        QVERIFY(left && right);
        QVERIFY2(left != right, "each its own");
        QCOMPARE(ground.coverOf(0, pattern), left); // worked out once
        pattern.source = TextureSource::Noise;
        QVERIFY(!texelMapOf(pattern, soup, 0));
    }
};

TACTUM_TEST(TestBrushParts)

} // namespace test_brush_parts

#include "test_brush_parts.moc"
