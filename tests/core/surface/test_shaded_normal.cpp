// The normal that a shaded surface is felt with, over faces, edges and corners of its C-obstacle.

#include <QTest>

#include "core/surface/shaded_normal.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_shaded_normal {

using namespace tactum;
using namespace tactum::test;

namespace {

std::shared_ptr<const SmoothNormals> normalsOf(const Soup& soup) {
    return compileNormals({true}, soup).value();
}

Soup shaded(const Soup& soup, const std::vector<Vec3>& normals) {
    auto result = std::make_shared<TriangleSoup>(*soup);
    for (const Vec3& normal : normals)
        result->cornerNormals.push_back(normal.normalized().cast<float>());
    return result;
}

double degrees(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

// What is felt by a proxy whose centre is there, of one triangle.
Vec3 feltAt(const SmoothNormals& normals, Index triangle, const Vec3& centre) {
    const Triangle t = triangleOf(*normals.soup, triangle);
    const ClosestPoint closest = closestPoint(t, centre);
    return shadedNormal(normals, triangle, t, closest, (centre - closest.point).normalized());
}

// A ridge along y between two triangles; its corner normals agree, and are not half-way between the facets.
Soup ridge() {
    SoupBuilder builder;
    const Vec3 a(0, -0.01, 0), b(0, 0.01, 0);
    builder.triangle(a, Vec3(0.02, 0, -0.005), b).triangle(b, Vec3(-0.02, 0, -0.012), a);
    const Vec3 na(0.1, 0.1, 1), nb(-0.2, 0, 1);
    return shaded(builder.build(), {na, {0.3, 0, 1}, nb, nb, {-0.6, 0, 1}, na});
}

} // namespace

class ShadedNormalTest : public QObject {
    Q_OBJECT

private slots:
    void isInterpolatedOnTheProxysSide();
    void goesOverAnEdgeWithoutAJump();
    void goesAroundAFreeEdgeWithoutAJump();
    void goesAroundACornerWithoutAJump();
    void aMirroredNeighbourIsExpectedAtASeam();
    void aFlatFacetIsFeltAsItIs();
    void seamsAreFoundWhereNormalsPart();
    void nothingLeansTooFar();
};

void ShadedNormalTest::isInterpolatedOnTheProxysSide() {
    const auto normals = normalsOf(ridge());
    const Triangle t = triangleOf(*normals->soup, 0);
    const Vec3 weights(0.2, 0.5, 0.3), at = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
    const Vec3 up = (t.b - t.a).cross(t.c - t.a).normalized();
    Vec3 expected = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        expected += weights[k] * normals->corners[std::size_t(k)].cast<double>();
    for (double side : {1.0, -1.0}) {
        const Vec3 felt = feltAt(*normals, 0, at + side * 1e-3 * up);
        QVERIFY2(degrees(felt, std::copysign(1.0, side * expected.dot(up)) * expected) < 1e-6,
                 qPrintable(QString::number(degrees(felt, expected))));
        QCOMPARE_GT(felt.dot(side * up), 0);
    }
}

// From one facet's inside over the edge to the other's, the contact now on one, now on the other: one normal.
void ShadedNormalTest::goesOverAnEdgeWithoutAJump() {
    const auto normals = normalsOf(ridge());
    const double r = 1e-3;
    Vec3 before = Vec3::Zero();
    double worst = 0, parted = 0;
    for (int i = 0; i <= 4000; ++i) {
        const double x = 2e-3 * (1 - i / 2000.0), y = 0.003;
        const auto nearest = [&](Index k, const Vec3& p) {
            return (p - closestPoint(triangleOf(*normals->soup, k), p).point).norm();
        };
        // The height at which the proxy touches.
        double low = -1.1e-3, high = 0.01;
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            (std::min(nearest(0, {x, y, middle}), nearest(1, {x, y, middle})) < r ? low : high) = middle;
        }
        const Vec3 centre(x, y, high);
        const Index touched = nearest(0, centre) <= nearest(1, centre) ? 0 : 1;
        const Vec3 felt = feltAt(*normals, touched, centre);
        if (std::abs(nearest(0, centre) - nearest(1, centre)) < 1e-12)
            parted = std::max(parted, degrees(feltAt(*normals, 0, centre), feltAt(*normals, 1, centre)));
        if (i > 0) worst = std::max(worst, degrees(before, felt));
        before = felt;
    }
    QVERIFY2(worst < 0.1, qPrintable(QString("a jump of %1 degrees").arg(worst)));
    QVERIFY2(parted < 1e-4, qPrintable(QString("%1 degrees apart").arg(parted)));
}

// Around the end of a sheet, from its upper to its lower side, whichever way its normals lean.
void ShadedNormalTest::goesAroundAFreeEdgeWithoutAJump() {
    for (double lean : {-0.7, -0.3, 0.0, 0.3, 0.7, 1.5}) {
        SoupBuilder builder;
        builder.triangle({0, -0.01, 0}, {0, 0.01, 0}, {-0.02, 0, 0});
        const Vec3 n(lean, 0.1, 1);
        const auto normals = normalsOf(shaded(builder.build(), {n, n, n}));
        Vec3 before = Vec3::Zero();
        double worst = 0;
        for (int i = 0; i <= 2000; ++i) {
            // Over the upper side, around, and under the lower side.
            const double s = i / 2000.0 * 3 - 1, angle = std::numbers::pi * std::clamp(s, 0.0, 1.0);
            const double inside = std::max({-s, s - 1, 0.0}) * 2e-3;
            const Vec3 felt =
                feltAt(*normals, 0, Vec3(1e-3 * std::sin(angle) - inside, 0.001, 1e-3 * std::cos(angle)));
            if (i > 0) worst = std::max(worst, degrees(before, felt));
            before = felt;
        }
        QVERIFY2(worst < 2, qPrintable(QString("leaning %1: a jump of %2 degrees").arg(lean).arg(worst)));
    }
}

void ShadedNormalTest::goesAroundACornerWithoutAJump() {
    SoupBuilder builder;
    builder.triangle({0, 0, 0}, {-0.02, 0.01, 0}, {-0.02, -0.01, 0});
    const Vec3 n(0.3, 0.1, 1);
    const auto normals = normalsOf(shaded(builder.build(), {n, n, n}));
    Rng rng(5);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = direction(rng), b = (a + 1e-4 * direction(rng)).normalized();
        const double apart = degrees(feltAt(*normals, 0, 1e-3 * a), feltAt(*normals, 0, 1e-3 * b));
        QCOMPARE_LT(apart, 0.2);
    }
}

// Between facets that lie mirrored but share nothing, both feel the same normal.
void ShadedNormalTest::aMirroredNeighbourIsExpectedAtASeam() {
    SoupBuilder builder;
    const Vec3 a(0, -0.01, 0), b(0, 0.01, 0), gap(0, 0, 1e-5);
    builder.triangle(a, Vec3(0.02, 0, -0.006), b).triangle(b + gap, Vec3(-0.02, 0, -0.006) + gap, a + gap);
    const Vec3 n(0, 0, 1);
    const auto normals = normalsOf(shaded(builder.build(), {n, {0.3, 0, 1}, n, n, {-0.3, 0, 1}, n}));
    QCOMPARE_NE(normals->seams[0], 0);
    for (double angle : {-0.29, -0.1, 0.0, 0.1, 0.29}) { // within the facets' normals
        const Vec3 centre(1e-3 * std::sin(angle), 0, 1e-3 * std::cos(angle));
        QCOMPARE_LT(degrees(feltAt(*normals, 0, centre), n), 1e-3);
        QCOMPARE_LT(degrees(feltAt(*normals, 1, centre + gap), n), 1e-3);
    }
}

// Beyond the crease angle the corners have the normal of their facet: nothing is to be rounded.
void ShadedNormalTest::aFlatFacetIsFeltAsItIs() {
    SoupBuilder builder;
    builder.triangle({0, -0.01, 0}, {0, 0.01, 0}, {-0.02, 0, 0});
    const Vec3 n = Vec3::UnitZ();
    const auto normals = normalsOf(shaded(builder.build(), {n, n, n}));
    for (double angle = -0.4; angle < 1.5; angle += 0.01) {
        const Vec3 out(std::sin(angle), 0, std::cos(angle)), foot(angle < 0 ? -0.002 : 0, 0.001, 0);
        const Vec3 right = angle < 0 ? n : out;
        QCOMPARE_LT(degrees(feltAt(*normals, 0, foot + 1e-3 * right), right), 1e-4);
    }
}

void ShadedNormalTest::seamsAreFoundWhereNormalsPart() {
    const Soup smooth = ridge();
    // Corner 1 of both triangles is off the ridge: the edge opposite to it goes on, all others end.
    const auto normals = normalsOf(smooth);
    for (std::uint8_t seams : normals->seams)
        QCOMPARE(int(seams), 0b111101);
    auto creased = std::make_shared<TriangleSoup>(*smooth);
    creased->cornerNormals[0] = Eigen::Vector3f(0.5f, 0, 1).normalized();
    const auto parted = normalsOf(creased);
    for (std::uint8_t seams : parted->seams)
        QCOMPARE(int(seams), 0b111111);
    auto flipped = std::make_shared<TriangleSoup>(*smooth);
    for (int k = 0; k < 3; ++k)
        flipped->cornerNormals[std::size_t(k)] *= -1;
    const auto turned = normalsOf(flipped);
    for (std::uint8_t seams : turned->seams)
        QCOMPARE(int(seams), 0b111101);
    // Closed, and every corner has the same normal.
    const auto whole = normalsOf(shaded(ball(0.01, 1), std::vector<Vec3>(240, Vec3::UnitX())));
    for (std::uint8_t seams : whole->seams)
        QCOMPARE(int(seams), 0);
}

void ShadedNormalTest::nothingLeansTooFar() {
    Rng rng(6);
    for (int i = 0; i < 20000; ++i) {
        SoupBuilder builder;
        if (i % 10 == 0)
            builder.segment(inBox(rng, 1), inBox(rng, 1));
        else
            builder.triangle(inBox(rng, 1), inBox(rng, 1), inBox(rng, 1));
        const auto normals =
            normalsOf(shaded(builder.build(), {direction(rng), direction(rng), direction(rng)}));
        const Vec3 centre = inBox(rng, 2), felt = feltAt(*normals, 0, centre);
        const Vec3 away = (centre - closestPoint(triangleOf(*normals->soup, 0), centre).point).normalized();
        QVERIFY(felt.allFinite());
        COMPARE_NEAR(felt.norm(), 1, 1e-12, "");
        QCOMPARE_GE(felt.dot(away), kMaxLean - 1e-12);
    }
}

TACTUM_TEST(ShadedNormalTest)

} // namespace test_shaded_normal

#include "test_shaded_normal.moc"
