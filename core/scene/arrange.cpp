#include "core/scene/arrange.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/motion/motion_build.h"
#include "core/scene/bodies.h"

namespace tactum {
namespace {

/// Colliders count as inside of an object up to a part of its size. Another one is like it that is about the
/// same place, and no smaller or larger than these parts: the ball around a rod has a box of 1.7 times its
/// size.
constexpr double kInside = 0.02, kSamePlaces = 0.1, kLeastLike = 0.5, kMostLike = 2;

Bounds boxOf(const ColliderShape& shape) {
    Bounds box;
    if (shape.mesh) {
        for (const Vec3& point : shape.mesh->points)
            box.add(point);
        return box;
    }
    const double round = std::max(shape.radius, shape.radiusBottom), high = 0.5 * shape.height;
    const bool capped = shape.kind == ShapeKind::Capsule;
    Vec3 half = 0.5 * shape.size;
    if (shape.kind == ShapeKind::Sphere) half = Vec3::Constant(shape.radius);
    if (capped || shape.kind == ShapeKind::Cylinder) half = {round, high + (capped ? round : 0), round};
    box.add(-half), box.add(half);
    return box;
}

bool isStillAndSolid(const SceneObject& object) {
    return object.body == kWorldBody && !object.motion && object.geometry &&
           !object.geometry->triangles.empty();
}

/// The still colliders that go together: those of one part, and others each by itself.
std::vector<std::vector<std::size_t>> stillGroups(const Mechanics& mechanics) {
    std::map<std::uint32_t, std::vector<std::size_t>> parts;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < mechanics.colliders.size(); ++i) {
        const Collider& collider = mechanics.colliders[i];
        if (collider.body != kWorldBody || collider.shape.kind == ShapeKind::Plane) continue;
        if (collider.part == 0)
            groups.push_back({i});
        else
            parts[collider.part].push_back(i);
    }
    for (auto& [part, group] : parts)
        groups.push_back(std::move(group));
    return groups;
}

Bounds boxInFrame(const Mechanics& mechanics, const std::vector<std::size_t>& group, const Pose& frame) {
    Bounds box;
    for (const std::size_t i : group) {
        const Bounds own = boxOf(mechanics.colliders[i].shape);
        const Pose inFrame = frame.inverse() * mechanics.colliders[i].pose;
        for (int corner = 0; corner < 8; ++corner) {
            Vec3 p = own.low;
            for (int axis = 0; axis < 3; ++axis)
                if (corner >> axis & 1) p[axis] = own.high[axis];
            box.add(inFrame.apply(p));
        }
    }
    return box;
}

/// How badly a group stands for an object, for the least of all: the larger of their sizes, where the object
/// has it inside or is like it; else nothing.
std::optional<double> misfit(const Bounds& group, const Bounds& own) {
    const double size = own.diagonal(), room = kInside * size, wide = group.diagonal();
    const bool inside =
        ((group.low - own.low).array() >= -room).all() && ((own.high - group.high).array() >= -room).all();
    const double away = (group.centre() - own.centre()).norm();
    const bool like = away < kSamePlaces * size && wide > kLeastLike * size && wide < kMostLike * size;
    return inside || like ? std::optional(std::max(size, wide) + away) : std::nullopt;
}

/// Who each group stands for; 0: nobody.
std::vector<ObjectId> ownersOf(const Scene& scene, const std::vector<std::vector<std::size_t>>& groups) {
    std::vector<ObjectId> owners(groups.size(), 0);
    std::vector<double> least(groups.size(), kUnbounded);
    for (const SceneObject& object : scene.objects) {
        if (groups.empty() || !isStillAndSolid(object)) continue;
        const Bounds own = tactum::boundsOf(*object.geometry);
        for (std::size_t i = 0; i < groups.size(); ++i)
            if (const auto bad = misfit(boxInFrame(scene.mechanics, groups[i], object.pose), own);
                bad && *bad < least[i])
                least[i] = *bad, owners[i] = object.id;
    }
    return owners;
}

std::set<std::size_t> stillCollidersOf(const Scene& scene, const std::set<ObjectId>& objects) {
    std::set<std::size_t> found;
    if (objects.empty()) return found;
    const auto groups = stillGroups(scene.mechanics);
    const auto owners = ownersOf(scene, groups);
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (objects.contains(owners[i])) found.insert(groups[i].begin(), groups[i].end());
    return found;
}

void arrangeBody(RigidBody& body, const Arrangement& by) {
    body.pose = by.apply(body.pose);
    body.centre *= by.scale;
    body.inertia *= by.scale * by.scale;
    body.velocity = by.scale * (by.turn * body.velocity);
    body.angularVelocity = by.turn * body.angularVelocity;
}

bool isAmong(const auto& all, auto one) {
    return std::ranges::find(all, one) != all.end();
}

/// What a joint is fixed to goes along.
bool carriesJoint(const GoingAlong& along, const Joint& joint) {
    return joint.a == kWorldBody ? joint.part != 0 && isAmong(along.parts, joint.part)
                                 : isAmong(along.bodies, joint.a);
}

/// `placeA`: where the body was that it is fixed to.
void arrangeJoint(Joint& joint, const Pose& placeA, const GoingAlong& along, const Arrangement& by) {
    if (!isAmong(along.bodies, joint.b)) return;
    const bool carried = carriesJoint(along, joint), bodyA = carried && joint.a != kWorldBody;
    if (!bodyA && (carried || !joint.path.isThere()))
        joint.frameA = placeA.inverse() * by.apply(placeA * joint.frameA);
    if (by.scale == 1) return;
    const Joint before = joint;
    scaleLengths(joint, by.scale);
    if (!bodyA) joint.frameA = before.frameA; // in what keeps its size
    if (!carried) joint.path = before.path;
}

void arrangeObject(SceneObject& object, const Arrangement& by,
                   std::map<const TriangleSoup*, std::shared_ptr<const TriangleSoup>>& scaled) {
    object.pose = by.apply(object.pose);
    if (by.scale == 1) return;
    auto& known = scaled[object.geometry.get()];
    if (!known) {
        auto soup = std::make_shared<TriangleSoup>(*object.geometry);
        for (Vec3& p : soup->positions)
            p *= by.scale;
        known = std::move(soup);
    }
    object.geometry = known;
    if (object.motion)
        object.motion = std::make_shared<const Motion>(tactum::scaled(*object.motion, by.scale));
}

} // namespace

bool Arrangement::changesNothing() const {
    return move == Vec3::Zero() && turn.coeffs() == Quat::Identity().coeffs() && scale == 1;
}

bool GoingAlong::has(ObjectId object) const {
    return isAmong(objects, object);
}

std::vector<std::size_t> collidersOf(const Scene& scene, const SceneObject& object) {
    std::vector<std::size_t> found;
    if (object.body == kWorldBody) {
        const auto still = stillCollidersOf(scene, {object.id});
        return {still.begin(), still.end()};
    }
    for (std::size_t i = 0; i < scene.mechanics.colliders.size(); ++i)
        if (scene.mechanics.colliders[i].body == object.body) found.push_back(i);
    return found;
}

GoingAlong goingAlong(const Scene& scene, std::span<const ObjectId> objects) {
    GoingAlong along;
    std::set<ObjectId> still;
    const auto addBody = [&](BodyId body) {
        if (body != kWorldBody && !isAmong(along.bodies, body)) along.bodies.push_back(body);
    };
    for (const SceneObject& object : scene.objects) {
        if (!isAmong(objects, object.id)) continue;
        addBody(object.body);
        if (object.body == kWorldBody) still.insert(object.id);
    }
    for (const std::size_t i : stillCollidersOf(scene, still)) {
        along.colliders.push_back(i);
        if (const auto part = scene.mechanics.colliders[i].part; part != 0 && !isAmong(along.parts, part))
            along.parts.push_back(part);
    }
    for (std::size_t known = along.bodies.size() + 1; known != along.bodies.size();) {
        known = along.bodies.size();
        for (const Joint& joint : scene.mechanics.joints)
            if (carriesJoint(along, joint)) addBody(joint.b);
    }
    for (const SceneObject& object : scene.objects)
        if (isAmong(objects, object.id) || isAmong(along.bodies, object.body))
            along.objects.push_back(object.id);
    return along;
}

void arrange(Scene& scene, const GoingAlong& along, const Arrangement& by) {
    if (by.changesNothing()) return;
    Mechanics& mechanics = scene.mechanics;
    std::map<BodyId, Pose> places{{kWorldBody, Pose{}}};
    for (RigidBody& body : mechanics.bodies) {
        places[body.id] = body.pose;
        if (isAmong(along.bodies, body.id)) arrangeBody(body, by);
    }
    for (Joint& joint : mechanics.joints)
        arrangeJoint(joint, places[joint.a], along, by);
    for (std::size_t i = 0; i < mechanics.colliders.size(); ++i) {
        Collider& collider = mechanics.colliders[i];
        if (isAmong(along.colliders, i))
            collider.pose = by.apply(collider.pose);
        else if (isAmong(along.bodies, collider.body))
            collider.pose.translation *= by.scale;
        else
            continue;
        if (by.scale != 1) collider.shape = scaled(std::move(collider.shape), by.scale);
    }
    std::map<const TriangleSoup*, std::shared_ptr<const TriangleSoup>> soups;
    for (SceneObject& object : scene.objects)
        if (along.has(object.id)) arrangeObject(object, by, soups);
}

void placeObject(Scene& scene, ObjectId id, const Pose& pose) {
    SceneObject& object = *scene.find(id);
    const Pose before = object.pose;
    const ObjectId ids[] = {id};
    const GoingAlong along = goingAlong(scene, ids);
    if (along.objects.size() == 1 && along.bodies.empty() && along.colliders.empty()) {
        object.pose = pose;
        return;
    }
    arrange(scene, along,
            {.about = before.translation,
             .move = pose.translation - before.translation,
             .turn = unitLength(pose.rotation * before.rotation.conjugate())});
}

} // namespace tactum
