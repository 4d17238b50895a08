// Loose bodies for tests, and what stands still.
#pragma once

#include "tests/core/dynamics/mechanisms.h"

namespace tactum::test {

inline ColliderShape box(const Vec3& size) {
    ColliderShape shape;
    shape.size = size;
    return shape;
}
inline ColliderShape ball(double radius) {
    ColliderShape shape;
    shape.kind = ShapeKind::Sphere;
    shape.radius = radius;
    return shape;
}
inline ColliderShape lengthwise(ShapeKind kind, double radius, double height) {
    ColliderShape shape;
    shape.kind = kind;
    shape.radius = shape.radiusBottom = radius;
    shape.height = height;
    return shape;
}
inline ColliderShape floorShape() {
    ColliderShape shape;
    shape.kind = ShapeKind::Plane;
    shape.size = {kUnbounded, 0, kUnbounded};
    return shape;
}

/// A scene that grows by bodies of one shape each.
struct World {
    Mechanics mechanics;
    TouchMaterial material;

    RigidBody& add(const ColliderShape& shape, const Pose& pose, double mass) {
        RigidBody body = bodyAt(BodyId(mechanics.bodies.size() + 1), pose.translation, mass);
        body.pose = pose;
        const ShapeMass whole = massOf(shape);
        body.inertia = whole.moments.diagonal() * (mass / whole.volume);
        body.centre = whole.centre;
        mechanics.bodies.push_back(body);
        mechanics.colliders.push_back({body.id, Pose{}, shape, material, {}});
        return mechanics.bodies.back();
    }
    void addStill(const ColliderShape& shape, const Pose& pose = {}) {
        mechanics.colliders.push_back({kWorldBody, pose, shape, material, {}});
    }
};

inline Pose at(double x, double y, double z = 0) {
    return {Quat::Identity(), Vec3(x, y, z)};
}

} // namespace tactum::test
