// What of a body touches others: shapes, how they rub and bounce, and which meet. Plain values with ==.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/dynamics/rigid_body.h"

namespace tactum {

enum class ShapeKind : std::uint8_t { Box, Sphere, Capsule, Cylinder, Plane, Hull, Mesh };

/// The corners and triangles of a hull or a mesh, immutable.
struct ShapeMesh {
    std::vector<Vec3> points;                        ///< m
    std::vector<std::array<std::uint32_t, 3>> faces; ///< of a mesh
    bool operator==(const ShapeMesh&) const = default;
};

/// About the origin of its own frame; what is round has y for its axis (KHR_implicit_shapes). Unit: m.
struct ColliderShape {
    ShapeKind kind = ShapeKind::Box;
    Vec3 size = Vec3::Ones(); ///< of a box; of a plane x and z, endless where it has no end
    double radius = 0.5;      ///< of a sphere; of a capsule or cylinder that at the top
    double radiusBottom = 0.5;
    double height = 0.5;                   ///< of a capsule between the centres of its ends
    std::shared_ptr<const ShapeMesh> mesh; ///< of a hull and a mesh

    bool operator==(const ColliderShape& other) const {
        const bool same = mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh);
        return kind == other.kind && size == other.size && radius == other.radius &&
               radiusBottom == other.radiusBottom && height == other.height && same;
    }
};

/// How two coefficients become one; the earlier one of the two modes counts.
enum class Combine : std::uint8_t { Average, Minimum, Maximum, Multiply };

struct TouchMaterial {
    double staticFriction = 0.6, dynamicFriction = 0.6, restitution = 0;
    Combine frictionCombine = Combine::Average, restitutionCombine = Combine::Average;

    bool operator==(const TouchMaterial&) const = default;
};

/// Which colliders meet, by the names of systems.
struct CollisionFilter {
    std::vector<std::string> systems, notWith, with;
    bool operator==(const CollisionFilter&) const = default;
};

struct Collider {
    BodyId body = kWorldBody;
    Pose pose; ///< body frame, or world
    ColliderShape shape;
    TouchMaterial material;
    CollisionFilter filter;
    std::uint32_t part = 0; ///< of the world: which of the things that stand still it is of; 0: of no other

    bool operator==(const Collider&) const = default;
};

/// Mass, centre and moments of a shape for 1 kg/m^3. Nothing for a plane, and for what encloses nothing.
struct ShapeMass {
    double volume = 0;           ///< m^3
    Vec3 centre = Vec3::Zero();  ///< m, frame of the shape
    Mat3 moments = Mat3::Zero(); ///< about the centre, kg m^2
};
ShapeMass massOf(const ColliderShape& shape);

/// How far a point in the frame of a shape is outside it, m; 0 inside. Of hulls and meshes their box counts.
double distanceTo(const ColliderShape& shape, const Vec3& point);

/// Two parts, each in its own pose, as one.
ShapeMass together(const ShapeMass& a, const ShapeMass& b);
ShapeMass placed(const ShapeMass& mass, const Pose& pose);

} // namespace tactum
