#include "core/scene/mechanics_bytes.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

/// A bound that may be endless in its sense: byte streams hold finite numbers.
template <class Io> void bound(Io& io, double& value) {
    bool endless = std::isinf(value);
    bool positive = value > 0;
    double finite = endless ? 0 : value;
    io(endless), io(positive), io(finite);
    value = endless ? (positive ? kUnbounded : -kUnbounded) : finite;
}

template <class Io, class T, class Each>
void list(Io& io, std::vector<T>& all, std::size_t least, Each each) {
    io.count(all, least);
    for (T& one : all)
        each(one);
}

template <class Io> void turn(Io& io, Quat& q) {
    io(q.coeffs());
    io.demand(std::abs(q.norm() - 1) < 1e-6, "a rotation is not of unit length");
}

// Each function names all members of its struct, as in scene_transfer.cpp.

template <class Io> void body(Io& io, RigidBody& value) {
    auto& [id, name, pose, mass, centre, inertia, frame, velocity, angular, gravity, kinematic] = value;
    io(id), io(name), io(pose), io(mass), io(centre), io(inertia);
    turn(io, frame);
    io(velocity), io(angular), io(gravity), io(kinematic);
    io.demand(id != kWorldBody && mass >= 0 && inertia.minCoeff() >= 0, "a body has no possible mass");
}

template <class Io> void axisOf(Io& io, int& axis) {
    io(axis);
    io.demand(axis >= 0 && axis < 3, "an axis is none of three");
}

template <class Io> void limit(Io& io, JointLimit& value) {
    auto& [angular, axes, min, max, stiffness, damping] = value;
    io(angular), io(axes), io(damping);
    bound(io, min), bound(io, max), bound(io, stiffness);
    io.demand(axes > 0 && axes <= kAllAxes && min <= max && stiffness >= 0 && damping >= 0,
              "a limit of a joint is not possible");
}

template <class Io> void drive(Io& io, JointDrive& value) {
    auto& [angular, axis, stiffness, damping, position, velocity, force, acceleration, spacing] = value;
    io(angular), axisOf(io, axis), io(stiffness), io(damping), io(position), io(velocity);
    bound(io, force);
    io(acceleration), io(spacing);
    io.demand(stiffness >= 0 && damping >= 0 && force >= 0 && spacing >= 0,
              "a drive of a joint is not possible");
}

template <class Io> void friction(Io& io, JointFriction& value) {
    auto& [angular, axis, force] = value;
    io(angular), axisOf(io, axis), io(force);
    io.demand(force >= 0, "the friction of a joint is negative");
}

template <class Io> void pathBytes(Io& io, JointPath& value) {
    auto& [points, ups, closed] = value;
    list(io, points, 24, [&](Vec3& point) { io(point); });
    list(io, ups, 24, [&](Vec3& up) { io(up); });
    io(closed);
    io.demand(points.size() <= kMostPathPoints && (ups.empty() || ups.size() == points.size()),
              "a path has more points than are allowed, or not one up for each");
}

template <class Io> void joint(Io& io, Joint& value) {
    auto& [name, a, b, frameA, frameB, limits, drives, frictions, collide, part, path] = value;
    io(name), io(a), io(b), io(frameA), io(frameB), io(collide), io(part);
    list(io, limits, 30, [&](JointLimit& one) { limit(io, one); });
    list(io, drives, 40, [&](JointDrive& one) { drive(io, one); });
    list(io, frictions, 10, [&](JointFriction& one) { friction(io, one); });
    pathBytes(io, path);
}

template <class Io> void shape(Io& io, ColliderShape& value) {
    auto& [kind, size, radius, bottom, height, mesh] = value;
    choose(io, kind, 7);
    for (double& length : size)
        bound(io, length);
    io(radius), io(bottom), io(height);
    bool there = mesh != nullptr;
    io(there);
    if (!there) return;
    ShapeMesh inside = mesh ? *mesh : ShapeMesh{};
    list(io, inside.points, 24, [&](Vec3& point) { io(point); });
    io.bulk(inside.faces);
    for (const auto& face : inside.faces)
        for (const std::uint32_t corner : face)
            io.demand(corner < inside.points.size(), "a corner of a shape is not there");
    if constexpr (Io::kReads) mesh = std::make_shared<const ShapeMesh>(std::move(inside));
}

template <class Io> void collider(Io& io, Collider& value) {
    auto& [of, pose, form, material, filter, part] = value;
    io(of), io(pose), io(part);
    shape(io, form);
    auto& [still, sliding, restitution, frictionMode, restitutionMode] = material;
    io(still), io(sliding), io(restitution);
    choose(io, frictionMode, 4), choose(io, restitutionMode, 4);
    for (auto* names : {&filter.systems, &filter.notWith, &filter.with})
        list(io, *names, 8, [&](std::string& name) { io(name); });
}

} // namespace

template <class Io> void mechanicsBytes(Io& io, Mechanics& mechanics) {
    auto& [bodies, joints, colliders, gravity, air, forceScale, timeScale] = mechanics;
    io(gravity), io(air), io(forceScale), io(timeScale);
    io.demand(air >= 0, "the air has a negative density");
    io.demand(forceScale > 0 && timeScale > 0, "a scale is not positive");
    list(io, bodies, 100, [&](RigidBody& one) { body(io, one); });
    list(io, joints, 100, [&](Joint& one) { joint(io, one); });
    list(io, colliders, 100, [&](Collider& one) { collider(io, one); });
    const auto known = [&all = mechanics.bodies](BodyId id) {
        return id == kWorldBody || std::ranges::find(all, id, &RigidBody::id) != all.end();
    };
    if constexpr (Io::kReads) {
        for (const Joint& one : joints)
            io.demand(known(one.a) && known(one.b), "a joint names a body that there is not");
        for (const Collider& one : colliders)
            io.demand(known(one.body), "a collider names a body that there is not");
    }
}

template void mechanicsBytes(ByteOut&, Mechanics&);
template void mechanicsBytes(StringOut&, Mechanics&);
template void mechanicsBytes(ByteIn&, Mechanics&);

} // namespace tactum
