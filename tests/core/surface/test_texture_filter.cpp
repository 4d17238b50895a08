// Detail that the servo cannot render is filtered out of the texture, and does not come back as another one.

#include <QTest>

#include "tests/core/surface/spectrum.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_texture_filter {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFeature = 1e-3; ///< m

/// A grating of waves along x: `count` of them in a repeat of `texels`.
Image grating(int count, int texels) {
    return imageOf(texels, 1, [&](double x, double) { return 0.5 + 0.5 * std::sin(2 * kPi * count * x); });
}

/// The share of a grating's slope that is kept when details below kFeature are filtered.
double keptOfGrating(double wavelength, double rotation = 0) {
    const int count = 61; // against 4000 texels: never in step with any level
    TextureLayer layer =
        imageLayer(grating(count, 4000), TextureMapping::Planar, count * wavelength, 0.02 * wavelength);
    layer.pattern.rotation = rotation;
    const Stack stack = stackOf({layer});
    const double half = 0.5 * count * wavelength;
    return meanSlope(*stack, kFeature, half) / meanSlope(*stack, 0, half);
}

double keptOfPattern(TextureSource source, double size) {
    TextureLayer layer = heightLayer(source, TextureMapping::Planar, size, 0.02 * size);
    layer.pattern.softness = 1;
    layer.pattern.octaves = 1;
    const Stack stack = stackOf({layer});
    return meanSlope(*stack, kFeature, 20 * size) / meanSlope(*stack, 0, 20 * size);
}

/// The slope along a slide over a texture, once each tick.
std::vector<double> slide(const TextureStack& stack, double speed, double rate, double smallestFeature) {
    std::vector<double> slopes;
    const Vec3 way = Vec3(0.83, 0.56, 0).normalized();
    for (int i = 0; i < 2048; ++i) {
        TexturePoint point;
        point.position = speed * i / rate * way;
        slopes.push_back(feel(stack, point, smallestFeature).slope.dot(way));
    }
    return slopes;
}

} // namespace

class TextureFilterTest : public QObject {
    Q_OBJECT

private slots:
    void gratingsShorterThanTheFeatureVanish();
    void longGratingsStay();
    void withoutAFeatureEverythingStays();
    void stretchedUvsAreFilteredInMetres();
    void proceduralPatternsFadeByTheirWaves();
    void fineOctavesGoFirst();
    void aliasOfASlide_data();
    void aliasOfASlide();
};

void TextureFilterTest::gratingsShorterThanTheFeatureVanish() {
    for (double ratio : {0.1, 0.23, 0.4, 0.5, 0.7, 0.9, 1.0})
        for (double rotation : {0.0, 0.5, kPi / 2}) {
            const double share = keptOfGrating(ratio * kFeature, rotation);
            QVERIFY2(share < 0.01, qPrintable(QString("%1: %2").arg(ratio).arg(share)));
        }
}

// Between the two a mip level does what it can: the slope of a grating of 2, 4 and 6 features.
void TextureFilterTest::longGratingsStay() {
    for (double features : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0})
        qInfo("kept of a grating of %g features: %.1f %%", features,
              100 * keptOfGrating(features * kFeature));
    for (double ratio : {8.0, 9.7, 12.0, 20.0, 50.0})
        for (double rotation : {0.0, 0.5, kPi / 2}) {
            const double share = keptOfGrating(ratio * kFeature, rotation);
            QVERIFY2(share >= 0.98 && share < 1.02, qPrintable(QString("%1: %2").arg(ratio).arg(share)));
        }
}

void TextureFilterTest::withoutAFeatureEverythingStays() {
    // The slope of height / 2 sin(2 pi x / wavelength) has the mean square of pi height / wavelength /
    // root 2.
    const Stack stack = stackOf({imageLayer(grating(61, 4000), TextureMapping::Planar, 0.061, 2e-5)});
    COMPARE_NEAR(meanSlope(*stack, 0, 0.03, 20000) / (kPi * 0.02 / std::numbers::sqrt2), 1, 0.02, "");
}

// The image lies six times finer in one direction: its waves are judged by their length in metres alone.
void TextureFilterTest::stretchedUvsAreFilteredInMetres() {
    const auto share = [](double wavelength, const Vector2d& texelsPerMetre, double skew) {
        const int waves = 50, width = int(waves * wavelength * texelsPerMetre.x());
        TexturePoint point;
        point.uvGradient.row(0) = Vec3(texelsPerMetre.x() / width, skew * texelsPerMetre.x() / width, 0);
        point.uvGradient.row(1) = Vec3(0, texelsPerMetre.y() / 64, 0);
        TextureLayer layer = imageLayer(
            imageOf(width, 64, [&](double x, double) { return 0.5 + 0.5 * std::sin(2 * kPi * waves * x); }),
            TextureMapping::UvUnit, 0.01, 0.02 * wavelength);
        UvTriangle anything{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {Vector2d(0, 0), {1, 0}, {0, 1}}};
        const Stack stack = stackOf({layer}, anything.soup());
        Rng rng(6);
        double kept = 0, whole = 0;
        for (int i = 0; i < 1000; ++i) {
            point.uv = {uniform(rng, 0, 1), uniform(rng, 0, 1)};
            kept += feel(*stack, point, kFeature).slope.squaredNorm();
            whole += feel(*stack, point, 0).slope.squaredNorm();
        }
        return std::sqrt(kept / whole);
    };
    for (double skew : {0.0, 0.3})
        for (const Vector2d& density :
             {Vector2d(2000, 12000), Vector2d(12000, 2000), Vector2d(12000, 72000)}) {
            // An image of 2000 texels/m has no waves of 0.7 mm.
            const double fine = density.x() < 3000 ? 0 : share(0.7 * kFeature, density, skew),
                         coarse = share(10 * kFeature, density, skew);
            const QString what = QString("skew %1, %2 x %3 texels/m: %4 and %5")
                                     .arg(skew)
                                     .arg(density.x())
                                     .arg(density.y())
                                     .arg(fine)
                                     .arg(coarse);
            // Askew, the creases of the interpolation do not line up with the places that are averaged.
            QVERIFY2(fine < (skew == 0 ? 0.03 : 0.1) && coarse >= 0.95, qPrintable(what));
        }
}

void TextureFilterTest::proceduralPatternsFadeByTheirWaves() {
    for (TextureSource source :
         {TextureSource::Noise, TextureSource::Grooves, TextureSource::Dots, TextureSource::Weave}) {
        QCOMPARE_EQ(keptOfPattern(source, kFeature), 0);
        QVERIFY2(keptOfPattern(source, 32 * kFeature) >= 0.99, qPrintable(QString::number(int(source))));
    }
    COMPARE_NEAR(keptOfPattern(TextureSource::Grooves, 2 * kFeature), 7.0 / 27, 1e-6, "");
    QCOMPARE_GT(keptOfPattern(TextureSource::Grooves, 8 * kFeature), 0.999);
    QCOMPARE_GT(keptOfPattern(TextureSource::Noise, 8 * kFeature), 0.999);
}

// Noise from 32 features on: of its octaves the first three are longer than eight features and whole, the
// next two fade each by its own length, and the finer ones are gone.
void TextureFilterTest::fineOctavesGoFirst() {
    const auto noise = [](int octaves) {
        TextureLayer layer = heightLayer(TextureSource::Noise, TextureMapping::Planar, 32 * kFeature, 1e-3);
        layer.pattern.octaves = octaves;
        layer.strength *= 2 - std::exp2(1 - octaves); // each octave as high as in any other
        return stackOf({layer});
    };
    const Stack all = noise(8), three = noise(3), four = noise(4), five = noise(5);
    Rng rng(2);
    for (int i = 0; i < 500; ++i) {
        TexturePoint point;
        point.position = inBox(rng, 0.1);
        const auto slope = [&](const Stack& stack) { return feel(*stack, point, 0).slope; };
        const Vec3 expected =
            slope(three) + 20.0 / 27 * (slope(four) - slope(three)) + 7.0 / 27 * (slope(five) - slope(four));
        COMPARE_NEAR(feel(*all, point, kFeature).slope, expected, 1e-12, "");
    }
}

void TextureFilterTest::aliasOfASlide_data() {
    QTest::addColumn<double>("rate");
    QTest::newRow("1 kHz") << 1000.0;
    QTest::newRow("2 kHz") << 2000.0;
    QTest::newRow("4 kHz") << 4000.0;
}

// White grain, the worst there is: 20 um high, 0.1 mm fine, pressed with 1 N. What sounds within a tenth of
// the rate from its half is not there by itself: it is what a level or the interpolation shows wrongly, or
// the last of the fading waves.
void TextureFilterTest::aliasOfASlide() {
    QFETCH(double, rate);
    const double speed = 0.15, feature = 2.5 * speed / rate;
    Rng rng(9);
    const Image grain = imageOf(512, 512, [&](double, double) { return uniform(rng, 0, 1); });
    const Stack stack = stackOf({imageLayer(grain, TextureMapping::Planar, 0.05, 2e-5)});
    const Spectrum sharp = spectrumOf(slide(*stack, speed, rate, 0), rate, 0.4 * rate),
                   soft = spectrumOf(slide(*stack, speed, rate, feature), rate, 0.4 * rate);
    qInfo("force above %g Hz: %.3g mN, %.2f %% of the energy; unfiltered %.3g mN, %.1f %%", 0.4 * rate,
          1e3 * std::sqrt(soft.above), 100 * soft.above / soft.whole, 1e3 * std::sqrt(sharp.above),
          100 * sharp.above / sharp.whole);
    QCOMPARE_LT(soft.above, 0.02 * soft.whole);
    QCOMPARE_LE(soft.above, sharp.above);
    QCOMPARE_GT(soft.whole, 0);
}

TACTUM_TEST(TextureFilterTest)

} // namespace test_texture_filter

#include "test_texture_filter.moc"
