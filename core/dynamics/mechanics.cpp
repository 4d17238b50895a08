#include "core/dynamics/mechanics.h"

#include <memory>

namespace tactum {

namespace {

Pose scaled(Pose pose, double factor) {
    pose.translation *= factor;
    return pose;
}

} // namespace

ColliderShape scaled(ColliderShape shape, double factor) {
    shape.size *= factor;
    shape.radius *= factor;
    shape.radiusBottom *= factor;
    shape.height *= factor;
    if (!shape.mesh) return shape;
    ShapeMesh mesh = *shape.mesh;
    for (Vec3& point : mesh.points)
        point *= factor;
    shape.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
    return shape;
}

void scaleLengths(Joint& joint, double factor) {
    joint.frameA = scaled(joint.frameA, factor);
    joint.frameB = scaled(joint.frameB, factor);
    for (Vec3& point : joint.path.points)
        point *= factor;
    for (JointLimit& limit : joint.limits)
        if (!limit.angular) {
            limit.min *= factor;
            limit.max *= factor;
        }
    for (JointDrive& drive : joint.drives)
        if (!drive.angular) {
            drive.position *= factor;
            drive.velocity *= factor;
            drive.spacing *= factor;
        }
}

Mechanics scaled(Mechanics mechanics, double factor, const Vec3& about) {
    for (RigidBody& body : mechanics.bodies) {
        body.pose.translation = factor * (body.pose.translation - about);
        body.centre *= factor;
        body.inertia *= factor * factor;
        body.velocity *= factor;
    }
    for (Joint& joint : mechanics.joints) {
        // What is fixed to the world moves as the bodies do.
        if (joint.a == kWorldBody) joint.frameA.translation -= about;
        if (joint.b == kWorldBody) joint.frameB.translation -= about;
        scaleLengths(joint, factor);
    }
    for (Collider& collider : mechanics.colliders) {
        if (collider.body == kWorldBody) collider.pose.translation -= about;
        collider.pose = scaled(collider.pose, factor);
        collider.shape = scaled(collider.shape, factor);
    }
    return mechanics;
}

} // namespace tactum
