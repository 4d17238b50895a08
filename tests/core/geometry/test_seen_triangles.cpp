// What is selected by drawing over the view, against a slow answer: a ray through the middle of every pixel.
#include <cmath>
#include <random>
#include <set>

#include <QTest>

#include "core/geometry/seen_triangles.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_seen_triangles {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kSide = 64;

/// Looks along -z; a thing at z = -1 and as wide as 2 fills the view.
Eigen::Matrix4d eye() {
    constexpr double kNear = 0.1, kFar = 10;
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = m(1, 1) = 1;
    m(2, 2) = (kNear + kFar) / (kNear - kFar);
    m(2, 3) = 2 * kNear * kFar / (kNear - kFar);
    m(3, 2) = -1;
    return m;
}

BodyInView inView(TriangleSoup soup, const Vec3& at) {
    BodyInView body{std::make_shared<const TriangleSoup>(std::move(soup)),
                    eye() * Eigen::Affine3d(Eigen::Translation3d(at)).matrix(),
                    {}};
    body.shown.assign(4, true);
    return body;
}

ScreenMask whole() {
    ScreenMask mask(kSide, kSide);
    const ScreenMask::Point corners[] = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
    mask.addPolygon(corners);
    return mask;
}

std::set<Index> seenOf(const SeenTriangles& seen, const ScreenMask& mask, std::uint32_t body = 0) {
    std::set<Index> result;
    seen.eachUnder(mask, [&](std::uint32_t b, Index t) {
        if (b == body) result.insert(t);
    });
    return result;
}

int count(const ScreenMask& mask) {
    int pixels = 0;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            pixels += mask.has(x, y);
    return pixels;
}

/// How far along a ray from the origin a triangle is met; nothing beside it, or nearly beside.
std::optional<double> met(const TriangleSoup& soup, Index t, const Vec3& at, const Vec3& ray, double margin) {
    const auto& c = soup.triangles[t];
    Eigen::Matrix3d m;
    m << soup.positions[c[0]] + at, soup.positions[c[1]] + at, soup.positions[c[2]] + at;
    if (std::abs(m.determinant()) < 1e-9) return std::nullopt;
    const Vec3 parts = m.inverse() * ray;
    if (parts.minCoeff() < margin * parts.cwiseAbs().maxCoeff() || !(parts.sum() > 0)) return std::nullopt;
    return 1 / parts.sum();
}

} // namespace

class TestSeenTriangles : public QObject {
    Q_OBJECT

private slots:

    // Two plates across the way of the eye; a section takes the left half of the one in front.
    void whatASectionCutsAwayIsNotSeen() {
        const auto plate = [](double x0, double x1) {
            TriangleSoup soup;
            soup.positions = {{x0, -1, 0}, {x1, -1, 0}, {x1, 1, 0}, {x0, 1, 0}};
            soup.triangles = {{0, 1, 2}, {0, 2, 3}};
            soup.surfaceOf = {0, 0};
            return soup;
        };
        BodyInView front = inView(plate(-1, 1), {0, 0, -1}), back = inView(plate(-2, 2), {0, 0, -2});
        const auto right = [](const BodyInView& body) { // what is right of the middle is kept
            return Eigen::Vector4d(body.clipFromBody.inverse().transpose() * Eigen::Vector4d(1, 0, 0, 0));
        };
        front.kept = right(front);
        const auto seen = SeenTriangles::look({front, back}, kSide, kSide).value();
        int wrong = 0;
        for (int y = 1; y < kSide - 1; ++y)
            for (int x = 1; x < kSide - 1; ++x) {
                if (std::abs(x - kSide / 2) < 2) continue;
                ScreenMask pixel(kSide, kSide);
                const ScreenMask::Point corners[] = {
                    {double(x), double(y)}, {x + 1.0, double(y)}, {x + 1.0, y + 1.0}, {double(x), y + 1.0}};
                pixel.addPolygon(corners);
                wrong += seenOf(seen, pixel, 0).empty() != (x < kSide / 2);
            }
        QCOMPARE(wrong, 0);
        ScreenMask left(kSide, kSide);
        const ScreenMask::Point corners[] = {{0, 0}, {kSide / 2 - 2, 0}, {kSide / 2 - 2, kSide}, {0, kSide}};
        left.addPolygon(corners);
        QVERIFY(trianglesUnder(front, left).value().empty());
        QCOMPARE(trianglesUnder(back, left).value().size(), 1U + 1U);
    }
    void aLineGoesRoundPixels() {
        ScreenMask mask(8, 8);
        QVERIFY(mask.empty());
        const ScreenMask::Point square[] = {{1.4, 2.4}, {5.4, 2.4}, {5.4, 4.4}, {1.4, 4.4}};
        mask.addPolygon(square);
        QCOMPARE(count(mask), 4 * 2);
        QVERIFY(mask.has(1, 2) && mask.has(4, 3) && !mask.has(5, 3) && !mask.has(1, 4));
        QCOMPARE(mask.top(), 2);
        QCOMPARE(mask.bottom(), 3);
    }

    /// A line that crosses itself, gone round twice in the same sense or out of the view, has no holes.
    void aLineMayCrossItselfAndLeaveTheView() {
        ScreenMask twice(8, 8);
        const ScreenMask::Point round[] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {6, 2}, {6, 6}, {2, 6}};
        twice.addPolygon(round);
        QVERIFY(twice.has(4, 4));
        ScreenMask outside(8, 8);
        const ScreenMask::Point far[] = {{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}};
        outside.addPolygon(far);
        QCOMPARE(count(outside), 64);
        ScreenMask none(8, 8);
        const ScreenMask::Point wrong[] = {{0, 0}, {8, std::nan("")}, {8, 8}};
        none.addPolygon(wrong);
        none.addStroke({0, std::nan("")}, {1, 1}, 3);
        QVERIFY(none.empty());
    }

    void aStrokeIsItsDiscs() {
        ScreenMask mask(32, 32);
        mask.addStroke({8.5, 8.5}, {20.5, 8.5}, 3);
        QVERIFY(mask.has(8, 5) && mask.has(14, 11) && mask.has(23, 8) && mask.has(5, 8));
        QVERIFY(!mask.has(8, 4) && !mask.has(24, 8) && !mask.has(5, 5));
        ScreenMask point(32, 32);
        point.addStroke({3.02, 3.98}, {3.02, 3.98}, 0);
        QVERIFY(point.has(3, 3));
        QCOMPARE_LE(count(point), 4);
    }

    void whatLiesBehindIsNotSeen() {
        const auto flat = [](double, double) { return 0.0; };
        TriangleSoup small = grid(1, flat);
        for (Vec3& p : small.positions)
            p *= 0.25;
        const auto seen = SeenTriangles::look(
            {inView(grid(2, flat), {-0.5, -0.5, -0.6}), inView(small, {-0.125, -0.125, -0.5})}, kSide, kSide);
        VERIFY_RESULT(seen);
        ScreenMask middle(kSide, kSide);
        middle.addStroke({32, 32}, {32, 32}, 4);
        QVERIFY(seenOf(*seen, middle, 0).empty());
        QCOMPARE(seenOf(*seen, middle, 1).size(), std::size_t(2));
        QCOMPARE(seenOf(*seen, whole(), 0).size(), std::size_t(8));
        const auto through = trianglesUnder(seen->bodies()[0], middle);
        VERIFY_RESULT(through);
        // Of each of the four squares at the middle, one or both triangles.
        QCOMPARE_GE(through->size(), std::size_t(4));
    }

    void hiddenSurfacesLetThrough() {
        const auto flat = [](double, double) { return 0.0; };
        auto back = inView(grid(1, flat), {-0.5, -0.5, -0.6}),
             front = inView(grid(1, flat), {-0.5, -0.5, -0.5});
        front.shown[0] = false;
        const auto seen = SeenTriangles::look({back, front}, kSide, kSide);
        VERIFY_RESULT(seen);
        QCOMPARE(seenOf(*seen, whole(), 0).size(), std::size_t(2));
        QVERIFY(seenOf(*seen, whole(), 1).empty());
        QVERIFY(trianglesUnder(front, whole())->empty());
    }

    void theFrontOfACube() {
        const auto body = inView(cube({-0.5, -0.5, -3}), Vec3::Zero());
        const auto seen = SeenTriangles::look({body}, kSide, kSide);
        VERIFY_RESULT(seen);
        QCOMPARE(seenOf(*seen, whole()), (std::set<Index>{2, 3})); // z = -2
        QCOMPARE(trianglesUnder(body, whole())->size(), std::size_t(12));
        // Around the eye: cut at the near plane, nothing behind it.
        const auto inside =
            SeenTriangles::look({inView(cube({-0.5, -0.5, -0.4}), Vec3::Zero())}, kSide, kSide);
        VERIFY_RESULT(inside);
        QCOMPARE(seenOf(*inside, whole()), (std::set<Index>{0, 1}));
    }

    /// On a ball of 80,000 triangles over 1,300 pixels most cover the middle of none.
    void smallTrianglesAreSeenToo() {
        constexpr Index kCells = 200;
        TriangleSoup ball = grid(kCells, [](double, double) { return 0.0; });
        for (Vec3& p : ball.positions) {
            const double around = 2 * M_PI * p.x(), up = M_PI * (p.y() - 0.5);
            p = Vec3(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around));
        }
        const Vec3 at(0, 0, -3);
        const auto seen = SeenTriangles::look({inView(ball, at)}, kSide, kSide);
        VERIFY_RESULT(seen);
        const std::set<Index> found = seenOf(*seen, whole());
        std::size_t front = 0, missed = 0, wrong = 0;
        for (Index t = 0; t < ball.triangles.size(); ++t) {
            Vec3 middle = Vec3::Zero();
            for (const Index corner : ball.triangles[t])
                middle += ball.positions[corner] / 3;
            const double turned = middle.normalized().dot((middle + at).normalized()); // < 0: to the eye
            front += turned < -0.05;
            missed += turned < -0.05 && !found.contains(t);
            wrong += turned > 0.15 && found.contains(t);
        }
        QCOMPARE_GT(front, std::size_t(15000));
        QCOMPARE_LT(missed, front / 100);
        QCOMPARE(wrong, std::size_t(0));
    }

    void everyPixelShowsWhatARayMeetsFirst() {
        std::mt19937 random(7);
        int compared = 0;
        for (int round = 0; round < 20; ++round) {
            const TriangleSoup soup = tangle(random, 30);
            const Vec3 at(-1, -0.5, -3);
            const auto seen = SeenTriangles::look({inView(soup, at)}, kSide, kSide);
            VERIFY_RESULT(seen);
            for (int i = 0; i < 200; ++i) {
                const int x = int(random() % kSide), y = int(random() % kSide);
                const Vec3 ray(2 * (x + 0.5) / kSide - 1, 1 - 2 * (y + 0.5) / kSide, -1);
                std::optional<double> nearest;
                for (Index t = 0; t < soup.triangles.size(); ++t)
                    if (const auto far = met(soup, t, at, ray, 1e-6); far && (!nearest || *far < *nearest))
                        nearest = far;
                ScreenMask pixel(kSide, kSide);
                pixel.addStroke({x + 0.5, y + 0.5}, {x + 0.5, y + 0.5}, 0);
                const std::set<Index> found = seenOf(*seen, pixel);
                if (!nearest) continue;
                bool any = false;
                for (const Index t : found) // that on whose edge the ray goes may be nearer
                    if (const auto far = met(soup, t, at, ray, -1e-6); far && *far < *nearest + 1e-4)
                        any = true;
                QVERIFY2(any, "something else is in front");
                ++compared;
            }
        }
        QCOMPARE_GT(compared, 300);
    }

    void whoIsCancelledStops() {
        const std::atomic<bool> cancelled{true};
        Progress progress;
        progress.cancelled = &cancelled;
        const auto body = inView(grid(60, [](double, double) { return 0.0; }), {-0.5, -0.5, -1});
        QVERIFY(!SeenTriangles::look({body}, kSide, kSide, progress));
        QVERIFY(!trianglesUnder(body, whole(), progress));
    }
};

TACTUM_TEST(TestSeenTriangles)

} // namespace test_seen_triangles

#include "test_seen_triangles.moc"
