// Slow answers by other means than the code under test, in extended precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/proxy/nearest_point.h"
#include "tests/support/soups.h"

namespace tactum::test {

using Real = long double;
using RVec = Eigen::Matrix<Real, 3, 1>;

inline Real segmentDistance(const RVec& a, const RVec& b, const RVec& p) {
    const RVec e = b - a;
    const Real length2 = e.squaredNorm();
    const Real s = length2 > 0 ? std::clamp<Real>(e.dot(p - a) / length2, 0, 1) : 0;
    return (p - (a + s * e)).norm();
}

/// Distance from a point to a triangle: its edges, and its plane where the foot point lies inside.
inline Real distance(const Triangle& triangle, const RVec& p) {
    const RVec a = triangle.a.cast<Real>(), b = triangle.b.cast<Real>(), c = triangle.c.cast<Real>();
    Real best = std::min({segmentDistance(a, b, p), segmentDistance(b, c, p), segmentDistance(c, a, p)});
    const RVec n = (b - a).cross(c - a);
    if (n.norm() > 1e-15L * (b - a).norm() * (c - a).norm()) {
        const RVec q = p - n * (n.dot(p - a) / n.squaredNorm());
        const bool inside = n.dot((b - a).cross(q - a)) >= 0 && n.dot((c - b).cross(q - b)) >= 0 &&
                            n.dot((a - c).cross(q - c)) >= 0;
        if (inside) best = std::min(best, std::abs(n.dot(p - a)) / n.norm());
    }
    return best;
}

/// How far the nearest primitive is from a point.
inline double clearance(const TriangleSoup& soup, const Vec3& p) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        nearest = std::min(nearest, (p - closestPoint(triangleOf(soup, i), p).point).norm());
    return nearest;
}

struct ReferencePoint {
    RVec x;
    Real volume = 1; ///< that the active normals span: 0 for dependent ones
    Eigen::Matrix<Real, 3, 1> lambda = RVec::Zero();
};

/// The point nearest to u on one plane, on the line of two, or the corner of three: by cross products.
/// `volume` is 0 when the normals are dependent: then a smaller set says the same.
inline ReferencePoint footPoint(const RVec& u, const std::vector<const ConstraintPlane*>& set) {
    ReferencePoint foot{u};
    std::array<RVec, 3> n;
    RVec need = RVec::Zero(); // how far u is below each plane
    for (std::size_t k = 0; k < set.size(); ++k) {
        n[k] = set[k]->normal.cast<Real>();
        need[Eigen::Index(k)] = set[k]->offset - n[k].dot(u);
    }
    if (set.size() == 1) {
        foot.lambda[0] = need[0] / n[0].squaredNorm();
        foot.x += foot.lambda[0] * n[0];
    } else if (set.size() == 2) {
        const RVec axis = n[0].cross(n[1]);
        foot.volume = axis.norm();
        foot.x += (need[0] * n[1].cross(axis) + need[1] * axis.cross(n[0])) / axis.squaredNorm();
        foot.lambda[0] = (need[0] * n[1].squaredNorm() - n[0].dot(n[1]) * need[1]) / axis.squaredNorm();
        foot.lambda[1] = (need[1] * n[0].squaredNorm() - n[0].dot(n[1]) * need[0]) / axis.squaredNorm();
    } else {
        const RVec a = n[1].cross(n[2]), b = n[2].cross(n[0]), c = n[0].cross(n[1]);
        const Real determinant = n[0].dot(a);
        foot.volume = std::abs(determinant);
        const RVec way = (need[0] * a + need[1] * b + need[2] * c) / determinant;
        foot.x = (set[0]->offset * a + set[1]->offset * b + set[2]->offset * c) / determinant;
        foot.lambda = RVec(way.dot(a), way.dot(b), way.dot(c)) / determinant;
    }
    return foot;
}

/// Equation (2) by trying every set of at most three planes: the one whose multipliers are not negative
/// and whose point violates nothing is the answer. Empty when the planes exclude each other.
inline std::optional<ReferencePoint> bruteNearestPoint(const Vec3& u, std::span<const ConstraintPlane> planes,
                                                       Real tolerance) {
    const RVec finger = u.cast<Real>();
    auto holds = [&](const RVec& x, Real slack) {
        return std::all_of(planes.begin(), planes.end(), [&](const ConstraintPlane& plane) {
            return plane.normal.cast<Real>().dot(x) >= plane.offset - slack;
        });
    };
    if (holds(finger, tolerance)) return ReferencePoint{finger};
    std::optional<ReferencePoint> best;
    Real bestDistance = 0;
    auto consider = [&](const std::vector<const ConstraintPlane*>& set) {
        const ReferencePoint foot = footPoint(finger, set);
        if (!(foot.volume > 1e-12L) || foot.lambda.minCoeff() < -tolerance) return;
        const Real away = (foot.x - finger).norm();
        if (best && away >= bestDistance) return;
        if (!holds(foot.x, tolerance * (1 + foot.x.norm() + foot.lambda.maxCoeff()))) return;
        best = foot, bestDistance = away;
    };
    const std::size_t m = planes.size();
    std::vector<const ConstraintPlane*> one(1), two(2), three(3);
    for (std::size_t i = 0; i < m; ++i) {
        one[0] = two[0] = three[0] = &planes[i];
        consider(one);
        for (std::size_t j = 0; j < i; ++j) {
            two[1] = three[1] = &planes[j];
            consider(two);
            for (std::size_t k = 0; k < j; ++k) {
                three[2] = &planes[k];
                consider(three);
            }
        }
    }
    return best;
}

/// The point nearest to u of a convex room with any number of walls: the most violated wall is added until
/// none is violated; walls that do not push are dropped, which keeps the sets tiny. Where rounding lets no
/// wall help any more the best point so far is the answer.
inline Vec3 nearestInRoom(const Vec3& u, const std::vector<ConstraintPlane>& walls) {
    std::vector<ConstraintPlane> active;
    Vec3 x = u;
    for (std::size_t walk = 0; walk < 1000 + walls.size(); ++walk) {
        const ConstraintPlane* worst = nullptr;
        double most = 1e-13;
        for (const ConstraintPlane& wall : walls) {
            const double violation = wall.offset - wall.normal.dot(x);
            if (violation > most) worst = &wall, most = violation;
        }
        if (!worst) return x;
        std::erase_if(active,
                      [&](const ConstraintPlane& wall) { return wall.normal.dot(x) > wall.offset + 1e-9; });
        active.push_back(*worst);
        const auto nearest = bruteNearestPoint(u, active, 1e-15L);
        if (!nearest) return x;
        x = nearest->x.cast<double>();
    }
    return x;
}

/// The walls that keep a sphere of radius r on the side of `inside` of every triangle's plane.
inline std::vector<ConstraintPlane> wallsOf(const TriangleSoup& soup, double r, const Vec3& inside) {
    std::vector<ConstraintPlane> walls;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle t = triangleOf(soup, i);
        Vec3 n = (t.b - t.a).cross(t.c - t.a).normalized();
        if (n.dot(inside - t.a) < 0) n = -n;
        const bool known = std::any_of(walls.begin(), walls.end(), [&](const ConstraintPlane& wall) {
            return (wall.normal - n).norm() < 1e-9 && std::abs(wall.offset - n.dot(t.a) - r) < 1e-9;
        });
        if (!known) walls.push_back({n, n.dot(t.a) + r});
    }
    return walls;
}

/// How far a resting proxy is from the nearest local minimum: the step that the tangent planes of all
/// primitives within `reach` of touching it would still allow.
inline double distanceFromMinimum(const TriangleSoup& soup, double r, const Vec3& proxy, const Vec3& finger,
                                  double reach) {
    std::vector<ConstraintPlane> planes;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Vec3 away = proxy - closestPoint(triangleOf(soup, i), proxy).point;
        if (away.norm() < r + reach) planes.push_back({away.normalized(), std::min(0.0, r - away.norm())});
    }
    return nearestInRoom(finger - proxy, planes).norm();
}

} // namespace tactum::test
