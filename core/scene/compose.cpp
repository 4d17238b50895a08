#include "core/scene/compose.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/scene/bodies.h"
#include "core/scene/groups.h"
#include "core/scene/kept_elsewhere.h"
#include "core/scene/numbered_names.h"

namespace tactum {
namespace {

NumberedNames namesOf(const Scene& scene) {
    NumberedNames names;
    for (const SceneObject& object : scene.objects)
        names.reserve(object.name);
    return names;
}

/// What the groups of copies are called: a whole group becomes another one, and what is of a part of one that
/// `scene` has stays with it.
class CopiedGroups {
public:
    CopiedGroups(const Scene& scene, const Scene& from, std::span<const ObjectId> copied)
        : whole_(wholeGroups(from, copied)) {
        for (const SceneObject& object : scene.objects)
            names_.reserve(object.group), known_.insert(object.group);
    }
    std::string operator()(const std::string& group) {
        if (group.empty() || (known_.contains(group) && !whole_.contains(group))) return group;
        const auto [to, isNew] = to_.try_emplace(group);
        if (isNew) to->second = names_.take(group);
        return to->second;
    }

private:
    std::set<std::string> whole_, known_;
    NumberedNames names_;
    std::map<std::string, std::string> to_;
};

ObjectId largestId(const Scene& scene) {
    ObjectId largest = 0;
    for (const SceneObject& object : scene.objects)
        largest = std::max(largest, object.id);
    return largest;
}

BodyId largestBody(const Scene& scene) {
    BodyId largest = kWorldBody;
    for (const RigidBody& body : scene.mechanics.bodies)
        largest = std::max(largest, body.id);
    return largest;
}

std::uint32_t largestPart(const Scene& scene) {
    std::uint32_t largest = 0;
    for (const Collider& collider : scene.mechanics.colliders)
        largest = std::max(largest, collider.part);
    return largest;
}

/// What the copies are called; what has none stays what it is.
template <class Id> struct Renamed {
    std::map<Id, Id> to;

    Renamed(std::span<const Id> all, Id above) {
        for (const Id each : all)
            to[each] = ++above;
    }
    bool has(Id each) const { return to.contains(each); }
    Id operator()(Id each) const {
        const auto found = to.find(each);
        return found == to.end() ? each : found->second;
    }
};

void copyMechanics(Scene& scene, const Mechanics& from, const GoingAlong& what,
                   const Renamed<BodyId>& bodies) {
    const Renamed<std::uint32_t> parts(what.parts, largestPart(scene));
    Mechanics& mechanics = scene.mechanics;
    for (RigidBody body : from.bodies) {
        if (!bodies.has(body.id)) continue;
        body.id = bodies(body.id);
        mechanics.bodies.push_back(std::move(body));
    }
    const std::set<std::size_t> still(what.colliders.begin(), what.colliders.end());
    for (std::size_t i = 0; i < from.colliders.size(); ++i) {
        Collider collider = from.colliders[i];
        if (!still.contains(i) && !bodies.has(collider.body)) continue;
        collider.body = bodies(collider.body), collider.part = parts(collider.part);
        mechanics.colliders.push_back(std::move(collider));
    }
    for (Joint joint : from.joints) {
        if (!bodies.has(joint.b)) continue;
        joint.a = bodies(joint.a), joint.b = bodies(joint.b), joint.part = parts(joint.part);
        mechanics.joints.push_back(std::move(joint));
    }
}

/// Places in the file that they are from, which is not that of this scene. How surfaces look comes along.
void forgetKept(Scene& scene) {
    scene.kept = {};
    for (SceneObject& object : scene.objects) {
        object.kept = object.keptMesh = {};
        for (Surface& surface : object.surfaces)
            surface.kept.index = surface.kept.json ? kOfAnotherFile : -1;
    }
    for (SavedCamera& camera : scene.cameras)
        camera.kept = camera.keptCamera = {};
}

void standInTheWay(Scene& scene, std::span<const ObjectId> objects) {
    for (const ObjectId id : objects)
        addStillColliders(scene, id);
}

} // namespace

GoingAlong allOf(const Scene& scene) {
    GoingAlong all;
    for (const SceneObject& object : scene.objects)
        all.objects.push_back(object.id);
    for (const RigidBody& body : scene.mechanics.bodies)
        all.bodies.push_back(body.id);
    for (std::size_t i = 0; i < scene.mechanics.colliders.size(); ++i) {
        const Collider& collider = scene.mechanics.colliders[i];
        if (collider.body != kWorldBody) continue;
        all.colliders.push_back(i);
        if (collider.part != 0) all.parts.push_back(collider.part);
    }
    std::ranges::sort(all.parts);
    all.parts.erase(std::unique(all.parts.begin(), all.parts.end()), all.parts.end());
    return all;
}

std::string freeName(const Scene& scene, const std::string& wanted) {
    return namesOf(scene).take(wanted);
}

std::vector<ObjectId> addCopies(Scene& scene, const Scene& from, const GoingAlong& what, ObjectId above) {
    const Renamed<BodyId> bodies(what.bodies, largestBody(scene));
    copyMechanics(scene, from.mechanics, what, bodies);
    const std::set<ObjectId> wanted(what.objects.begin(), what.objects.end());
    NumberedNames names = namesOf(scene);
    CopiedGroups groups(scene, from, what.objects);
    std::vector<ObjectId> added;
    above = std::max(above, largestId(scene));
    for (SceneObject object : from.objects) {
        if (!wanted.contains(object.id)) continue;
        object.id = ++above;
        object.name = names.take(object.name);
        object.group = groups(object.group);
        object.body = bodies(object.body);
        added.push_back(object.id);
        scene.objects.push_back(std::move(object));
    }
    return added;
}

std::vector<ObjectId> addScene(Scene& scene, Scene other, ObjectId above) {
    const bool first = scene.objects.empty(), moved = !scene.mechanics.bodies.empty(),
               moves = !other.mechanics.bodies.empty();
    if (first) {
        scene.proxyRadius = other.proxyRadius;
        scene.reach = other.reach;
        forgetKept(scene); // of cameras that were there already
        scene.kept = other.kept;
        for (const SavedCamera& camera : other.cameras)
            if (!findCamera(scene, camera.name)) putCamera(scene, camera);
    } else
        forgetKept(other);
    if (!scene.finger) scene.finger = other.finger;
    if (!moved) {
        Mechanics settings = other.mechanics;
        settings.bodies.clear(), settings.joints.clear(), settings.colliders.clear();
        scene.mechanics = std::move(settings);
    }
    if (moves && !moved) standInTheWay(scene, allOf(scene).objects);
    const std::vector<ObjectId> added = addCopies(scene, other, allOf(other), above);
    if (moved && !moves) standInTheWay(scene, added);
    return added;
}

Removed removeObjects(Scene& scene, std::span<const ObjectId> objects) {
    const auto hanging = [&] {
        std::map<BodyId, std::size_t> joints;
        for (const RigidBody& body : scene.mechanics.bodies)
            joints[body.id] = jointsOf(scene, body.id);
        return joints;
    };
    const auto before = hanging();
    const std::size_t joints = scene.mechanics.joints.size(), count = scene.objects.size();
    for (const ObjectId id : objects) {
        removeMechanics(scene, id);
        std::erase_if(scene.objects, [id](const SceneObject& each) { return each.id == id; });
    }
    Removed removed{count - scene.objects.size(), joints - scene.mechanics.joints.size(), {}};
    for (const auto& [body, held] : hanging())
        if (held == 0 && before.at(body) > 0) removed.loose.push_back(findBody(scene, body)->name);
    return removed;
}

} // namespace tactum
