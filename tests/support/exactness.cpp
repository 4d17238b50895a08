#include "tests/support/exactness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/mesh_health.h"
#include "core/geometry/triangle.h"
#include "tests/support/reference.h"

namespace tactum::test {

namespace {

constexpr double kMaxCells = 16e6;
constexpr double kFar = 1e-3, kOff = 10e-6, kOverlap = -2e-9;
constexpr double kAtRest = 1e-10; // m
constexpr int kMaxSteps = 400;
// Two clear places of a sphere nearer than its diameter lie on the same side of everything.
constexpr double kSurelyOneSide = 1.9;
// A surface with holes lets some of its winding number leak.
constexpr double kInside = 0.6;

// How much more of the directions around p see a back than see a front, from -1 to 1: 1 inside a closed
// surface and 0 outside it; it jumps by 1 wherever a surface is crossed.
double windingNumber(const TriangleSoup& soup, const Vec3& p) {
    double sum = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle t = triangleOf(soup, i);
        const Vec3 a = t.a - p, b = t.b - p, c = t.c - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        const double across = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        sum += std::atan2(a.dot(b.cross(c)), across);
    }
    return sum / (2 * std::numbers::pi);
}

// Where the nearest point of the free room lies from here.
Vec3 stepToward(const TriangleGrid& grid, double r, double reach, const Vec3& p, const Vec3& finger) {
    std::vector<ConstraintPlane> planes;
    grid.near(p, r + reach, [&](Index i) {
        const Vec3 away = p - closestPoint(triangleOf(grid.soup(), i), p).point;
        const double distance = away.norm();
        if (distance > 0 && distance < r + reach)
            planes.push_back({away / distance, std::min(0.0, r - distance)});
    });
    const Vec3 step = nearestInRoom(finger - p, planes);
    return step * std::min(1.0, reach / std::max(step.norm(), 1e-300));
}

} // namespace

TriangleGrid::TriangleGrid(const TriangleSoup& soup, double cell) : soup_(soup), cell_(cell) {
    const Bounds bounds = boundsOf(soup);
    if (bounds.empty()) {
        first_.assign(2, 0);
        return;
    }
    low_ = bounds.low;
    const Vec3 size = bounds.high - bounds.low;
    while ((size / cell_ + Vec3::Ones()).prod() > kMaxCells)
        cell_ *= 1.25;
    cells_ = (size / cell_).cast<int>() + Cell::Ones();
    first_.assign(std::size_t(cells_.cast<double>().prod()) + 1, 0);
    // Counted, summed, then filled from each cell's end to its beginning.
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        eachCellOf(i, [&](std::size_t c) { ++first_[c]; });
    for (std::size_t c = 1; c < first_.size(); ++c)
        first_[c] += first_[c - 1];
    triangles_.resize(first_.back());
    for (std::size_t i = soup.triangles.size(); i-- > 0;)
        eachCellOf(i, [&](std::size_t c) { triangles_[--first_[c]] = Index(i); });
}

template <class Seen> void TriangleGrid::eachCellOf(std::size_t triangle, Seen&& seen) const {
    Bounds box;
    for (Index corner : soup_.triangles[triangle])
        box.add(soup_.positions[corner]);
    const Cell low = cellAt(box.low), high = cellAt(box.high);
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x)
                seen(indexOf({x, y, z}));
}

TriangleGrid::Cell TriangleGrid::cellAt(const Vec3& p) const {
    const Vec3 place = ((p - low_) / cell_).cwiseMax(0.0).cwiseMin((cells_ - Cell::Ones()).cast<double>());
    return place.cast<int>();
}

std::size_t TriangleGrid::indexOf(const Cell& cell) const {
    return (std::size_t(cell.z()) * std::size_t(cells_.y()) + std::size_t(cell.y())) *
               std::size_t(cells_.x()) +
           std::size_t(cell.x());
}

double clearance(const TriangleGrid& grid, const Vec3& p, double reach) {
    double nearest = reach;
    grid.near(p, reach, [&](Index i) {
        nearest = std::min(nearest, (p - closestPoint(triangleOf(grid.soup(), i), p).point).norm());
    });
    return nearest;
}

double distanceFromMinimum(const TriangleGrid& grid, double r, const Vec3& proxy, const Vec3& finger) {
    Vec3 p = proxy;
    for (int i = 0; i < kMaxSteps; ++i) {
        const Vec3 step = stepToward(grid, r, r / 4, p, finger);
        p += step;
        if (step.norm() < kAtRest) break;
    }
    return (p - proxy).norm();
}

Exactness exactnessOf(const TriangleSoup& soup, double r, const TouchTrace& rows) {
    Exactness result;
    if (rows.empty()) return result;
    const TriangleGrid grid(soup, 1.25 * r);
    result.rows = rows.size();
    result.closed = healthOf(soup).value().closed();
    result.smallestClearance = 1e300;
    const double outside = windingNumber(soup, rows.front().proxy);
    bool inside = false;
    Vec3 before = rows.front().proxy;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const TouchRow& row = rows[i];
        const double far = distanceFromMinimum(grid, r, row.proxy, row.finger);
        result.farRows += far > kFar;
        result.offRows += far > kOff;
        result.worst = std::max(result.worst, far);
        const double clear = clearance(grid, row.proxy, 2 * r) - r;
        result.smallestClearance = std::min(result.smallestClearance, clear);
        if (far > kOff || clear < kOverlap) result.faults.push_back({i, far, clear});
        result.deepest = std::max(result.deepest, (row.finger - row.proxy).norm());
        if ((row.proxy - before).norm() > kSurelyOneSide * r)
            inside = windingNumber(soup, row.proxy) > outside + kInside;
        result.insideRows += inside;
        before = row.proxy;
    }
    return result;
}

} // namespace tactum::test
