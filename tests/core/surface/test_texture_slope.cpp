// Slopes of the texture in metres per metre: against known heights and against finite differences.

#include <QTest>

#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_texture_slope {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;

QString text(const Vec3& v) {
    return QString("(%1 %2 %3)").arg(v.x()).arg(v.y()).arg(v.z());
}

/// A smooth image that repeats without a seam.
Image waves(int width, int height) {
    return imageOf(width, height, [](double x, double y) {
        return 0.5 + 0.25 * std::sin(2 * kPi * x) + 0.2 * std::cos(2 * kPi * (x + 2 * y));
    });
}

/// 20 mm in the plane z = 0, with coordinates that are `linear` of the place plus a shift.
UvTriangle laidOut(const Eigen::Matrix2d& linear) {
    UvTriangle result;
    result.triangle = {{0, 0, 0}, {0.02, 0, 0}, {0, 0.02, 0}};
    const Vector2d shift(0.1, 0.1);
    result.uvs = {shift, linear * Vector2d(0.02, 0) + shift, linear * Vector2d(0, 0.02) + shift};
    return result;
}

std::vector<TextureMapping> allMappings() {
    return {TextureMapping::Uv,     TextureMapping::UvUnit,      TextureMapping::Triplanar,
            TextureMapping::Planar, TextureMapping::Cylindrical, TextureMapping::Spherical};
}

std::vector<TextureSource> allSources() {
    return {TextureSource::Image, TextureSource::Noise, TextureSource::Grooves, TextureSource::Dots,
            TextureSource::Weave};
}

} // namespace

class TextureSlopeTest : public QObject {
    Q_OBJECT

private slots:
    void everySourceInEveryMappingAgreesWithDifferences();
    void imageRampHasTheSlopeOfItsHeights();
    void slopeIsInMetresHoweverTheUvsLie_data();
    void slopeIsInMetresHoweverTheUvsLie();
    void uvGradientIsThatOfTheLinearMap();
    void uvGradientOfNothingIsZero();
    void forceRatioIsTheSlope();
    void eightBitsRenderARampToo();
    void cylinderAndSphereFollowTheirFormulas();
    void axisAndPolesStayTame();
    void wholeRepeatsFillATurn();
    void triplanarOfAnAxisIsPlanar();
    void maskCountsInTheSlope();
    void strangeInputGivesThePlainSurface();
    void beyondAllRepeatsIsThePlainSurface();
};

// 1 % of the steepest slope seen: what the differences themselves are worth at a step of a nanometre or so.
void TextureSlopeTest::everySourceInEveryMappingAgreesWithDifferences() {
    Rng rng(11);
    for (TextureMapping mapping : allMappings())
        for (TextureSource source : allSources()) {
            TextureLayer layer = heightLayer(source, mapping, 0.013, 1e-3);
            layer.pattern.image = waves(48, 30);
            layer.pattern.rotation = 0.7;
            layer.pattern.offsetU = 0.004;
            layer.pattern.frame = {Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized())),
                                   Vec3(0.01, -0.02, 0.005)};
            UvTriangle surface = laidOut(60 * Eigen::Matrix2d::Identity());
            const Stack stack = stackOf({layer}, surface.soup());
            QVERIFY(stack);
            double steepest = 0, worst = 0;
            for (int i = 0; i < 300; ++i) {
                surface.triangle = {inBox(rng, 0.03), inBox(rng, 0.03), inBox(rng, 0.03)};
                const TexturePoint point = surface.at({0.3, 0.4, 0.3});
                // Around an axis the filter itself changes from place to place, which the slope leaves out.
                const bool round =
                    mapping == TextureMapping::Cylindrical || mapping == TextureMapping::Spherical;
                const double detail = round ? 0 : 5e-4 * (i % 3);
                const Vec3 slope = feel(*stack, point, detail).slope;
                if (slope.norm() > 0.99 * kSteepestSlope) continue; // cut
                QCOMPARE_LT(std::abs(slope.dot(point.normal)), 1e-12);
                steepest = std::max(steepest, slope.norm());
                // The slope of a spline has creases: a step across one of them says little.
                const Vec3 coarse = measuredSlope(*stack, point, detail, 2e-9),
                           fine = measuredSlope(*stack, point, detail, 1e-9);
                if ((coarse - fine).norm() > 1e-3 * (0.1 + slope.norm())) continue;
                worst = std::max(worst, (slope - fine).norm());
            }
            QVERIFY2(
                steepest > 0.02,
                qPrintable(
                    QString("source %1, mapping %2: %3").arg(int(source)).arg(int(mapping)).arg(steepest)));
            QVERIFY2(worst < 0.01 * steepest, qPrintable(QString("source %1 mapping %2: %3 of %4")
                                                             .arg(int(source))
                                                             .arg(int(mapping))
                                                             .arg(worst)
                                                             .arg(steepest)));
        }
}

// 1 mm over 10 mm along x.
void TextureSlopeTest::imageRampHasTheSlopeOfItsHeights() {
    const Stack stack = stackOf({imageLayer(ramp(), TextureMapping::Planar, 0.01, 1e-3)});
    for (double x : {0.0022, 0.0037, 0.005, 0.0078}) {
        TexturePoint point;
        point.position = {x, 0.0021, 0};
        for (double detail : {0.0, 2e-4}) {
            const TextureFeel felt = feel(*stack, point, detail);
            // A texel's step is 256 of 65536 values, here and there 255.
            QVERIFY2((felt.slope - Vec3(0.1, 0, 0)).norm() < 5e-4, qPrintable(text(felt.slope)));
            COMPARE_NEAR(felt.height, 0.1 * x, 1e-7, "m");
        }
    }
}

void TextureSlopeTest::slopeIsInMetresHoweverTheUvsLie_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("c");
    QTest::addColumn<double>("d");
    QTest::newRow("as they are") << 10.0 << 0.0 << 0.0 << 10.0;
    QTest::newRow("scaled up") << 40.0 << 0.0 << 0.0 << 40.0;
    QTest::newRow("scaled down") << 0.5 << 0.0 << 0.0 << 0.5;
    QTest::newRow("stretched") << 30.0 << 0.0 << 0.0 << 5.0;
    QTest::newRow("mirrored") << -10.0 << 0.0 << 0.0 << 10.0;
    QTest::newRow("turned") << 0.0 << -10.0 << 10.0 << 0.0;
    QTest::newRow("skewed") << 10.0 << 7.0 << 0.0 << 10.0;
    QTest::newRow("everything") << -25.0 << 9.0 << 4.0 << 6.0;
}

// The heights over the surface are known from the coordinates alone: height = strength x u.
void TextureSlopeTest::slopeIsInMetresHoweverTheUvsLie() {
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, c);
    QFETCH(double, d);
    Eigen::Matrix2d linear;
    linear << a, b, c, d;
    UvTriangle surface = laidOut(linear);
    const Stack unit = stackOf({imageLayer(ramp(), TextureMapping::UvUnit, 0.01, 1e-3)}, surface.soup());
    TexturePoint point = surface.at({0.6, 0.2, 0.2});
    point.uv = {0.4, 0.3}; // away from the seam of the ramp
    const Vec3 expected = 1e-3 * Vec3(a, b, 0);
    const Vec3 slope = feel(*unit, point, 0).slope;
    QVERIFY2((slope - expected).norm() < 0.005 * expected.norm(), qPrintable(text(slope)));

    // In metres: the mean scale of the coordinates drops out, a square millimetre of pattern stays one.
    const Stack metres = stackOf({imageLayer(ramp(), TextureMapping::Uv, 0.01, 1e-3)}, surface.soup());
    const double scale = 1 / std::sqrt(std::abs(linear.determinant())); // metres per unit
    point.uv = Vector2d(0.4, 0.3) * 0.01 / scale;
    const Vec3 felt = feel(*metres, point, 0).slope, wanted = 0.1 * scale * Vec3(a, b, 0);
    QVERIFY2((felt - wanted).norm() < 0.005 * wanted.norm(), qPrintable(text(felt) + text(wanted)));
}

void TextureSlopeTest::uvGradientIsThatOfTheLinearMap() {
    Rng rng(3);
    for (int i = 0; i < 1000; ++i) {
        const double scale = std::pow(10, uniform(rng, -4, 2));
        const Triangle t{scale * inBox(rng, 1), scale * inBox(rng, 1), scale * inBox(rng, 1)};
        const auto uv = [&] { return Vector2d(uniform(rng, -9, 9), uniform(rng, -9, 9)); };
        const CornerUvs uvs{uv(), uv(), uv()};
        const auto gradient = uvGradientOf(t, uvs);
        const Vec3 n = (t.b - t.a).cross(t.c - t.a);
        if (n.norm() < 1e-3 * scale * scale) continue;
        QCOMPARE_LT((gradient * (t.b - t.a) - (uvs[1] - uvs[0])).norm(), 1e-6);
        QCOMPARE_LT((gradient * (t.c - t.b) - (uvs[2] - uvs[1])).norm(), 1e-6);
        QCOMPARE_LT((gradient * n.normalized()).norm() * scale, 1e-6);
    }
}

void TextureSlopeTest::uvGradientOfNothingIsZero() {
    const CornerUvs uvs{Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1)};
    const Vec3 a(1, 2, 3), b(2, 2, 3), c(1, 4, 3);
    const double nan = std::nan("");
    QVERIFY(uvGradientOf({a, b, b}, uvs).isZero(0));
    QVERIFY(uvGradientOf({a, a, a}, uvs).isZero(0));
    QVERIFY(uvGradientOf({a, b, 0.5 * (a + b)}, uvs).isZero(0));
    QVERIFY(uvGradientOf({a, b, c}, {uvs[1], uvs[1], uvs[1]}).isZero(0));
    QVERIFY(uvGradientOf({a, b, c}, {Vector2d(nan, 0), uvs[1], uvs[2]}).isZero(0));
    QVERIFY(!uvGradientOf({a, b, c}, uvs).isZero(1e-3));
    // Corners on one line, but for the rounding of their coordinates.
    Rng rng(12);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = inBox(rng, 1), way = inBox(rng, 1e-2);
        QVERIFY(uvGradientOf({p, p + way, p + uniform(rng, 0, 2) * way}, uvs).isZero(0));
    }
}

// Tangential by normal force of the tilted plane, pushing downhill.
void TextureSlopeTest::forceRatioIsTheSlope() {
    Rng rng(8);
    for (double s : {0.01, 0.1, 0.5}) {
        const Vec3 n = direction(rng), uphill = n.unitOrthogonal();
        const Vec3 force = bumpedNormal(n, s * uphill);
        const double normal = force.dot(n), tangential = force.dot(uphill);
        COMPARE_NEAR(force.norm(), 1, 1e-15, "N");
        COMPARE_NEAR(-tangential / normal, s, 1e-12, "");
    }
}

// 256 texels of a ramp are one step of 8 bits each: exact. 1024 texels have stairs, whose mean is right.
void TextureSlopeTest::eightBitsRenderARampToo() {
    const Stack coarse = stackOf({imageLayer(ramp(256, 8), TextureMapping::Planar, 0.01, 1e-3)});
    const Stack fine = stackOf({imageLayer(ramp(1024, 8), TextureMapping::Planar, 0.01, 1e-3)});
    const Stack deep = stackOf({imageLayer(ramp(1024, 16), TextureMapping::Planar, 0.01, 1e-3)});
    double mean = 0, stairs = 0, smooth = 0;
    for (int i = 0; i < 400; ++i) {
        TexturePoint point;
        point.position = {0.003 + 1e-5 * i, 0.001, 0};
        COMPARE_NEAR(feel(*coarse, point, 0).slope.x(), 0.1, 0.002, "");
        const double slope = feel(*fine, point, 0).slope.x();
        mean += slope / 400;
        stairs = std::max(stairs, std::abs(slope - 0.1));
        smooth = std::max(smooth, std::abs(feel(*deep, point, 0).slope.x() - 0.1));
    }
    COMPARE_NEAR(mean, 0.1, 0.004, "");
    QCOMPARE_GT(stairs, 0.05); // what 16 bits are for
    QCOMPARE_LT(smooth, 0.002);
}

void TextureSlopeTest::cylinderAndSphereFollowTheirFormulas() {
    const double r = 0.04, height = 1e-3;
    for (double angle : {-2.5, -0.4, 0.3, 2.9})
        for (double z : {-0.015, 0.0113}) {
            TextureLayer layer = imageLayer(ramp(), TextureMapping::Cylindrical, 0.05, height);
            layer.pattern.radius = r;
            TexturePoint point;
            point.normal = {std::cos(angle), std::sin(angle), 0};
            point.position = r * point.normal + Vec3(0, 0, z);
            const Vec3 east(-std::sin(angle), std::cos(angle), 0);
            // 2 pi 0.04 m has room for 5 repeats of 0.05 m: 5 ramps a turn.
            const double slope = height * 5 / (2 * kPi * r);
            const Vec3 felt = feel(*stackOf({layer}), point, 0).slope;
            QVERIFY2((felt - slope * east).norm() < 0.005 * slope, qPrintable(text(felt)));

            layer.pattern.mapping = TextureMapping::Spherical;
            layer.pattern.rotation = kPi / 2; // the ramp rises northward
            layer.pattern.offsetV = 0.3;
            const double latitude = z / 0.03;
            point.normal = {std::cos(latitude) * std::cos(angle), std::cos(latitude) * std::sin(angle),
                            std::sin(latitude)};
            point.position = r * point.normal;
            const Vec3 north = point.normal.cross(east);
            const Vec3 climbed = feel(*stackOf({layer}), point, 0).slope;
            QVERIFY2((climbed - height / 0.05 * north).norm() < 0.005 * height / 0.05,
                     qPrintable(text(climbed) + text(north)));
        }
}

void TextureSlopeTest::axisAndPolesStayTame() {
    for (TextureMapping mapping : {TextureMapping::Cylindrical, TextureMapping::Spherical})
        for (double away : {0.0, 1e-300, 1e-12, 1e-6, 1e-5}) {
            TextureLayer layer = heightLayer(TextureSource::Grooves, mapping, 0.01, 1e-3);
            layer.pattern.radius = 0.05;
            TexturePoint point;
            point.position = {away, 0, mapping == TextureMapping::Spherical ? 0.05 : 0.01};
            for (double detail : {0.0, 1e-3}) {
                const TextureFeel felt = feel(*stackOf({layer}), point, detail);
                QVERIFY(felt.slope.allFinite());
                // The pattern is finer there than any detail: nothing is left of it.
                if (detail > 0) QVERIFY2(felt.slope.norm() < 1e-12, qPrintable(text(felt.slope)));
            }
        }
}

// No seam where the longitude jumps from pi to -pi.
void TextureSlopeTest::wholeRepeatsFillATurn() {
    for (TextureMapping mapping : {TextureMapping::Cylindrical, TextureMapping::Spherical})
        for (TextureSource source : {TextureSource::Image, TextureSource::Grooves, TextureSource::Weave}) {
            TextureLayer layer = heightLayer(source, mapping, 0.0123, 1e-3);
            layer.pattern.image = waves(64, 64);
            const Stack stack = stackOf({layer});
            TexturePoint east, west;
            east.position = {-0.05, 1e-12, 0.003}, west.position = {-0.05, -1e-12, 0.003};
            east.normal = west.normal = -Vec3::UnitX();
            COMPARE_NEAR(feel(*stack, east, 0).height, feel(*stack, west, 0).height, 1e-9, "m");
        }
}

void TextureSlopeTest::triplanarOfAnAxisIsPlanar() {
    const TextureLayer triplanar = imageLayer(waves(32, 32), TextureMapping::Triplanar, 0.01, 1e-3);
    TextureLayer planar = triplanar;
    planar.pattern.mapping = TextureMapping::Planar;
    TexturePoint point;
    point.position = {0.0123, 0.0045, 0.7};
    QCOMPARE(feel(*stackOf({triplanar}), point, 0).slope, feel(*stackOf({planar}), point, 0).slope);
    // From behind it is laid on anew, so that writing reads from either side: a ramp rises the other way.
    const Stack rising = stackOf({imageLayer(ramp(), TextureMapping::Triplanar, 0.01, 1e-3)});
    for (double side : {1.0, -1.0}) {
        TexturePoint plain;
        plain.position = {0.002, 0.003, 0};
        plain.normal = side * Vec3::UnitZ();
        COMPARE_NEAR(feel(*rising, plain, 0).slope, Vec3(side * 0.1, 0, 0), 5e-4, "");
    }
    // Over an edge it blends: half of the one, half of the other.
    point.normal = Vec3(1, 0, 1).normalized();
    const double between = feel(*stackOf({triplanar}), point, 0).height;
    point.normal = Vec3::UnitX();
    const double x = feel(*stackOf({triplanar}), point, 0).height;
    point.normal = Vec3::UnitZ();
    const double z = feel(*stackOf({triplanar}), point, 0).height;
    COMPARE_NEAR(between, 0.5 * (x + z), 1e-12, "");
}

// A ramp under a mask that is a ramp across it: height = k x y, its slope k (y, x).
void TextureSlopeTest::maskCountsInTheSlope() {
    TextureLayer layer = imageLayer(ramp(), TextureMapping::Planar, 0.01, 1e-3);
    layer.mask = layer.pattern;
    layer.mask->rotation = kPi / 2;
    const Stack stack = stackOf({layer});
    TexturePoint point;
    point.position = {0.003, 0.007, 0};
    const Vec3 expected = 1e-3 / (0.01 * 0.01) * Vec3(0.007, 0.003, 0);
    const Vec3 slope = feel(*stack, point, 0).slope;
    QVERIFY2((slope - expected).norm() < 0.005 * expected.norm(), qPrintable(text(slope)));
}

void TextureSlopeTest::strangeInputGivesThePlainSurface() {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (TextureMapping mapping : allMappings())
        for (TextureSource source : allSources())
            for (double wrong : {nan, inf, -inf, 1e300}) {
                TextureLayer layer = heightLayer(source, mapping, wrong, wrong);
                layer.pattern.image = waves(8, 8);
                layer.pattern.offsetU = layer.pattern.fill = layer.pattern.octaves = wrong;
                layer.pattern.frame.translation.x() = wrong;
                const Stack stack = stackOf({layer}, laidOut(Eigen::Matrix2d::Identity()).soup());
                QVERIFY(stack);
                TexturePoint point = laidOut(Eigen::Matrix2d::Identity()).at({0.3, 0.3, 0.4});
                QVERIFY(feel(*stack, point, wrong).slope.allFinite());
                point.position.x() = point.uv.x() = wrong;
                const TextureFeel felt = feel(*stack, point, 1e-3);
                QCOMPARE_LE(felt.slope.norm(), kSteepestSlope * (1 + 1e-12));
                QVERIFY(std::isfinite(felt.height));
                point.uvGradient(0, 0) = point.normal.y() = wrong;
                QCOMPARE_LE(feel(*stack, point, 1e-3).slope.norm(), kSteepestSlope * (1 + 1e-12));
            }
}

// Beyond kMaxRepeats a double no longer knows where in a repeat it is, along either way.
void TextureSlopeTest::beyondAllRepeatsIsThePlainSurface() {
    TextureLayer layer = heightLayer(TextureSource::Noise, TextureMapping::Uv, 0.01, 1e-3);
    const UvTriangle laid = laidOut(Eigen::Matrix2d::Identity());
    const Stack stack = stackOf({layer}, laid.soup());
    TexturePoint point = laid.at({0.3, 0.3, 0.4});
    QCOMPARE_GT(feel(*stack, point, 0).slope.norm(), 0);
    const Vector2d before = point.uv;
    for (const int way : {0, 1}) {
        point.uv = before;
        point.uv[way] = 3 * kMaxRepeats;
        QCOMPARE(feel(*stack, point, 0).height, 0.0);
        QCOMPARE(feel(*stack, point, 0).slope, Vec3(0, 0, 0));
    }
}

TACTUM_TEST(TextureSlopeTest)

} // namespace test_texture_slope

#include "test_texture_slope.moc"
