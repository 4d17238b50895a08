// The nearest part of a mesh against a search through all triangles, and inside against a closed form.
#include <QtTest>

#include "core/collision/nearest.h"
#include "core/geometry/closed.h"
#include "tests/support/soups.h"

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

/// A leaning spike: where it points, the largest of its faces shows its back.
Soup spike() {
    const Vec3 tip(0, 0, 1);
    const std::vector<Vec3> base{{0.9, 0, 0}, {-0.1, 0.1, 0}, {-0.1, -0.1, 0}};
    SoupBuilder builder;
    for (std::size_t i = 0; i < 3; ++i)
        builder.triangle(base[i], base[(i + 1) % 3], tip);
    return builder.triangle(base[0], base[2], base[1]).build();
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
                QVERIFY(std::abs(near.distance - distance) <= 1e-8 * distance);
                QVERIFY(std::abs((near.point - p).norm() - distance) <= 1e-8 * distance);
                QVERIFY(std::isinf(nearestOn(mesh, p, 0.999 * distance).distance));
                QVERIFY(std::abs(nearestOn(mesh, p, 1.001 * distance).distance - distance) <=
                        1e-8 * distance);
            }
        }
    }

    void nothingIsNearAnEmptyMesh() {
        QVERIFY(std::isinf(nearestOn(meshOf(SoupBuilder().build()), Vec3::Zero()).distance));
    }

    void theSideTellsInsideFromOutside() {
        Rng rng(72);
        const CollisionMesh sphere = meshOf(ball(1, 2)), thorn = meshOf(spike());
        QVERIFY(sphere.closed && thorn.closed);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 way = direction(rng);
            QVERIFY(nearestOn(sphere, uniform(rng, 0, 0.93) * way).front < 0);
            QVERIFY(nearestOn(sphere, uniform(rng, 1.01, 3) * way).front > 0);
            QVERIFY(nearestOn(thorn, Vec3(0, 0, 1) + uniform(rng, 0.001, 0.1) * Vec3(0.5, 0, 1)).front > 0);
        }
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

QTEST_APPLESS_MAIN(TestNearest)
#include "test_nearest.moc"
