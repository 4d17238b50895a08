// How primitives are put into leaves, and how tight the spheres around these are.
//
// What would show that a test here is wrong: the best cut and the smallest sphere are found by trying all
// there are, from the definition, without the order or the ways that the code takes; the plane's figures are
// geometry.
#include <algorithm>
#include <cmath>
#include <set>

#include <QTest>

#include "core/collision/leaf_packing.h"
#include "core/collision/sphere_tree.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_leaf_packing {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr std::size_t kFull = 8;

std::vector<LeafSphere> randomSpheres(Rng& rng, std::size_t count, const Vec3& size) {
    std::vector<LeafSphere> spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 at = inBox(rng, 1).cwiseProduct(size);
        spheres.push_back({at.cast<float>(), float(uniform(rng, 0.001, 0.1)), Index(i), 1});
    }
    return spheres;
}

double costOf(std::span<const LeafSphere> part) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const LeafSphere& s : part) {
        low = low.cwiseMin((s.centre.cast<double>().array() - double(s.radius)).matrix());
        high = high.cwiseMax((s.centre.cast<double>().array() + double(s.radius)).matrix());
    }
    return (high - low).squaredNorm() * std::ceil(double(part.size()) / kFull);
}

double costOf(std::span<const LeafSphere> all, std::size_t cut) {
    return costOf(all.first(cut)) + costOf(all.subspan(cut));
}

// Of every cut along the two longer axes that fills one side's leaves.
double leastCost(std::vector<LeafSphere> spheres) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const LeafSphere& s : spheres) {
        low = low.cwiseMin((s.centre.cast<double>().array() - double(s.radius)).matrix());
        high = high.cwiseMax((s.centre.cast<double>().array() + double(s.radius)).matrix());
    }
    int shortest = 0;
    (high - low).minCoeff(&shortest);
    double least = 1e300;
    for (const int axis : {0, 1, 2}) {
        if (axis == shortest) continue;
        std::ranges::sort(spheres, {}, [axis](const LeafSphere& s) { return s.centre[axis]; });
        for (std::size_t cut = 1; cut < spheres.size(); ++cut)
            if (cut % kFull == 0 || (spheres.size() - cut) % kFull == 0)
                least = std::min(least, costOf(spheres, cut));
    }
    return least;
}

// A square plane of 2 n^2 triangles in cells of edge 1.
Soup plane(int n) {
    SoupBuilder builder;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const Vec3 a(i, k, 0), b(i + 1, k, 0), c(i + 1, k + 1, 0), d(i, k + 1, 0);
            builder.triangle(a, b, c).triangle(a, c, d);
        }
    return builder.build();
}

// Of the spheres that two, three or four of the points give, the smallest that holds them all.
double smallestRadius(const std::vector<Vec3>& points) {
    double least = 1e300;
    const auto tried = [&](const Vec3& centre) {
        double radius = 0;
        for (const Vec3& p : points)
            radius = std::max(radius, (p - centre).norm());
        least = std::min(least, radius);
    };
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            tried(0.5 * (points[i] + points[j]));
            for (std::size_t k = j + 1; k < n; ++k) {
                // The centre lies in the plane of the three, as far from each.
                const Vec3 ab = points[j] - points[i], ac = points[k] - points[i];
                Eigen::Matrix3d rows;
                rows << ab.transpose(), ac.transpose(), ab.cross(ac).transpose();
                tried(points[i] + rows.inverse() * Vec3(ab.squaredNorm() / 2, ac.squaredNorm() / 2, 0));
                for (std::size_t l = k + 1; l < n; ++l) {
                    const Vec3 ad = points[l] - points[i];
                    rows << ab.transpose(), ac.transpose(), ad.transpose();
                    tried(points[i] + rows.inverse() * Vec3(ab.squaredNorm() / 2, ac.squaredNorm() / 2,
                                                            ad.squaredNorm() / 2));
                }
            }
        }
    return least;
}

} // namespace

class LeafPackingTest : public QObject {
    Q_OBJECT

private slots:
    void noOtherCutIsBetter() {
        Rng rng(3);
        for (int round = 0; round < 400; ++round) {
            const std::size_t count = kFull + 1 + rng() % (kMostPacked - kFull);
            const Vec3 size(uniform(rng, 0.2, 2), uniform(rng, 0.2, 2), uniform(rng, 0.01, 2));
            const std::vector<LeafSphere> before = randomSpheres(rng, count, size);
            std::vector<LeafSphere> spheres = before;
            const std::size_t cut = packLeaves(spheres, kFull);
            QCOMPARE_GT(cut, 0);
            QCOMPARE_LT(cut, count);
            QVERIFY2(cut % kFull == 0 || (count - cut) % kFull == 0,
                     qPrintable(QString("%1 of %2").arg(cut).arg(count)));
            std::set<Index> left;
            for (const LeafSphere& s : spheres) {
                left.insert(s.triangle);
                QCOMPARE(s.centre, before[s.triangle].centre);
                QCOMPARE(s.radius, before[s.triangle].radius);
            }
            QCOMPARE(left.size(), count);
            const double least = leastCost(before);
            COMPARE_NEAR(costOf(spheres, cut), least, 1e-5 * least, "m2");
        }
    }

    void whatIsBeyondNumbersIsDividedAllTheSame() {
        Rng rng(4);
        std::vector<LeafSphere> spheres = randomSpheres(rng, 20, Vec3::Ones());
        for (LeafSphere& s : spheres)
            s.centre *= 1e30f;
        const std::size_t cut = packLeaves(spheres, kFull);
        QCOMPARE_GT(cut, 0);
        QCOMPARE_LT(cut, spheres.size());
        std::set<Index> left;
        for (const LeafSphere& s : spheres)
            left.insert(s.triangle);
        QCOMPARE(left.size(), spheres.size());
    }

    // Eight triangles are two by two cells, and half their diagonal is as small as a sphere around them can
    // be.
    void leavesOfAPlaneAreFullSquares() {
        const SphereTree tree(*plane(32));
        QCOMPARE(tree.leaves().size(), std::size_t(2 * 32 * 32) / kFull);
        for (const SphereTree::Node& node : tree.nodes())
            for (int i = 0; i < SphereTree::kWidth; ++i)
                if (node.radius[i] >= 0 && node.child[i] < 0)
                    COMPARE_NEAR(double(node.radius[i]), std::sqrt(2.0), 1e-5, "m");
    }

    void spheresAreNearlyTheSmallest() {
        Rng rng(5);
        int tried = 0;
        double sum = 0;
        for (int round = 0; round < 80; ++round) {
            SoupBuilder builder;
            std::vector<Vec3> corners;
            for (int k = 0; k < 4; ++k) {
                const Vec3 at = inBox(rng, 1);
                corners.insert(corners.end(), {at, at + inBox(rng, 0.3), at + inBox(rng, 0.3)});
                builder.triangle(corners[corners.size() - 3], corners[corners.size() - 2], corners.back());
            }
            const SphereTree tree(*builder.build());
            // One leaf alone, if none of them is long.
            if (tree.leaves().size() != 1 || tree.nodes().size() != 1) continue;
            const double ratio = double(tree.nodes().front().radius[0]) / smallestRadius(corners);
            QCOMPARE_GE(ratio, 1 - 1e-6);
            QCOMPARE_LE(ratio, 1.08);
            sum += ratio;
            ++tried;
        }
        QCOMPARE_GE(tried, 40);
        QCOMPARE_LE(sum / tried, 1.03);
    }
};

TACTUM_TEST(LeafPackingTest)

} // namespace test_leaf_packing

#include "test_leaf_packing.moc"
