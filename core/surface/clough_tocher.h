// The smooth surface over a triangle that its corners' values and slopes give.
#pragma once

#include <array>

#include "core/base/vec.h"
#include "core/geometry/triangle.h"

namespace tactum {

/// Value and gradient in the plane of a triangle.
struct Rise {
    double value = 0;
    Vec3 slope = Vec3::Zero();
};

/// The surface of Clough and Tocher through values and slopes at the corners of a triangle (R. W. Clough and
/// J. L. Tocher, Finite element stiffness matrices for analysis of plate bending, 1965), by Bezier's
/// ordinates: a corner i, a corner j and the middle m of all three are the corners of the part that a point
/// lies in. The slope across the side from i to the next corner is quadratic along it: `bulge` i is what its
/// ordinate has above the one that lets it be linear. The slope does not jump between the parts, nor toward a
/// neighbour with the same values, slopes and slope across. Slopes lie in the plane of the triangle, which
/// must have one. Thread: real time.
class CloughTocher {
public:
    CloughTocher(const Triangle& t, const Vec3& values, const std::array<Vec3, 3>& slopes,
                 const std::array<float, 3>& bulge) noexcept
        : corner_{t.a, t.b, t.c}, middle_((t.a + t.b + t.c) / 3), values_(values), slopes_(slopes),
          bulge_(bulge) {}

    /// Weights of the corners: none below zero.
    Rise at(const Vec3& weights) const noexcept {
        int k = 0;
        weights.minCoeff(&k);
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double u = weights[i] - weights[k], v = weights[j] - weights[k], w = 3 * weights[k];
        const double opposite[3] = {across(1, 2), across(2, 0), across(0, 1)};
        double inner[3];
        for (int c = 0; c < 3; ++c)
            inner[c] = (toMiddle(c) + opposite[(c + 1) % 3] + opposite[(c + 2) % 3]) / 3;
        const double fi = values_[i], fj = values_[j], fm = (inner[0] + inner[1] + inner[2]) / 3;
        const double ij = toward(i, j), ji = toward(j, i), im = toMiddle(i), jm = toMiddle(j);
        const double mi = inner[i], mj = inner[j], all = opposite[k];
        const double du = quadratic(u, v, w, fi, ji, mi, ij, im, all),
                     dv = quadratic(u, v, w, ij, fj, mj, ji, all, jm),
                     dw = quadratic(u, v, w, im, jm, fm, all, mi, mj);
        return {u * du + v * dv + w * dw,
                3 * (du * rising(i, j) + dv * rising(j, i) + dw * risingInward(i, j))};
    }

private:
    /// On the edge from i, a third of the way to j; and to the middle.
    double toward(int i, int j) const noexcept {
        return values_[i] + slopes_[i].dot(corner_[j] - corner_[i]) / 3;
    }
    double toMiddle(int i) const noexcept { return values_[i] + slopes_[i].dot(middle_ - corner_[i]) / 3; }

    /// The one that lets the slope across the edge from i to j be linear along it, and the bulge.
    double across(int i, int j) const noexcept {
        const Vec3 edge = corner_[j] - corner_[i];
        const double t = (middle_ - corner_[i]).dot(edge) / edge.squaredNorm();
        const double ij = toward(i, j), ji = toward(j, i);
        const double first = toMiddle(i) - (1 - t) * values_[i] - t * ij,
                     last = toMiddle(j) - (1 - t) * ji - t * values_[j];
        return 0.5 * (first + last) + (1 - t) * ij + t * ji + double(bulge_[std::size_t(i)]);
    }

    static double quadratic(double u, double v, double w, double uu, double vv, double ww, double uv,
                            double uw, double vw) noexcept {
        return u * u * uu + v * v * vv + w * w * ww + 2 * (u * v * uv + u * w * uw + v * w * vw);
    }

    /// The gradient of the weight of i in the part of i, j and the middle; and of the middle's own weight.
    Vec3 rising(int i, int j) const noexcept { return awayFrom(corner_[j], middle_, corner_[i]); }
    Vec3 risingInward(int i, int j) const noexcept { return awayFrom(corner_[i], corner_[j], middle_); }
    static Vec3 awayFrom(const Vec3& a, const Vec3& b, const Vec3& p) noexcept {
        const Vec3 side = b - a, up = p - a;
        const Vec3 height = up - side * (up.dot(side) / side.squaredNorm());
        return height / height.squaredNorm();
    }

    std::array<Vec3, 3> corner_;
    Vec3 middle_, values_;
    const std::array<Vec3, 3>& slopes_;
    const std::array<float, 3>& bulge_;
};

} // namespace tactum
