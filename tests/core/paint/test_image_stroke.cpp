// The brush on the texels of an image: the same as on vertices where both can tell, and no gaps at seams.
#include <QTest>

#include "core/surface/image_sample.h"
#include "tests/core/paint/paint_rig.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_image_stroke {

using namespace tactum;
using namespace tactum::test;

namespace {

/// The sheet with uv = linear (x, y) + shift.
Soup laidOut(double half, int cells, const Eigen::Matrix2d& linear, const Vector2d& shift) {
    auto soup = std::make_shared<TriangleSoup>(*sheet(half, cells));
    for (const auto& triangle : soup->triangles)
        for (const Index corner : triangle)
            soup->cornerUvs.push_back((linear * soup->positions[corner].head<2>() + shift).cast<float>());
    return soup;
}

Image plain(int width, int height, double value) {
    return imageOf(width, height, [=](double, double) { return value; });
}

TexelMap mapOf(const Image& image) {
    TexelMap map;
    map.width = image->width(), map.height = image->height();
    map.perUv = Vector2d(map.width, map.height).asDiagonal();
    return map;
}

Image onImage(const Soup& soup, const Image& before, const Brush& brush, const std::vector<Dab>& places,
              const PaintableSurfaces& surfaces = {}) {
    ImageStroke stroke(reachOf(soup), surfaces,
                       std::make_shared<const TexelCover>(*soup, PaintableSurfaces{}, mapOf(before)), before,
                       brush);
    for (const Dab& place : places)
        stroke.moveTo(place);
    return stroke.image();
}

/// No two rows and no two columns alike.
Image mottled(int width, int height, std::uint64_t seed) {
    Rng rng(seed);
    return imageOf(width, height, [&](double, double) { return uniform(rng, 0, 1); });
}

double valueAt(const TextureImage& image, const Vector2d& uv) {
    return sampleImage(image, {uv, {}}, 0).value;
}

std::vector<std::uint16_t> texels(const TextureImage& image) {
    const std::uint16_t* first = image.row(0);
    return {first, first + image.width() * image.height()};
}

/// How many texels are others than before, of those that `isMeant` or of the rest.
struct Changes {
    int meant = 0, others = 0;
};
template <class IsMeant> Changes changes(const Image& before, const Image& after, IsMeant&& isMeant) {
    const auto one = texels(*before), other = texels(*after);
    Changes changes;
    for (std::size_t i = 0; i < one.size(); ++i)
        if (one[i] != other[i])
            ++(isMeant(int(i) % before->width(), int(i) / before->width()) ? changes.meant : changes.others);
    return changes;
}

/// The sheet of half a side of 0.02 m that shows an image once, and where the centre of a texel lies on it.
Soup wholeSheet(int cells) {
    return laidOut(0.02, cells, 25 * Eigen::Matrix2d::Identity(), {0.5, 0.5});
}
Vec3 placeOf(const Image& image, int x, int y) {
    return {0.04 * ((x + 0.5) / image->width() - 0.5), 0.04 * ((y + 0.5) / image->height() - 0.5), 0};
}

} // namespace

class TestImageStroke : public QObject {
    Q_OBJECT

private slots:
    /// Of every texel, by where its centre lies on the sheet; also where coordinates are turned, mirrored and
    /// skewed.
    void aDabHasItsClosedForm() {
        const double half = 0.02, radius = 6e-3, strength = 0.8;
        Eigen::Matrix2d linear;
        for (const auto& [a, b, c, d] : {std::array{25.0, 0.0, 0.0, 25.0}, {-20.0, 5.0, 3.0, 20.0}}) {
            linear << a, b, c, d;
            const Vector2d shift(0.5, 0.5);
            const Soup soup = laidOut(half, 9, linear, shift);
            const Vec3 centre(2e-3, -1e-3, 1e-3);
            const Image after = onImage(soup, plain(200, 120, 0.1),
                                        brushOf(BrushMode::Add, radius, strength, 0.6), {{centre}});
            int inside = 0;
            for (int y = 0; y < 120; ++y)
                for (int x = 0; x < 200; ++x) {
                    const Vector2d uv((x + 0.5) / 200, (y + 0.5) / 120), xy = linear.inverse() * (uv - shift);
                    if (xy.cwiseAbs().maxCoeff() > half) continue; // beside the sheet
                    const double apart = (Vec3(xy.x(), xy.y(), 0) - centre).norm();
                    const double expected = 0.1 + strength * expectedFalloff(apart / radius, 0.6);
                    QVERIFY2(std::abs(after->texel(after->level(0), x, y) - expected) < 2e-4,
                             qPrintable(QString("%1 %2: %3 instead of %4")
                                            .arg(x)
                                            .arg(y)
                                            .arg(after->texel(after->level(0), x, y))
                                            .arg(expected)));
                    inside += apart < radius;
                }
            QCOMPARE_GT(inside, 1000);
        }
    }

    /// Of an image that has something to lose: within the brush each texel becomes what the mode makes of the
    /// value that it had, beyond it none changes by a bit.
    void whatLiesBeyondTheBrushStays() {
        const double radius = 4e-3, strength = 0.7, value = 0.9;
        const std::vector<Dab> places{{{-0.01, 0.002, 0}}, {{0.007, 0.006, 0}}};
        const std::vector<Vec3> path{places[0].centre, places[1].centre};
        const Image before = mottled(90, 70, 21);
        for (const BrushMode mode :
             {BrushMode::Add, BrushMode::Subtract, BrushMode::Set, BrushMode::Smooth}) {
            const Brush brush = brushOf(mode, radius, strength, 0.5, value);
            const Image after = onImage(wholeSheet(15), before, brush, places);
            const Changes seen = changes(before, after, [&](int x, int y) {
                return distanceTo(path, placeOf(before, x, y)) <= radius;
            });
            QVERIFY2(seen.others == 0,
                     qPrintable(QString("mode %1: %2 texels beyond the brush instead of 0, %3 within it")
                                    .arg(int(mode))
                                    .arg(seen.others)
                                    .arg(seen.meant)));
            QVERIFY2(seen.meant > 600, qPrintable(QString::number(seen.meant)));
            if (mode == BrushMode::Smooth) continue;
            const Image dabbed = onImage(wholeSheet(15), before, brush, {places[0]});
            for (int y = 0; y < 70; ++y)
                for (int x = 0; x < 90; ++x) {
                    const double was = before->texel(before->level(0), x, y),
                                 is = dabbed->texel(dabbed->level(0), x, y);
                    const double apart = (placeOf(before, x, y) - path[0]).norm();
                    const double part = strength * expectedFalloff(apart / radius, 0.5);
                    const double expected = mode == BrushMode::Add        ? std::min(was + part, 1.0)
                                            : mode == BrushMode::Subtract ? std::max(was - part, 0.0)
                                                                          : was + part * (value - was);
                    QVERIFY2(std::abs(is - expected) < 2e-5,
                             qPrintable(QString("mode %1 at %2 %3: %4 instead of %5")
                                            .arg(int(mode))
                                            .arg(x)
                                            .arg(y)
                                            .arg(is)
                                            .arg(expected)));
                }
        }
    }

    /// However often it crosses itself: of all dabs the one counts that lies best.
    void whatWasPaintedIsNotPaintedTwice() {
        const Image before = mottled(64, 64, 22);
        for (const BrushMode mode : {BrushMode::Add, BrushMode::Subtract, BrushMode::Set}) {
            const Brush brush = brushOf(mode, 5e-3, 0.3, 1, 0.5);
            const Vec3 here(1e-3, 2e-3, 0), beside(4e-3, 2e-3, 0);
            ImageStroke stroke(
                reachOf(wholeSheet(9)), {},
                std::make_shared<const TexelCover>(*wholeSheet(9), PaintableSurfaces{}, mapOf(before)),
                before, brush);
            stroke.paint({here});
            const Image once = stroke.image();
            stroke.paint({here});
            QVERIFY(stroke.image() == once);
            stroke.paint({beside});
            const Image both = stroke.image();
            const Changes seen = changes(once, both, [&](int x, int y) {
                const Vec3 place = placeOf(before, x, y);
                return (place - beside).norm() < (place - here).norm();
            });
            QVERIFY2(
                seen.others == 0 && seen.meant > 100,
                qPrintable(QString("%1 texels nearer to the first dab instead of 0, %2 nearer to the second")
                               .arg(seen.others)
                               .arg(seen.meant)));
        }
    }

    /// Between two places of the pointer nothing is painted when it was away in between.
    void aLiftedBrushLeavesAGap() {
        const double radius = 3e-3;
        const Soup soup = wholeSheet(9);
        const Image before = mottled(80, 80, 23);
        const Vec3 from(-0.012, 0, 0), to(0.012, 0, 0);
        for (const bool lifts : {false, true}) {
            ImageStroke stroke(reachOf(soup), {},
                               std::make_shared<const TexelCover>(*soup, PaintableSurfaces{}, mapOf(before)),
                               before, brushOf(BrushMode::Set, radius, 1, 0));
            stroke.moveTo({from});
            if (lifts) stroke.lift();
            stroke.moveTo({to});
            const Changes seen = changes(before, stroke.image(), [&](int x, int y) {
                const Vec3 place = placeOf(before, x, y);
                return std::min((place - from).norm(), (place - to).norm()) <= radius;
            });
            QVERIFY2(
                lifts == (seen.others == 0),
                qPrintable(QString("%1 texels on the way, %2 at its ends").arg(seen.others).arg(seen.meant)));
            QVERIFY(seen.meant > 200);
        }
    }

    /// Two sheets, one above the other, that show the same texels: each is painted by the nearer one,
    /// whichever comes first in the mesh.
    void ofSeveralPlacesTheNearestCounts() {
        const Soup near = wholeSheet(6);
        TriangleSoup far = *near;
        for (Vec3& p : far.positions)
            p.z() -= 3e-3;
        const Image before = mottled(60, 60, 24);
        const Brush brush = brushOf(BrushMode::Add, 5e-3, 0.9, 1);
        for (const double height : {0.0, -3e-3})
            for (const bool farFirst : {false, true}) {
                const Soup nearer = height == 0 ? near : std::make_shared<const TriangleSoup>(far);
                const std::vector<Dab> dab{{{0.002, -0.001, height}}};
                auto both = std::make_shared<TriangleSoup>(farFirst ? far : *near);
                const TriangleSoup& second = farFirst ? *near : far;
                const Index more = Index(both->positions.size());
                both->positions.insert(both->positions.end(), second.positions.begin(),
                                       second.positions.end());
                for (const auto& t : second.triangles)
                    both->triangles.push_back({t[0] + more, t[1] + more, t[2] + more});
                both->surfaceOf.resize(both->triangles.size(), 0);
                both->cornerUvs.insert(both->cornerUvs.end(), second.cornerUvs.begin(),
                                       second.cornerUvs.end());
                const Changes seen =
                    changes(onImage(nearer, before, brush, dab), onImage(both, before, brush, dab),
                            [](int, int) { return false; });
                QCOMPARE(seen.others, 0);
            }
    }

    /// An island in the middle of an image: the brush lies over all of it, and paints it and the texels
    /// that an interpolation on it reads.
    void besideAnIslandOnlyTexelsThatAreReadArePainted() {
        SoupBuilder builder;
        const Vec3 corners[] = {{0, 0, 0}, {0.01, 0, 0}, {0.002, 0.008, 0}};
        builder.triangle(corners[0], corners[1], corners[2]);
        auto soup = std::make_shared<TriangleSoup>(*builder.build());
        const int side = 48;
        Triangle island; // in texels
        for (int k = 0; k < 3; ++k) {
            const Vec3 texel = Vec3(12.3, 14.7, 0) + 2400 * corners[k];
            (k == 0 ? island.a : k == 1 ? island.b : island.c) = texel;
            soup->cornerUvs.push_back((texel.head<2>() / side).cast<float>());
        }
        const Image before = mottled(side, side, 25);
        const Vec3 centre(0.004, 0.003, 0);
        const Image after = onImage(soup, before, brushOf(BrushMode::Set, 0.02, 1, 1, 0), {{centre}});
        const auto nearest = [&](int x, int y) {
            return closestPoint(island, Vec3(x + 0.5, y + 0.5, 0)).point;
        };
        const auto apart = [&](int x, int y) { return (nearest(x, y) - Vec3(x + 0.5, y + 0.5, 0)).norm(); };
        const double next = 3 * std::sqrt(2.0), rounding = 1e-5; // texels
        const Changes seen =
            changes(before, after, [&](int x, int y) { return apart(x, y) <= next + rounding; });
        QVERIFY2(seen.others == 0,
                 qPrintable(QString("%1 texels farther away instead of 0").arg(seen.others)));
        QVERIFY(seen.meant > 300);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                if (apart(x, y) > next - rounding) continue;
                const Vec3 place = (nearest(x, y) - Vec3(12.3, 14.7, 0)) / 2400;
                const double expected = before->texel(before->level(0), x, y) *
                                        (1 - expectedFalloff((place - centre).norm() / 0.02, 1));
                const double is = after->texel(after->level(0), x, y);
                QVERIFY2(std::abs(is - expected) < 5e-5,
                         qPrintable(QString("%1 %2, %3 beside it: %4 instead of %5")
                                        .arg(x)
                                        .arg(y)
                                        .arg(apart(x, y))
                                        .arg(is)
                                        .arg(expected)));
            }
    }

    /// What lies around the brush is a part of the mean, and stays as it is; and a dab somewhere else does
    /// nothing to what is smooth already.
    void smoothingLooksBeyondTheBrush() {
        const double radius = 6e-3;
        const Soup soup = wholeSheet(9);
        const Image pond = imageOf(80, 80, [&](double x, double y) {
            return (0.04 * Vector2d(x - 0.5, y - 0.5) - Vector2d(-0.01, 0)).norm() > radius ? 1.0 : 0.0;
        });
        const Vec3 here(-0.01, 0, 0), elsewhere(0.01, 0, 0);
        ImageStroke stroke(reachOf(soup), {},
                           std::make_shared<const TexelCover>(*soup, PaintableSurfaces{}, mapOf(pond)), pond,
                           brushOf(BrushMode::Smooth, radius, 1, 0));
        stroke.paint({here});
        const Image once = stroke.image();
        const Changes seen =
            changes(pond, once, [&](int x, int y) { return (placeOf(pond, x, y) - here).norm() <= radius; });
        QCOMPARE(seen.others, 0);
        QCOMPARE_GT(seen.meant, 100);
        stroke.paint({elsewhere});
        const Changes then = changes(once, stroke.image(), [&](int x, int y) {
            return (placeOf(pond, x, y) - elsewhere).norm() <= radius;
        });
        QCOMPARE(then.others, 0);
    }

    /// Nor is another image made where every texel has the value already that it would get.
    void whatHasTheValueAlreadyStaysTheSameImage() {
        const Image before = plain(32, 32, 1);
        for (const BrushMode mode : {BrushMode::Add, BrushMode::Set, BrushMode::Smooth})
            QVERIFY(onImage(wholeSheet(3), before, brushOf(mode, 5e-3, 1, 0.5), {{Vec3::Zero()}}) == before);
    }

    /// The same stroke on vertices and on texels, each read at the vertices: apart by what the brush changes
    /// over a texel at most.
    void vertexAndImageAgree() {
        const double half = 0.02, radius = 5e-3;
        const int side = 256;
        const Soup soup = laidOut(half, 40, 25 * Eigen::Matrix2d::Identity(), {0.5, 0.5});
        std::vector<Dab> places{{{-0.01, 0.002, 0}}, {{0.007, 0.006, 0}}, {{0.003, -0.011, 0}}};
        for (const BrushMode mode :
             {BrushMode::Add, BrushMode::Subtract, BrushMode::Set, BrushMode::Smooth}) {
            const Brush brush = brushOf(mode, radius, 0.7, 1, 0.9);
            const auto values =
                onVertices(soup, brush, places, std::vector<float>(soup->positions.size(), 0.5F));
            const Image image = onImage(soup, plain(side, side, 0.5), brush, places);
            // The falloff is nowhere steeper than 1.5 / radius.
            const double texel = 2 * half / side, most = 0.7 * 1.5 * texel / radius;
            double apart = 0, changed = 0;
            for (std::size_t i = 0; i < soup->positions.size(); ++i) {
                const Vec3& p = soup->positions[i];
                if (p.cwiseAbs().maxCoeff() > half - texel) continue; // the image repeats there
                const Vector2d uv = 25 * p.head<2>() + Vector2d(0.5, 0.5);
                apart = std::max(apart, std::abs(double(values[i]) - valueAt(*image, uv)));
                changed = std::max(changed, std::abs(double(values[i]) - 0.5));
            }
            QVERIFY2(apart < most, qPrintable(QString("%1: %2").arg(int(mode)).arg(apart)));
            if (mode != BrushMode::Smooth) QCOMPARE_GT(changed, 0.25);
        }
    }

    /// A ball of which every triangle is an island of its own, with six texels between: read anywhere on the
    /// surface, the image shows no gap.
    void seamsLeaveNoGaps() {
        auto soup = std::make_shared<TriangleSoup>(*ball(0.02, 2));
        const int across = int(std::ceil(std::sqrt(double(soup->triangles.size())))), cell = 17, edge = 9;
        const int side = across * cell;
        for (std::size_t i = 0; i < soup->triangles.size(); ++i) {
            const Vector2d low(double(int(i) % across * cell), double(int(i) / across * cell));
            for (const Vector2d& corner :
                 {Vector2d(3.3, 3.6), Vector2d(3.3 + edge, 3.9), Vector2d(3.7, 3.6 + edge)})
                soup->cornerUvs.push_back(((low + corner) / side).cast<float>());
        }
        const Image after = onImage(soup, plain(side, side, 0), brushOf(BrushMode::Add, 0.2, 1, 0),
                                    {{{0.02, 0, 0}, Vec3::UnitX()}});
        Rng rng(8);
        int read = 0;
        for (int i = 0; i < 20000; ++i) {
            const std::size_t triangle = rng() % soup->triangles.size();
            const Triangle t = triangleOf(*soup, triangle);
            if ((t.b - t.a).cross(t.c - t.a).x() <= 0) continue; // faces away
            Vec3 w(uniform(rng, 0, 1), uniform(rng, 0, 1), uniform(rng, 0, 1));
            w[int(rng() % 3)] = 0; // on a seam, where it is hardest
            w /= w.sum();
            Vector2d uv = Vector2d::Zero();
            for (std::size_t k = 0; k < 3; ++k)
                uv += w[int(k)] * soup->cornerUvs[3 * triangle + k].cast<double>();
            QCOMPARE_GT(valueAt(*after, uv), 1 - 1e-4);
            ++read;
        }
        QCOMPARE_GT(read, 5000);
    }

    /// Neither by its own surface nor by the margin of its neighbour.
    void lockedSurfacesStay() {
        auto soup =
            std::make_shared<TriangleSoup>(*laidOut(0.02, 20, 25 * Eigen::Matrix2d::Identity(), {0.5, 0.5}));
        for (std::size_t i = 0; i < soup->triangles.size(); ++i)
            soup->surfaceOf[i] = soup->positions[soup->triangles[i][0]].x() >= 0 ? 1 : 0;
        const Image before = plain(128, 128, 0.25);
        const Image after =
            onImage(soup, before, brushOf(BrushMode::Add, 9e-3, 1, 0), {{Vec3::Zero()}}, {{true, false}});
        int painted = 0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const bool changed =
                    after->texel(after->level(0), x, y) != before->texel(before->level(0), x, y);
                if (changed) QCOMPARE_LT(x, 64);
                painted += changed;
            }
        QCOMPARE_GT(painted, 1000);
    }

    /// Where the layer moves, turns and scales its image the texels are those that the layer shows.
    void theMapIsThatOfTheLayer() {
        Rng rng(9);
        const Soup soup = laidOut(0.02, 4, 25 * Eigen::Matrix2d::Identity(), {0.5, 0.5});
        const Image image = imageOf(64, 40, [&](double, double) { return uniform(rng, 0, 1); });
        for (const TextureMapping mapping : {TextureMapping::Uv, TextureMapping::UvUnit}) {
            TextureLayer layer = imageLayer(image, mapping, 0.013, 1e-3);
            layer.pattern.offsetU = 1e-3, layer.pattern.offsetV = -2e-3, layer.pattern.rotation = 0.4;
            const auto stack = stackOf({layer}, soup);
            const TexelMap map = texelMapOf(stack->layers[0].pattern);
            for (int i = 0; i < 50; ++i) {
                TexturePoint point;
                point.uv = {uniform(rng, 0, 1), uniform(rng, 0, 1)};
                const Vector2d texel = map.perUv * point.uv + map.shift;
                const double there = valueAt(*image, texel.cwiseQuotient(Vector2d(64, 40)));
                COMPARE_NEAR(feel(*stack, point, 0).height, 1e-3 * there, 1e-9, "m");
            }
        }
    }

    void theSameStrokeGivesTheSameBits() {
        const Soup soup =
            laidOut(0.02, 15, 60 * Eigen::Matrix2d::Identity(), {0.3, 0.1}); // over the edges too
        Rng rng(10);
        const Image before = imageOf(90, 70, [&](double, double) { return uniform(rng, 0, 1); });
        const std::vector<Dab> places{{{-0.01, 0.002, 0}}, {{0.007, 0.006, 0}}};
        for (int mode = 0; mode < 4; ++mode) {
            const Brush brush = brushOf(BrushMode(mode), 4e-3, 0.7, 0.5, 0.9);
            const Image one = onImage(soup, before, brush, places),
                        two = onImage(soup, before, brush, places);
            QCOMPARE_EQ(texels(*one), texels(*two));
            QCOMPARE_NE(texels(*one), texels(*before));
            const TextureImage whole(90, 70, texels(*one)); // its levels as well
            const auto& top = whole.level(3);
            for (int y = 0; y < top.height; ++y)
                for (int x = 0; x < top.width; ++x)
                    QCOMPARE_EQ(whole.texel(top, x, y), one->texel(one->level(3), x, y));
        }
        ImageStroke none(reachOf(soup), {},
                         std::make_shared<const TexelCover>(*soup, PaintableSurfaces{}, mapOf(before)),
                         before, Brush{});
        none.paint({{9, 9, 9}});
        QVERIFY(none.image() == before);
    }

    /// Against every texel by itself, in every repeat; of the surfaces that are asked for alone.
    void theCoverIsWhatTheTrianglesCover() {
        Rng rng(26);
        const Image image = plain(29, 17, 0);
        const TexelMap map = mapOf(image);
        for (int run = 0; run < 50; ++run) {
            TriangleSoup soup;
            for (Index i = 0; i < 5; ++i) {
                soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
                soup.surfaceOf.push_back(i % 2);
                const Vector2d middle(uniform(rng, -2, 2), uniform(rng, -2, 2));
                for (int k = 0; k < 3; ++k) {
                    const Vector2d uv = middle + Vector2d(uniform(rng, -0.3, 0.3), uniform(rng, -0.3, 0.3));
                    soup.positions.emplace_back(uv.x(), uv.y(), 0);
                    soup.cornerUvs.push_back(uv.cast<float>());
                }
            }
            soup.triangles.push_back({0, 1, 2}); // a line on the image
            soup.surfaceOf.push_back(1);
            for (const double along : {-1.0, 0.5, 1.0})
                soup.cornerUvs.emplace_back(float(along), 0.25F);
            const TexelCover cover(soup, {{false, true}}, map);
            std::vector<char> expected(map.texels(), 0);
            for (const Index i : {1, 3})
                for (int y = -3 * map.height; y < 3 * map.height; ++y)
                    for (int x = -3 * map.width; x < 3 * map.width; ++x)
                        if (TexelTriangle::isInside(
                                TexelTriangle(soup, i, map).weightsAt({x + 0.5, y + 0.5})))
                            expected[map.wrapped(x, y)] = 1;
            for (std::size_t i = 0; i < map.texels(); ++i)
                QVERIFY2(cover.isCovered(i) == bool(expected[i]),
                         qPrintable(QString("run %1, texel %2").arg(run).arg(i)));
        }
    }

    /// Coordinates that repeat the image without end, to all sides or to one: all of it is covered, and found
    /// so after few of them.
    void theCoverOfHostileCoordinatesIsToldSoon() {
        const Image image = plain(32, 32, 0);
        const double most = 64 * 32 * 32 + 1e6 + 1;
        for (const double scale : {1e30, 1e9, 1e7, 1e6, 1e4, 25.0})
            for (const Vector2d& stretched :
                 {Vector2d(scale, 25), Vector2d(25, scale), Vector2d(scale, scale)}) {
                const Soup soup = laidOut(0.02, 3, stretched.asDiagonal(), {0.5, 0.5});
                const TexelCover cover(*soup, {}, mapOf(image));
                const QString which = QString("stretched by %1 and %2").arg(stretched.x()).arg(stretched.y());
                QVERIFY2(double(cover.lookedAt()) <= most,
                         qPrintable(QString("%1: %2 texels instead of %3 at most")
                                        .arg(which)
                                        .arg(double(cover.lookedAt()))
                                        .arg(most)));
                for (std::size_t i = 0; i < 32 * 32; ++i)
                    QVERIFY2(cover.isCovered(i), qPrintable(QString("%1: not texel %2").arg(which).arg(i)));
            }
    }

    /// Coordinates that are damaged, or repeat the image ten thousand times, cost no more than others.
    void oddCoordinatesAreSurvived() {
        const Image before = plain(32, 32, 0);
        for (const double scale : {0.0, 1e-9, 1e7, 1e30}) {
            const Soup soup = laidOut(0.02, 3, scale * Eigen::Matrix2d::Identity(), {0, 0});
            const Image after = onImage(soup, before, brushOf(BrushMode::Add, 5e-3, 1, 1), {{Vec3::Zero()}});
            for (const std::uint16_t texel : texels(*after))
                QCOMPARE_LE(texel, 65535);
        }
        const Soup bare = sheet(0.02, 3);
        QVERIFY(onImage(bare, before, Brush{}, {{Vec3::Zero()}}) == before);
    }
};

TACTUM_TEST(TestImageStroke)

} // namespace test_image_stroke

#include "test_image_stroke.moc"
