// Friction on convex surfaces: a sliding proxy goes along the surface, not past it on a tangent, and the cone
// of friction is that of the place where it ends.
//
// The judge measures the distance to every triangle by formulas of its own. It would be wrong if it missed
// the nearest one: then the gap would be too large, never too small.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_friction_curved {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMu = 0.3;

Vec3 onSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return a + t * (b - a);
}

Vec3 nearestOf(const TriangleSoup& soup, const Vec3& p) {
    Vec3 best = soup.positions[0];
    const auto take = [&](const Vec3& q) {
        if ((p - q).squaredNorm() < (p - best).squaredNorm()) best = q;
    };
    for (const auto& t : soup.triangles) {
        const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
        const Vec3 n = (b - a).cross(c - a).normalized(), foot = p - n * n.dot(p - a);
        const bool inside = n.dot((b - a).cross(foot - a)) >= 0 && n.dot((c - b).cross(foot - b)) >= 0 &&
                            n.dot((a - c).cross(foot - c)) >= 0;
        if (inside) take(foot);
        take(onSegment(a, b, p));
        take(onSegment(b, c, p));
        take(onSegment(c, a, p));
    }
    return best;
}

/// Of the tangential to the normal part of a force, on a surface that `away` leads from.
double ratioOf(const Vec3& force, const Vec3& away) {
    const Vec3 n = away.normalized();
    const double normal = force.dot(n);
    return (force - normal * n).norm() / normal;
}

} // namespace

class FrictionCurvedTest : public QObject {
    Q_OBJECT

private slots:
    void aSlideStaysOnTheSurface_data();
    void aSlideStaysOnTheSurface();
    void stripsRubAsTheirCylinder_data();
    void stripsRubAsTheirCylinder();
};

void FrictionCurvedTest::aSlideStaysOnTheSurface_data() {
    QTest::addColumn<int>("divisions");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("depth");
    QTest::addColumn<double>("speed");
    for (int divisions : {1, 2, 4})
        for (double radius : {0.5e-3, 1e-3, 5e-3})
            for (double depth : {0.5e-3, 3e-3})
                for (double speed : {0.02, 0.15}) {
                    if (divisions == 1 && depth < 1e-3) continue; // not below the flat faces
                    QTest::addRow("%d divisions, r %g mm, %g mm deep, %g m/s", divisions, 1e3 * radius,
                                  1e3 * depth, speed)
                        << divisions << radius << depth << speed;
                }
}

void FrictionCurvedTest::aSlideStaysOnTheSurface() {
    QFETCH(int, divisions);
    QFETCH(double, radius);
    QFETCH(double, depth);
    QFETCH(double, speed);
    constexpr double kBall = 0.02;
    ProxyRig rig(ball(kBall, divisions), radius, rough(kMu, kMu));
    const double way = kBall + radius - depth;
    const auto at = [&](double angle, double height) {
        return Vec3(height * std::cos(angle), height * std::sin(angle) * 0.9,
                    height * std::sin(angle) * 0.43);
    };
    rig.startAt(at(0.1, kBall + 2 * radius));
    rig.walk(at(0.1, kBall + 2 * radius), at(0.1, way), 1e-4);
    double worstGap = 0, rounds = 0;
    std::vector<double> ratios;
    const double step = speed * kMillisecond / way;
    for (double angle = 0.1; angle < 2.0; angle += step) {
        const Vec3 finger = at(angle, way);
        rounds = std::max(rounds, double(rig.step(finger).rounds));
        const Vec3 nearest = nearestOf(rig.soup(), rig.position()), away = rig.position() - nearest;
        worstGap = std::max(worstGap, std::abs(away.norm() - radius));
        if (angle > 0.6) ratios.push_back(ratioOf(rig.position() - finger, away));
    }
    std::ranges::sort(ratios);
    const auto part = [&](double p) { return ratios[std::size_t(p * double(ratios.size() - 1))]; };
    qInfo("gap %.4f um, ratio %.5f %.5f %.5f %.5f %.5f, %g rounds", 1e6 * worstGap, part(0), part(0.01),
          part(0.5), part(0.99), part(1), rounds);
    QCOMPARE_LT(worstGap, 1e-8);
    COMPARE_NEAR(part(0.5), kMu, 1e-4 * kMu, "");
    // Between facets that hardly lean, what is touched is known to the skin alone: 0.45 % in single ticks.
    // When it slid on by the cone of the facet that it had left, it was 1.4 % and in every hundredth 1.2 %.
    COMPARE_NEAR(part(0), kMu, 0.006 * kMu, "");
    COMPARE_NEAR(part(0.01), kMu, 0.001 * kMu, "");
    COMPARE_NEAR(part(1), kMu, 0.001 * kMu, "");
}

void FrictionCurvedTest::stripsRubAsTheirCylinder_data() {
    QTest::addColumn<int>("strips");
    QTest::addColumn<int>("pieces");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("mu");
    for (int strips : {180, 360, 720})
        for (int pieces : {1, 4})
            for (double radius : {0.5e-3, 2e-3, 5e-3})
                for (double mu : {0.3, 0.8})
                    QTest::addRow("%d strips of %d, r %g mm, mu %g", strips, pieces, 1e3 * radius, mu)
                        << strips << pieces << radius << mu;
}

// As programs for design write a cylinder: strips much longer than they are wide.
void FrictionCurvedTest::stripsRubAsTheirCylinder() {
    QFETCH(int, strips);
    QFETCH(int, pieces);
    QFETCH(double, radius);
    QFETCH(double, mu);
    constexpr double kCylinder = 0.03, kHalf = 0.03, kDepth = 1e-3, kSpeed = 0.05;
    SoupBuilder builder;
    const auto corner = [&](int i, int k) {
        const double angle = 2 * EIGEN_PI * (i % strips) / strips;
        return Vec3(kCylinder * std::cos(angle), kCylinder * std::sin(angle),
                    -kHalf + 2 * kHalf * k / pieces);
    };
    for (int k = 0; k < pieces; ++k)
        for (int i = 0; i < strips; ++i)
            builder.triangle(corner(i, k), corner(i + 1, k), corner(i + 1, k + 1))
                .triangle(corner(i, k), corner(i + 1, k + 1), corner(i, k + 1));
    ProxyRig rig(builder.build(), radius, rough(mu + 0.1, mu));
    const double way = kCylinder + radius - kDepth, z = 1.3e-3;
    const auto at = [&](double angle, double height) {
        return Vec3(height * std::cos(angle), height * std::sin(angle), z);
    };
    rig.startAt(at(0.123, kCylinder + 2 * radius));
    rig.walk(at(0.123, kCylinder + 2 * radius), at(0.123, way), 5e-5);
    std::vector<double> ratios;
    double longest = 0, worstGap = 0;
    int stops = 0;
    const double step = kSpeed * kMillisecond / way;
    for (double angle = 0.123; angle < 2.5; angle += step) {
        const Vec3 finger = at(angle, way), before = rig.position();
        rig.step(finger);
        if (angle < 0.3) continue;
        const Vec3 nearest = nearestOf(rig.soup(), rig.position()), away = rig.position() - nearest;
        worstGap = std::max(worstGap, std::abs(away.norm() - radius));
        ratios.push_back(ratioOf(rig.position() - finger, away));
        const double went = (rig.position() - before).norm();
        stops += went < 0.01 * kSpeed * kMillisecond;
        longest = std::max(longest, went);
    }
    std::ranges::sort(ratios);
    const auto part = [&](double p) { return ratios[std::size_t(p * double(ratios.size() - 1))]; };
    qInfo("gap %.4f um, ratio %.5f %.5f %.5f %.5f %.5f, %d stops, longest %.2f um", 1e6 * worstGap, part(0),
          part(0.01), part(0.5), part(0.99), part(1), stops, 1e6 * longest);
    QCOMPARE_LT(worstGap, 1e-8);
    QCOMPARE(stops, 0);
    // Over a crease the cone turns by as much as the strips lean, which lets the proxy go on that far at
    // once; and as far as the ratio may be off.
    constexpr double kOff = 0.006;
    const double lean = 2 * EIGEN_PI / strips, turned = (1 + mu * mu) * lean * (1 + radius / kCylinder);
    QCOMPARE_LT(longest, kSpeed * kMillisecond + kDepth * (turned + 1.1 * kOff * mu));
    COMPARE_NEAR(part(0.5), mu, 1e-4 * mu, "");
    COMPARE_NEAR(part(0), mu, kOff * mu, "");
    COMPARE_NEAR(part(1), mu, 0.001 * mu, "");
}

TACTUM_TEST(FrictionCurvedTest)

} // namespace test_friction_curved

#include "test_friction_curved.moc"
