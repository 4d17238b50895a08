// Goldfarb and Idnani's dual active-set method (Mathematical Programming 27, 1983) in three dimensions.
//
// It climbs the dual of section 2.2: x = u + N lambda (6) holds throughout, lambda >= 0 throughout, and each
// pivot satisfies one more plane until none is violated. Every pivot raises the dual objective (7), so it
// ends, with at most three planes active. The paper runs Gilbert's algorithm on the hull of the columns of
// S = [0 | c_i n_i] (9), (17) for the same answer; that needs every c_i = 1 / (u . n_i) (10) to exist, and
// planes through one point.

#include "core/proxy/nearest_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace tactum {

namespace {

constexpr int kMaxPivots = 4 * kMaxPlanes;
// Violations below this part of the lengths in a problem are rounding.
constexpr double kRounding = 3e-14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct ActiveSet {
    std::array<int, 3> plane{};
    std::array<double, 3> lambda{};
    int size = 0;

    bool contains(int i) const {
        return std::find(plane.begin(), plane.begin() + size, i) != plane.begin() + size;
    }
    void add(int i, double value) {
        plane[size] = i;
        lambda[size++] = value;
    }
    void drop(int k) {
        assert(k >= 0 && k < size);
        for (; k + 1 < size; ++k) {
            plane[k] = plane[k + 1];
            lambda[k] = lambda[k + 1];
        }
        --size;
    }
};

// normal = sum r_k n_k + z with z perpendicular to the active normals.
struct Split {
    std::array<double, 3> r{};
    Vec3 z = Vec3::Zero();
};

class Solver {
public:
    Solver(const Vec3& u, std::span<const ConstraintPlane> planes) noexcept : u_(u), x_(u), planes_(planes) {
        scale_ = u.norm();
        for (const ConstraintPlane& plane : planes)
            scale_ = std::max(scale_, std::abs(plane.offset));
    }

    NearestPoint solve() noexcept {
        NearestPoint result;
        for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
            const int violated = mostViolated();
            if (violated < 0) {
                result.x = x_;
                for (int k = 0; k < active_.size; ++k)
                    result.lambda[active_.plane[k]] = active_.lambda[k];
                result.active = active_.size;
                return result;
            }
            if (!satisfy(violated)) break;
            polish();
        }
        result.feasible = false;
        return result;
    }

private:
    const Vec3& normal(int k) const { return planes_[active_.plane[k]].normal; }

    // Of a corner so sharp that its multipliers are large, x is known no better than their rounding: a fourth
    // plane through the corner is not to count as violated by it. Nor are two opposite walls, parallel but
    // for the rounding of their normals, to close like a wedge.
    int mostViolated() const noexcept {
        int worst = -1;
        double most = scale_;
        for (int k = 0; k < active_.size; ++k)
            most += active_.lambda[k];
        most *= kRounding;
        for (int i = 0; i < int(planes_.size()); ++i) {
            const double violation = planes_[i].offset - planes_[i].normal.dot(x_);
            if (violation > most && !active_.contains(i)) worst = i, most = violation;
        }
        return worst;
    }

    // Raises the multiplier of plane j until the plane holds, dropping planes whose multiplier reaches 0.
    bool satisfy(int j) noexcept {
        double lambda = 0;
        while (true) {
            const Split split = splitNormal(planes_[j].normal);
            const double curvature = split.z.squaredNorm();
            const double violation = planes_[j].offset - planes_[j].normal.dot(x_);
            const double full = curvature > 1e-24 ? std::max(violation, 0.0) / curvature : kInfinity;
            const auto [partial, blocking] = firstToVanish(split.r);
            const double step = std::min(full, partial);
            if (!(step < kInfinity)) return false; // nor one that is no number
            for (int k = 0; k < active_.size; ++k)
                active_.lambda[k] -= step * split.r[k];
            lambda += step;
            if (full < kInfinity) x_ += step * split.z;
            if (blocking < 0 || full <= partial) break;
            active_.drop(blocking);
        }
        active_.add(j, lambda);
        return true;
    }

    std::pair<double, int> firstToVanish(const std::array<double, 3>& r) const noexcept {
        double first = kInfinity;
        int which = -1;
        for (int k = 0; k < active_.size; ++k) {
            if (!(r[k] > 1e-14)) continue;
            const double step = std::max(active_.lambda[k], 0.0) / r[k];
            if (step < first) first = step, which = k;
        }
        return {first, which};
    }

    Split splitNormal(const Vec3& n) const noexcept {
        Split split;
        if (active_.size == 0) split.z = n;
        if (active_.size == 1) {
            split.r[0] = normal(0).dot(n);
            // The double cross product keeps its digits where n - (n . a) a loses them.
            split.z = normal(0).cross(n.cross(normal(0)));
        }
        if (active_.size == 2) {
            const Vec3 axis = normal(0).cross(normal(1));
            const double length2 = axis.squaredNorm();
            split.z = axis * (axis.dot(n) / length2);
            split.r[0] = n.cross(normal(1)).dot(axis) / length2;
            split.r[1] = normal(0).cross(n).dot(axis) / length2;
        }
        if (active_.size == 3) {
            const Vec3 r = activeNormals().partialPivLu().solve(n);
            split.r = {r[0], r[1], r[2]};
        }
        return split;
    }

    Mat3 activeNormals() const noexcept {
        Mat3 n;
        for (int k = 0; k < 3; ++k)
            n.col(k) = normal(k);
        return n;
    }

    // Computes x and lambda afresh from the active planes, so that no pivot's rounding is left in them.
    void polish() noexcept {
        if (active_.size == 0) x_ = u_;
        if (active_.size == 1) {
            active_.lambda[0] = offset(0) - normal(0).dot(u_);
            x_ = u_ + active_.lambda[0] * normal(0);
        }
        if (active_.size == 2) {
            // By cross products: the Gram matrix of two nearly dependent normals loses twice the digits.
            const Vec3 axis = normal(0).cross(normal(1));
            const Vec3 a = normal(1).cross(axis) / axis.squaredNorm(),
                       b = axis.cross(normal(0)) / axis.squaredNorm();
            const double s0 = offset(0) - normal(0).dot(u_), s1 = offset(1) - normal(1).dot(u_);
            const Vec3 way = s0 * a + s1 * b;
            active_.lambda[0] = way.dot(a);
            active_.lambda[1] = way.dot(b);
            x_ = u_ + way;
        }
        if (active_.size == 3) {
            const Mat3 n = activeNormals();
            x_ = n.transpose().partialPivLu().solve(Vec3(offset(0), offset(1), offset(2)));
            const Vec3 lambda = n.partialPivLu().solve(x_ - u_);
            for (int k = 0; k < 3; ++k)
                active_.lambda[k] = lambda[k];
        }
        for (int k = 0; k < active_.size; ++k)
            active_.lambda[k] = std::max(active_.lambda[k], 0.0);
    }

    double offset(int k) const { return planes_[active_.plane[k]].offset; }

    const Vec3& u_;
    Vec3 x_;
    std::span<const ConstraintPlane> planes_;
    double scale_ = 0;
    ActiveSet active_;
};

// What the solver below would say, without its pivots: most contacts are alone.
NearestPoint onOnePlane(const Vec3& u, const ConstraintPlane& plane) noexcept {
    NearestPoint result;
    result.x = u;
    const double violation = plane.offset - plane.normal.dot(u);
    if (violation <= kRounding * std::max(u.norm(), std::abs(plane.offset))) return result;
    result.x += violation * plane.normal;
    result.lambda[0] = violation;
    result.active = 1;
    return result;
}

} // namespace

NearestPoint nearestPoint(const Vec3& u, std::span<const ConstraintPlane> planes) noexcept {
    if (planes.size() == 1) return onOnePlane(u, planes.front());
    return Solver(u, planes).solve();
}

NearestPoint nearestReachable(const Vec3& u, std::span<ConstraintPlane> planes) noexcept {
    NearestPoint nearest = nearestPoint(u, planes);
    if (nearest.feasible) return nearest;
    for (ConstraintPlane& plane : planes)
        plane.offset = std::min(plane.offset, 0.0);
    nearest = nearestPoint(u, planes);
    nearest.feasible = false;
    return nearest;
}

} // namespace tactum
