// The brush on vertices: closed forms, what it must leave alone, and strokes that do not depend on the
// pointer.
#include <QTest>

#include "tests/core/paint/paint_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_brush {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kSmall = 1e-6; // values are in single precision

/// Without any index.
std::vector<Index> trianglesWithin(const TriangleSoup& soup, const Vec3& centre, double radius) {
    std::vector<Index> found;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        if ((closestPoint(triangleOf(soup, i), centre).point - centre).norm() <= radius)
            found.push_back(Index(i));
    return found;
}

} // namespace

class TestBrush : public QObject {
    Q_OBJECT

private slots:
    void everyTriangleInReachIsFound() {
        Rng rng(1);
        for (int round = 0; round < 60; ++round) {
            const Soup soup = randomSoup(rng, 1 + int(rng() % 500), 0.1);
            const auto reach = reachOf(soup);
            for (int i = 0; i < 20; ++i) {
                const Vec3 centre = inBox(rng, 0.12);
                const double radius = uniform(rng, 1e-4, 0.1);
                std::vector<Index> found;
                reach->within(centre, radius, [&](Index triangle) { found.push_back(triangle); });
                std::ranges::sort(found);
                QVERIFY(std::ranges::adjacent_find(found) == found.end());
                QVERIFY(std::ranges::includes(found, trianglesWithin(*soup, centre, radius)));
            }
            std::size_t far = 0;
            reach->within(Vec3(9, 9, 9), 0.1, [&](Index) { ++far; });
            QCOMPARE(far, std::size_t(0));
        }
        reachOf(std::make_shared<const TriangleSoup>())->within(Vec3::Zero(), 1, [](Index) {
            QVERIFY(false);
        });
    }

    /// On a flat grid the value at the distance d is strength x falloff(d / r), and nothing beyond.
    void aDabHasItsClosedForm_data() {
        QTest::addColumn<double>("falloff");
        for (const double falloff : {0.0, 0.3, 1.0})
            QTest::newRow(qPrintable(QString::number(falloff))) << falloff;
    }
    void aDabHasItsClosedForm() {
        QFETCH(double, falloff);
        const Soup soup = sheet(0.02, 40);
        const Vec3 centre(1.3e-3, -0.7e-3, 2e-4);
        const double radius = 7e-3, strength = 0.6;
        const auto after = [&](BrushMode mode, double before, double value = 1) {
            return onVertices(soup, brushOf(mode, radius, strength, falloff, value), {{centre}},
                              std::vector<float>(soup->positions.size(), float(before)));
        };
        const auto added = after(BrushMode::Add, 0.3), less = after(BrushMode::Subtract, 0.7),
                   set = after(BrushMode::Set, 0.9, 0.2), over = after(BrushMode::Add, 0.8);
        int inside = 0;
        for (std::size_t i = 0; i < soup->positions.size(); ++i) {
            const double d = (soup->positions[i] - centre).norm(),
                         part = strength * expectedFalloff(d / radius, falloff);
            COMPARE_NEAR(double(added[i]), 0.3 + part, kSmall, "");
            COMPARE_NEAR(double(less[i]), 0.7 - part, kSmall, "");
            COMPARE_NEAR(double(set[i]), 0.9 - 0.7 * part, kSmall, "");
            COMPARE_NEAR(double(over[i]), std::min(0.8 + part, 1.0), kSmall, "");
            if (d > radius) {
                QCOMPARE_EQ(added[i], 0.3F);
                QCOMPARE_EQ(less[i], 0.7F);
                QCOMPARE_EQ(set[i], 0.9F);
            } // to the bit
            inside += d <= radius;
        }
        QCOMPARE_GT(inside, 100);
    }

    /// Turned about the middle, or mirrored, a dab is the same.
    void aDabIsRound() {
        const Soup soup = sheet(0.02, 40);
        const auto values = onVertices(soup, brushOf(BrushMode::Add, 8e-3, 0.7, 0.8), {{Vec3::Zero()}});
        const auto valueAt = [&](const Vec3& p) {
            for (std::size_t i = 0; i < soup->positions.size(); ++i)
                if ((soup->positions[i] - p).norm() < 1e-9) return values[i];
            return -1.0F;
        };
        for (std::size_t i = 0; i < soup->positions.size(); i += 7) {
            const Vec3& p = soup->positions[i];
            COMPARE_NEAR(valueAt({-p.y(), p.x(), 0}), values[i], 1e-6F, "");
            COMPARE_NEAR(valueAt({p.x(), -p.y(), 0}), values[i], 1e-6F, "");
        }
    }

    void theBackOfAThinSheetStays() {
        // The front of a plate and, below it, the same upside down.
        const Soup front = sheet(0.02, 20);
        auto both = std::make_shared<TriangleSoup>(*front);
        const Index count = Index(front->positions.size());
        for (const Vec3& p : front->positions)
            both->positions.emplace_back(p - Vec3(0, 0, 1e-4));
        for (const auto& t : front->triangles)
            both->triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
        both->surfaceOf.resize(both->triangles.size(), 0);
        for (const double side : {1.0, -1.0}) {
            const auto values =
                onVertices(both, brushOf(BrushMode::Add, 5e-3, 1, 0.5), {{Vec3::Zero(), Vec3(0, 0, side)}});
            for (Index i = 0; i < count; ++i) {
                const bool within = both->positions[i].norm() < 4.9e-3;
                QCOMPARE(values[i] > 0 && within, side > 0 && within);
                QCOMPARE(values[i + count] > 0 && within, side < 0 && within);
            }
        }
    }

    void lockedSurfacesStay() {
        auto soup = std::make_shared<TriangleSoup>(*sheet(0.02, 20));
        for (std::size_t i = 0; i < soup->triangles.size(); ++i)
            soup->surfaceOf[i] = soup->positions[soup->triangles[i][0]].x() >= 0 ? 1 : 0;
        const auto values =
            onVertices(soup, brushOf(BrushMode::Add, 8e-3, 1, 0.5), {{Vec3::Zero()}}, {}, {{true, false}});
        double left = 0;
        for (std::size_t i = 0; i < soup->positions.size(); ++i) {
            if (soup->positions[i].x() > 1e-9) QCOMPARE_EQ(values[i], 0);
            left += double(values[i]);
        }
        QCOMPARE_GT(left, 10);
    }

    void segmentsAndPointsArePaintedFromEverySide() {
        auto soup = std::make_shared<TriangleSoup>();
        soup->positions = {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 5e-3}};
        soup->triangles = {{0, 1, 1}, {2, 2, 2}};
        soup->surfaceOf = {0, 0};
        const auto values =
            onVertices(soup, brushOf(BrushMode::Add, 0.01, 1, 0), {{Vec3::Zero(), -Vec3::UnitX()}});
        QCOMPARE_EQ(values, std::vector<float>({1, 1, 1, 0})); // what no triangle uses is not there
    }

    /// However often a stroke crosses itself, and wherever the pointer was read, add goes up to strength.
    void aStrokeAddsNoMoreThanItsStrength() {
        const Soup soup = sheet(0.02, 40);
        const std::vector<Vec3> path{{-0.01, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, -0.01, 0}, {-0.01, 0, 0}};
        const double radius = 4e-3, strength = 0.4;
        std::vector<Dab> places;
        for (int turn = 0; turn < 3; ++turn)
            for (const Vec3& p : path)
                places.push_back({p});
        for (const BrushMode mode : {BrushMode::Add, BrushMode::Subtract, BrushMode::Set}) {
            const Brush brush = brushOf(mode, radius, strength, 1, 0.5);
            const float start = mode == BrushMode::Add ? 0.0F : 1.0F;
            const auto values =
                onVertices(soup, brush, places, std::vector<float>(soup->positions.size(), start));
            double most = 0;
            for (std::size_t i = 0; i < soup->positions.size(); ++i) {
                const double d = distanceTo(path, soup->positions[i]);
                // The nearest dab is at most half a spacing along the path from the nearest point.
                const double nearest = std::hypot(d, radius / 8);
                const double reached =
                    std::abs(double(values[i] - start)) / (mode == BrushMode::Set ? 0.5 : 1);
                QCOMPARE_LE(reached, strength * expectedFalloff(d / radius, 1) + kSmall);
                QCOMPARE_GE(reached, strength * expectedFalloff(nearest / radius, 1) - 0.02);
                most = std::max(most, reached);
            }
            COMPARE_NEAR(most, strength, 0.02, "");
        }
    }

    /// The same dabs, whether the pointer was read 3 times on the way or 300 times.
    void aStrokeDoesNotDependOnThePointersRate() {
        const Vec3 from(-0.013, 0.002, 0), corner(0.0071, 0.004, 0), to(0.006, -0.011, 0);
        const auto dabsOf = [&](int pieces) {
            std::vector<Vec3> dabs;
            StrokePath path(5e-3);
            const auto moveTo = [&](const Vec3& p) {
                path.moveTo({p}, [&](const Dab& dab) { dabs.push_back(dab.centre); });
            };
            moveTo(from);
            for (const auto& [a, b] : {std::pair(from, corner), std::pair(corner, to)})
                for (int i = 1; i <= pieces; ++i)
                    moveTo(a + double(i) / pieces * (b - a));
            return dabs;
        };
        const auto slow = dabsOf(1), fast = dabsOf(150);
        QCOMPARE(slow.size(), fast.size());
        QCOMPARE_GT(slow.size(), 20);
        for (std::size_t i = 0; i < slow.size(); ++i)
            COMPARE_NEAR(slow[i], fast[i], 1e-12, "");
        for (std::size_t i = 0; i + 1 < slow.size(); ++i) // around the corner it is nearer
            COMPARE_NEAR(slow[i + 1], slow[i], 5e-3 / 4 + 1e-12, "");
        std::size_t straight = 0;
        for (std::size_t i = 0; i + 1 < slow.size(); ++i)
            straight += std::abs((slow[i + 1] - slow[i]).norm() - 5e-3 / 4) < 1e-12;
        QCOMPARE(straight, slow.size() - 2);
    }

    /// Toward the mean of what is near: noise shrinks, a plain stays, an edge becomes a slope that rises.
    void smoothTakesAwayWhatIsFine() {
        const Soup soup = sheet(0.02, 80);
        Rng rng(6);
        std::vector<float> noisy, flat(soup->positions.size(), 0.3F), edge;
        for (const Vec3& p : soup->positions) {
            noisy.push_back(float(uniform(rng, 0.4, 0.6)));
            edge.push_back(p.x() < 1e-5 ? 0 : 1);
        }
        const Brush brush = brushOf(BrushMode::Smooth, 8e-3, 1, 0.5);
        const auto spread = [&](const std::vector<float>& values) {
            double sum = 0, squares = 0, count = 0;
            for (std::size_t i = 0; i < values.size(); ++i)
                if (soup->positions[i].norm() < 3e-3)
                    sum += double(values[i]), squares += double(values[i]) * double(values[i]), ++count;
            return std::sqrt(squares / count - sum * sum / count / count);
        };
        QCOMPARE_LT(spread(onVertices(soup, brush, {{Vec3::Zero()}}, noisy)), 0.25 * spread(noisy));
        for (const float value : onVertices(soup, brush, {{Vec3::Zero()}}, flat))
            COMPARE_NEAR(value, 0.3F, 1e-6F, "");
        const auto softened = onVertices(soup, brush, {{Vec3::Zero()}}, edge);
        for (std::size_t i = 0; i < soup->positions.size(); ++i) {
            const Vec3& p = soup->positions[i];
            if (p.norm() > 8e-3) QCOMPARE_EQ(softened[i], edge[i]);
            if (std::abs(p.y()) < 1e-9 && std::abs(p.x()) < 1.5e-3) {
                QCOMPARE_GT(softened[i], 0.05F);
                QCOMPARE_LT(softened[i], 0.95F);
            }
        }
    }

    /// Not toward one mean for the whole dab: a slope stays a slope.
    void smoothLeavesASlope() {
        const Soup soup = sheet(0.02, 80);
        std::vector<float> slope;
        for (const Vec3& p : soup->positions)
            slope.push_back(float(0.5 + 20 * p.x() - 5 * p.y()));
        const double radius = 8e-3, rise = 25 * radius;
        const auto after =
            onVertices(soup, brushOf(BrushMode::Smooth, radius, 1, 0.5), {{Vec3::Zero()}}, slope);
        for (std::size_t i = 0; i < after.size(); ++i)
            QCOMPARE_LT(std::abs(double(after[i] - slope[i])), 0.05 * rise);
    }

    /// Any soup, brush and path: values stay from 0 to 1, nothing changes beyond reach, the same bits twice.
    void anyStrokeKeepsThePromises() {
        for (unsigned seed = 0; seed < 300; ++seed) {
            Rng rng(seed);
            auto soup = std::make_shared<TriangleSoup>(*randomSoup(rng, 1 + int(rng() % 300), 0.05));
            for (Index& surface : soup->surfaceOf)
                surface = Index(rng() % 3);
            const Brush brush = brushOf(BrushMode(rng() % 4), uniform(rng, 1e-3, 0.05), uniform(rng, 0, 1),
                                        uniform(rng, 0, 1), uniform(rng, 0, 1));
            const PaintableSurfaces surfaces{{true, rng() % 2 == 0, false}};
            std::vector<float> before;
            for (std::size_t i = 0; i < soup->positions.size(); ++i)
                before.push_back(float(uniform(rng, 0, 1)));
            std::vector<Dab> places;
            std::vector<Vec3> path;
            for (int i = 0; i < 4; ++i) {
                places.push_back({inBox(rng, 0.06), direction(rng)});
                path.push_back(places.back().centre);
            }
            const auto after = onVertices(soup, brush, places, before, surfaces);
            QCOMPARE_EQ(after, onVertices(soup, brush, places, before, surfaces));
            std::vector<char> allowed(before.size(), 0);
            for (std::size_t i = 0; i < soup->triangles.size(); ++i)
                for (const Index corner : soup->triangles[i])
                    allowed[corner] = allowed[corner] || surfaces(soup->surfaceOf[i]);
            for (std::size_t i = 0; i < after.size(); ++i) {
                QCOMPARE_GE(after[i], 0);
                QCOMPARE_LE(after[i], 1);
                if (after[i] == before[i]) continue;
                QVERIFY(allowed[i]);
                QCOMPARE_LE(distanceTo(path, soup->positions[i]), brush.radius + 1e-12);
                if (brush.mode == BrushMode::Add)
                    QCOMPARE_LE(double(after[i] - before[i]), brush.strength + kSmall);
            }
        }
    }

    void everyNumberOfABrushHasAParameter() {
        Brush wild{-1, 7, std::numeric_limits<double>::quiet_NaN(), 2, BrushMode::Set};
        const Brush safe = madeSafe(wild);
        for (const BrushField& field : kBrushFields) {
            QVERIFY(field.parameter->allows(safe.*field.value));
            QVERIFY(field.parameter->allows(field.parameter->initial));
            QVERIFY(!field.parameter->sentence.empty());
        }
    }
};

TACTUM_TEST(TestBrush)

} // namespace test_brush

#include "test_brush.moc"
