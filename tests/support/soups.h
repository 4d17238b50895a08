// Geometry from formulas, so that tests know the exact answers. Unit: metre.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "core/geometry/triangle.h"
#include "core/geometry/triangle_soup.h"

namespace tactum::test {

using Soup = std::shared_ptr<const TriangleSoup>;
using Rng = std::mt19937_64;

/// Uniform in [low, high); the same on every machine, unlike std::uniform_real_distribution.
inline double uniform(Rng& rng, double low, double high) {
    return low + (high - low) * (double(rng() >> 11) * 0x1p-53);
}
inline Vec3 inBox(Rng& rng, double half) {
    return {uniform(rng, -half, half), uniform(rng, -half, half), uniform(rng, -half, half)};
}
inline Vec3 direction(Rng& rng) {
    while (true) {
        const Vec3 v = inBox(rng, 1);
        if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1) return v.normalized();
    }
}

/// Collects triangles; every one brings its own corners, as in a real polygon soup.
class SoupBuilder {
public:
    SoupBuilder& triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Index first = Index(soup_.positions.size());
        for (const Vec3& p : {a, b, c})
            soup_.positions.push_back(p);
        return add({first, first + 1, first + 2});
    }
    SoupBuilder& quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        return triangle(a, b, c).triangle(a, c, d);
    }
    SoupBuilder& segment(const Vec3& a, const Vec3& b) {
        const Index first = Index(soup_.positions.size());
        soup_.positions.insert(soup_.positions.end(), {a, b});
        return add({first, first + 1, first + 1});
    }
    SoupBuilder& point(const Vec3& a) {
        const Index first = Index(soup_.positions.size());
        soup_.positions.push_back(a);
        return add({first, first, first});
    }
    Soup build() const { return std::make_shared<const TriangleSoup>(soup_); }

private:
    SoupBuilder& add(const std::array<Index, 3>& corners) {
        soup_.triangles.push_back(corners);
        soup_.surfaceOf.push_back(0);
        return *this;
    }

    TriangleSoup soup_;
};

inline Triangle triangleOf(const TriangleSoup& soup, std::size_t i) {
    const auto& corner = soup.triangles[i];
    return {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]};
}

inline Soup transformed(const TriangleSoup& soup, const Pose& pose, double scale = 1) {
    auto result = std::make_shared<TriangleSoup>(soup);
    for (Vec3& p : result->positions)
        p = scale * pose.apply(p);
    return result;
}

/// z = height(x, y) over a square of side 2 half, in cells x cells quads.
template <class Height> Soup heightField(double half, int cells, Height&& height) {
    SoupBuilder builder;
    auto at = [&](int i, int j) {
        const double x = half * (2.0 * i / cells - 1), y = half * (2.0 * j / cells - 1);
        return Vec3(x, y, height(x, y));
    };
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j)
            builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return builder.build();
}

/// The plane z = 0, counter-clockwise from above; two triangles when cells = 1.
inline Soup sheet(double half, int cells = 1) {
    return heightField(half, cells, [](double, double) { return 0.0; });
}

inline Soup eggCrate(double half, int cells, double amplitude, double period) {
    const double k = 2 * std::numbers::pi / period;
    return heightField(half, cells,
                       [=](double x, double y) { return amplitude * std::sin(k * x) * std::sin(k * y); });
}

/// Two parallel sheets at z = +-thickness / 2.
inline Soup plate(double half, double thickness) {
    SoupBuilder builder;
    for (double z : {-thickness / 2, thickness / 2})
        builder.quad({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z});
    return builder.build();
}

/// Two parallel walls at x = +-width / 2.
inline Soup channel(double half, double width) {
    SoupBuilder builder;
    for (double x : {-width / 2, width / 2})
        builder.quad({x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half});
    return builder.build();
}

/// A valley along y with its bottom in the origin; `opening` in radians between its two faces.
inline Soup wedge(double opening, double size) {
    const Vec3 right = size * Vec3(std::sin(opening / 2), 0, std::cos(opening / 2));
    const Vec3 left(-right.x(), 0, right.z()), far(0, size, 0);
    SoupBuilder builder;
    builder.quad(-far, right - far, right + far, far);
    builder.quad(-far, far, left + far, left - far);
    return builder.build();
}

/// The rays of a pit whose faces rise at an angle from a common bottom; n of them, evenly around.
inline std::vector<Vec3> evenRays(int n, double elevation) {
    std::vector<Vec3> rays;
    for (int k = 0; k < n; ++k) {
        const double turn = 2 * std::numbers::pi * k / n;
        rays.push_back({std::cos(turn) * std::cos(elevation), std::sin(turn) * std::cos(elevation),
                        std::sin(elevation)});
    }
    return rays;
}

/// Triangles from the origin between neighbouring rays.
inline Soup pit(const std::vector<Vec3>& rays, double size) {
    SoupBuilder builder;
    for (std::size_t k = 0; k < rays.size(); ++k)
        builder.triangle(Vec3::Zero(), size * rays[k], size * rays[(k + 1) % rays.size()]);
    return builder.build();
}

/// A tube along y with n flat sides, open at both ends; corners at `radius`.
inline Soup pipe(double radius, double halfLength, int n) {
    SoupBuilder builder;
    auto at = [&](int k, double y) {
        const double turn = 2 * std::numbers::pi * k / n;
        return Vec3(radius * std::cos(turn), y, radius * std::sin(turn));
    };
    for (int k = 0; k < n; ++k)
        builder.quad(at(k, -halfLength), at(k, halfLength), at(k + 1, halfLength), at(k + 1, -halfLength));
    return builder.build();
}

/// An icosahedron whose faces were divided in four, `divisions` times: 20 * 4^divisions triangles.
inline Soup ball(double radius, int divisions) {
    const double g = std::numbers::phi;
    const std::vector<Vec3> v{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    SoupBuilder builder;
    auto divide = [&](auto&& self, const Vec3& a, const Vec3& b, const Vec3& c, int depth) -> void {
        if (depth == 0) {
            builder.triangle(radius * a, radius * b, radius * c);
            return;
        }
        const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
        self(self, a, ab, ca, depth - 1);
        self(self, ab, b, bc, depth - 1);
        self(self, ca, bc, c, depth - 1);
        self(self, ab, bc, ca, depth - 1);
    };
    for (const auto& f : faces)
        divide(divide, v[f[0]].normalized(), v[f[1]].normalized(), v[f[2]].normalized(), divisions);
    return builder.build();
}

/// The floor z = 0 with a slit of the given width along y, walls going down.
inline Soup crack(double half, double width, double depth) {
    SoupBuilder builder;
    for (double side : {-1.0, 1.0}) {
        const double x = side * width / 2, out = side * half;
        builder.quad({x, -half, 0}, {out, -half, 0}, {out, half, 0}, {x, half, 0});
        builder.quad({x, -half, 0}, {x, half, 0}, {x, half, -depth}, {x, -half, -depth});
    }
    return builder.build();
}

/// Triangles of every kind in a box: compact, long and thin, coincident, segments and points.
inline Soup randomSoup(Rng& rng, int count, double half, const Vec3& centre = Vec3::Zero()) {
    SoupBuilder builder;
    Triangle last{centre, centre, centre};
    for (int i = 0; i < count; ++i) {
        const double size = half * std::pow(10, uniform(rng, -2, -0.3));
        const Vec3 a = centre + inBox(rng, half), b = a + size * direction(rng);
        switch (rng() % 8) {
        case 0:
            builder.segment(a, b);
            continue;
        case 1:
            builder.point(a);
            continue;
        case 2:
            builder.triangle(last.b, last.c, last.a);
            continue;
        case 3:
            last = {a, b, a + 0.4 * (b - a) + 1e-3 * size * direction(rng)};
            break;
        default:
            last = {a, b, a + size * direction(rng)};
        }
        builder.triangle(last.a, last.b, last.c);
    }
    return builder.build();
}

} // namespace tactum::test
