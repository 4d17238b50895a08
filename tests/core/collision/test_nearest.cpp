// The nearest part of a mesh against a search through all triangles, and inside against a closed form.
#include <map>

#include <Eigen/LU>
#include <QTest>

#include "core/collision/nearest.h"
#include "core/geometry/closed.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_nearest {

using namespace tactum;
using namespace tactum::test;

namespace {

CollisionMesh meshOf(const Soup& soup) {
    return {soup, SphereTree(*soup), isClosed(*soup)};
}

double distanceByAll(const TriangleSoup& soup, const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        least = std::min(least, (closestPoint(triangleOf(soup, i), p).point - p).norm());
    return least;
}

Soup turnedAround(const TriangleSoup& soup) {
    auto result = std::make_shared<TriangleSoup>(soup);
    for (auto& corners : result->triangles)
        std::swap(corners[1], corners[2]);
    return result;
}

/// A ball whose corners lie at random distances: spikes, pits and saddles, each ray from its centre meets it
/// once.
Soup crumpledBall(Rng& rng) {
    auto soup = std::make_shared<TriangleSoup>(*ball(1, 1));
    std::map<std::array<double, 3>, double> distances; // the same for corners at the same place
    for (Vec3& p : soup->positions) {
        const std::array<double, 3> place{p.x(), p.y(), p.z()};
        p *= distances.try_emplace(place, uniform(rng, 0.3, 1.5)).first->second;
    }
    return soup;
}

/// How far the surface of a star-shaped body lies in a direction.
double reachOf(const TriangleSoup& soup, const Vec3& way) {
    double reach = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle t = triangleOf(soup, i);
        Mat3 cone;
        cone << t.a, t.b, t.c;
        const Vec3 parts =
            cone.inverse() * way; // way = parts of the corners: inside the cone none is negative
        if (parts.minCoeff() >= -1e-12) reach = std::max(reach, 1 / parts.sum());
    }
    return reach;
}

} // namespace

class TestNearest : public QObject {
    Q_OBJECT

private slots:
    void findsWhatASearchThroughAllFinds() {
        Rng rng(71);
        for (int soup = 0; soup < 200; ++soup) {
            const CollisionMesh mesh = meshOf(randomSoup(rng, 1 + int(rng() % 300), 1));
            for (int i = 0; i < 50; ++i) {
                const Vec3 p = inBox(rng, 2);
                const double distance = distanceByAll(*mesh.soup, p);
                const Nearest near = nearestOn(mesh, p);
                QCOMPARE_LE(std::abs(near.distance - distance), 1e-8 * distance);
                QCOMPARE_LE(std::abs((near.point - p).norm() - distance), 1e-8 * distance);
                QVERIFY(std::isinf(nearestOn(mesh, p, 0.999 * distance).distance));
                QCOMPARE_LE(std::abs(nearestOn(mesh, p, 1.001 * distance).distance - distance),
                            1e-8 * distance);
            }
        }
    }

    void nothingIsNearAnEmptyMesh() {
        QVERIFY(std::isinf(nearestOn(meshOf(SoupBuilder().build()), Vec3::Zero()).distance));
    }

    void whatIsNotFeltIsNotThere() {
        TriangleSoup two = *sheet(1);
        const Index half = Index(two.triangles.size() / 2);
        for (Index i = half; i < two.triangles.size(); ++i)
            two.surfaceOf[i] = 1;
        const CollisionMesh mesh = meshOf(std::make_shared<const TriangleSoup>(two));
        const std::array<Sides, 2> first{Sides::Both, Sides::None}, none{Sides::None, Sides::None};
        Rng rng(73);
        for (int i = 0; i < 100; ++i) {
            const Vec3 p = inBox(rng, 1);
            QCOMPARE_LT(nearestOn(mesh, p, 10, first).triangle, half);
            QVERIFY(std::isinf(nearestOn(mesh, p, 10, none).distance));
        }
    }

    void theSideTellsInsideFromOutside() {
        Rng rng(72);
        int corners = 0;
        for (int body = 0; body < 100; ++body) {
            const CollisionMesh mesh = meshOf(crumpledBall(rng));
            QVERIFY(mesh.closed);
            for (int i = 0; i < 100; ++i) {
                const Vec3 way = direction(rng);
                const double part = uniform(rng, 0.2, 2);
                if (std::abs(part - 1) < 1e-3) continue;
                const Nearest near = nearestOn(mesh, part * reachOf(*mesh.soup, way) * way);
                QCOMPARE_EQ(near.front > 0, part > 1);
                const Triangle t = triangleOf(*mesh.soup, near.triangle);
                corners += near.point == t.a || near.point == t.b || near.point == t.c;
            }
        }
        QCOMPARE_GT(corners, 500);
    }

    // Hardly below the plane of a face of a box, and far beside it: an edge of that face is as far as the
    // face that is the nearest, but for what a double hardly tells.
    void theSideIsRightFromAfar() {
        Rng rng(74);
        const CollisionMesh mesh = meshOf(cube(1));
        QVERIFY(mesh.closed);
        int wrong = 0;
        for (int i = 0; i < 30000; ++i) {
            const int flat = i % 3, away = (flat + 1 + i / 3 % 2) % 3, other = 3 - flat - away;
            Vec3 p;
            p[flat] = (rng() % 2 ? 1 : -1) * (1 - std::pow(10, uniform(rng, -12, -1)));
            p[away] = (rng() % 2 ? 1 : -1) * (1 + std::pow(10, uniform(rng, -3, 3)));
            p[other] = uniform(rng, -1.5, 1.5);
            const Nearest near = nearestOn(mesh, p);
            const double right = (p - p.cwiseMax(-1).cwiseMin(1)).norm();
            wrong += !(near.front > 0);
            QCOMPARE_LE(std::abs(near.distance - right), 1.1e-9 * right);
        }
        QCOMPARE(wrong, 0);
    }

    void onlyWhatHasAnInsideIsClosed() {
        QVERIFY(isClosed(*ball(1, 1)));
        QVERIFY(!isClosed(*turnedAround(*ball(1, 1)))); // its front is inside
        QVERIFY(!isClosed(*sheet(1)));
        QVERIFY(!isClosed(*plate(1, 0.1)));
        QVERIFY(!isClosed(*pipe(1, 1, 12)));
        QVERIFY(!isClosed(*SoupBuilder().build()));
        QVERIFY(!isClosed(*SoupBuilder().segment(Vec3::Zero(), Vec3::UnitX()).build()));
        TriangleSoup torn = *ball(1, 2);
        torn.triangles.pop_back();
        QVERIFY(!isClosed(torn));
        torn = *ball(1, 2);
        std::swap(torn.triangles[7][0], torn.triangles[7][1]);
        QVERIFY(!isClosed(torn));
    }
};

TACTUM_TEST(TestNearest)

} // namespace test_nearest

#include "test_nearest.moc"
