// The triangle's closed forms against slow answers in extended precision.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_triangle {

using namespace tactum;
using namespace tactum::test;

namespace {

enum class Kind { Compact, Sliver, Flat, Segment, Point };

Triangle randomTriangle(Rng& rng, Kind kind) {
    const Vec3 a = inBox(rng, 1), b = a + std::pow(10, uniform(rng, -2, 0)) * direction(rng);
    const Vec3 between = a + uniform(rng, -0.2, 1.2) * (b - a);
    switch (kind) {
    case Kind::Compact:
        return {a, b, a + (b - a).norm() * uniform(rng, 0.3, 2) * direction(rng)};
    case Kind::Sliver:
        return {a, b, between + std::pow(10, uniform(rng, -14, -2)) * direction(rng)};
    case Kind::Flat:
        return {a, b, between};
    case Kind::Segment:
        return {a, b, b};
    case Kind::Point:
        break;
    }
    return {a, a, a};
}

constexpr Kind kKinds[] = {Kind::Compact, Kind::Sliver, Kind::Flat, Kind::Segment, Kind::Point};

double sizeOf(const Triangle& t, const Vec3& p) {
    return std::max({(p - t.a).norm(), (p - t.b).norm(), (p - t.c).norm()});
}

// All orders of the corners, front and back.
std::array<Triangle, 6> permutations(const Triangle& t) {
    return {{{t.a, t.b, t.c},
             {t.b, t.c, t.a},
             {t.c, t.a, t.b},
             {t.a, t.c, t.b},
             {t.c, t.b, t.a},
             {t.b, t.a, t.c}}};
}

// Where a convex function of t in [0, 1] is least.
template <class Function> Real whereLeast(Function&& f) {
    Real low = 0, high = 1;
    for (int i = 0; i < 80; ++i) {
        const Real third = (high - low) / 3;
        if (f(low + third) < f(high - third))
            high -= third;
        else
            low += third;
    }
    return f(0) <= f((low + high) / 2) ? 0 : (low + high) / 2;
}

struct Sweep {
    Triangle triangle;
    Vec3 from, motion;
    double radius;

    Real gap(Real t) const {
        return distance(triangle, from.cast<Real>() + t * motion.cast<Real>()) - Real(radius);
    }
};

// Rounding of the closed forms: parts of the largest length, and of the square of the start's distance over
// the radius, which is what the discriminant of a quadratic loses.
Real toleranceOf(const Sweep& s) {
    const double lever = sizeOf(s.triangle, s.from) + s.motion.norm();
    return 1e-12L * (lever + s.radius) + 2e-15L * lever * lever / s.radius;
}

// Empty when the contact time is right: the distance is a convex function of the time, so it is r and falling
// at one time at most.
QString mistake(const Sweep& s) {
    const double t = sweepSphere(s.triangle, s.from, s.motion, s.radius);
    const Real tolerance = toleranceOf(s);
    auto gap = [&](Real time) { return s.gap(time); };
    const Real start = gap(0);
    if (t == kNoContact || t == 0) {
        const Real depth = gap(whereLeast(gap));
        if (t == 0) return start <= tolerance && depth <= start + tolerance ? "" : "time 0";
        if (start > 0 && depth < -tolerance) return QString("missed, depth %1").arg(double(depth));
        if (start <= 0 && depth < start - tolerance) return "an overlapping start goes deeper";
        return {};
    }
    if (!(t > 0 && t <= 1) || start < -tolerance) return QString("time %1").arg(t);
    if (std::abs(gap(t)) > tolerance) return QString("gap %1 at contact").arg(double(gap(t)));
    if (gap(0.999L * t) < gap(t) - tolerance) return "touched on the way out";
    return {};
}

} // namespace

class TriangleTest : public QObject {
    Q_OBJECT

private slots:
    void weightsReproduceTheNearestPoint();
    void nothingOnTheTriangleIsNearer();
    void orderOfCornersDoesNotMatter();
    void featureIsWhereThePointLies();
    void sweepAgreesWithARootFinder();
    void sweepGrazes();
    void sweepAgreesAtEveryScale();
    void touchingSphereGoesNoDeeper();
};

void TriangleTest::weightsReproduceTheNearestPoint() {
    Rng rng(1);
    for (int i = 0; i < 100000; ++i) {
        const Triangle t = randomTriangle(rng, kKinds[i % 5]);
        const Vec3 p = inBox(rng, 2);
        const ClosestPoint closest = closestPoint(t, p);
        const Vec3 rebuilt = closest.weights[0] * t.a + closest.weights[1] * t.b + closest.weights[2] * t.c;
        COMPARE_NEAR(closest.weights.sum(), 1, 1e-14, "");
        QCOMPARE_GE(closest.weights.minCoeff(), -1e-9);
        COMPARE_NEAR(rebuilt, closest.point, 1e-14 * sizeOf(t, Vec3::Zero()) + 1e-14, "m");
    }
}

void TriangleTest::nothingOnTheTriangleIsNearer() {
    Rng rng(2);
    for (int i = 0; i < 100000; ++i) {
        const Triangle t = randomTriangle(rng, kKinds[i % 5]);
        const Vec3 p = i % 2 ? inBox(rng, 2) : Vec3(t.a + 0.1 * direction(rng));
        const double found = (p - closestPoint(t, p).point).norm();
        const double exact = double(distance(t, p.cast<Real>()));
        QVERIFY2(
            std::abs(found - exact) < 1e-12 * sizeOf(t, p),
            qPrintable(
                QString("case %1: %2 instead of %3").arg(i).arg(found, 0, 'g', 17).arg(exact, 0, 'g', 17)));
    }
    // The same by dense sampling, which shares no formula with anything.
    for (int i = 0; i < 50; ++i) {
        const Triangle t = randomTriangle(rng, kKinds[i % 5]);
        const Vec3 p = inBox(rng, 2);
        const double found = (p - closestPoint(t, p).point).norm();
        double nearest = 1e300;
        constexpr int grid = 200;
        for (int v = 0; v <= grid; ++v)
            for (int w = 0; w <= grid - v; ++w)
                nearest = std::min(
                    nearest,
                    (p - (t.a + (double(v) / grid) * (t.b - t.a) + (double(w) / grid) * (t.c - t.a))).norm());
        QCOMPARE_LE(found, nearest + 1e-14);
        QCOMPARE_LT(nearest - found, 3.0 / grid);
    }
}

void TriangleTest::orderOfCornersDoesNotMatter() {
    Rng rng(3);
    for (int i = 0; i < 20000; ++i) {
        const Triangle t = randomTriangle(rng, kKinds[i % 5]);
        const Vec3 p = inBox(rng, 2);
        const double first = (p - closestPoint(t, p).point).norm();
        for (const Triangle& turned : permutations(t))
            COMPARE_NEAR((p - closestPoint(turned, p).point).norm(), first, 1e-12 * sizeOf(t, p), "m");
    }
}

void TriangleTest::featureIsWhereThePointLies() {
    const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    QCOMPARE_EQ(closestPoint(t, {0.2, 0.3, 1}).feature, Feature::Face);
    COMPARE_NEAR(closestPoint(t, {0.2, 0.3, 1}).point, Vec3(0.2, 0.3, 0), 1e-15, "m");
    QCOMPARE_EQ(closestPoint(t, {0.5, -1, 1}).feature, Feature::Edge);
    QCOMPARE(closestPoint(t, {0.5, -1, 1}).weights, Vec3(0.5, 0.5, 0));
    QCOMPARE_EQ(closestPoint(t, {-1, -1, 1}).feature, Feature::Vertex);
    QCOMPARE(closestPoint(t, {2, -0.5, 0}).weights, Vec3(0, 1, 0));
}

void TriangleTest::sweepAgreesWithARootFinder() {
    Rng rng(4);
    for (int i = 0; i < 100000; ++i) {
        Sweep s{randomTriangle(rng, kKinds[i % 5]), inBox(rng, 1.5), inBox(rng, 3),
                std::pow(10, uniform(rng, -4, 0))};
        if (i % 3) { // aimed at the triangle: most of these touch
            const Vec3 aim = uniform(rng, 0, 0.6) * (s.triangle.b - s.triangle.a) +
                             uniform(rng, 0, 0.4) * (s.triangle.c - s.triangle.a) + s.triangle.a;
            s.motion = uniform(rng, 0.3, 2) * (aim - s.from);
        }
        const QString wrong = mistake(s);
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("case %1: %2").arg(i).arg(wrong)));
    }
}

// Paths that pass a corner, an edge or the plane at the distance r to within rounding: a touch may be
// reported or not, but never at a wrong place.
void TriangleTest::sweepGrazes() {
    Rng rng(5);
    for (int i = 0; i < 20000; ++i) {
        Sweep s{randomTriangle(rng, kKinds[i % 5]), Vec3::Zero(), Vec3::Zero(), uniform(rng, 0.01, 0.5)};
        const Vec3 corner = i % 2 ? s.triangle.a : Vec3(0.5 * (s.triangle.a + s.triangle.b));
        const Vec3 out = direction(rng), along = out.cross(direction(rng)).normalized();
        const double nudge = (int(rng() % 5) - 2) * 1e-10;
        s.from = corner + (s.radius + nudge) * out - uniform(rng, 0, 1) * along;
        s.motion = 2 * along;
        const QString wrong = mistake(s);
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("case %1: %2").arg(i).arg(wrong)));
    }
}

void TriangleTest::sweepAgreesAtEveryScale() {
    Rng rng(6);
    for (double scale : {1e-9, 1e-6, 1e-3, 1e3, 1e6})
        for (int i = 0; i < 4000; ++i) {
            const Triangle t = randomTriangle(rng, kKinds[i % 5]);
            const Vec3 from = inBox(rng, 1.5);
            const Sweep s{{scale * t.a, scale * t.b, scale * t.c},
                          scale * from,
                          scale * uniform(rng, 0.5, 2) * (t.b - from),
                          scale * uniform(rng, 0.01, 0.3)};
            const QString wrong = mistake(s);
            QVERIFY2(wrong.isEmpty(),
                     qPrintable(QString("scale %1, case %2: %3").arg(scale).arg(i).arg(wrong)));
        }
}

// A sphere that a sweep has just stopped at the surface, to the last bit, and that is sent on into it.
void TriangleTest::touchingSphereGoesNoDeeper() {
    Rng rng(7);
    int touched = 0;
    for (int i = 0; i < 200000; ++i) {
        const Triangle t = randomTriangle(rng, kKinds[i % 5]);
        const double radius = uniform(rng, 0.01, 0.5);
        const Vec3 from = inBox(rng, 1.5), way = 2 * (t.a + 0.4 * (t.b - t.a) + 0.3 * (t.c - t.a) - from);
        const double time = sweepSphere(t, from, way, radius);
        if (!(time > 0 && time <= 1)) continue;
        const Vec3 stopped = from + time * way, away = stopped - closestPoint(t, stopped).point;
        const Vec3 on = (direction(rng) - away.normalized()).normalized();
        if (on.dot(away) > -0.1 * radius) continue;
        ++touched;
        const double next = sweepSphere(t, stopped, on, radius);
        QVERIFY2(next < 1e-9, qPrintable(QString("case %1: goes on for %2").arg(i).arg(next)));
    }
    QCOMPARE_GT(touched, 50000);
}

TACTUM_TEST(TriangleTest)

} // namespace test_triangle

#include "test_triangle.moc"
