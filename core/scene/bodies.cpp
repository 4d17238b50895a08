#include "core/scene/bodies.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "core/dynamics/path_places.h"
#include "core/dynamics/weigh.h"
#include "core/scene/convex_parts.h"

namespace tactum {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;
constexpr double kLongest = 1; // m: ways and angles at the end of their range are without limit

constexpr Parameter kLowAngle{"hinge-low",
                              "Lower stop",
                              "rad",
                              -kWholeTurn,
                              0,
                              0.02,
                              -kWholeTurn,
                              3,
                              "How far it turns back; a whole turn: without stop."};
constexpr Parameter kHighAngle{"hinge-high",
                               "Upper stop",
                               "rad",
                               0,
                               kWholeTurn,
                               0.02,
                               kWholeTurn,
                               3,
                               "How far it turns; a whole turn: without stop."};
constexpr Parameter kTurnSpring{"hinge-spring",
                                "Spring",
                                "N m",
                                0,
                                10,
                                0.01,
                                0,
                                3,
                                "Torque for each radian away from where the spring rests."};
constexpr Parameter kTurnRest{"hinge-rest",
                              "Rests at",
                              "rad",
                              -kWholeTurn,
                              kWholeTurn,
                              0.02,
                              0,
                              3,
                              "Where the spring pulls to; beyond a stop: it presses against it."};
constexpr Parameter kTurnDamping{
    "hinge-damping", "Damping", "N m s", 0, 1, 1e-4, 1e-4, 5, "Torque against each radian a second."};
constexpr Parameter kTurnFriction{
    "hinge-friction", "Dry friction", "N m", 0, 5, 1e-3, 0, 4, "Up to this torque it stays where it is."};
constexpr Parameter kTurnSpeed{"hinge-speed",
                               "Motor speed",
                               "rad/s",
                               -100,
                               100,
                               0.1,
                               0,
                               2,
                               "What its motor turns at, as far as its torque suffices."};
constexpr Parameter kTurnStrength{"hinge-strength",
                                  "Motor torque",
                                  "N m",
                                  0,
                                  10,
                                  1e-3,
                                  0,
                                  4,
                                  "The most that its motor can do; 0: it has none."};

constexpr Parameter kTurnSpacing{"hinge-spacing",
                                 "Detents every",
                                 "rad",
                                 0,
                                 kWholeTurn,
                                 0.02,
                                 0,
                                 3,
                                 "It rests at its beginning and every so far from it; 0: it has no detents."};
constexpr Parameter kTurnDetent{
    "hinge-detent", "Detent torque", "N m", 0, 5, 1e-3, 0, 4, "What it takes to leave a detent."};
constexpr Parameter kSlideSpacing{
    "slider-spacing",
    "Detents every",
    "m",
    0,
    kLongest,
    1e-3,
    0,
    4,
    "It rests at its beginning and every so far from it; 0: it has no detents."};
constexpr Parameter kSlideDetent{
    "slider-detent", "Detent force", "N", 0, 50, 0.05, 0, 2, "What it takes to leave a detent."};

constexpr Parameter kLowWay{"slider-low",
                            "Lower stop",
                            "m",
                            -kLongest,
                            0,
                            1e-3,
                            -kLongest,
                            4,
                            "How far it slides back; a metre: without stop."};
constexpr Parameter kHighWay{"slider-high",
                             "Upper stop",
                             "m",
                             0,
                             kLongest,
                             1e-3,
                             kLongest,
                             4,
                             "How far it slides; a metre: without stop."};
constexpr Parameter kSlideSpring{"slider-spring",
                                 "Spring",
                                 "N/m",
                                 0,
                                 10000,
                                 5,
                                 0,
                                 0,
                                 "Force for each metre away from where the spring rests."};
constexpr Parameter kSlideRest{"slider-rest",
                               "Rests at",
                               "m",
                               -kLongest,
                               kLongest,
                               1e-3,
                               0,
                               4,
                               "Where the spring pulls to; beyond a stop: it presses against it."};
constexpr Parameter kSlideDamping{
    "slider-damping", "Damping", "N s/m", 0, 50, 0.05, 0.1, 2, "Force against each metre a second."};
constexpr Parameter kSlideFriction{
    "slider-friction", "Dry friction", "N", 0, 50, 0.05, 0, 2, "Up to this force it stays where it is."};
constexpr Parameter kSlideSpeed{"slider-speed",
                                "Motor speed",
                                "m/s",
                                -10,
                                10,
                                0.01,
                                0,
                                3,
                                "What its motor drives it at, as far as its force suffices."};
constexpr Parameter kSlideStrength{"slider-strength",
                                   "Motor force",
                                   "N",
                                   0,
                                   50,
                                   0.05,
                                   0,
                                   2,
                                   "The most that its motor can do; 0: it has none."};

/// A motor holds its speed to a hundredth at half of its strength.
constexpr double kMotorGrip = 50;
constexpr double kLeastSpeed = 1e-3; // rad/s or m/s

bool isSolid(const SceneObject& object) {
    return object.geometry && !object.geometry->triangles.empty();
}

void addColliders(Scene& scene, const SceneObject& object, BodyId body, const Pose& inBody,
                  std::uint32_t part) {
    for (ColliderShape& shape : convexParts(*object.geometry)) {
        Collider collider;
        collider.body = body, collider.part = part;
        collider.pose = inBody, collider.shape = std::move(shape);
        scene.mechanics.colliders.push_back(std::move(collider));
    }
}

std::uint32_t freePart(const Scene& scene) {
    std::uint32_t most = 0;
    for (const Collider& collider : scene.mechanics.colliders)
        most = std::max(most, collider.part);
    return most + 1;
}

void addWorld(Scene& scene) {
    const auto& all = scene.mechanics.colliders;
    if (std::ranges::find(all, kWorldBody, &Collider::body) != all.end()) return;
    for (const SceneObject& object : scene.objects)
        addStillColliders(scene, object.id);
}

/// Those hulls of the world that stand for this object.
void dropStillColliders(Scene& scene, const SceneObject& object) {
    const auto shapes = convexParts(*object.geometry);
    std::erase_if(scene.mechanics.colliders, [&](const Collider& collider) {
        return collider.body == kWorldBody && collider.pose == object.pose &&
               std::ranges::find(shapes, collider.shape) != shapes.end();
    });
}

/// What stands still nearest to a place: what a joint there is fixed to.
std::uint32_t partAt(const Scene& scene, const Vec3& at) {
    std::uint32_t part = 0;
    double nearest = kUnbounded;
    for (const Collider& collider : scene.mechanics.colliders) {
        if (collider.body != kWorldBody || collider.part == 0) continue;
        const double away = distanceTo(collider.shape, collider.pose.applyInverse(at));
        if (away < nearest) nearest = away, part = collider.part;
    }
    return part;
}

Pose poseOf(const Scene& scene, BodyId body) {
    const RigidBody* found = findBody(scene, body);
    return found ? found->pose : Pose{};
}

bool isLock(const JointLimit& limit, bool angular, AxisSet axes) {
    return limit.isLock() && limit.min == 0 && limit.angular == angular && limit.axes == axes;
}

/// The two locks of a hinge or a slider come first, as jointFrom() puts them.
std::optional<AxisKind> kindOf(const Joint& joint) {
    if (joint.path.isThere()) return AxisKind::Path;
    if (joint.limits.size() < 2) return std::nullopt;
    const auto locks = [&](AxisSet linear, AxisSet angular) {
        const auto has = [&](bool isAngular, AxisSet axes) {
            return std::ranges::any_of(
                joint.limits, [&](const JointLimit& limit) { return isLock(limit, isAngular, axes); });
        };
        return has(false, linear) && has(true, angular);
    };
    if (locks(kAllAxes, 6)) return AxisKind::Hinge;
    if (locks(6, kAllAxes)) return AxisKind::Slider;
    return std::nullopt;
}

JointPath seenFrom(JointPath path, const Pose& pose) {
    for (Vec3& point : path.points)
        point = pose.apply(point);
    for (Vec3& up : path.ups)
        up = pose.rotate(up);
    return path;
}

/// On a curve that is given in the world: the body stays where it is, and rides where that is nearest.
void putOnPath(Joint& joint, const AxisJoint& axis, const Scene& scene, BodyId body) {
    const Pose place = poseOf(scene, body);
    joint.name = "path";
    joint.frameA = poseOf(scene, axis.to).inverse();
    joint.path = axis.path;
    joint.limits.clear();
    if (const auto on = nearestOn(axis.path, {place.rotation, axis.at})) joint.frameB = place.inverse() * *on;
}

/// Along the same line, between the same bodies.
bool liesAlike(const AxisJoint& a, const AxisJoint& b) {
    return a.kind == b.kind && a.to == b.to && a.at == b.at && a.axis == b.axis && a.path == b.path;
}

/// The end of the joints for one that there is not.
auto jointAt(auto& joints, BodyId body, std::size_t which) {
    return std::ranges::find_if(joints, [&](const Joint& joint) { return joint.b == body && which-- == 0; });
}

Joint jointFrom(const AxisJoint& axis, const Scene& scene, BodyId body) {
    const bool angular = axis.kind == AxisKind::Hinge;
    Joint joint;
    joint.name = angular ? "hinge" : "slider";
    joint.a = axis.to, joint.b = body;
    const Pose at{turnOnto(Vec3::UnitX(), axis.axis), axis.at};
    joint.frameA = poseOf(scene, axis.to).inverse() * at;
    joint.frameB = poseOf(scene, body).inverse() * at;
    joint.limits = {{false, AxisSet(angular ? kAllAxes : 6), 0, 0},
                    {true, AxisSet(angular ? 6 : kAllAxes), 0, 0}};
    if (axis.kind == AxisKind::Path) putOnPath(joint, axis, scene, body);
    if (axis.low > -kUnbounded || axis.high < kUnbounded)
        joint.limits.push_back({angular, 1, axis.low, axis.high});
    if (axis.stiffness > 0 || axis.damping > 0)
        joint.drives.push_back({angular, 0, axis.stiffness, axis.damping, axis.rest});
    if (axis.strength > 0) {
        JointDrive motor{angular, 0, 0,
                         kMotorGrip * axis.strength / std::max(kLeastSpeed, std::abs(axis.speed))};
        motor.velocity = axis.speed, motor.maxForce = axis.strength;
        joint.drives.push_back(motor);
    }
    if (axis.spacing > 0 && axis.detent > 0) {
        JointDrive detents{angular, 0, axis.detent * kWholeTurn / axis.spacing};
        detents.spacing = axis.spacing;
        joint.drives.push_back(detents);
    }
    if (axis.friction > 0) joint.frictions.push_back({angular, 0, axis.friction});
    if (axis.to == kWorldBody) joint.part = partAt(scene, axis.at);
    return joint;
}

} // namespace

const std::array<AxisField, 10> kAxisFields{
    {{&kLowAngle, &kLowWay, &AxisJoint::low},
     {&kHighAngle, &kHighWay, &AxisJoint::high},
     {&kTurnDamping, &kSlideDamping, &AxisJoint::damping},
     {&kTurnFriction, &kSlideFriction, &AxisJoint::friction},
     {&kTurnSpring, &kSlideSpring, &AxisJoint::stiffness},
     {&kTurnRest, &kSlideRest, &AxisJoint::rest},
     {&kTurnSpeed, &kSlideSpeed, &AxisJoint::speed, &AxisJoint::strength, 0.05, 1},
     {&kTurnStrength, &kSlideStrength, &AxisJoint::strength},
     {&kTurnSpacing, &kSlideSpacing, &AxisJoint::spacing, &AxisJoint::detent, 0.02, 0.5},
     {&kTurnDetent, &kSlideDetent, &AxisJoint::detent, &AxisJoint::spacing, kWholeTurn / 24, 0.005}}};

void setFigure(AxisJoint& joint, const AxisField& field, double value) {
    const Parameter& parameter = field.of(joint.kind);
    const double safe = parameter.clamped(value);
    joint.*field.value = field.isStop() && safe == parameter.initial ? field.endless() : safe;
    if (field.needs && safe != 0 && joint.*field.needs == 0)
        joint.*field.needs = joint.kind == AxisKind::Hinge ? field.usualOfHinge : field.usualOfSlider;
}

RigidBody* findBody(Scene& scene, BodyId id) {
    return const_cast<RigidBody*>(findBody(std::as_const(scene), id));
}

const RigidBody* findBody(const Scene& scene, BodyId id) {
    const auto& all = scene.mechanics.bodies;
    const auto found = std::ranges::find(all, id, &RigidBody::id);
    return found == all.end() ? nullptr : &*found;
}

void addStillColliders(Scene& scene, ObjectId id) {
    const SceneObject* object = scene.find(id);
    if (object && object->body == kWorldBody && !object->motion && isSolid(*object))
        addColliders(scene, *object, kWorldBody, object->pose, freePart(scene));
}

BodyId makeBody(Scene& scene, ObjectId id) {
    SceneObject* object = scene.find(id);
    if (!object || object->body != kWorldBody || object->motion || !isSolid(*object)) return kWorldBody;
    addWorld(scene);
    dropStillColliders(scene, *object);
    RigidBody body;
    for (const RigidBody& other : scene.mechanics.bodies)
        body.id = std::max(body.id, other.id);
    ++body.id;
    body.name = object->name, body.pose = object->pose;
    object->body = body.id;
    addColliders(scene, *object, body.id, Pose{}, 0);
    ShapeMass shapes;
    for (const Collider& collider : scene.mechanics.colliders)
        if (collider.body == body.id)
            shapes = together(shapes, placed(massOf(collider.shape), collider.pose));
    const double mass = shapes.volume > 0 ? kDensity * shapes.volume : kBodyMass.initial;
    weigh(body, shapes, kBodyMass.clamped(mass));
    scene.mechanics.bodies.push_back(std::move(body));
    return scene.mechanics.bodies.back().id;
}

void makeStill(Scene& scene, BodyId id) {
    const RigidBody* body = findBody(scene, id);
    if (!body) return;
    Mechanics& mechanics = scene.mechanics;
    const std::uint32_t part = freePart(scene);
    for (Collider& collider : mechanics.colliders)
        if (collider.body == id) {
            collider.pose = body->pose * collider.pose;
            collider.body = kWorldBody, collider.part = part;
        }
    std::erase_if(mechanics.joints, [id](const Joint& joint) { return joint.a == id || joint.b == id; });
    std::erase_if(mechanics.bodies, [id](const RigidBody& each) { return each.id == id; });
    for (SceneObject& object : scene.objects)
        if (object.body == id) object.body = kWorldBody;
    if (mechanics.bodies.empty()) mechanics.colliders.clear(); // nothing moves, nothing meets
}

void removeMechanics(Scene& scene, ObjectId id) {
    const SceneObject* object = scene.find(id);
    if (!object) return;
    const BodyId body = object->body;
    const auto moves = std::ranges::count(scene.objects, body, &SceneObject::body);
    if (body != kWorldBody && moves > 1) return;
    makeStill(scene, body);
    if (isSolid(*object)) dropStillColliders(scene, *object);
}

void setMass(RigidBody& body, double mass) {
    if (body.mass > 0) body.inertia *= mass / body.mass;
    body.mass = mass;
}

Moves movesOf(const Scene& scene, const SceneObject& object) {
    if (object.motion) return Moves::ByKeys;
    if (!findBody(scene, object.body)) return Moves::Never;
    return std::ranges::any_of(
               scene.mechanics.joints,
               [&](const Joint& joint) { return joint.a == object.body || joint.b == object.body; })
               ? Moves::OnJoints
               : Moves::Loose;
}

std::size_t jointsOf(const Scene& scene, BodyId body) {
    return std::size_t(std::ranges::count(scene.mechanics.joints, body, &Joint::b));
}

std::optional<AxisJoint> axisJointOf(const Scene& scene, BodyId body, std::size_t which) {
    const auto found = jointAt(scene.mechanics.joints, body, which);
    if (found == scene.mechanics.joints.end()) return std::nullopt;
    const Joint& joint = *found;
    const auto kind = kindOf(joint);
    if (!kind) return std::nullopt;
    const bool angular = *kind == AxisKind::Hinge;
    AxisJoint axis;
    axis.kind = *kind, axis.to = joint.a;
    const Pose at = poseOf(scene, joint.a) * joint.frameA;
    axis.at = at.translation, axis.axis = at.rotation * Vec3::UnitX();
    if (*kind == AxisKind::Path) {
        axis.path = seenFrom(joint.path, at);
        axis.at = (poseOf(scene, body) * joint.frameB).translation;
    }
    for (const JointLimit& limit : joint.limits)
        if (!limit.isLock() && limit.angular == angular && limit.axes == 1)
            axis.low = limit.min, axis.high = limit.max;
    for (const JointDrive& drive : joint.drives) {
        if (drive.angular != angular || drive.axis != 0) return std::nullopt;
        if (drive.spacing > 0)
            axis.spacing = drive.spacing, axis.detent = drive.stiffness * drive.spacing / kWholeTurn;
        else if (drive.maxForce < kUnbounded)
            axis.speed = drive.velocity, axis.strength = drive.maxForce;
        else
            axis.stiffness = drive.stiffness, axis.damping = drive.damping, axis.rest = drive.position;
    }
    for (const JointFriction& friction : joint.frictions)
        axis.friction = friction.force;
    return axis;
}

void setLoose(Scene& scene, BodyId body) {
    std::erase_if(scene.mechanics.joints, [body](const Joint& joint) { return joint.b == body; });
}

void setAxisJoint(Scene& scene, BodyId body, const AxisJoint& axis, std::size_t which) {
    if (!findBody(scene, body) || axis.to == body) return;
    if (axis.kind == AxisKind::Path && !nearestOn(axis.path, {})) return;
    auto& joints = scene.mechanics.joints;
    Joint made = jointFrom(axis, scene, body);
    const auto held = jointAt(joints, body, which);
    if (held == joints.end()) return joints.push_back(std::move(made));
    const bool named = held->name != "hinge" && held->name != "slider" && held->name != "path";
    if (named) made.name = held->name;
    if (made.path.isThere() && held->path.isThere()) made.frameB = held->frameB;
    // To the bit: with frames that are rounded anew the bodies would begin anew too.
    if (const auto before = axisJointOf(scene, body, which); before && liesAlike(*before, axis))
        made.frameA = held->frameA, made.frameB = held->frameB, made.path = held->path;
    made.collide = held->collide;
    *held = std::move(made);
}

void removeJoint(Scene& scene, BodyId body, std::size_t which) {
    auto& joints = scene.mechanics.joints;
    if (const auto found = jointAt(joints, body, which); found != joints.end()) joints.erase(found);
}

} // namespace tactum
