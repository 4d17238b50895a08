// Equation (2) solved in the dual, against trying every set of planes in extended precision.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_nearest_point {

using namespace tactum;
using namespace tactum::test;

namespace {

using Planes = std::vector<ConstraintPlane>;

Vec3 nearly(Rng& rng, const Vec3& n, double angle) {
    return (n + angle * direction(rng)).normalized();
}

// Normals all around, in a half space (always feasible), or degenerate copies of earlier ones.
Planes randomPlanes(Rng& rng, int m, bool offsets) {
    Planes planes;
    const Vec3 up = direction(rng);
    const int mix = int(rng() % 4);
    for (int i = 0; i < m; ++i) {
        Vec3 n = direction(rng);
        if (mix > 0 && n.dot(up) < 0) n = -n;
        double offset = offsets ? uniform(rng, -1, 1) : 0;
        if (mix > 1 && i > 0 && rng() % 3 == 0) {
            const ConstraintPlane& other = planes[rng() % planes.size()];
            const int kind = int(rng() % 4);
            n = kind == 2 ? Vec3(-other.normal) : kind == 3 ? nearly(rng, other.normal, 1e-3) : other.normal;
            offset = kind == 0 ? other.offset : kind == 2 ? -other.offset - (offsets ? 0.1 : 0.0) : offset;
        }
        planes.push_back({n, offset});
    }
    return planes;
}

// Most sets small, as in real contact, some as large as they can be.
int randomSize(Rng& rng) {
    const int draw = int(rng() % 100);
    if (draw < 1) return kMaxPlanes;
    return draw < 10 ? 1 + int(rng() % 16) : 1 + int(rng() % 8);
}

// Equations (5) and (6): what makes a point the nearest one. Returns the largest breach.
double breach(const Vec3& u, const Planes& planes, const NearestPoint& found) {
    double worst = 0;
    Vec3 pushed = found.x - u;
    int pushing = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        worst = std::max({worst, planes[i].offset - planes[i].normal.dot(found.x), -found.lambda[i]});
        if (found.lambda[i] > 0) {
            ++pushing;
            worst = std::max(worst, std::abs(planes[i].normal.dot(found.x) - planes[i].offset));
        }
        pushed -= found.lambda[i] * planes[i].normal;
    }
    return pushing > 3 || found.active > 3 ? 1e300 : std::max(worst, pushed.norm());
}

QString describe(int i, const char* what, double size) {
    return QString("case %1: %2 %3").arg(i).arg(what).arg(size);
}

} // namespace

class NearestPointTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithEverySubset();
    void nearlyParallelPlanes();
    void exactlyOppositePlanes();
    void planesThatExcludeEachOther();
    void isFreeAboveAllPlanes();
    void doesNotDependOnScale();
    void doesNotDependOnOrder();
    void whatIsNoNumberEndsTheSearch();
};

void NearestPointTest::agreesWithEverySubset() {
    Rng rng(31);
    int infeasible = 0;
    for (int i = 0; i < 100000; ++i) {
        const Planes planes = randomPlanes(rng, randomSize(rng), i % 2);
        const Vec3 u = uniform(rng, 0.01, 2) * direction(rng);
        const NearestPoint found = nearestPoint(u, planes);
        const auto exact = bruteNearestPoint(u, planes, 1e-15L);
        if (!exact) {
            QVERIFY2(!found.feasible,
                     qPrintable(describe(i, "infeasible set solved with breach", breach(u, planes, found))));
            ++infeasible;
            continue;
        }
        QVERIFY2(found.feasible,
                 qPrintable(describe(i, "called infeasible, condition", double(exact->volume))));
        const double error = double((found.x.cast<Real>() - exact->x).norm());
        // A corner of nearly dependent planes is only as sharp as its normals are given.
        const double allowed =
            1e-12 * std::max(1.0, double(exact->x.norm())) * std::max(1.0, 1e-3 / double(exact->volume));
        QVERIFY2(error < allowed, qPrintable(describe(i, "error", error)));
        QVERIFY2(breach(u, planes, found) < allowed,
                 qPrintable(describe(i, "breach", breach(u, planes, found))));
    }
    QCOMPARE_GT(infeasible, 1000);
}

// Two planes that differ by an angle d: the line in which they meet is known to 1e-16 / d.
void NearestPointTest::nearlyParallelPlanes() {
    Rng rng(32);
    for (double angle : {1e-4, 1e-6, 1e-8, 1e-10, 1e-13, 1e-16})
        for (int i = 0; i < 1000; ++i) {
            const Vec3 n = direction(rng);
            Planes planes;
            for (int k = 0; k < 6; ++k)
                planes.push_back({nearly(rng, n, angle), 0});
            const Vec3 u = direction(rng) - n;
            const NearestPoint found = nearestPoint(u, planes);
            QVERIFY(found.feasible);
            double violation = 0;
            Vec3 pushed = found.x - u;
            for (int k = 0; k < 6; ++k) {
                violation = std::max(violation, -planes[k].normal.dot(found.x));
                QCOMPARE_GE(found.lambda[k], 0);
                pushed -= found.lambda[k] * planes[k].normal;
            }
            QVERIFY2(violation < 1e-12, qPrintable(describe(i, "violation", violation)));
            QVERIFY2(pushed.norm() < 1e-14, qPrintable(describe(i, "unbalanced", pushed.norm())));
            // Whatever the corner is, it is within the angle of the foot point on the one plane.
            COMPARE_NEAR(found.x, u - n * n.dot(u), 10 * angle + 1e-12, "");
        }
}

void NearestPointTest::exactlyOppositePlanes() {
    Rng rng(33);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = direction(rng);
        const double where = i % 2 ? uniform(rng, -1, 1) : 0;
        const Planes planes{{n, where}, {-n, -where}};
        const Vec3 u = 2 * inBox(rng, 1);
        const NearestPoint found = nearestPoint(u, planes);
        QVERIFY(found.feasible);
        COMPARE_NEAR(found.x, u + (where - n.dot(u)) * n, 1e-13, "");
    }
}

void NearestPointTest::planesThatExcludeEachOther() {
    Rng rng(34);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = direction(rng), t = n.cross(direction(rng)).normalized(), b = n.cross(t);
        // Two walls that overlap, and a prism turned inside out.
        const Planes walls{{n, 0.1}, {t, 0}, {-n, -0.099}};
        QVERIFY(!nearestPoint(inBox(rng, 1), walls).feasible);
        const Planes prism{
            {t, 0.1}, {-0.5 * t + std::sqrt(0.75) * b, 0.1}, {-0.5 * t - std::sqrt(0.75) * b, 0.1}};
        const NearestPoint found = nearestPoint(inBox(rng, 1), prism);
        QVERIFY(!found.feasible);
        QCOMPARE(found.x, Vec3(Vec3::Zero()));
    }
}

void NearestPointTest::isFreeAboveAllPlanes() {
    const Planes planes{{Vec3::UnitZ(), 0}, {Vec3::UnitX(), -1}};
    const Vec3 u(-0.5, 3, 0.2);
    const NearestPoint found = nearestPoint(u, planes);
    QCOMPARE(found.x, u);
    QCOMPARE(found.active, 0);
    QCOMPARE(nearestPoint(u, {}).x, u);
}

void NearestPointTest::doesNotDependOnScale() {
    Rng rng(35);
    for (int i = 0; i < 2000; ++i) {
        Planes planes = randomPlanes(rng, 1 + int(rng() % 8), true);
        const Vec3 u = direction(rng);
        const NearestPoint unit = nearestPoint(u, planes);
        const double scale = 0x1p-40; // a power of two: the same bits
        for (ConstraintPlane& plane : planes)
            plane.offset *= scale;
        const NearestPoint small = nearestPoint(scale * u, planes);
        QCOMPARE(small.feasible, unit.feasible);
        if (unit.feasible) QCOMPARE(small.x, Vec3(scale * unit.x));
    }
}

void NearestPointTest::doesNotDependOnOrder() {
    Rng rng(36);
    for (int i = 0; i < 2000; ++i) {
        Planes planes = randomPlanes(rng, 2 + int(rng() % 12), false);
        const Vec3 u = direction(rng), first = nearestPoint(u, planes).x;
        std::reverse(planes.begin(), planes.end());
        COMPARE_NEAR(nearestPoint(u, planes).x, first, 1e-12, "");
    }
}

// A plane was dropped once that the set did not have: an assertion says so.
void NearestPointTest::whatIsNoNumberEndsTheSearch() {
    Rng rng(37);
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (int i = 0; i < 20000; ++i) {
        Planes planes = randomPlanes(rng, 1 + int(rng() % 12), false);
        for (ConstraintPlane& plane : planes)
            for (double* value : {&plane.normal.x(), &plane.normal.y(), &plane.normal.z(), &plane.offset})
                if (rng() % 4 == 0) *value = std::array{infinity, -infinity, nan, 1e200, -1e300}[rng() % 5];
        const NearestPoint nearest = nearestPoint(direction(rng), planes);
        QCOMPARE_GE(nearest.active, 0);
        QCOMPARE_LE(nearest.active, 3);
    }
}

TACTUM_TEST(NearestPointTest)

} // namespace test_nearest_point

#include "test_nearest_point.moc"
