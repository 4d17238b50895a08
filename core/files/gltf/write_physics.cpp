#include "core/files/gltf/write_physics.h"

#include <algorithm>
#include <cmath>

#include "core/files/gltf/gltf_references.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

// In the order of Combine and ShapeKind.
constexpr std::array<const char*, 4> kCombines{"average", "minimum", "maximum", "multiply"};
constexpr std::array<const char*, 5> kShapes{"box", "sphere", "capsule", "cylinder", "plane"};

/// What is endless is not said.
void putBound(Json& json, const char* key, double value) {
    if (std::isfinite(value)) json[key] = value;
}

Json axesJson(AxisSet axes) {
    Json list = Json::array();
    for (int axis = 0; axis < 3; ++axis)
        if (axes >> axis & 1) list.push_back(axis);
    return list;
}

Json limitJson(const JointLimit& limit) {
    Json json{{limit.angular ? "angularAxes" : "linearAxes", axesJson(limit.axes)}};
    putBound(json, "min", limit.min), putBound(json, "max", limit.max);
    putBound(json, "stiffness", limit.stiffness);
    if (limit.damping != 0) json["damping"] = limit.damping;
    return json;
}

const char* typeOf(bool angular) {
    return angular ? "angular" : "linear";
}

Json driveJson(const JointDrive& drive) {
    Json json{{"type", typeOf(drive.angular)},
              {"axis", drive.axis},
              {"stiffness", drive.stiffness},
              {"damping", drive.damping},
              {"positionTarget", drive.position},
              {"velocityTarget", drive.velocity},
              {"mode", drive.acceleration ? "acceleration" : "force"}};
    putBound(json, "maxForce", drive.maxForce);
    if (drive.spacing > 0) json["spacing"] = drive.spacing;
    return json;
}

Json pathJson(const JointPath& path) {
    Json json{{"closed", path.closed}, {"points", Json::array()}};
    for (const Vec3& point : path.points)
        json["points"].push_back(vectorJson(point));
    for (const Vec3& up : path.ups)
        json["ups"].push_back(vectorJson(up));
    return json;
}

/// With `type` and an object under its name.
Json shapeJson(const ColliderShape& shape) {
    const std::string type = kShapes[std::size_t(shape.kind)];
    Json of = Json::object();
    switch (shape.kind) {
    case ShapeKind::Box:
        of["size"] = vectorJson(shape.size);
        break;
    case ShapeKind::Sphere:
        of["radius"] = shape.radius;
        break;
    case ShapeKind::Plane:
        putBound(of, "sizeX", shape.size.x()), putBound(of, "sizeZ", shape.size.z());
        break;
    default:
        of = {{"height", shape.height}, {"radiusTop", shape.radius}, {"radiusBottom", shape.radiusBottom}};
    }
    return {{"type", type}, {type, of}};
}

Json materialJson(const TouchMaterial& material) {
    return {{"staticFriction", material.staticFriction},
            {"dynamicFriction", material.dynamicFriction},
            {"restitution", material.restitution},
            {"frictionCombine", kCombines[std::size_t(material.frictionCombine)]},
            {"restitutionCombine", kCombines[std::size_t(material.restitutionCombine)]}};
}

Json filterJson(const CollisionFilter& filter) {
    Json json = Json::object();
    if (!filter.systems.empty()) json["collisionSystems"] = filter.systems;
    if (!filter.notWith.empty()) json["notCollideWithSystems"] = filter.notWith;
    if (!filter.with.empty()) json["collideWithSystems"] = filter.with;
    return json;
}

Json motionJson(const RigidBody& body) {
    const Quat back = body.pose.rotation.conjugate(); // velocities are those of the node's own space
    Json json{{"mass", body.mass},
              {"centerOfMass", vectorJson(body.centre)},
              {"inertiaDiagonal", vectorJson(body.inertia)},
              {"inertiaOrientation", quaternionJson(body.inertiaFrame)},
              {"gravityFactor", body.gravityFactor}};
    if (!body.velocity.isZero(0)) json["linearVelocity"] = vectorJson(back * body.velocity);
    if (!body.angularVelocity.isZero(0)) json["angularVelocity"] = vectorJson(back * body.angularVelocity);
    if (body.kinematic) json["isKinematic"] = true;
    return json;
}

} // namespace

PhysicsWriter::PhysicsWriter(Json& root, GltfData& data, const Mechanics& mechanics,
                             const AddShapeMesh& meshOf)
    : root_(root), data_(data), mechanics_(mechanics), meshOf_(meshOf) {}

void PhysicsWriter::use(const char* extension) {
    Json& used = root_["extensionsUsed"];
    if (!used.is_array()) used = Json::array();
    if (std::ranges::find(used, Json(extension)) == used.end()) used.push_back(extension);
}

/// Equal ones are said once.
int PhysicsWriter::element(const char* extension, const char* array, Json value) {
    Json& all = root_["extensions"][extension][array];
    use(extension);
    const auto [known, isNew] = known_.try_emplace(array + value.dump(), int(all.size()));
    if (isNew) all.push_back(std::move(value));
    return known->second;
}

/// What it stands still with, if there is a collider of it already.
const PhysicsWriter::Thing* PhysicsWriter::thingOf(BodyId body, std::uint32_t part) const {
    const auto found = body == kWorldBody && part != 0 ? things_.find(part) : things_.end();
    return found == things_.end() ? nullptr : &found->second;
}

/// `pose`: in the frame of the body.
Json PhysicsWriter::partNode(const char* role, const std::string& name, const Pose& pose, BodyId body,
                             std::uint32_t part) const {
    const Thing* thing = thingOf(body, part);
    Json node = nodePoseJson(thing ? thing->pose.inverse() * pose : pose);
    const bool isExact = !thing && node == poseJson(pose);
    node["name"] = name;
    node["extensions"][kExtension]["role"] = role;
    if (!isExact) node["extensions"][kExtension]["pose"] = poseJson(pose);
    return node;
}

void PhysicsWriter::hang(int node, BodyId body, std::uint32_t part) {
    if (body != kWorldBody)
        below_[body].push_back(node);
    else if (const Thing* thing = thingOf(body, part))
        root_["nodes"][std::size_t(thing->node)]["children"].push_back(node);
    else
        still_.push_back(node);
}

Json PhysicsWriter::geometryOf(const ColliderShape& shape) {
    if (shape.mesh) return {{"mesh", meshOf_(shape.mesh)}, {"convexHull", shape.kind == ShapeKind::Hull}};
    return {{"shape", element(kShapesExtension, "shapes", shapeJson(shape))}};
}

void PhysicsWriter::addCollider(const Collider& collider) {
    Json json{{"geometry", geometryOf(collider.shape)}};
    json["physicsMaterial"] = element(kPhysicsExtension, "physicsMaterials", materialJson(collider.material));
    if (collider.filter != CollisionFilter{})
        json["collisionFilter"] = element(kPhysicsExtension, "collisionFilters", filterJson(collider.filter));
    Json node = partNode("collider", "collider", collider.pose, collider.body, collider.part);
    node["extensions"][kPhysicsExtension]["collider"] = std::move(json);
    const int index = data_.add("nodes", std::move(node));
    hang(index, collider.body, collider.part);
    if (collider.body == kWorldBody && collider.part != 0)
        things_.try_emplace(collider.part, Thing{index, collider.pose});
}

void PhysicsWriter::addJoint(const Joint& joint) {
    Json description = Json::object(), path;
    Json& acts = joint.path.isThere() ? path : description; // along a path nothing acts that others know
    if (joint.path.isThere()) path = pathJson(joint.path);
    for (const JointLimit& limit : joint.limits)
        acts["limits"].push_back(limitJson(limit));
    for (const JointDrive& drive : joint.drives)
        if (drive.spacing == 0) acts["drives"].push_back(driveJson(drive));
    const auto frame = [&](const std::string& name, BodyId body, const Pose& pose) {
        return partNode("joint", name, pose, body, joint.part);
    };
    const int other = data_.add("nodes", frame(joint.name + " to", joint.b, joint.frameB));
    Json node = frame(joint.name, joint.a, joint.frameA);
    node["extensions"][kPhysicsExtension]["joint"] = {
        {"connectedNode", other},
        {"joint", element(kPhysicsExtension, "physicsJoints", std::move(description))},
        {"enableCollision", joint.collide}};
    if (joint.path.isThere()) node["extensions"][kExtension]["path"] = std::move(path);
    for (const JointDrive& drive : joint.drives) // the standard has no detents
        if (drive.spacing > 0) node["extensions"][kExtension]["detents"].push_back(driveJson(drive));
    for (const JointFriction& friction : joint.frictions)
        node["extensions"][kExtension]["frictions"].push_back(
            {{"type", typeOf(friction.angular)}, {"axis", friction.axis}, {"force", friction.force}});
    hang(other, joint.b, joint.part);
    hang(data_.add("nodes", std::move(node)), joint.a, joint.part);
}

void PhysicsWriter::addParts() {
    if (mechanics_.bodies.empty()) return;
    for (const Collider& collider : mechanics_.colliders)
        addCollider(collider);
    for (const Joint& joint : mechanics_.joints)
        addJoint(joint);
}

int PhysicsWriter::addBody(const RigidBody& body, const std::vector<int>& objects) {
    Json node = partNode("body", body.name, body.pose, kWorldBody, 0);
    Json& ours = node["extensions"][kExtension];
    if (!body.velocity.isZero(0)) ours["velocity"] = vectorJson(body.velocity);
    if (!body.angularVelocity.isZero(0)) ours["angularVelocity"] = vectorJson(body.angularVelocity);
    node["extensions"][kPhysicsExtension]["motion"] = motionJson(body);
    use(kPhysicsExtension);
    std::vector<int> children = objects;
    const std::vector<int>& parts = below_[body.id];
    children.insert(children.end(), parts.begin(), parts.end());
    if (!children.empty()) node["children"] = children;
    return data_.add("nodes", std::move(node));
}

void eraseMechanics(Json& element) {
    for (const char* name : {kPhysicsExtension, kShapesExtension, kOlderShapes}) {
        eraseUse(element, name);
        eraseExtension(element, name);
        if (Json* required = arrayIn(element, "extensionsRequired"))
            required->erase(std::remove(required->begin(), required->end(), Json(name)), required->end());
    }
    if (const Json* required = member(element, "extensionsRequired"); required && required->empty())
        element.erase("extensionsRequired");
    if (Json* nodes = arrayIn(element, "nodes"))
        for (Json& node : *nodes)
            eraseExtension(node, kPhysicsExtension);
}

} // namespace tactum
