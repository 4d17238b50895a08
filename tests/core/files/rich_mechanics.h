// Bodies, joints and colliders in which every member says something else than it does by default, and once as
// it does; 1 and 0 among them, which a writer may take for nothing to say.
#pragma once

#include "core/dynamics/mechanics.h"

namespace tactum::test {

inline std::vector<RigidBody> richBodies() {
    RigidBody turning, led;
    turning.id = 1, turning.name = "turning";
    turning.pose = {Quat(0.5, 0.5, -0.5, 0.5), {0.25, 0.5, -0.125}};
    turning.mass = 2;
    turning.centre = {0.125, 0, -0.25};
    turning.inertia = {1, 2, 2.5};
    turning.inertiaFrame = Quat(0.5, -0.5, 0.5, 0.5);
    turning.velocity = {1, -2, 3};
    turning.angularVelocity = {-4, 5, 0.5};
    turning.gravityFactor = 0.5;
    led.id = 2, led.name = "led";
    led.kinematic = true;
    return {turning, led};
}

inline std::vector<Joint> richJoints() {
    Joint limits, drives, onPath;
    limits.name = "limits", limits.b = 1;
    limits.frameA = {Quat(0, 0, 1, 0), {1, 0, 0}};
    limits.frameB = {Quat(0.5, 0.5, 0.5, 0.5), {0, 1, 0.5}};
    limits.limits = {{false, 1, 0, 0},
                     {false, 2, -0.5, kUnbounded, 100, 1},
                     {false, 4, -1, 1, 50, 0},
                     {true, 3, -kUnbounded, 0.25, 10, 2},
                     {true, 4, -0.25, 0.5}};
    limits.part = 0;
    drives.name = "drives", drives.a = 1, drives.b = 2;
    drives.collide = true;
    JointDrive detents, motor;
    detents.axis = 2, detents.stiffness = 20, detents.damping = 1, detents.position = 0.25;
    detents.spacing = 1;
    motor.angular = true, motor.axis = 1, motor.damping = 3, motor.velocity = 1.5;
    motor.maxForce = 4, motor.acceleration = true;
    drives.drives = {motor, detents};
    drives.frictions = {{false, 0, 1}, {true, 2, 0.5}};
    onPath.name = "on a path", onPath.b = 2;
    onPath.path.points = {{0, 0, 0}, {1, 0, 0}, {1, 0.5, 1}, {0, 0, 1}};
    onPath.path.ups = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
    onPath.path.closed = true;
    return {limits, drives, onPath};
}

/// One of each shape, each of another material and filter than the one before.
inline std::vector<Collider> richColliders() {
    std::vector<Collider> all;
    for (const ShapeKind kind : {ShapeKind::Box, ShapeKind::Sphere, ShapeKind::Capsule, ShapeKind::Cylinder,
                                 ShapeKind::Plane, ShapeKind::Hull, ShapeKind::Mesh}) {
        Collider one;
        const double n = double(all.size() + 1);
        one.body = n < 4 ? 1 : n < 6 ? 2 : kWorldBody;
        if (one.body == kWorldBody) one.part = all.size() < 6 ? 1 : 2; // as a reader counts them
        one.pose = {Quat::Identity(), {n, 0, -0.5 * n}};
        ColliderShape& shape = one.shape;
        shape.kind = kind;
        if (kind == ShapeKind::Box || kind == ShapeKind::Plane)
            shape.size = {0.25 * n, kind == ShapeKind::Box ? 1.0 : 0.0, 0.125};
        if (kind == ShapeKind::Sphere) shape.radius = shape.radiusBottom = 0.25;
        if (kind == ShapeKind::Capsule || kind == ShapeKind::Cylinder) shape.height = n;
        if (kind == ShapeKind::Capsule) shape.radius = shape.radiusBottom = 0.25;
        if (kind == ShapeKind::Cylinder) shape.radius = 0.25, shape.radiusBottom = 0.75;
        if (kind >= ShapeKind::Hull) {
            ShapeMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
            if (kind == ShapeKind::Mesh) mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
            shape.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
        }
        one.material = {0.125 * n, 0.0625 * n, 0.125, Combine(all.size() % 4), Combine((all.size() + 1) % 4)};
        if (kind == ShapeKind::Sphere) one.filter.systems = {"near", "far"};
        if (kind == ShapeKind::Capsule) one.filter.notWith = {"near"};
        if (kind == ShapeKind::Box) one.filter.with = {"far"};
        all.push_back(one);
    }
    return all;
}

inline Mechanics richMechanics() {
    Mechanics all;
    all.bodies = richBodies();
    all.joints = richJoints();
    all.colliders = richColliders();
    all.gravity = {1, -8, 0.5};
    all.airDensity = 1;
    all.forceScale = 2;
    all.timeScale = 0.5;
    return all;
}

} // namespace tactum::test
