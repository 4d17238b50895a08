// Painted values: a smooth surface through them, left out where they do not fit, and images painted in part.
//
// What would show that a test here is wrong: slopes are compared with differences of the height, and heights
// with formulas that a cubic meets exactly; that slopes do not jump is seen from both sides of an edge.
#include <QTest>

#include "core/geometry/weld.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/uneven_grid.h"

namespace test_painted_values {

using namespace tactum;
using namespace tactum::test;

namespace {

SharedPaint painted(std::vector<float> values) {
    return {std::make_shared<const PaintedValues>(std::move(values))};
}

TextureLayer paintedLayer(SharedPaint paint, double height) {
    TextureLayer layer = heightLayer(TextureSource::Painted, TextureMapping::Triplanar, 0.01, height);
    layer.pattern.painted = std::move(paint);
    return layer;
}

TexturePoint pointOn(const TriangleSoup& soup, Index triangle, const Vec3& weights, const Vec3& normal) {
    const Triangle t = triangleOf(soup, triangle);
    TexturePoint point;
    point.position = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
    point.normal = normal;
    point.triangle = triangle;
    point.weights = weights;
    return point;
}

/// 2 n^2 triangles in the plane z = 0 around the origin, as fine as `cell`.
Soup evenPlane(int n, double cell) {
    SoupBuilder builder;
    const auto at = [&](int i, int k) { return Vec3((i - 0.5 * n) * cell, (k - 0.5 * n) * cell, 0); };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            builder.triangle(at(i, k), at(i + 1, k), at(i + 1, k + 1))
                .triangle(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    return builder.build();
}

/// The same with its inner positions moved, and halved by either diagonal.
Soup unevenPlane(int n, double cell, Rng& rng) {
    return unevenGrid(n, n, 0.3, false, rng,
                      [&](double x, double y) { return Vec3(cell * Vec3(x - 0.5 * n, y - 0.5 * n, 0)); });
}

template <class Height> std::vector<float> valuesOf(const TriangleSoup& soup, Height&& height) {
    std::vector<float> values;
    for (const Vec3& p : soup.positions)
        values.push_back(float(height(p)));
    return values;
}

Vec3 randomWeights(Rng& rng) {
    Vec3 weights(uniform(rng, 0, 1), uniform(rng, 0, 1), uniform(rng, 0, 1));
    return weights / weights.sum();
}

} // namespace

class TestPaintedValues : public QObject {
    Q_OBJECT

private slots:
    /// Values of a function that is linear in space are that function on one triangle and in a plane, and its
    /// gradient along it.
    void whatIsLinearIsMet() {
        Rng rng(3);
        for (int round = 0; round < 300; ++round) {
            const Vec3 gradient = uniform(rng, 0.1, 2) * direction(rng);
            const Pose pose{Quat::FromTwoVectors(Vec3::UnitZ(), direction(rng)), inBox(rng, 0.01)};
            auto soup = std::make_shared<TriangleSoup>();
            std::vector<float> values;
            for (int i = 0; i < 5; ++i) {
                soup->positions.push_back(pose.apply(inBox(rng, 0.1).cwiseProduct(Vec3(1, 1, 0))));
                values.push_back(float(0.5 + gradient.dot(soup->positions.back())));
            }
            soup->triangles = {{0, 1, 2}, {4, 3, 1}};
            soup->surfaceOf = {0, 0};
            const auto stack = stackOf({paintedLayer(painted(values), 0.01)}, soup);
            for (Index triangle = 0; triangle < 2; ++triangle) {
                const Triangle t = triangleOf(*soup, triangle);
                const Vec3 across = (t.b - t.a).cross(t.c - t.a);
                if (across.norm() < 1e-3) continue; // single precision of the values over a sliver
                const Vec3 normal = across.normalized();
                const TexturePoint point = pointOn(*soup, triangle, randomWeights(rng), normal);
                const TextureFeel touch = feel(*stack, point, 1e-3);
                COMPARE_NEAR(touch.height, 0.01 * (0.5 + gradient.dot(point.position)), 1e-8, "m");
                const Vec3 expected = 0.01 * (gradient - gradient.dot(normal) * normal);
                COMPARE_NEAR(touch.slope, expected, 2e-6, "");
            }
        }
    }

    /// What is cubic in the plane is met exactly, whatever the triangles, up to the rim.
    void whatIsCubicIsMet() {
        Rng rng(6);
        const Soup soup = unevenPlane(12, 0.01, rng);
        for (int round = 0; round < 20; ++round) {
            std::array<double, 10> c;
            for (double& coefficient : c)
                coefficient = uniform(rng, -1, 1);
            const auto height = [&](const Vec3& p) {
                const double x = p.x() / 0.06, y = p.y() / 0.06;
                return 0.5 +
                       0.04 * (c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y +
                               c[6] * x * x * x + c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y);
            };
            const auto slope = [&](const Vec3& p) {
                const double x = p.x() / 0.06, y = p.y() / 0.06;
                return Vec3(
                    0.04 / 0.06 *
                    Vec3(c[1] + 2 * c[3] * x + c[4] * y + 3 * c[6] * x * x + 2 * c[7] * x * y + c[8] * y * y,
                         c[2] + c[4] * x + 2 * c[5] * y + c[7] * x * x + 2 * c[8] * x * y + 3 * c[9] * y * y,
                         0));
            };
            const auto stack = stackOf({paintedLayer(painted(valuesOf(*soup, height)), 1e-3)}, soup);
            for (int place = 0; place < 200; ++place) {
                const Index triangle = Index(rng() % soup->triangles.size());
                const TexturePoint point = pointOn(*soup, triangle, randomWeights(rng), Vec3::UnitZ());
                const TextureFeel touch = feel(*stack, point, 0);
                COMPARE_NEAR(touch.height, 1e-3 * height(point.position), 1e-9, "m");
                COMPARE_NEAR(touch.slope, 1e-3 * slope(point.position), 1e-7, "");
            }
        }
    }

    /// The slope is that of the height everywhere, and does not jump at an edge, whatever was painted.
    void theSlopeIsTheHeightsAndDoesNotJump() {
        Rng rng(7);
        auto moved = std::make_shared<TriangleSoup>(*evenPlane(8, 0.01));
        // Any that are the same at the corners that lie at one place.
        const std::vector<Index> place = weldMap(moved->positions);
        std::vector<float> values;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const bool isFirst = place[i] == i;
            values.push_back(isFirst ? float(uniform(rng, 0.35, 0.65)) : values[place[i]]);
            moved->positions[i] =
                isFirst ? Vec3(moved->positions[i] + 0.002 * inBox(rng, 1).cwiseProduct(Vec3(1, 1, 0)))
                        : moved->positions[place[i]];
        }
        const auto stack = stackOf({paintedLayer(painted(values), 1e-3)}, moved);
        const auto at = [&](Index triangle, const Vec3& weights) {
            return feel(*stack, pointOn(*moved, triangle, weights, Vec3::UnitZ()), 0);
        };
        for (int round = 0; round < 2000; ++round) {
            const Index triangle = Index(rng() % moved->triangles.size());
            const Triangle t = triangleOf(*moved, triangle);
            const Vec3 weights = 0.98 * randomWeights(rng) + Vec3::Constant(0.02 / 3);
            const TextureFeel touch = at(triangle, weights);
            for (const Vec3& way : {Vec3(1, -1, 0), Vec3(0, 1, -1)}) {
                constexpr double kBit = 1e-5;
                const Vec3 went = way[0] * t.a + way[1] * t.b + way[2] * t.c;
                const double rise =
                    (at(triangle, weights + kBit * way).height - at(triangle, weights - kBit * way).height) /
                    (2 * kBit);
                COMPARE_NEAR(rise, touch.slope.dot(went), 1e-8, "m");
            }
        }
        int edges = 0;
        for (Index one = 0; one < moved->triangles.size(); ++one)
            for (Index other = 0; other < one; ++other)
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k) {
                        const auto &a = moved->triangles[one], &b = moved->triangles[other];
                        const auto isAt = [&](Index p, Index q) {
                            return moved->positions[p] == moved->positions[q];
                        };
                        if (!isAt(a[std::size_t(i)], b[std::size_t(k)]) ||
                            !isAt(a[std::size_t((i + 1) % 3)], b[std::size_t((k + 2) % 3)]))
                            continue;
                        ++edges;
                        const double part = uniform(rng, 0, 1);
                        Vec3 here = Vec3::Zero(), there = Vec3::Zero();
                        here[i] = there[k] = 1 - part;
                        here[(i + 1) % 3] = there[(k + 2) % 3] = part;
                        COMPARE_NEAR(at(one, here).height, at(other, there).height, 1e-12, "m");
                        COMPARE_NEAR(at(one, here).slope, at(other, there).slope, 1e-8, "");
                    }
        QCOMPARE_GT(edges, 150);
    }

    /// Around a crease a slope goes on as if the surface were unrolled.
    void aSlopeGoesAroundACrease() {
        auto soup = std::make_shared<TriangleSoup>(*evenPlane(8, 0.01));
        for (Vec3& p : soup->positions)
            if (p.x() > 0) p = {0, p.y(), -p.x()};
        const auto along = [](const Vec3& p) { return 0.5 + 8 * (p.x() - p.z()) + 2 * p.y(); };
        const auto stack = stackOf({paintedLayer(painted(valuesOf(*soup, along)), 1e-3)}, soup);
        Rng rng(8);
        for (int round = 0; round < 500; ++round) {
            const Index triangle = Index(rng() % soup->triangles.size());
            const Triangle t = triangleOf(*soup, triangle);
            const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
            const TexturePoint point = pointOn(*soup, triangle, randomWeights(rng), normal);
            const TextureFeel touch = feel(*stack, point, 0);
            COMPARE_NEAR(touch.height, 1e-3 * along(point.position), 1e-9, "m");
            const Vec3 downhill = normal.x() > 0.5 ? Vec3(0, 2, -8) : Vec3(8, 2, 0);
            COMPARE_NEAR(touch.slope, 1e-3 * downhill, 1e-8, "");
        }
    }

    /// A slide looks ahead in the plane of the triangle where it begins: there lies what its neighbours have,
    /// in their planes turned into that one. Where the mesh ends it goes on straight.
    void besideATriangleItsNeighboursGoOn() {
        const auto wave = [](const Vec3& p) {
            return 0.5 + 0.2 * std::sin(90 * p.x()) * std::cos(70 * p.y());
        };
        const Soup plane = evenPlane(12, 0.01);
        const TextureLayer layer = paintedLayer(painted(valuesOf(*plane, wave)), 1e-3);
        const auto folded = [](const Vec3& p) { return p.x() > 0 ? Vec3(0, p.y(), -p.x()) : p; };
        auto creased = std::make_shared<TriangleSoup>(*plane);
        for (Vec3& p : creased->positions)
            p = folded(p);
        const auto flat = stackOf({layer}, plane), bent = stackOf({layer}, creased);
        Rng rng(10);
        int across = 0;
        for (int round = 0; round < 3000; ++round) {
            const Index triangle = Index(rng() % plane->triangles.size());
            const Vec3 beside = 1.5 * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), 0);
            const Vec3 weights(beside[0], beside[1], 1 - beside[0] - beside[1]);
            const TexturePoint point = pointOn(*plane, triangle, weights, Vec3::UnitZ());
            if (point.position.cwiseAbs().maxCoeff() > 0.055) continue;
            Index there = 0;
            Vec3 inside;
            for (; there < plane->triangles.size(); ++there) {
                const Triangle t = triangleOf(*plane, there);
                Eigen::Matrix3d corners;
                corners << t.a, t.b, t.c;
                corners.row(2).setOnes();
                inside = corners.inverse() * Vec3(point.position.x(), point.position.y(), 1);
                if (inside.minCoeff() >= -1e-12) break;
            }
            const TextureFeel right = feel(*flat, pointOn(*plane, there, inside, Vec3::UnitZ()), 0),
                              touch = feel(*flat, point, 0);
            COMPARE_NEAR(touch.height, right.height, 1e-12, "m");
            COMPARE_NEAR(touch.slope, right.slope, 1e-9, "");
            const Triangle t = triangleOf(*creased, triangle);
            const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
            const TextureFeel around = feel(*bent, pointOn(*creased, triangle, weights, normal), 0);
            COMPARE_NEAR(around.height, right.height, 1e-9, "m");
            const Vec3 turned = normal.x() > 0.5 ? Vec3(0, right.slope.y(), -right.slope.x()) : right.slope;
            COMPARE_NEAR(around.slope, turned, 1e-7, "");
            across += (normal.x() > 0.5) != (point.position.x() > 0);
        }
        QCOMPARE_GT(across, 50);
        const TexturePoint rim = pointOn(*plane, 1, Vec3(0.5, 0, 0.9) / 1.4, Vec3::UnitZ()),
                           outside = pointOn(*plane, 1, {0.5, -0.4, 0.9}, Vec3::UnitZ());
        const TextureFeel last = feel(*flat, rim, 0), beyond = feel(*flat, outside, 0);
        COMPARE_NEAR(beyond.slope, last.slope, 1e-12, "");
        COMPARE_NEAR(beyond.height, last.height + last.slope.dot(outside.position - rim.position), 1e-12,
                     "m");
    }

    /// Beside a hard edge it leaves 0 to 1 by a hundredth at most; what is not painted stays level, and
    /// there, too, the slope is the height's.
    void itStaysFromNoneToAll() {
        const Soup soup = evenPlane(8, 0.01);
        const auto step = [](const Vec3& p) { return p.x() > 0.005 ? 1.0 : 0.0; };
        const auto stack = stackOf({paintedLayer(painted(valuesOf(*soup, step)), 1e-3)}, soup);
        Rng rng(9);
        int beyond = 0, level = 0;
        for (int round = 0; round < 3000; ++round) {
            const Index triangle = Index(rng() % soup->triangles.size());
            const Vec3 weights = 0.99 * randomWeights(rng) + Vec3::Constant(0.01 / 3);
            const auto at = [&](const Vec3& w) {
                return feel(*stack, pointOn(*soup, triangle, w, Vec3::UnitZ()), 0);
            };
            const TextureFeel touch = at(weights);
            QCOMPARE_GT(touch.height, -0.01e-3);
            QCOMPARE_LT(touch.height, 1.01e-3);
            const double x = pointOn(*soup, triangle, weights, Vec3::UnitZ()).position.x();
            if (x < -0.01 || x > 0.02) {
                COMPARE_NEAR(touch.height, x < 0 ? 0 : 1e-3, 1e-12, "m");
                COMPARE_NEAR(touch.slope.norm(), 0, 1e-12, "");
                ++level;
            }
            if (touch.height >= 0 && touch.height <= 1e-3) continue;
            ++beyond;
            const Triangle t = triangleOf(*soup, triangle);
            const Vec3 way(1e-5, -1e-5, 0);
            COMPARE_NEAR(at(weights + way).height - at(weights - way).height,
                         2e-5 * touch.slope.dot(t.a - t.b), 1e-12, "m");
        }
        QCOMPARE_GT(beyond, 50);
        QCOMPARE_GT(level, 1000);
    }

    /// In the middle of a lid, one fan of triangles around a centre, values stay near those of the corners:
    /// all but one lie on one circle, and what the fit leaves open across it led to 0.8 beyond them.
    void aLidStaysNearItsCorners_data() {
        QTest::addColumn<int>("corners");
        for (const int corners : {5, 12, 20, 30, 40, 80})
            QTest::addRow("%d corners", corners) << corners;
    }
    void aLidStaysNearItsCorners() {
        QFETCH(int, corners);
        constexpr double kLid = 0.02;
        const auto at = [&](int i) {
            const double turn = 2 * std::numbers::pi * i / corners;
            return Vec3(kLid * Vec3(std::cos(turn), std::sin(turn), 0));
        };
        SoupBuilder builder;
        for (int i = 0; i < corners; ++i)
            builder.triangle(Vec3::Zero(), at(i), at(i + 1));
        const Soup soup = builder.build();
        const auto ramp = [](const Vec3& p) { return std::clamp(0.5 + 40 * p.x(), 0.0, 0.95); };
        const std::vector<float> values = valuesOf(*soup, ramp);
        const auto stack = stackOf({paintedLayer(painted(values), 1e-3)}, soup);
        Rng rng(12);
        for (int round = 0; round < 3000; ++round) {
            const Index triangle = Index(rng() % soup->triangles.size());
            const auto& corner = soup->triangles[triangle];
            const auto [low, high] = std::minmax({values[corner[0]], values[corner[1]], values[corner[2]]});
            const TextureFeel touch =
                feel(*stack, pointOn(*soup, triangle, randomWeights(rng), Vec3::UnitZ()), 0);
            QCOMPARE_GT(touch.height, 1e-3 * (double(low) - 0.15));
            QCOMPARE_LT(touch.height, 1e-3 * (double(high) + 0.15));
        }
    }

    /// Those of one layer are found again when another edit makes a new stack of the same values.
    void slopesAreMadeOnce() {
        const Soup soup = evenPlane(4, 0.01);
        TextureLayer layer =
            paintedLayer(painted(valuesOf(*soup, [](const Vec3& p) { return 0.5 + p.x(); })), 1e-3);
        const auto before = stackOf({layer}, soup);
        layer.strength = 2e-3;
        const std::vector known{before};
        const auto after = compileTextures({layer}, soup, 0, known);
        QVERIFY(after != before);
        QCOMPARE(after->layers[0].pattern.slopes, before->layers[0].pattern.slopes);
        layer.pattern.painted = painted(valuesOf(*soup, [](const Vec3& p) { return 0.5 + p.y(); }));
        QVERIFY(compileTextures({layer}, soup, 0, known)->layers[0].pattern.slopes !=
                before->layers[0].pattern.slopes);
    }

    void segmentsAndPoints() {
        auto soup = std::make_shared<TriangleSoup>();
        soup->positions = {{0, 0, 0}, {0.02, 0, 0}, {0, 0.01, 0}};
        soup->triangles = {{0, 1, 1}, {2, 2, 2}};
        soup->surfaceOf = {0, 0};
        const auto stack = stackOf({paintedLayer(painted({0.25F, 0.75F, 1}), 0.01)}, soup);
        const TextureFeel along = feel(*stack, pointOn(*soup, 0, {0.5, 0.2, 0.3}, Vec3::UnitZ()), 0);
        COMPARE_NEAR(along.height, 0.005, 1e-9, "m");
        COMPARE_NEAR(along.slope, Vec3(0.01 * 0.5 / 0.02, 0, 0), 1e-9, "");
        const TextureFeel there = feel(*stack, pointOn(*soup, 1, {0, 0, 1}, Vec3::UnitZ()), 0);
        COMPARE_NEAR(there.height, 0.01, 1e-9, "m");
        QCOMPARE_EQ(there.slope.norm(), 0);
    }

    /// The product rule of a mask holds, whatever the two are made of.
    void aMaskIsPaintedToo() {
        Rng rng(4);
        const Soup soup = std::make_shared<const TriangleSoup>(uvSquare(0.1));
        TextureLayer layer = heightLayer(TextureSource::Noise, TextureMapping::Planar, 0.02, 2e-4);
        const auto bare = stackOf({layer}, soup);
        layer.mask = paintedLayer(painted({0, 1, 0.5F, 0.25F}), 0).pattern;
        const auto masked = stackOf({layer}, soup);
        const TextureLayer alone = paintedLayer(layer.mask->painted, 1e-3);
        const auto mask = stackOf({alone}, soup);
        for (int i = 0; i < 100; ++i) {
            const TexturePoint point = pointOn(*soup, Index(rng() % 2), randomWeights(rng), Vec3::UnitZ());
            const TextureFeel h = feel(*bare, point, 0), m = feel(*mask, point, 0),
                              both = feel(*masked, point, 0);
            const double part = m.height / 1e-3;
            COMPARE_NEAR(both.height, part * h.height, 1e-12, "m");
            COMPARE_NEAR(both.slope, part * h.slope + h.height / 1e-3 * m.slope, 1e-9, "");
        }
    }

    void whatDoesNotFitIsLeftOut() {
        const Soup soup = std::make_shared<const TriangleSoup>(uvSquare(0.1));
        QVERIFY(stackOf({paintedLayer(painted({0, 1, 0, 1}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer(painted({0, 1, 0}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer(painted({0, 1, 0, 1, 0}), 1e-4)}, soup));
        QVERIFY(!stackOf({paintedLayer({}, 1e-4)}, soup));
        TextureLayer masked = heightLayer(TextureSource::Noise, TextureMapping::Planar, 0.02, 2e-4);
        masked.mask = paintedLayer(painted({1}), 0).pattern;
        QVERIFY(!stackOf({masked}, soup));
        // It asks for no coordinates, whatever its mapping says.
        auto bare = std::make_shared<TriangleSoup>(*soup);
        bare->cornerUvs.clear();
        TextureLayer layer = paintedLayer(painted({0, 1, 0, 1}), 1e-4);
        layer.pattern.mapping = TextureMapping::Uv;
        QVERIFY(stackOf({layer}, bare));
    }

    void equalWhereTheValuesAre() {
        const TextureLayer one = paintedLayer(painted({0.5F, 0.25F}), 1e-4);
        TextureLayer other = paintedLayer(painted({0.5F, 0.25F}), 1e-4);
        QVERIFY(one == other);
        other.pattern.painted = painted({0.5F, 0.5F});
        QVERIFY(!(one == other));
        other.pattern.painted = {};
        QVERIFY(!(one == other));
        const PaintedValues safe({-1, 2, std::numeric_limits<float>::quiet_NaN(), 0.5F});
        QCOMPARE_EQ(safe.all(), std::vector<float>({0, 1, 0, 0.5F}));
    }

    /// Every level, to the bit, for sizes that are no powers of two.
    void anImagePaintedInPartIsThatBuiltWhole() {
        Rng rng(5);
        for (int round = 0; round < 200; ++round) {
            const int width = 1 + int(rng() % 70), height = 1 + int(rng() % 70);
            const auto before = imageOf(width, height, [&](double, double) { return uniform(rng, 0, 1); });
            std::vector<std::uint16_t> texels(before->row(0), before->row(0) + width * height);
            std::vector<TextureImage::Region> regions;
            for (int i = int(rng() % 4); i > 0; --i) {
                TextureImage::Region region{int(rng() % unsigned(width)), int(rng() % unsigned(height)), 0,
                                            0};
                region.width = int(rng() % unsigned(width - region.x + 1));
                region.height = int(rng() % unsigned(height - region.y + 1));
                regions.push_back(region);
                for (int y = region.y; y < region.y + region.height; ++y)
                    for (int x = region.x; x < region.x + region.width; ++x)
                        texels[std::size_t(y * width + x)] = std::uint16_t(rng());
            }
            const auto after = before->withRegions(regions, texels);
            const TextureImage whole(width, height, texels, "formula");
            QCOMPARE(after->levelCount(), whole.levelCount());
            QCOMPARE(after->name(), before->name());
            for (int i = 0; i < whole.levelCount(); ++i)
                for (int y = 0; y < whole.level(i).height; ++y)
                    for (int x = 0; x < whole.level(i).width; ++x)
                        QCOMPARE_EQ(after->texel(after->level(i), x, y), whole.texel(whole.level(i), x, y));
        }
    }
};

TACTUM_TEST(TestPaintedValues)

} // namespace test_painted_values

#include "test_painted_values.moc"
