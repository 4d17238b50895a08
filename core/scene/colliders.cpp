#include "core/scene/colliders.h"

#include <algorithm>
#include <cmath>

#include "core/scene/arrange.h"
#include "core/scene/bodies.h"
#include "core/scene/convex_parts.h"

namespace tactum {
namespace {

/// One mesh that a collider stands for, in the frame of its body, or in the world.
struct MetMesh {
    const TriangleSoup* soup;
    Pose pose;
};

std::vector<MetMesh> meshesOf(const Scene& scene, const SceneObject& object) {
    if (object.body == kWorldBody) return {{object.geometry.get(), object.pose}};
    const RigidBody* body = findBody(scene, object.body);
    std::vector<MetMesh> all;
    for (const SceneObject& each : scene.objects)
        if (body && each.body == body->id && each.geometry)
            all.push_back({each.geometry.get(), body->pose.inverse() * each.pose});
    return all;
}

/// Where a point is, seen along an axis: how far along it, and how far from it.
struct Cylindrical {
    double along, out;
};
Cylindrical seenAlong(const Vec3& p, int axis) {
    return {p[axis], std::hypot(p[(axis + 1) % 3], p[(axis + 2) % 3])};
}

/// Round about one axis through the origin, with y for its own.
ColliderShape roundAbout(const std::vector<Vec3>& points, ColliderForm form, int axis) {
    ColliderShape shape;
    const bool capped = form == ColliderForm::Capsule;
    shape.kind = capped ? ShapeKind::Capsule : ShapeKind::Cylinder;
    shape.radius = shape.height = 0;
    for (const Vec3& p : points)
        shape.radius = std::max(shape.radius, seenAlong(p, axis).out);
    for (const Vec3& p : points) {
        const auto [along, out] = seenAlong(p, axis);
        const double cap = capped ? std::sqrt(std::max(0.0, shape.radius * shape.radius - out * out)) : 0;
        shape.height = std::max(shape.height, 2 * (std::abs(along) - cap));
    }
    shape.radiusBottom = shape.radius;
    return shape;
}

ColliderShape leastRound(const std::vector<Vec3>& points, ColliderForm form, Pose& pose) {
    ColliderShape best;
    double least = kUnbounded;
    const Quat before = pose.rotation;
    for (int axis = 0; axis < 3; ++axis) {
        ColliderShape shape = roundAbout(points, form, axis);
        const double volume = massOf(shape).volume;
        if (volume >= least) continue;
        least = volume, best = shape;
        pose.rotation = unitLength(before * turnOnto(Vec3::UnitY(), Vec3::Unit(axis)));
    }
    return best;
}

ColliderShape hullAround(std::span<const Vec3> points) {
    TriangleSoup soup; // one part, whatever its triangles are
    soup.positions.assign(points.begin(), points.end());
    for (Index i = 1; i + 1 < Index(points.size()); ++i)
        soup.triangles.push_back({0, i, i + 1});
    return convexParts(soup).front();
}

std::vector<Vec3> pointsOf(const std::vector<MetMesh>& meshes) {
    std::vector<Vec3> points;
    for (const MetMesh& mesh : meshes)
        for (const auto& corners : mesh.soup->triangles)
            for (const Index corner : corners)
                points.push_back(mesh.pose.apply(mesh.soup->positions[corner]));
    return points;
}

/// Shapes with their places in the body, or in the world.
std::vector<std::pair<Pose, ColliderShape>> shapesOf(const std::vector<MetMesh>& meshes, ColliderForm form) {
    std::vector<std::pair<Pose, ColliderShape>> all;
    if (form == ColliderForm::Parts) {
        for (const MetMesh& mesh : meshes)
            for (ColliderShape& part : convexParts(*mesh.soup))
                all.push_back({mesh.pose, std::move(part)});
        return all;
    }
    // Along the axes of the first mesh: of one alone its own.
    Pose pose = meshes.front().pose;
    std::vector<Vec3> points = pointsOf(meshes);
    for (Vec3& p : points)
        p = meshes.front().pose.applyInverse(p);
    Pose own;
    ColliderShape shape = shapeAround(points, form, own);
    all.push_back({pose * own, std::move(shape)});
    return all;
}

} // namespace

const std::array<ColliderFormName, 6> kColliderForms{{
    {ColliderForm::Parts, "Convex parts", "The hull of each part that shares no corner with the others."},
    {ColliderForm::Hull, "One hull", "As if it were wrapped tightly: hollows are filled."},
    {ColliderForm::Box, "Box", "Along its own axes."},
    {ColliderForm::Sphere, "Sphere", "It rolls in every direction."},
    {ColliderForm::Capsule, "Capsule", "A rod with round ends."},
    {ColliderForm::Cylinder, "Cylinder", "A round plate or rod with flat ends."},
}};

ColliderShape shapeAround(std::span<const Vec3> points, ColliderForm form, Pose& pose) {
    pose = {};
    if (form == ColliderForm::Hull || form == ColliderForm::Parts) return hullAround(points);
    Bounds box;
    for (const Vec3& p : points)
        box.add(p);
    pose.translation = box.centre();
    ColliderShape shape;
    shape.size = box.high - box.low;
    if (form == ColliderForm::Box) return shape;
    std::vector<Vec3> about;
    for (const Vec3& p : points)
        about.push_back(p - pose.translation);
    if (form != ColliderForm::Sphere) return leastRound(about, form, pose);
    shape = {};
    shape.kind = ShapeKind::Sphere;
    shape.radius = 0;
    for (const Vec3& p : about)
        shape.radius = std::max(shape.radius, p.norm());
    return shape;
}

std::optional<ColliderForm> colliderFormOf(const Scene& scene, ObjectId id) {
    const SceneObject* object = scene.find(id);
    const auto own = object ? collidersOf(scene, *object) : std::vector<std::size_t>();
    if (own.empty()) return std::nullopt;
    const auto kind = [&](std::size_t i) { return scene.mechanics.colliders[i].shape.kind; };
    const bool hulls = std::ranges::all_of(own, [&](std::size_t i) { return kind(i) == ShapeKind::Hull; });
    if (own.size() > 1) return hulls ? std::optional(ColliderForm::Parts) : std::nullopt;
    switch (kind(own[0])) {
    case ShapeKind::Box:
        return ColliderForm::Box;
    case ShapeKind::Sphere:
        return ColliderForm::Sphere;
    case ShapeKind::Capsule:
        return ColliderForm::Capsule;
    case ShapeKind::Cylinder:
        return ColliderForm::Cylinder;
    case ShapeKind::Hull:
        return ColliderForm::Hull;
    default:
        return std::nullopt;
    }
}

void setColliderForm(Scene& scene, ObjectId id, ColliderForm form) {
    const SceneObject* object = scene.find(id);
    if (!object || object->motion || !object->geometry || object->geometry->triangles.empty() ||
        scene.mechanics.bodies.empty())
        return;
    auto& colliders = scene.mechanics.colliders;
    const auto own = collidersOf(scene, *object);
    Collider like;
    like.body = object->body;
    if (!own.empty())
        like = colliders[own[0]];
    else if (like.body == kWorldBody)
        for (const Collider& each : colliders)
            like.part = std::max(like.part, each.part + 1);
    const std::size_t place = own.empty() ? colliders.size() : own[0];
    for (auto i = own.rbegin(); i != own.rend(); ++i)
        colliders.erase(colliders.begin() + std::ptrdiff_t(*i));
    std::vector<Collider> made;
    for (auto& [pose, shape] : shapesOf(meshesOf(scene, *object), form)) {
        made.push_back(like);
        made.back().pose = pose, made.back().shape = std::move(shape);
    }
    colliders.insert(colliders.begin() + std::ptrdiff_t(place), made.begin(), made.end());
}

} // namespace tactum
