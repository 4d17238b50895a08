// Layers as pictures of flat ground, against a cosine that anybody can write down. Wrong itself if what is
// left out of details below two pixels reached the waves here: they are 20 pixels long and more.
#include <atomic>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/cosine_layer.h"
#include "ui/document/layer_picture.h"

namespace test_layer_ground {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPeriod = 8e-3; // m
constexpr TextureTarget kRatios[] = {TextureTarget::StaticFriction, TextureTarget::DynamicFriction,
                                     TextureTarget::Viscosity, TextureTarget::Stiffness};

TextureLayer cosine(TextureTarget target, double strength) {
    TextureLayer layer = cosineLayer(target, strength, kPeriod);
    layer.pattern.mapping = TextureMapping::Spherical; // unrolled
    layer.pattern.frame.translation = {1, 2, 3};       // wherever it lies on the model
    return layer;
}

TextureLayer painted() {
    TextureLayer layer;
    layer.pattern.source = TextureSource::Painted;
    layer.strength = 1e-3;
    return layer;
}

/// The middle of a pixel of a row, m.
double middleOf(int column, const FlatWish& wish) {
    return (column + 0.5) * wish.side / wish.pixels - wish.side / 2;
}

} // namespace

class TestLayerGround : public QObject {
    Q_OBJECT
private slots:
    void heightsFollowTheCosine() {
        const FlatWish wish{64, 2 * kPeriod, TextureTarget::Height, 0};
        const FlatGround ground = flatGround({cosine(TextureTarget::Height, 2e-4)}, wish);
        QCOMPARE(ground.pixels, 64);
        QCOMPARE(ground.side, 2 * kPeriod);
        QCOMPARE(ground.target, TextureTarget::Height);
        QCOMPARE(ground.values.size(), 64u * 64u);
        double low = 1, high = -1;
        for (int row = 0; row < 64; ++row)
            for (int column = 0; column < 64; ++column) {
                const double expected = 2e-4 * cosineAt(middleOf(column, wish), kPeriod);
                COMPARE_NEAR(ground.values[std::size_t(64 * row + column)], expected, 1e-9, "m");
                low = std::min(low, expected), high = std::max(high, expected);
            }
        COMPARE_NEAR(ground.low, low, 1e-9, "m");
        COMPARE_NEAR(ground.high, high, 1e-9, "m");
        QCOMPARE(ground.picture.size(), QSize(64, 64));
        QCOMPARE(ground.at(0, 0), ground.values[0]);
        QCOMPARE(ground.at(0.99, 0), ground.values[63]);
        QCOMPARE(ground.at(0, 0.99), ground.values[64 * 63]);
        QCOMPARE(ground.at(1, 1), ground.values.back()); // and nothing beyond
        QCOMPARE(ground.at(-1, 2), ground.values[64 * 63]);
        QCOMPARE(FlatGround().at(0.5, 0.5), 0.0);
    }

    /// Each target by itself, from dark to light.
    void otherTargetsAreFactors() {
        for (const TextureTarget target : kRatios) {
            const FlatWish wish{64, kPeriod, target, 0};
            const FlatGround ground =
                flatGround({cosine(target, 0.5), cosine(TextureTarget::Height, 1e-3)}, wish);
            for (int column = 0; column < 64; ++column)
                COMPARE_NEAR(ground.values[std::size_t(column)],
                             1 + 0.5 * cosineAt(middleOf(column, wish), kPeriod), 1e-6, "");
            const auto grey = [&](int column) { return qRed(ground.picture.pixel(column, 5)); };
            QCOMPARE(grey(0), int(std::lround(255 * 0.12))); // the lowest
            QCOMPARE(grey(31), int(std::lround(255 * 0.88)));
            for (const TextureTarget other : kRatios) {
                if (other == target) continue;
                const FlatGround flat = flatGround({cosine(target, 0.5)}, {8, kPeriod, other, 0});
                QCOMPARE(flat.low, 1.0);
                QCOMPARE(flat.high, 1.0);
                QCOMPARE(qRed(flat.picture.pixel(3, 3)), 128); // neither dark nor light
            }
        }
    }

    /// A relief lit from (-0.5, 0.6, 0.75), so much steeper that its mean slope is 0.5: of a sine that is its
    /// amplitude times the root of 2.
    void theReliefIsLitFromTheLeft() {
        const FlatWish wish{64, kPeriod, TextureTarget::Height, 0};
        const FlatGround ground = flatGround({cosine(TextureTarget::Height, 2e-4)}, wish);
        const Vec3 light = Vec3(-0.5, 0.6, 0.75).normalized();
        const auto lit = [&](double slope) {
            const double part = std::max(Vec3(-slope, 0, 1).normalized().dot(light), 0.0);
            return int(std::lround(255 * (0.14 + 0.68 * part)));
        };
        for (int column = 0; column < 64; ++column) {
            const double phase = 2 * std::numbers::pi * middleOf(column, wish) / kPeriod;
            const int expected = lit(-std::numbers::sqrt2 / 2 * std::sin(phase));
            QCOMPARE_LE(std::abs(qRed(ground.picture.pixel(column, 5)) - expected), 1);
        }
        const FlatGround flat = flatGround({}, wish);
        QCOMPARE(qRed(flat.picture.pixel(3, 3)), lit(0));
        // However low it is it is seen as well, but no more than 40 times as steep.
        const FlatGround low = flatGround({cosine(TextureTarget::Height, 5e-5)}, wish); // 36 times
        QCOMPARE_LE(std::abs(qRed(low.picture.pixel(47, 5)) - qRed(ground.picture.pixel(47, 5))), 2);
    }

    void layersWithPlanesOfTheirOwnAreAdded() {
        TextureLayer own = cosine(TextureTarget::Height, 1e-4);
        own.name = "own", own.ownPlane = true, own.blend = TextureBlend::Multiply;
        TextureLayer base = cosine(TextureTarget::Height, 2e-4);
        base.name = "base";
        TextureLayer factor = cosine(TextureTarget::Viscosity, 0.5);
        factor.name = "factor", factor.ownPlane = true; // which means nothing there
        const TextureLayers layers = withoutOwnPlanes({own, base, factor});
        QCOMPARE(layers.size(), 3u);
        QCOMPARE(layers[0].name, "base");
        QVERIFY(layers[0] == base);
        QVERIFY(layers[1] == factor);
        QCOMPARE(layers[2].name, "own");
        QVERIFY(!layers[2].ownPlane);
        QCOMPARE(layers[2].blend, TextureBlend::Add);
        const FlatGround ground = flatGround({own, base}, {64, kPeriod, TextureTarget::Height, 0});
        COMPARE_NEAR(ground.high, 3e-4, 1e-6, "m");
    }

    void whatIsPaintedCountsAsPaintedEverywhere() {
        const FlatGround ground = flatGround({painted()}, {8, kPeriod, TextureTarget::Height, 0});
        COMPARE_NEAR(ground.low, 1e-3, 1e-12, "m");
        COMPARE_NEAR(ground.high, 1e-3, 1e-12, "m");
        TextureLayer masked = cosine(TextureTarget::Height, 2e-4);
        masked.mask = painted().pattern;
        const FlatGround all = flatGround({masked}, {64, kPeriod, TextureTarget::Height, 0});
        COMPARE_NEAR(all.high, 2e-4, 1e-6, "m");
    }

    /// A unit of the coordinates is as long as it is on the surface, else as the square.
    void coordinatesHaveTheirLength() {
        TextureLayer layer = cosine(TextureTarget::Height, 2e-4);
        layer.pattern.mapping = TextureMapping::UvUnit; // one repeat for each unit
        for (const auto& [metresPerUv, period] : {std::pair(0.0, 0.02), {0.01, 0.01}, {0.005, 0.005}}) {
            const FlatWish wish{80, 0.02, TextureTarget::Height, metresPerUv};
            const FlatGround ground = flatGround({layer}, wish);
            for (int column = 0; column < 80; ++column)
                COMPARE_NEAR(ground.values[std::size_t(column)],
                             2e-4 * cosineAt(middleOf(column, wish), period), 1e-8, "m");
        }
    }

    void thePatternAloneIsAPicture() {
        const QImage picture = patternPicture(cosine(TextureTarget::Height, 1).pattern, 48);
        QCOMPARE(picture.size(), QSize(48, 48));
        int low = 255, high = 0;
        for (int column = 0; column < 48; ++column) {
            low = std::min(low, qRed(picture.pixel(column, 10)));
            high = std::max(high, qRed(picture.pixel(column, 10)));
            QCOMPARE(picture.pixel(column, 10), picture.pixel(column, 40)); // ridges from below to above
        }
        QCOMPARE_LT(low, 10);
        QCOMPARE_GT(high, 245);
        QVERIFY(patternPicture(painted().pattern, 48).isNull());
        TexturePattern missing;
        missing.source = TextureSource::Image;
        QVERIFY(patternPicture(missing, 48).isNull());
    }

    void itCanBeCancelled() {
        const std::atomic<bool> cancelled = true;
        QVERIFY(flatGround({painted()}, {}, {{}, &cancelled}).values.empty());
        const FlatGround usual = flatGround({painted()}, {});
        QCOMPARE(usual.pixels, 96);
        QCOMPARE(usual.side, 0.03);
    }
};

TACTUM_TEST(TestLayerGround)

} // namespace test_layer_ground

#include "test_layer_ground.moc"
