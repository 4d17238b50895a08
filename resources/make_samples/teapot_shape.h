// The teapot and its table from formulas: our own, in the spirit of the well-known one.
//
// Body, lid and table are B-spline profiles turned about the z axis, spout and handle are circles swept along
// B-splines. Every part is a closed surface of its own. Unit: metre, z up in the formulas, the top of the
// table at z = 0.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/base/vec.h"

namespace tactum::samples {

/// A closed surface, round in v: rings of points from one pole to the other.
struct Part {
    std::string name;
    Eigen::Vector3f colour;
    std::size_t rings, segments;
    std::function<Vec3(double u, double v)> point; ///< u, v: 0 to 1; all v are one point at u = 0 and u = 1

    Vec3 normal(double u, double v) const;
    /// The mean around a pole: `u` close to it, where there still is a ring.
    Vec3 poleNormal(double u) const;
    std::size_t pointsOf(std::size_t ring) const { return ring == 0 || ring == rings ? 1 : segments; }
    /// Of the k-th point of a ring, counted over the whole part.
    std::size_t numberOf(std::size_t ring, std::size_t k) const;
    std::size_t pointCount() const { return 2 + (rings - 1) * segments; }
    /// The normal at a point of a ring, also where u is 0 or 1.
    Vec3 normalAt(std::size_t ring, std::size_t k) const;
    Vec3 pointAt(std::size_t ring, std::size_t k) const {
        return point(double(ring) / double(rings), double(k) / double(segments));
    }
    /// Counter-clockwise seen from outside.
    std::vector<std::array<std::size_t, 3>> triangles() const;
};

Part teapotBody();
Part teapotLid();
Part teapotSpout();
Part teapotHandle();
Part teapotTable();

/// The formulas stand on z; files and the view stand on y, as glTF does.
inline Vec3 yUp(const Vec3& p) {
    return {p.x(), p.z(), -p.y()};
}

} // namespace tactum::samples
