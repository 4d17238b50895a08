#include "core/files/gltf/gltf_physics.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/dynamics/convex.h"
#include "core/dynamics/weigh.h"
#include "core/files/gltf/gltf_mirror.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_physics_values.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/geometry/soup_builder.h"
#include "core/scene/world_fields.h"

namespace tactum {

namespace {

using Severity = Finding::Severity;
using Affine = Eigen::Affine3d;

constexpr std::size_t kMostLooks = std::size_t(1) << 20;

/// What a number of a motion may be. 0 is always one of them.
struct Range {
    double least, most; ///< of its size
    bool negative;
    const char* words;
};
constexpr Range kMassRange{1e-15, 1e12, false, "0 or from 1e-15 to 1e12 kg"};
constexpr Range kMomentRange{1e-30, 1e18, false, "three times 0 or from 1e-30 to 1e18 kg m^2"};
constexpr Range kPlaceRange{0, 1e6, true, "three numbers up to 1e6 m"};
constexpr Range kSpeedRange{0, 1e9, true, "three numbers up to 1e9 m/s or rad/s"};
constexpr Range kFactorRange{0, 1e6, true, "a number up to 1e6"};

bool isIn(const Range& range, double value) {
    if (value < 0 && !range.negative) return false;
    return value == 0 || (std::abs(value) >= range.least && std::abs(value) <= range.most);
}

/// A place of the node tree: p_W = pose.apply(stretch * p).
struct Spot {
    Affine world = Affine::Identity();
    Pose pose;
    Mat3 stretch = Mat3::Identity();
    Pose inBody;       ///< the same in the frame of its body
    bool rigid = true; ///< neither this node nor one above has a matrix or a scale: poses are exact
};

Affine affineOf(const Pose& pose) {
    return Eigen::Translation3d(pose.translation) * pose.rotation;
}

class PhysicsReader {
public:
    PhysicsReader(const Source& source, const tinygltf::Model& model, const Json& root,
                  const GltfMotions& motions, const ReadShapeMesh& meshAt)
        : source_(source), model_(model), root_(root), motions_(motions), meshAt_(meshAt),
          physics_(extension(root, kPhysicsExtension)) {
        shapes_ = extension(root, kShapesExtension);
        if (!shapes_) shapes_ = extension(root, kOlderShapes);
    }

    GltfPhysics run();

private:
    static const Json* extension(const Json& holder, const char* name) {
        const Json* all = member(holder, "extensions");
        return all ? member(*all, name) : nullptr;
    }
    const Json* ofNode(int node) const {
        const Json& json = root_["nodes"][std::size_t(node)];
        return extension(json, kPhysicsExtension);
    }
    const Json* element(const Json* holder, const char* array, int index) const {
        const Json* all = holder ? member(*holder, array) : nullptr;
        if (!all || !all->is_array() || index < 0 || std::size_t(index) >= all->size()) return nullptr;
        const Json& found = (*all)[std::size_t(index)];
        return found.is_object() ? &found : nullptr;
    }
    int indexOf(const Json& holder, const char* key) const {
        return indexIn(holder, key, std::size_t(1) << 30);
    }
    std::string nameOf(int node) const {
        const std::string& name = model_.nodes[std::size_t(node)].name;
        return name.empty() ? "node" + std::to_string(node) : name;
    }
    Values valuesOf(const Json& json, int node, const char* what) {
        return {json, nameOf(node), what, made_.findings};
    }
    void warn(const std::string& object, const std::string& sentence, const std::string& remedy) {
        made_.findings.push_back({Severity::Warning, object, sentence, remedy});
    }
    RigidBody* bodyOf(BodyId id) {
        const auto found = std::ranges::find(made_.mechanics.bodies, id, &RigidBody::id);
        return found == made_.mechanics.bodies.end() ? nullptr : &*found;
    }
    Pose frameOf(BodyId id) {
        const RigidBody* body = bodyOf(id);
        return body ? body->pose : Pose{};
    }

    template <int N>
    std::optional<Eigen::Matrix<double, N, 1>> valueIn(const Json& motion, const char* key,
                                                       const Range& range, const std::string& body);
    void checkKinds(int node, const Json& ours);
    void checkShared();
    std::optional<Quat> inertiaTurn(const Json& motion, const std::string& body);
    void visit(int node, const Spot& parent, BodyId body, std::uint32_t part);
    Spot spotOf(int node, const Spot& parent, BodyId body);
    void numberParts();
    void noteTriggers();
    Pose placeOf(int node);
    void addBody(int node, const Json& motion);
    const Json* named(int node, const Json& collider, const char* key, const char* array);
    void addCollider(int node, const Json& collider, BodyId body);
    std::optional<ColliderShape> shapeOf(int node, const Json& geometry);
    void addMesh(int mesh, const Mat3& linear, const Vec3& offset, ShapeMesh& to);
    void addNodeMeshes(int node, const Affine& to, ShapeMesh& mesh, int depth);
    void fillMasses();
    void addJoint(int node, const Json& json);
    void readWorld(const Json& ours, const char* where, const WorldField& field);

    const Source& source_;
    const tinygltf::Model& model_;
    const Json& root_;
    const GltfMotions& motions_;
    const ReadShapeMesh& meshAt_;
    const Json* physics_;
    const Json* shapes_ = nullptr;
    std::map<int, Spot> spots_; ///< of every node of the scene
    std::map<int, BodyId> owners_;
    std::map<int, std::uint32_t> parts_; ///< Collider::part, of nodes that stand still
    std::map<BodyId, const Json*> motionsOf_;
    std::map<BodyId, int> nodeOf_;
    std::size_t looked_ = 0; ///< nodes of meshes, which need not be a tree
    GltfPhysics made_;
};

Spot PhysicsReader::spotOf(int node, const Spot& parent, BodyId body) {
    Spot spot;
    const tinygltf::Node& of = model_.nodes[std::size_t(node)];
    spot.rigid = parent.rigid && !motions_.moves(node) && of.matrix.empty() &&
                 scaleOf(model_, node).diagonal() == Vec3::Ones();
    if (spot.rigid) {
        const Pose local = rigidOf(source_, model_, node);
        spot.pose = parent.pose * local;
        spot.inBody = parent.inBody * local;
        spot.world = affineOf(spot.pose);
        return spot;
    }
    spot.world = parent.world * motions_.localAt(node, 0);
    const RigidAndStretch parts = polarDecomposition(spot.world.linear());
    spot.pose = {unitLength(Quat(parts.rotation)), spot.world.translation()};
    spot.stretch = parts.stretch;
    spot.inBody = frameOf(body).inverse() * spot.pose;
    return spot;
}

/// What of a node is no object at all; who reads it later sees nothing there.
void PhysicsReader::checkKinds(int node, const Json& ours) {
    valuesOf(root_["nodes"][std::size_t(node)]["extensions"], node, "set of extensions")
        .object(kPhysicsExtension);
    const Values values = valuesOf(ours, node, kPhysicsExtension);
    for (const char* key : {"motion", "collider", "trigger", "joint"})
        values.object(key);
}

/// The same of what all nodes share.
void PhysicsReader::checkShared() {
    const std::string file = "the file";
    const Json* all = Values(root_, file, "root", made_.findings).object("extensions");
    if (!all) return;
    const Values extensions(*all, file, "set of extensions", made_.findings);
    for (const char* name : {kPhysicsExtension, kShapesExtension, kOlderShapes}) {
        const Json* found = extensions.object(name);
        if (!found) continue;
        const Values values(*found, file, name, made_.findings);
        if (name != kPhysicsExtension) {
            values.listOfObjects("shapes");
            continue;
        }
        for (const char* key : {"physicsMaterials", "physicsJoints", "collisionFilters"})
            values.listOfObjects(key);
    }
}

void PhysicsReader::visit(int node, const Spot& parent, BodyId body, std::uint32_t part) {
    if (!placeIfAny(source_, motions_, node, parent.world)) return; // a camera, which has no part in it
    spots_[node] = spotOf(node, parent, body);
    const Json* ours = ofNode(node);
    if (ours) checkKinds(node, *ours);
    if (const Json* motion = ours ? member(*ours, "motion") : nullptr; motion && motion->is_object()) {
        addBody(node, *motion);
        body = made_.mechanics.bodies.back().id;
        spots_[node].inBody = Pose{};
    }
    // What hangs below a collider that stands still is one thing with it.
    if (part == 0 && ours && ours->contains("collider")) part = std::uint32_t(node) + 1;
    if (body == kWorldBody) parts_[node] = part;
    owners_[node] = body;
    if (body != kWorldBody) made_.bodyOfNode[node] = body;
    for (const int child : model_.nodes[std::size_t(node)].children)
        visit(child, spots_[node], body, part);
}

/// What is no such number is said, and is as if it were not there.
template <int N>
std::optional<Eigen::Matrix<double, N, 1>>
PhysicsReader::valueIn(const Json& motion, const char* key, const Range& range, const std::string& body) {
    const Json* found = member(motion, key);
    if (!found) return std::nullopt;
    const auto value = vectorOf<N>(N == 1 ? Json::array({*found}) : *found);
    if (value && std::ranges::all_of(*value, [&](double one) { return isIn(range, one); })) return value;
    warn(body, std::string("has a motion whose ") + key + " is not " + range.words,
         "it is as if it were not there; correct it");
    return std::nullopt;
}

void PhysicsReader::addBody(int node, const Json& motion) {
    const Spot& spot = spots_[node];
    RigidBody body;
    body.id = BodyId(made_.mechanics.bodies.size() + 1);
    body.name = printable(nameOf(node), kLongestName);
    const Json* ours = extensionOf(root_["nodes"][std::size_t(node)]);
    body.pose = ours ? exactPose(*ours, spot.pose).value_or(spot.pose) : spot.pose;
    body.kinematic =
        Values(motion, body.name, "motion", made_.findings).flag("isKinematic") || motions_.moves(node);
    if (const auto factor = valueIn<1>(motion, "gravityFactor", kFactorRange, body.name))
        body.gravityFactor = factor->x();
    // Of the node's frame; m/s, whatever its scale. In ours the exact one of the world stands beside it.
    const auto along = [&](const char* key, const char* exactKey) {
        const Vec3 turned =
            spot.pose.rotation * valueIn<3>(motion, key, kSpeedRange, body.name).value_or(Vec3::Zero());
        const auto exact = ours ? vectorIn<3>(*ours, exactKey) : std::nullopt;
        return exact && (*exact - turned).norm() <= 1e-9 * turned.norm() ? *exact : turned;
    };
    body.velocity = along("linearVelocity", "velocity");
    body.angularVelocity = along("angularVelocity", "angularVelocity");
    motionsOf_[body.id] = &motion;
    nodeOf_[body.id] = node;
    made_.mechanics.bodies.push_back(body);
}

void PhysicsReader::addMesh(int mesh, const Mat3& linear, const Vec3& offset, ShapeMesh& to) {
    const ShapeMesh part = meshAt_(mesh);
    const std::uint32_t first = std::uint32_t(to.points.size());
    for (const Vec3& point : part.points)
        to.points.push_back(linear * point + offset);
    const bool mirrored = linear.determinant() < 0;
    for (auto face : part.faces) {
        if (mirrored) std::swap(face[1], face[2]);
        to.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
}

/// The meshes of a node and of what is below it, which need not be in the scene.
void PhysicsReader::addNodeMeshes(int node, const Affine& to, ShapeMesh& mesh, int depth) {
    if (node < 0 || std::size_t(node) >= model_.nodes.size() || depth > 64) return;
    if (++looked_ > kMostLooks) source_.fail("has colliders that name too many nodes; simplify them");
    const tinygltf::Node& of = model_.nodes[std::size_t(node)];
    if (of.mesh >= 0 && std::size_t(of.mesh) < model_.meshes.size())
        addMesh(of.mesh, to.linear(), to.translation(), mesh);
    for (const int child : of.children)
        if (std::size_t(child) < model_.nodes.size())
            addNodeMeshes(child, to * transformOf(source_, model_, child), mesh, depth + 1);
}

std::optional<ColliderShape> PhysicsReader::shapeOf(int node, const Json& geometry) {
    const Mat3& stretch = spots_[node].stretch;
    if (const Json* shape = element(shapes_, "shapes", indexOf(geometry, "shape")))
        return implicitShapeOf(*shape, stretch, nameOf(node), made_.findings);
    const bool isHull = valuesOf(geometry, node, "collider").flag("convexHull");
    auto mesh = std::make_shared<ShapeMesh>();
    const int named = indexOf(geometry, "mesh");
    if (named >= 0 && std::size_t(named) < model_.meshes.size())
        addMesh(named, stretch, Vec3::Zero(), *mesh);
    else
        addNodeMeshes(indexOf(geometry, "node"), Affine(stretch), *mesh, 0);
    if (mesh->points.empty()) return std::nullopt;
    ColliderShape shape;
    shape.kind = isHull ? ShapeKind::Hull : ShapeKind::Mesh;
    shape.mesh = std::move(mesh);
    return shape;
}

/// In the frame of its body; exact in ours below another node, where the product of two loses the last bits.
Pose PhysicsReader::placeOf(int node) {
    const Pose& place = spots_[node].inBody;
    const Json* ours = extensionOf(root_["nodes"][std::size_t(node)]);
    return ours ? exactPose(*ours, place).value_or(place) : place;
}

/// What a collider names by its number; said where there is no such thing.
const Json* PhysicsReader::named(int node, const Json& collider, const char* key, const char* array) {
    const Json* found = element(physics_, array, indexOf(collider, key));
    if (!found && collider.contains(key))
        warn(nameOf(node), std::string("has a collider whose ") + key + " is none of the " + array,
             "it is as if it were not there; correct the number");
    return found;
}

void PhysicsReader::addCollider(int node, const Json& json, BodyId body) {
    const Json* geometry = member(json, "geometry");
    const auto shape = shapeOf(node, geometry && geometry->is_object() ? *geometry : json);
    if (!shape)
        return warn(nameOf(node), "has a collider without a usable shape",
                    "it touches no other body; give it one");
    if (shape->mesh && hullOf(shape->mesh->points).faces.empty())
        return warn(nameOf(node), "has a collider whose mesh is flat",
                    "it touches no other body; give it a thickness, or a box or plane as shape");
    Collider collider;
    collider.body = body;
    collider.pose = placeOf(node);
    collider.shape = *shape;
    if (const Json* of = named(node, json, "physicsMaterial", "physicsMaterials"))
        collider.material = touchMaterialOf(*of, nameOf(node), made_.findings);
    if (const Json* of = named(node, json, "collisionFilter", "collisionFilters"))
        collider.filter = collisionFilterOf(*of, nameOf(node), made_.findings);
    if (body == kWorldBody) collider.part = parts_[node];
    made_.mechanics.colliders.push_back(std::move(collider));
}

/// What is no turn is said; so is one that turns nothing.
std::optional<Quat> PhysicsReader::inertiaTurn(const Json& motion, const std::string& body) {
    if (!member(motion, "inertiaOrientation")) return std::nullopt;
    const auto turn = vectorIn<4>(motion, "inertiaOrientation");
    const Values values(motion, body, "motion", made_.findings);
    if (!turn || !isUsable(*turn)) {
        values.warn("whose inertiaOrientation is not a turn of four numbers",
                    "it is as if it were not there; correct it");
        return std::nullopt;
    }
    const Quat unit = unitLength(Quat(*turn));
    if (!member(motion, "inertiaDiagonal") && unit.vec().norm() > 1e-6)
        values.warn("with an inertiaOrientation and no inertiaDiagonal", "it turns nothing; give it both");
    return unit;
}

/// What the file says of a body's mass, and what its colliders say where the file says nothing.
void PhysicsReader::fillMasses() {
    for (RigidBody& body : made_.mechanics.bodies) {
        const Json& motion = *motionsOf_[body.id];
        ShapeMass shapes;
        for (const Collider& collider : made_.mechanics.colliders)
            if (collider.body == body.id)
                shapes = together(shapes, placed(massOf(collider.shape), collider.pose));
        const auto mass = valueIn<1>(motion, "mass", kMassRange, body.name);
        weigh(body, shapes, mass ? mass->x() : shapes.volume > 0 ? kDensity * shapes.volume : 1);
        if (const auto centre = valueIn<3>(motion, "centerOfMass", kPlaceRange, body.name))
            body.centre = spots_[nodeOf_[body.id]].stretch * *centre;
        const auto inertia = valueIn<3>(motion, "inertiaDiagonal", kMomentRange, body.name);
        const auto turn = inertiaTurn(motion, body.name);
        if (!inertia) continue;
        body.inertia = *inertia;
        body.inertiaFrame = turn.value_or(Quat::Identity());
    }
}

void PhysicsReader::readWorld(const Json& ours, const char* where, const WorldField& field) {
    const std::string key = jsonKey(field.parameter->key);
    if (!ours.contains(key) || ours[key].is_null()) return;
    const auto value = numberIn(ours, key.c_str());
    if (value && field.parameter->allows(*value))
        made_.mechanics.*field.value = *value;
    else
        warn("", where + ("." + key) + " is not a number that it may be", "the initial value is used");
}

void PhysicsReader::addJoint(int node, const Json& json) {
    const int other = indexOf(json, "connectedNode");
    const Json* description = element(physics_, "physicsJoints", indexOf(json, "joint"));
    if (!description || !spots_.contains(other))
        return warn(nameOf(node), "has a joint that names no other node or no description",
                    "left out; give it both");
    Joint joint;
    joint.name = printable(nameOf(node), kLongestName);
    joint.a = owners_[node];
    joint.b = owners_[other];
    joint.frameA = placeOf(node);
    joint.frameB = placeOf(other);
    joint.collide = valuesOf(json, node, "joint").flag("enableCollision");
    if (joint.a == kWorldBody) joint.part = parts_[node];
    if (joint.b == kWorldBody) joint.part = parts_[other];
    const Json* ours = extensionOf(root_["nodes"][std::size_t(node)]);
    const Json* path = ours ? member(*ours, "path") : nullptr;
    if (path && !addPath(*path, joint, made_.findings)) return;
    const Json& acts = path ? *path : *description; // what the standard says of such a joint is for others
    addLimits(acts, joint, made_.findings);
    addDrives(acts, "drives", joint, made_.findings);
    if (ours) {
        addDrives(*ours, "detents", joint, made_.findings);
        addFrictions(*ours, joint, made_.findings);
    }
    if (joint.a == joint.b)
        return warn(joint.name, "joins two nodes that move as one",
                    "left out; one of them needs a motion of its own");
    made_.mechanics.joints.push_back(std::move(joint));
}

/// In the order of their colliders, wherever their nodes stand.
void PhysicsReader::numberParts() {
    std::map<std::uint32_t, std::uint32_t> numbers{{0, 0}};
    for (Collider& collider : made_.mechanics.colliders)
        collider.part = numbers.try_emplace(collider.part, numbers.size()).first->second;
    for (Joint& joint : made_.mechanics.joints) {
        const auto number = numbers.find(joint.part);
        joint.part = number == numbers.end() ? 0 : number->second;
    }
}

void PhysicsReader::noteTriggers() {
    std::size_t count = 0;
    for (const auto& [node, body] : owners_)
        if (const Json* ours = ofNode(node)) count += ours->contains("trigger");
    if (count > 0)
        made_.findings.push_back({Severity::Note, "", counted(count, "trigger") + " of another program",
                                  "not known here, and not written when the scene is saved"});
}

GltfPhysics PhysicsReader::run() {
    const Json* nodes = member(root_, "nodes");
    if (!nodes || !nodes->is_array() || nodes->size() != model_.nodes.size()) return {};
    if (std::ranges::none_of(*nodes, [](const Json& node) { return extension(node, kPhysicsExtension); }))
        return {};
    checkShared();
    for (const int node : sceneRoots(model_))
        visit(node, Spot{}, kWorldBody, 0);
    // Colliders alone: copies of our own, or of no use here.
    if (made_.mechanics.bodies.empty()) return {{}, {}, std::move(made_.findings)};
    for (const auto& [node, body] : owners_)
        if (const Json* ours = ofNode(node))
            if (const Json* collider = member(*ours, "collider"); collider && collider->is_object())
                addCollider(node, *collider, body);
    fillMasses();
    for (const auto& [node, body] : owners_)
        if (const Json* ours = ofNode(node))
            if (const Json* joint = member(*ours, "joint"); joint && joint->is_object())
                addJoint(node, *joint);
    numberParts();
    if (const Json* ours = extensionOf(root_)) {
        if (const auto gravity = vectorIn<3>(*ours, "gravity"))
            made_.mechanics.gravity = *gravity;
        else if (member(*ours, "gravity"))
            Values(*ours, "the file", kExtension, made_.findings)
                .warn("whose gravity is not three numbers", "9.81 m/s^2 down is used; correct it");
        for (const WorldField& field : kWorldFields)
            readWorld(*ours, kExtension, field);
    } else if (const Json* scenes = member(root_, "scenes"); scenes && scenes->is_array()) {
        for (const Json& scene : *scenes) {
            const Json copy = mirrored(scene);
            for (const WorldField& field : kWorldFields)
                readWorld(copy, kMirror, field);
        }
    }
    noteTriggers();
    return std::move(made_);
}

} // namespace

GltfPhysics readPhysics(const Source& source, const tinygltf::Model& model, const Json& root,
                        const GltfMotions& motions, const ReadShapeMesh& meshAt) {
    return PhysicsReader(source, model, root, motions, meshAt).run();
}

} // namespace tactum
