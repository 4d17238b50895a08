// Convex bodies as contact sees them: a core of flat faces, of a segment or of a point, and a radius around
// it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/dynamics/collider.h"

namespace tactum {

/// Flat faces, edges and corners. Unit: m, frame of the collider.
struct Polytope {
    struct Face {
        Vec3 normal = Vec3::UnitZ(); ///< outward
        double offset = 0;           ///< normal . p on the face
        std::vector<int> corners;    ///< counter-clockwise from outside
    };
    struct Edge {
        int a = 0, b = 0;        ///< corners
        int left = 0, right = 0; ///< faces: that which has it from a to b, and the other
    };
    std::vector<Vec3> points;
    std::vector<Face> faces;
    std::vector<Edge> edges;
    Vec3 centre = Vec3::Zero(); ///< somewhere inside
};

/// What a collider is to others.
struct Convex {
    enum class Core : std::uint8_t { Point, Segment, Polytope, HalfSpace };
    /// What meets its like by formulas of its own (round/pairs.h).
    enum class Form : std::uint8_t { Other, Ball, Capsule, Cylinder };
    Core core = Core::Point;
    Form form = Form::Other;
    double radius = 0; ///< m, around the core
    double half = 0;   ///< of a segment, and of a cylinder, along y, m
    Polytope polytope; ///< of that core
    double round = 0;  ///< m: the larger radius of a cylinder, whose polytope is its prism; 0 for others
    double reach = 0;  ///< m: no point is farther from the origin; endless for a half-space
    Vec3 low = Vec3::Zero(), high = Vec3::Zero(); ///< the box of a polytope
};

/// Sides of a cylinder as a prism, which contact turns so that one of its edges is where it touches.
inline constexpr int kCylinderSides = 48;

/// A triangle mesh counts as the hull of its corners.
Convex convexOf(const ColliderShape& shape);
/// Corners of a hull; of more the farthest ones stay, so that the rest lies hardly outside.
inline constexpr int kMostCorners = 32;
/// The hull of points; less than a tetrahedron gives no faces.
Polytope hullOf(const std::vector<Vec3>& points);
Polytope boxOf(const Vec3& size);

} // namespace tactum
