// The hierarchy against a loop over all triangles.

#include <QTest>

#include "core/collision/leaf_cover.h"
#include "core/collision/sphere_tree.h"
#include "core/collision/sweep_memory.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_sphere_tree {

using namespace tactum;
using namespace tactum::test;

namespace {

template <class Array> Vec3 pointOf(const Array& x, const Array& y, const Array& z, int i) {
    return {x[i], y[i], z[i]};
}

// Whether a child's sphere and its pair of planes hold a point, to within the rounding that the sweep adds.
bool holds(const SphereTree::Node& node, int i, const Vec3& p) {
    const Vec3 way = p - pointOf(node.x, node.y, node.z, i);
    const double radius = node.radius[i], slack = 1e-6 * radius + 1e-12;
    const double height = pointOf(node.nx, node.ny, node.nz, i).dot(way) - double(node.offset[i]);
    return way.norm() <= radius + slack && std::abs(height) <= double(node.thickness[i]) + slack;
}

// Whether a leaf has a part of the triangle at a point; its corners are rounded to floats.
bool hasPart(const SphereTree::Leaf& leaf, Index triangle, const Vec3& p) {
    for (int i = 0; i < SphereTree::kWidth; ++i) {
        const Triangle part{pointOf(leaf.ax, leaf.ay, leaf.az, i), pointOf(leaf.bx, leaf.by, leaf.bz, i),
                            pointOf(leaf.cx, leaf.cy, leaf.cz, i)};
        const double slack = 4e-7 * (1 + p.cwiseAbs().maxCoeff());
        if (leaf.triangle[i] == triangle && (closestPoint(part, p).point - p).norm() <= slack) return true;
    }
    return false;
}

// Whether a descent toward a point of a triangle ends at that triangle.
bool reaches(const SphereTree& tree, const SphereTree::Node& node, const Vec3& p, Index triangle) {
    for (int i = 0; i < SphereTree::kWidth; ++i) {
        if (node.radius[i] < 0 || !holds(node, i, p)) continue;
        const std::int32_t child = node.child[i];
        if (child < 0 ? hasPart(tree.leaves()[std::size_t(~child)], triangle, p)
                      : reaches(tree, tree.nodes()[std::size_t(child)], p, triangle))
            return true;
    }
    return false;
}

int depthOf(const SphereTree& tree, std::int32_t index = 0) {
    if (index < 0) return 0;
    int deepest = 0;
    const SphereTree::Node& node = tree.nodes()[std::size_t(index)];
    for (int i = 0; i < SphereTree::kWidth; ++i)
        if (node.radius[i] >= 0) deepest = std::max(deepest, depthOf(tree, node.child[i]));
    return deepest + 1;
}

// The largest distance by which a sample of the triangle lies outside every sphere that covers it.
double uncovered(const Triangle& t, const std::vector<LeafSphere>& spheres) {
    double worst = -1e300;
    constexpr int grid = 12;
    for (int v = 0; v <= grid; ++v)
        for (int w = 0; w <= grid - v; ++w) {
            const Vec3 p = t.a + (double(v) / grid) * (t.b - t.a) + (double(w) / grid) * (t.c - t.a);
            double outside = 1e300;
            for (const LeafSphere& sphere : spheres)
                outside =
                    std::min(outside, (p - sphere.centre.cast<double>()).norm() - double(sphere.radius));
            worst = std::max(worst, outside);
        }
    return worst;
}

// Triangles that crowd toward a point in a geometric series: halving space alone would peel off one at a
// time.
Soup crowding(int count, double ratio) {
    SoupBuilder builder;
    double size = 1;
    for (int i = 0; i < count; ++i, size *= ratio)
        builder.triangle({size, 0, 0}, {size, 0.1 * size, 0}, {size, 0, 0.1 * size});
    return builder.build();
}

std::vector<std::pair<QString, Soup>> manySoups() {
    Rng rng(11);
    std::vector<std::pair<QString, Soup>> soups{
        {"one triangle", SoupBuilder().triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).build()},
        {"one segment", SoupBuilder().segment({0, 0, 0}, {1, 0.3, 0}).build()},
        {"one point", SoupBuilder().point({0.1, 0.2, 0.3}).build()},
        {"ball", ball(1, 2)},
        {"egg-crate", eggCrate(1, 20, 0.1, 0.5)},
        {"crowding", crowding(150, 0.8)},
    };
    SoupBuilder same, thin;
    for (int i = 0; i < 60; ++i) {
        same.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        const Vec3 a = inBox(rng, 1);
        thin.triangle(a, a + 3 * direction(rng), a + 1e-4 * direction(rng));
    }
    soups.emplace_back("coincident", same.build());
    soups.emplace_back("long and thin", thin.build());
    for (int i = 0; i < 12; ++i)
        soups.emplace_back(QString("random %1").arg(i), randomSoup(rng, 1 << (i / 2 + 3), 1));
    return soups;
}

double bruteSweep(const TriangleSoup& soup, const SpherePath& path, const std::vector<Index>& excluded) {
    double first = kNoContact;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (std::find(excluded.begin(), excluded.end(), Index(i)) != excluded.end()) continue;
        first = std::min(first, sweepSphere(triangleOf(soup, i), path.from, path.motion, path.radius));
    }
    return first;
}

SpherePath randomPath(Rng& rng, const TriangleSoup& soup, double radius) {
    const Vec3& aim = soup.positions[rng() % soup.positions.size()];
    SpherePath path;
    path.radius = radius;
    path.from = aim + std::pow(10, uniform(rng, -3, 0.5)) * direction(rng);
    // Toward the soup, past it, away from it, or nearly nowhere.
    path.motion = std::pow(10, uniform(rng, rng() % 4 ? -0.3 : -7, 0.5)) *
                  (aim + std::pow(10, uniform(rng, -4, -0.5)) * inBox(rng, 1) - path.from);
    if (rng() % 8 == 0) path.motion = -path.motion;
    return path;
}

// Of two contacts at the same time the tree may take either, so times agree to rounding and not to the bit.
bool sameTime(double a, double b) {
    return a == b || (a <= 1 && b <= 1 && std::abs(a - b) < 1e-11);
}

void compareSweeps(const Soup& soup, const QString& name, int paths, Rng& rng, int& hits) {
    const SphereTree tree(*soup);
    for (int i = 0; i < paths; ++i) {
        const SpherePath path = randomPath(rng, *soup, std::pow(10, uniform(rng, -6, -1)));
        std::vector<Index> excluded;
        const double brute = bruteSweep(*soup, path, excluded);
        // Whatever leaf is looked at first.
        const SweepHit hit = tree.sweep(*soup, path, excluded, Index(rng() % tree.leaves().size()));
        QVERIFY2(sameTime(hit.t, brute), qPrintable(QString("%1, path %2: %3 instead of %4")
                                                        .arg(name)
                                                        .arg(i)
                                                        .arg(hit.t, 0, 'g', 17)
                                                        .arg(brute, 0, 'g', 17)));
        if (hit.t > 1) continue;
        ++hits;
        QCOMPARE(sweepSphere(triangleOf(*soup, hit.triangle), path.from, path.motion, path.radius), hit.t);
        excluded.push_back(hit.triangle);
        const SweepHit next = tree.sweep(*soup, path, excluded);
        QVERIFY2(sameTime(next.t, bruteSweep(*soup, path, excluded)), qPrintable(name + ": excluded"));
        if (!(next.t > 1)) QCOMPARE_NE(next.triangle, hit.triangle);
    }
}

} // namespace

class SphereTreeTest : public QObject {
    Q_OBJECT

private slots:
    void leafSpheresCoverTheirPrimitives();
    void nodesContainAllThatIsBelow();
    void sweepFindsTheFirstContact();
    void aShortPathPastSomethingThinTouchesIt();
    void sweepIsSafeFarFromTheOrigin();
    void farFromTheOriginItPrunesAsWell();
    void whatReachesIntoABallIsGathered();
    void whatIsRememberedChangesNothing();
    void whatIsToComeIsNearTheEnd();
    void whatIsBeyondReachIsNeverTouched();
    void depthIsBounded();
    void atEachDepthSpheresHoldItAll();
    void aLargeMeshIsBuiltInParts();
    void emptySoupIsNeverTouched();
    void longTrianglesGetSeveralSpheres();
};

void SphereTreeTest::leafSpheresCoverTheirPrimitives() {
    for (const auto& [name, soup] : manySoups())
        for (double offset : {0.0, 1000.0}) {
            const Soup moved = transformed(*soup, {Quat::Identity(), Vec3::Constant(offset)});
            std::vector<std::vector<LeafSphere>> of(moved->triangles.size());
            for (const LeafSphere& s : coverWithSpheres(*moved))
                of[s.triangle].push_back(s);
            for (std::size_t i = 0; i < of.size(); ++i)
                QVERIFY2(
                    uncovered(triangleOf(*moved, i), of[i]) < 1e-12 * (1 + offset),
                    qPrintable(QString("%1: %2").arg(name).arg(uncovered(triangleOf(*moved, i), of[i]))));
        }
}

// Every point of every triangle is found through all the spheres and pairs of planes above it.
void SphereTreeTest::nodesContainAllThatIsBelow() {
    for (const auto& [name, soup] : manySoups()) {
        const SphereTree tree(*soup);
        for (std::size_t i = 0; i < soup->triangles.size(); ++i) {
            const Triangle t = triangleOf(*soup, i);
            constexpr int grid = 6;
            for (int v = 0; v <= grid; ++v)
                for (int w = 0; w <= grid - v; ++w) {
                    const Vec3 p = t.a + (double(v) / grid) * (t.b - t.a) + (double(w) / grid) * (t.c - t.a);
                    QVERIFY2(reaches(tree, tree.nodes().front(), p - tree.origin(), Index(i)),
                             qPrintable(name));
                }
        }
    }
}

void SphereTreeTest::sweepFindsTheFirstContact() {
    Rng rng(12);
    int hits = 0;
    for (const auto& [name, soup] : manySoups())
        compareSweeps(soup, name, 1500, rng, hits);
    QVERIFY2(hits > 5000, "the paths are to touch something");
}

// A sphere passes a point at the height h < r and has left it where its path, shorter than r, ends: it is
// touched sqrt(r^2 - h^2) before the foot.
void SphereTreeTest::aShortPathPastSomethingThinTouchesIt() {
    const double r = 1e-3, h = 0.95 * r, length = 0.9 * r;
    const double expected = (0.5 * length - std::sqrt(r * r - h * h)) / length;
    const std::pair<const char*, Soup> things[] = {
        {"point", SoupBuilder().point(Vec3::Zero()).build()},
        {"segment", SoupBuilder().segment({0, -r, 0}, {0, r, 0}).build()},
        {"sliver", SoupBuilder().triangle({0, -r, 0}, {0, r, 0}, {1e-9 * r, 0, -1e-5 * r}).build()}};
    for (const auto& [name, soup] : things) {
        const SphereTree tree(*soup);
        const SweepHit hit = tree.sweep(*soup, {{-0.5 * length, 0, h}, {length, 0, 0}, r}, {});
        QVERIFY2(std::abs(hit.t - expected) < 1e-6, qPrintable(QString("%1: %2").arg(name).arg(hit.t)));
    }
}

// At 1000 m a float resolves 0.06 mm: pruning has to let through what it cannot tell.
void SphereTreeTest::sweepIsSafeFarFromTheOrigin() {
    Rng rng(13);
    int hits = 0;
    for (const double far : {1e3, 1e5})
        for (const auto& [name, soup] : manySoups())
            compareSweeps(transformed(*soup, {Quat::Identity(), {far, -far, far}}), name, 500, rng, hits);
    QCOMPARE_GT(hits, 3000);
}

// Single precision tells millimetres apart ten kilometres from zero; seen from the mesh itself it is as near
// as ever: as much of it reaches into a ball.
void SphereTreeTest::farFromTheOriginItPrunesAsWell() {
    const Soup soup = eggCrate(0.02, 40, 0.002, 0.01);
    const SphereTree near(*soup);
    QVERIFY(near.origin().isZero());
    for (const double far : {1e4, 9e5}) {
        const Vec3 offset(far, -far, far);
        const Soup moved = transformed(*soup, {Quat::Identity(), offset});
        const SphereTree tree(*moved);
        Rng rng(17);
        int here = 0, there = 0;
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = inBox(rng, 0.02);
            Neighbourhood one, other;
            near.gather(p, 0.002, one);
            tree.gather(p + offset, 0.002, other);
            here += one.blocks + one.crowded;
            there += other.blocks + other.crowded;
            QCOMPARE(tree.isBeyond(p + offset, 0.002), near.isBeyond(p, 0.002));
        }
        QVERIFY2(std::abs(there - here) <= here / 100, qPrintable(QString("%1, %2").arg(here).arg(there)));
    }
}

// Each triangle whose nearest point lies in the ball can be come to, there, from what was gathered. Wrong
// would be a test whose balls hold nothing, or everything: both are counted.
void SphereTreeTest::whatReachesIntoABallIsGathered() {
    Rng rng(19);
    int within = 0, outside = 0;
    for (const auto& [name, soup] : manySoups()) {
        const SphereTree tree(*soup);
        for (int i = 0; i < 100; ++i) {
            const Vec3 p = randomPath(rng, *soup, 0).from;
            const double radius = std::pow(10, uniform(rng, -3, -0.5));
            Neighbourhood near;
            tree.gather(p, radius, near);
            for (Index k = 0; k < soup->triangles.size(); ++k) {
                const Vec3 nearest = closestPoint(triangleOf(*soup, k), p).point;
                if ((nearest - p).norm() > radius) {
                    ++outside;
                    continue;
                }
                ++within;
                const auto leads = [&](const SphereTree::Node& block) {
                    return reaches(tree, block, nearest - tree.origin(), k);
                };
                QVERIFY2(std::any_of(near.block.begin(), near.block.begin() + near.blocks, leads),
                         qPrintable(QString("%1, ball %2, triangle %3").arg(name).arg(i).arg(k)));
            }
        }
    }
    QVERIFY2(within > 5000 && outside > 5000, qPrintable(QString("%1, %2").arg(within).arg(outside)));
}

// A walk of short and long paths, as a proxy makes them: swept from what is remembered of the surroundings
// and afresh.
void SphereTreeTest::whatIsRememberedChangesNothing() {
    Rng rng(15);
    int hits = 0;
    for (const auto& [name, soup] : manySoups()) {
        const CollisionMesh mesh{soup, SphereTree(*soup)};
        SweepMemory memory;
        const double radius = std::pow(10, uniform(rng, -2.5, -0.7));
        SpherePath path{soup->positions[0] + 2 * radius * direction(rng), Vec3::Zero(), radius};
        for (int i = 0; i < 2000; ++i) {
            if (rng() % 100 == 0) path = randomPath(rng, *soup, radius);
            path.motion = radius * std::pow(10, uniform(rng, -3, rng() % 4 ? 0 : 1.5)) * direction(rng);
            const SweepHit afresh = mesh.tree.sweep(*soup, path, {});
            const SweepHit hit = sweepFrom(memory, mesh, path, {});
            QVERIFY2(sameTime(hit.t, afresh.t),
                     qPrintable(QString("%1, %2: %3, %4").arg(name).arg(i).arg(hit.t).arg(afresh.t)));
            hits += hit.t <= 1;
            path.from += std::min(1.0, hit.t) * path.motion;
        }
    }
    QCOMPARE_GT(hits, 1000);
}

// Of strips, too, of which a look in single precision tells no more than a bound.
void SphereTreeTest::whatIsToComeIsNearTheEnd() {
    Rng rng(23);
    SoupBuilder builder;
    for (int i = 0; i < 200; ++i) {
        const Vec3 a(0.002 * i, 0, 0), b(0.002 * (i + 1), 0, 0), up(0, 1, 0);
        builder.triangle(a, b, b + up).triangle(a, b + up, a + up);
    }
    const Soup soup = builder.build();
    int named = 0;
    const SphereTree tree(*soup);
    for (int i = 0; i < 2000; ++i) {
        SpherePath path{.from = inBox(rng, 0.4) + Vec3(0.2, 0.5, 0), .radius = 0.01};
        path.from.z() = 0.01 + 1e-8 * uniform(rng, 0, 1); // as what slides on the strips
        path.motion = 0.005 * uniform(rng, 0, 1) * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), 0);
        const SweepHit hit = tree.sweep(*soup, path, {});
        if (hit.t <= 1 || hit.soonCount == 0) continue;
        const Vec3 end = path.from + path.motion;
        const auto gapOf = [&](Index k) {
            return (closestPoint(triangleOf(*soup, k), end).point - end).norm() - path.radius;
        };
        for (int k = 0; k < hit.soonCount; ++k, ++named) {
            const double gap = gapOf(hit.soon[std::size_t(k)]);
            QVERIFY2(gap < path.lookAhead * path.radius + 1e-6, qPrintable(QString::number(gap)));
        }
        // The first is the nearest of all: the sweep looks at long ones part by part.
        double nearest = 1e300;
        for (std::size_t k = 0; k < soup->triangles.size(); ++k)
            nearest = std::min(nearest, gapOf(Index(k)));
        COMPARE_NEAR(gapOf(hit.soon[0]), nearest, 1e-7, "m");
    }
    QCOMPARE_GT(named, 1000);
}

void SphereTreeTest::whatIsBeyondReachIsNeverTouched() {
    Rng rng(16);
    int beyond = 0, within = 0;
    for (const auto& [name, soup] : manySoups()) {
        const SphereTree tree(*soup);
        for (int i = 0; i < 500; ++i) {
            const SpherePath path = randomPath(rng, *soup, std::pow(10, uniform(rng, -4, -1)));
            if (tree.isBeyond(path.from, path.radius + path.motion.norm())) {
                ++beyond;
                QVERIFY2(bruteSweep(*soup, path, {}) > 1, qPrintable(name));
            } else {
                ++within;
            }
        }
    }
    QVERIFY2(beyond > 500 && within > 500, qPrintable(QString("%1, %2").arg(beyond).arg(within)));
    QVERIFY(SphereTree(TriangleSoup{}).isBeyond(Vec3::Zero(), 1e6));
}

void SphereTreeTest::depthIsBounded() {
    // 2000 triangles down to the smallest double: the sweep's stack holds 96 levels.
    const Soup soup = crowding(2000, 0.71);
    const SphereTree tree(*soup);
    QCOMPARE_LE(depthOf(tree), 96);
    QCOMPARE_GE(tree.leaves().size(), 2000 / SphereTree::kWidth);
    Rng rng(14);
    int hits = 0;
    compareSweeps(soup, "crowding", 200, rng, hits);
    QCOMPARE_LE(depthOf(SphereTree(*ball(1, 4))), 12);
}

// Those that are shown: all of the mesh lies in them, the deeper the more and the smaller; below the leaves
// nothing comes.
void SphereTreeTest::atEachDepthSpheresHoldItAll() {
    for (const double far : {0.0, 1e5}) {
        const Soup soup = transformed(*eggCrate(1, 20, 0.1, 0.5), {Quat::Identity(), Vec3::Constant(far)});
        const SphereTree tree(*soup);
        std::size_t before = 0;
        double largest = 1e300;
        const int deepest = depthOf(tree);
        for (int depth = 0; depth <= deepest; ++depth) {
            const std::vector<BoundingSphere> spheres = tree.spheresAt(depth);
            QCOMPARE_LE(spheres.size(), std::size_t(std::pow(SphereTree::kWidth, depth + 1)));
            QCOMPARE_GE(spheres.size(), before + (depth < deepest - 1));
            const double slack = 1e-6 + 1e-6 * far; // they are single precision
            double radius = 0;
            for (const BoundingSphere& sphere : spheres)
                radius = std::max(radius, double(sphere.radius));
            QCOMPARE_GT(radius, 0);
            QCOMPARE_LE(radius, largest);
            for (const Vec3& p : soup->positions) {
                double outside = 1e300;
                for (const BoundingSphere& sphere : spheres)
                    outside = std::min(outside, (p - sphere.centre.cast<double>()).norm() - sphere.radius);
                QCOMPARE_LE(outside, slack);
            }
            before = spheres.size();
            largest = radius;
        }
        QCOMPARE_GE(before, tree.leaves().size()); // those of what lies in the leaves
        QCOMPARE(tree.spheresAt(deepest + 9).size(), before);
    }
}

// Halves of more than 65,536 spheres are built at the same time: nothing is lost, and it is the same tree
// again.
void SphereTreeTest::aLargeMeshIsBuiltInParts() {
    const Soup soup = eggCrate(1, 280, 0.1, 0.5);
    QCOMPARE_GT(soup->triangles.size(), std::size_t(2) << 16);
    const SphereTree tree(*soup), again(*soup);
    QCOMPARE(again.nodes().size(), tree.nodes().size());
    std::vector<int> times(soup->triangles.size());
    for (std::size_t i = 0; i < tree.nodes().size(); ++i)
        for (int k = 0; k < SphereTree::kWidth; ++k) {
            QCOMPARE_EQ(again.nodes()[i].radius[k], tree.nodes()[i].radius[k]);
            QCOMPARE_EQ(again.nodes()[i].child[k], tree.nodes()[i].child[k]);
        }
    for (const SphereTree::Leaf& leaf : tree.leaves())
        for (int k = 0; k < SphereTree::kWidth; ++k)
            if (leaf.ax[k] < 1e14F) ++times[leaf.triangle[k]];
    QCOMPARE(std::count(times.begin(), times.end(), 0), 0);
    Rng rng(20);
    for (int i = 0; i < 2000; ++i) {
        const Index k = Index(rng() % soup->triangles.size());
        const Triangle t = triangleOf(*soup, k);
        const Vec3 p = (t.a + t.b + t.c) / 3;
        QVERIFY2(reaches(tree, tree.nodes().front(), p - tree.origin(), k),
                 qPrintable(QString("triangle %1").arg(k)));
    }
}

void SphereTreeTest::emptySoupIsNeverTouched() {
    const TriangleSoup nothing;
    const SphereTree tree(nothing);
    QCOMPARE(tree.sweep(nothing, {Vec3::Zero(), Vec3::UnitX(), 1}, {}).t, kNoContact);
    QVERIFY(tree.spheresAt(0).empty());
}

void SphereTreeTest::longTrianglesGetSeveralSpheres() {
    auto spheres = [](const Vec3& c) {
        return coverWithSpheres(*SoupBuilder().triangle({0, 0, 0}, {1, 0, 0}, c).build()).size();
    };
    QCOMPARE(spheres({0.5, 0.8, 0}), std::size_t(1));
    QCOMPARE_GE(spheres({0.5, 0.02, 0}), 4);
}

TACTUM_TEST(SphereTreeTest)

} // namespace test_sphere_tree

#include "test_sphere_tree.moc"
