// Where a mapping's frame goes on a surface: planes of known normals, a tube and a ball of known radii. Wrong
// itself if a shape here had another middle or radius than its formula.
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/document/layer_mapping.h"

namespace test_mapping_fit {

using namespace tactum;
using namespace tactum::test;

namespace {

void addQuad(TriangleSoup& soup, const std::array<Vec3, 4>& corners, Index surface) {
    const auto first = Index(soup.positions.size());
    soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 3});
    soup.surfaceOf.insert(soup.surfaceOf.end(), 2, surface);
}

/// A rectangle about `middle` that spans u and v, its normal u x v; with something else far away as another
/// surface.
TriangleSoup plane(const Vec3& middle, const Vec3& u, const Vec3& v) {
    TriangleSoup soup;
    const Vec3 away(5, 5, 5);
    addQuad(soup, {away, away + v, away + u + v, away + u}, 0);
    addQuad(soup, {middle - u - v, middle + u - v, middle + u + v, middle - u + v}, 1);
    return soup;
}

/// Upright, without caps; 64 sides, all corners `radius` from the axis.
TriangleSoup tube(const Vec3& middle, double radius, double height) {
    TriangleSoup soup;
    const auto at = [&](int i, double y) {
        const double angle = 2 * std::numbers::pi * i / 64;
        return Vec3(middle + Vec3(radius * std::cos(angle), y, radius * std::sin(angle)));
    };
    for (int i = 0; i < 64; ++i)
        addQuad(soup, {at(i, -height / 2), at(i, height / 2), at(i + 1, height / 2), at(i + 1, -height / 2)},
                0);
    return soup;
}

TexturePattern fittedAs(TextureMapping mapping, const TriangleSoup& soup, Index surface) {
    TexturePattern pattern;
    pattern.mapping = mapping;
    pattern.frame = {Quat(0.5, 0.5, 0.5, 0.5), Vec3(9, 9, 9)}; // of another surface
    return fitted(pattern, soup, surface);
}

Vec3 turned(const TexturePattern& pattern, const Vec3& axis) {
    return pattern.frame.rotation * axis;
}

} // namespace

class TestMappingFit : public QObject {
    Q_OBJECT
private slots:
    /// Looks along the normal, from the middle, as upright as it can.
    void aPlaneLooksAlongTheNormal() {
        const Vec3 middle(1, 2, 3);
        for (const auto& [u, v] : {std::pair(Vec3(0.2, 0, 0), Vec3(0, 0.1, 0)),
                                   {Vec3(0, 0, -0.1), Vec3(0, 0.3, 0)},
                                   {Vec3(0.1, 0.1, 0), Vec3(0, 0.1, 0.2)},
                                   {Vec3(0.1, 0, 0), Vec3(0, 0, -0.1)}}) {
            const TexturePattern pattern = fittedAs(TextureMapping::Planar, plane(middle, u, v), 1);
            const Vec3 normal = u.cross(v).normalized();
            COMPARE_NEAR((pattern.frame.translation - middle).norm(), 0, 1e-12, "m");
            COMPARE_NEAR((turned(pattern, Vec3::UnitZ()) - normal).norm(), 0, 1e-12, "");
            // y is as much of the world's up as there is across the normal; of what lies flat it is away from
            // who sits there.
            const Vec3 up = std::abs(normal.y()) < 0.9 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
            const Vec3 expected = (up - up.dot(normal) * normal).normalized();
            COMPARE_NEAR((turned(pattern, Vec3::UnitY()) - expected).norm(), 0, 1e-12, "");
            COMPARE_NEAR(pattern.frame.rotation.norm(), 1, 1e-12, "");
            QCOMPARE(pattern.radius, kTextureRadius.initial); // of no plane
        }
    }

    /// What looks to all sides has no normal: the frame stands as the body.
    void aPlaneHasNothingToLookAlong() {
        const TexturePattern pattern = fittedAs(TextureMapping::Planar, tube({1, 2, 3}, 0.1, 0.2), 0);
        COMPARE_NEAR((pattern.frame.translation - Vec3(1, 2, 3)).norm(), 0, 1e-12, "m");
        QVERIFY(pattern.frame.rotation.isApprox(Quat::Identity()));
        // Two walls of which one is 1.8 (1.9) times the other: 0.286 (0.310) of the area looks to one side.
        for (const auto& [larger, looks] : {std::pair(1.8, false), {1.9, true}}) {
            TriangleSoup walls;
            addQuad(walls, {Vec3(0, 0, 0), Vec3(larger, 0, 0), Vec3(larger, 1, 0), Vec3(0, 1, 0)}, 0);
            addQuad(walls, {Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(1, 1, 1), Vec3(1, 0, 1)}, 0);
            QCOMPARE(fittedAs(TextureMapping::Planar, walls, 0).frame.rotation.isApprox(Quat::Identity()),
                     true);
            // ... z is the normal of the first, so that both look alike there; beside it they differ.
            for (Vec3& p : walls.positions)
                p = Vec3(p.z(), p.y(), -p.x());
            QCOMPARE(turned(fittedAs(TextureMapping::Planar, walls, 0), Vec3::UnitZ())
                         .isApprox(Vec3::UnitX(), 1e-9),
                     looks);
        }
    }

    void aCylinderStandsUprightInTheMiddle() {
        const TexturePattern pattern = fittedAs(TextureMapping::Cylindrical, tube({1, 2, 3}, 0.07, 0.2), 0);
        COMPARE_NEAR((pattern.frame.translation - Vec3(1, 2, 3)).norm(), 0, 1e-12, "m");
        COMPARE_NEAR((turned(pattern, Vec3::UnitZ()) - Vec3::UnitY()).norm(), 0, 1e-12, "");
        COMPARE_NEAR((turned(pattern, Vec3::UnitY()) + Vec3::UnitZ()).norm(), 0, 1e-12, "");
        COMPARE_NEAR(pattern.radius, 0.07, 1e-12, "m");
    }

    /// From the middle to the corners, all of them as far.
    void aSphereIsAsLargeAsTheSurface() {
        const TexturePattern pattern = fittedAs(TextureMapping::Spherical, tube({1, 2, 3}, 0.03, 0.08), 0);
        COMPARE_NEAR((turned(pattern, Vec3::UnitZ()) - Vec3::UnitY()).norm(), 0, 1e-12, "");
        COMPARE_NEAR(pattern.radius, 0.05, 1e-12, "m"); // 3, 4, 5
        QCOMPARE(fittedAs(TextureMapping::Spherical, tube({0, 0, 0}, 1e6, 1), 0).radius,
                 kTextureRadius.maximum);
    }

    void othersStayAsTheyAre() {
        const TriangleSoup soup = plane({1, 2, 3}, {0.1, 0, 0}, {0, 0.1, 0});
        for (const TextureMapping mapping : {TextureMapping::Uv, TextureMapping::UvUnit}) {
            TexturePattern pattern;
            pattern.mapping = mapping;
            QVERIFY(fitted(pattern, soup, 1) == pattern);
        }
        TexturePattern pattern;
        pattern.mapping = TextureMapping::Planar;
        QVERIFY(fitted(pattern, soup, 2) == pattern); // a surface without triangles
        const TexturePattern all = fittedAs(TextureMapping::Triplanar, soup, 1);
        COMPARE_NEAR((all.frame.translation - Vec3(1, 2, 3)).norm(), 0, 1e-12, "m");
        QVERIFY(all.frame.rotation.isApprox(Quat::Identity()));
    }
};

TACTUM_TEST(TestMappingFit)

} // namespace test_mapping_fit

#include "test_mapping_fit.moc"
