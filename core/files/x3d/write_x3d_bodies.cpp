#include "core/files/x3d/write_x3d_bodies.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/numbers.h"
#include "core/dynamics/convex.h"
#include "core/files/x3d/write_x3d_parts.h"

namespace tactum {
namespace {

// A slab in place of what has no end, m.
constexpr double kEndless = 10, kThick = 1;
/// A stop in place of one that is not there, m or rad: far enough, and a number that every reader takes.
constexpr double kNoStop = 1e6;
/// m^2 for each kg: the moment of what does not turn, in place of an endless one.
constexpr double kNoTurn = 1e6;

/// A kind of joint that X3D has, and what of ours it is.
struct X3dJoint {
    const char* node;
    int axis = 0, axis2 = 0; ///< of frame a and, of a UniversalJoint, of frame b
    bool angular = false, stops = false;
};

AxisSet locked(const Joint& joint, bool angular) {
    AxisSet axes = 0;
    for (const JointLimit& limit : joint.limits)
        if (limit.angular == angular && limit.isLock() &&
            (limit.min == 0 || std::has_single_bit(unsigned(limit.axes))))
            axes = AxisSet(axes | limit.axes);
    return axes;
}

std::optional<X3dJoint> kindOf(const Joint& joint) {
    if (joint.path.isThere()) return std::nullopt;
    const auto free = [&](bool angular) { return unsigned(~locked(joint, angular) & kAllAxes); };
    const unsigned slides = free(false), turns = free(true);
    // A slider without a way holds everything: X3D has no node for that.
    if (turns == 0 && std::popcount(slides) <= 1)
        return X3dJoint{"SliderJoint", slides == 0 ? 0 : std::countr_zero(slides), 0, false, true};
    if (slides != 0) return std::nullopt;
    const int first = std::countr_zero(turns);
    if (std::has_single_bit(turns)) return X3dJoint{"SingleAxisHingeJoint", first, 0, true, true};
    if (turns == kAllAxes) return X3dJoint{"BallJoint"};
    const int held = std::countr_zero(~turns);
    return X3dJoint{"UniversalJoint", (held + 1) % 3, (held + 2) % 3};
}

/// Whether a limit is a stop of the one axis.
bool stops(const JointLimit& limit, const X3dJoint& kind) {
    return kind.stops && limit.isHard() && limit.angular == kind.angular && (limit.axes >> kind.axis & 1) &&
           (limit.isLock() || std::has_single_bit(unsigned(limit.axes)));
}

double angleAbout(int axis, const Quat& q) {
    return 2 * std::atan2(q.vec()[axis] * (q.w() < 0 ? -1 : 1), std::abs(q.w()));
}

Pose moved(const Vec3& along, const Pose& pose) {
    return {pose.rotation, pose.translation + along};
}

} // namespace

/// One node of geometry. Round ones have y for their axis, as ours.
struct X3dBodies::Shape {
    const char* node;
    Vec3 size = Vec3::Zero();
    double radius = 0, height = 0;
    const Polytope* faces = nullptr;
};

X3dBodies::X3dBodies(const Scene& scene, UniqueNames& names, std::vector<Loss>& losses)
    : scene_(scene), names_(names), losses_(losses) {
    const Mechanics& of = scene.mechanics;
    for (const RigidBody& body : of.bodies) {
        defs_[body.id] = names_.take(plainName(body.name) + "-body");
        if (body.kinematic || body.mass == 0) still_.insert(body.id);
        if (body.kinematic && !(body.velocity.isZero(0) && body.angularVelocity.isZero(0)))
            lose(body.name, "velocity", LossKind::Lost, "what nothing pushes stands still");
        if (body.mass != 0 && (body.inertia.array() == 0).any())
            lose(body.name, "moments", LossKind::Degraded, "an endless one is its mass a kilometre away");
        if (body.gravityFactor != 0 && body.gravityFactor != 1)
            lose(body.name, "gravity factor", LossKind::Lost, "X3D has all of the gravity or none");
    }
    for (const Joint& joint : of.joints) {
        const auto kind = kindOf(joint);
        const auto goes = [&](const JointLimit& limit) { return !limit.isLock() && !stops(limit, *kind); };
        if (kind && std::ranges::any_of(joint.limits, goes))
            lose(joint.name, "limits", LossKind::Degraded, "hard stops of hinges and sliders alone");
        if (kind) continue;
        lose(joint.name, "joint", LossKind::Lost,
             "X3D has none that leaves this free; its bodies stand still");
        still_.insert({joint.a, joint.b});
    }
    const auto differs = [&](const Collider& each) {
        return !(each.material == of.colliders[0].material) || !(each.filter == of.colliders[0].filter);
    };
    if (std::ranges::any_of(of.colliders, differs))
        lose({}, "friction, bounce and filters of bodies", LossKind::Degraded,
             "those of the first one count for all, and all meet each other");
}

void X3dBodies::lose(const std::string& of, const char* what, LossKind kind, const char* sentence) {
    losses_.push_back({ExportTarget::X3d, of, what, kind, sentence});
}

const RigidBody* X3dBodies::find(BodyId id) const {
    const auto found = std::ranges::find(scene_.mechanics.bodies, id, &RigidBody::id);
    return found == scene_.mechanics.bodies.end() ? nullptr : &*found;
}

Pose X3dBodies::poseOf(BodyId id) const {
    const RigidBody* body = find(id);
    return body ? body->pose : Pose{};
}

std::optional<Vec3> X3dBodies::originOf(BodyId id) const {
    const RigidBody* body = find(id);
    if (!body || still_.contains(id)) return std::nullopt;
    return body->pose.apply(body->centre);
}

void X3dBodies::write(XmlElement& scene) {
    if (scene_.mechanics.bodies.empty()) return;
    {
        XmlElement collection(scene, "RigidBodyCollection");
        collection.set("gravity", scene_.mechanics.gravity).set("preferAccuracy", true);
        for (const RigidBody& body : scene_.mechanics.bodies)
            writeBody(collection, body);
        writeColliders(collection);
        for (const Joint& joint : scene_.mechanics.joints)
            writeJoint(collection, joint);
    }
    for (const auto& [body, transform] : led_)
        for (const auto& [from, to] : {std::pair("position", "translation"), {"orientation", "rotation"}})
            writeRoute(scene, {defs_[body], from}, {transform, to});
}

void X3dBodies::writeBody(XmlElement& collection, const RigidBody& body) {
    const Vec3 origin = body.pose.apply(body.centre);
    XmlElement node(collection, "RigidBody");
    node.set("DEF", defs_[body.id]).set("containerField", "bodies").set("position", origin);
    if (still_.contains(body.id)) {
        node.set("fixed", true);
    } else {
        const Mat3 axes = (body.pose.rotation * body.inertiaFrame).toRotationMatrix();
        const Vec3 moments =
            (body.inertia.array() == 0).select(Vec3::Constant(kNoTurn * body.mass).array(), body.inertia);
        const Mat3 inertia = axes * moments.asDiagonal() * axes.transpose();
        std::string list;
        for (int i = 0; i < 9; ++i) {
            if (i > 0) list += ' ';
            appendNumber(list, inertia(i / 3, i % 3));
        }
        node.set("mass", body.mass)
            .setPlain("inertia", list)
            .set("linearVelocity", body.velocity)
            .set("angularVelocity", body.angularVelocity)
            .set("useGlobalGravity", body.gravityFactor != 0);
    }
    for (const Collider& collider : scene_.mechanics.colliders)
        if (collider.body == body.id)
            writeCollider(node, "geometry", collider, moved(-origin, body.pose * collider.pose));
}

void X3dBodies::writeCollider(XmlElement& parent, const char* field, const Collider& collider,
                              const Pose& place) {
    const ColliderShape& shape = collider.shape;
    const Convex convex = convexOf(shape);
    const auto write = [&](const Shape& each, const Vec3& at = Vec3::Zero()) {
        writeCollidable(parent, field, each, place * Pose{Quat::Identity(), at});
    };
    switch (convex.core) {
    case Convex::Core::Point:
        return write({.node = "Sphere", .radius = convex.radius});
    case Convex::Core::Segment:
        write({.node = "Cylinder", .radius = convex.radius, .height = 2 * convex.half});
        write({.node = "Sphere", .radius = convex.radius}, {0, convex.half, 0});
        return write({.node = "Sphere", .radius = convex.radius}, {0, -convex.half, 0});
    case Convex::Core::HalfSpace:
        return write({.node = "Box", .size = {kEndless, kThick, kEndless}}, {0, -kThick / 2, 0});
    case Convex::Core::Polytope:
        if (shape.kind == ShapeKind::Plane && !shape.size.allFinite()) {
            const Vec3 size(std::min(shape.size.x(), kEndless), kThick, std::min(shape.size.z(), kEndless));
            return write({.node = "Box", .size = size}, {0, -kThick / 2, 0});
        }
        if (shape.kind == ShapeKind::Box) return write({.node = "Box", .size = shape.size});
        if (shape.kind == ShapeKind::Cylinder && shape.radius == shape.radiusBottom)
            return write({.node = "Cylinder", .radius = shape.radius, .height = shape.height});
        if (!convex.polytope.faces.empty()) write({.node = "IndexedFaceSet", .faces = &convex.polytope});
    }
}

/// As a part of a body it is moved from the body's origin by an offset.
void X3dBodies::writeCollidable(XmlElement& parent, const char* field, const Shape& shape,
                                const Pose& place) {
    const bool isOfBody = field == std::string_view("geometry");
    const std::string& name = collidables_.emplace_back(names_.take("collider"));
    XmlElement node(parent, isOfBody ? "CollidableOffset" : "CollidableShape");
    node.set("DEF", name)
        .set("containerField", field)
        .set("translation", place.translation)
        .setPlain("rotation", axisAngle(place.rotation));
    if (!isOfBody) return writeShape(node, shape);
    XmlElement inner(node, "CollidableShape");
    inner.set("containerField", "collidable");
    writeShape(inner, shape);
}

void X3dBodies::writeShape(XmlElement& collidable, const Shape& shape) const {
    XmlElement node(collidable, "Shape");
    node.set("containerField", "shape");
    XmlElement geometry(node, shape.node);
    geometry.set("containerField", "geometry");
    if (shape.size != Vec3::Zero()) geometry.set("size", shape.size);
    if (shape.radius > 0) geometry.set("radius", shape.radius);
    if (shape.height > 0) geometry.set("height", shape.height);
    if (!shape.faces) return;
    std::string corners, points;
    for (const Polytope::Face& face : shape.faces->faces) {
        for (const int corner : face.corners)
            corners += std::to_string(corner) + ' ';
        corners += "-1 ";
    }
    for (const Vec3& point : shape.faces->points)
        for (int i = 0; i < 3; ++i) {
            appendNumber(points, point[i]);
            points += i < 2 ? " " : ", ";
        }
    geometry.setPlain("coordIndex", corners);
    XmlElement(geometry, "Coordinate").setPlain("point", points);
}

void X3dBodies::writeColliders(XmlElement& collection) {
    const auto& colliders = scene_.mechanics.colliders;
    if (colliders.empty()) return;
    const TouchMaterial& material = colliders[0].material;
    XmlElement node(collection, "CollisionCollection");
    std::string friction;
    appendNumber(friction, material.dynamicFriction);
    node.set("containerField", "collider")
        .setStrings("appliedParameters", {"BOUNCE", "FRICTION_COEFFICIENT-2"})
        .set("bounce", material.restitution)
        .setPlain("frictionCoefficients", friction + ' ' + friction);
    for (const std::string& name : collidables_)
        XmlElement(node, "CollidableOffset").set("USE", name).set("containerField", "collidables");
    for (const Collider& collider : colliders)
        if (collider.body == kWorldBody) writeCollider(node, "collidables", collider, collider.pose);
}

/// Its coordinates count from where it is at first, and are those of the first body against the second: ours
/// are those of b against a. Without a second body it is held to the world.
void X3dBodies::writeJoint(XmlElement& collection, const Joint& joint) const {
    const auto kind = kindOf(joint);
    if (!kind || (!find(joint.a) && !find(joint.b))) return;
    const bool turned = !find(joint.b); // a hangs on the world
    const Pose X_Wa = poseOf(joint.a) * joint.frameA, X_Wb = poseOf(joint.b) * joint.frameB;
    const Pose start = X_Wa.inverse() * X_Wb;
    const bool isSlider = !kind->angular && kind->stops;
    XmlElement node(collection, kind->node);
    node.set("containerField", "joints");
    if (!isSlider) node.set("anchorPoint", X_Wb.translation);
    const Vec3 onA = X_Wa.rotate(Vec3::Unit(kind->axis)), onB = X_Wb.rotate(Vec3::Unit(kind->axis2));
    if (kind->stops) node.set("axis", onA);
    if (!kind->stops && kind->axis != kind->axis2)
        node.set("axis1", turned ? onA : onB).set("axis2", turned ? onB : onA);
    if (kind->stops) {
        const double at =
            kind->angular ? angleAbout(kind->axis, start.rotation) : start.translation[kind->axis];
        double low = -kNoStop, high = kNoStop;
        for (const JointLimit& limit : joint.limits)
            if (stops(limit, *kind))
                low = std::max(low, limit.min - at), high = std::min(high, limit.max - at);
        if (turned) low = -std::exchange(high, -low);
        const double bound = kind->angular ? M_PI : kNoStop;
        node.set(kind->angular ? "minAngle" : "minSeparation", std::clamp(low, -bound, bound))
            .set(kind->angular ? "maxAngle" : "maxSeparation", std::clamp(high, -bound, bound));
    }
    const auto hold = [&](const char* field, BodyId body) {
        XmlElement(node, "RigidBody").set("USE", defs_.at(body)).set("containerField", field);
    };
    hold("body1", turned ? joint.a : joint.b);
    if (!turned && find(joint.a)) hold("body2", joint.a);
}

} // namespace tactum
