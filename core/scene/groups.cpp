#include "core/scene/groups.h"

#include <algorithm>
#include <map>

#include "core/scene/numbered_names.h"

namespace tactum {

namespace {

/// With all others of their bodies.
std::set<ObjectId> withTheirBodies(const Scene& scene, std::span<const ObjectId> objects) {
    std::set<ObjectId> all(objects.begin(), objects.end());
    std::set<BodyId> bodies;
    for (const SceneObject& object : scene.objects)
        if (object.body != kWorldBody && all.contains(object.id)) bodies.insert(object.body);
    for (const SceneObject& object : scene.objects)
        if (bodies.contains(object.body)) all.insert(object.id);
    return all;
}

std::set<std::string> groupsOf(const Scene& scene, std::span<const ObjectId> objects) {
    const std::set<ObjectId> chosen(objects.begin(), objects.end());
    std::set<std::string> names;
    for (const SceneObject& object : scene.objects)
        if (!object.group.empty() && chosen.contains(object.id)) names.insert(object.group);
    return names;
}

} // namespace

std::vector<std::string> groupNames(const Scene& scene) {
    std::vector<std::string> names;
    std::set<std::string> known;
    for (const SceneObject& object : scene.objects)
        if (!object.group.empty() && known.insert(object.group).second) names.push_back(object.group);
    return names;
}

std::vector<ObjectId> objectsOfGroup(const Scene& scene, const std::string& name) {
    std::vector<ObjectId> objects;
    for (const SceneObject& object : scene.objects)
        if (!name.empty() && object.group == name) objects.push_back(object.id);
    return objects;
}

std::vector<ObjectId> withTheirGroups(const Scene& scene, std::span<const ObjectId> objects) {
    const std::set<ObjectId> chosen(objects.begin(), objects.end());
    const std::set<std::string> names = groupsOf(scene, objects);
    std::vector<ObjectId> all;
    for (const SceneObject& object : scene.objects)
        if (chosen.contains(object.id) || names.contains(object.group)) all.push_back(object.id);
    return all;
}

std::set<std::string> wholeGroups(const Scene& scene, std::span<const ObjectId> objects) {
    const std::set<ObjectId> chosen(objects.begin(), objects.end());
    std::set<std::string> names = groupsOf(scene, objects);
    for (const SceneObject& object : scene.objects)
        if (!chosen.contains(object.id)) names.erase(object.group);
    return names;
}

std::string freeGroupName(const Scene& scene, const std::string& wanted) {
    NumberedNames names;
    for (const SceneObject& object : scene.objects)
        names.reserve(object.group);
    return names.take(wanted);
}

void putInGroup(Scene& scene, std::span<const ObjectId> objects, const std::string& name) {
    const std::set<ObjectId> all = withTheirBodies(scene, objects);
    for (SceneObject& object : scene.objects)
        if (all.contains(object.id)) object.group = name;
}

std::string groupTogether(Scene& scene, std::span<const ObjectId> objects) {
    if (withTheirGroups(scene, objects).empty()) return {};
    std::string name = freeGroupName(scene, "Group 1");
    putInGroup(scene, objects, name);
    gatherGroups(scene);
    return name;
}

void ungroup(Scene& scene, std::span<const ObjectId> objects) {
    const std::set<std::string> names = groupsOf(scene, objects);
    for (SceneObject& object : scene.objects)
        if (names.contains(object.group)) object.group.clear();
}

void renameGroup(Scene& scene, const std::string& from, const std::string& to) {
    if (from.empty() || to.empty() || from == to) return;
    const std::vector<ObjectId> objects = objectsOfGroup(scene, from);
    putInGroup(scene, objects, {});
    putInGroup(scene, objects, freeGroupName(scene, to));
}

void gatherGroups(Scene& scene) {
    std::map<BodyId, std::string> ofBody;
    for (SceneObject& object : scene.objects)
        if (object.body != kWorldBody)
            object.group = ofBody.try_emplace(object.body, object.group).first->second;
    std::map<std::string, std::size_t> places;
    std::vector<std::pair<std::size_t, std::size_t>> order; // of whom each stands with, and its own place
    bool sorted = true;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const std::string& group = scene.objects[i].group;
        order.emplace_back(group.empty() ? i : places.try_emplace(group, i).first->second, i);
        sorted = sorted && (i == 0 || order[i - 1] < order[i]);
    }
    if (sorted) return;
    std::ranges::sort(order);
    std::vector<SceneObject> gathered;
    for (const auto& [with, own] : order)
        gathered.push_back(std::move(scene.objects[own]));
    scene.objects = std::move(gathered);
}

} // namespace tactum
