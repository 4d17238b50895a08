#include "core/scene/selection_sets.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

namespace tactum {

namespace {

/// Where the set of this name is, or would be.
auto placeOf(auto& sets, const std::string& name) {
    return std::ranges::lower_bound(sets, name, {}, &NamedTriangles::name);
}

auto findSet(auto& sets, const std::string& name) {
    const auto place = placeOf(sets, name);
    return place != sets.end() && place->name == name ? place : sets.end();
}

void put(std::vector<NamedTriangles>& sets, const std::string& name, TriangleRanges triangles) {
    const auto found = findSet(sets, name);
    if (triangles.empty()) {
        if (found != sets.end()) sets.erase(found);
    } else if (found != sets.end())
        found->triangles = std::move(triangles);
    else
        sets.insert(placeOf(sets, name), {name, std::move(triangles)});
}

} // namespace

bool areSetsOf(const std::vector<NamedTriangles>& sets, std::size_t triangles) {
    const auto isRight = [&](const NamedTriangles& each) {
        return !each.name.empty() && !each.triangles.empty() && areTriangleRanges(each.triangles, triangles);
    };
    std::size_t ranges = 0;
    for (const NamedTriangles& each : sets)
        ranges += each.triangles.size();
    return sets.size() <= kMaxSets && ranges <= mostRanges(triangles) && std::ranges::all_of(sets, isRight) &&
           std::ranges::adjacent_find(sets, std::greater_equal{}, &NamedTriangles::name) == sets.end();
}

std::vector<std::string> setNames(const Scene& scene) {
    std::set<std::string> names;
    for (const SceneObject& object : scene.objects)
        for (const NamedTriangles& each : object.sets)
            names.insert(each.name);
    return {names.begin(), names.end()};
}

SceneTriangles trianglesOfSet(const Scene& scene, const std::string& name) {
    SceneTriangles found;
    for (const SceneObject& object : scene.objects)
        if (const auto part = findSet(object.sets, name); part != object.sets.end())
            found[object.id] = trianglesOf(part->triangles);
    return found;
}

void putSet(Scene& scene, const std::string& name, const SceneTriangles& triangles) {
    for (SceneObject& object : scene.objects) {
        const auto part = triangles.find(object.id);
        put(object.sets, name, part == triangles.end() ? TriangleRanges() : rangesOf(part->second));
    }
}

void addToSet(Scene& scene, const std::string& name, const SceneTriangles& triangles) {
    SceneTriangles all = trianglesOfSet(scene, name);
    for (const auto& [id, more] : triangles) {
        TriangleSet both;
        std::ranges::set_union(all[id], more, std::back_inserter(both));
        all[id] = std::move(both);
    }
    putSet(scene, name, all);
}

void renameSet(Scene& scene, const std::string& from, const std::string& to) {
    if (from == to) return;
    const SceneTriangles triangles = trianglesOfSet(scene, from);
    removeSet(scene, from);
    addToSet(scene, to, triangles);
}

void carrySets(const TriangleSoup& from, SceneObject& object) {
    for (NamedTriangles& each : object.sets)
        each.triangles = carriedRanges(each.triangles, from, *object.geometry);
    std::erase_if(object.sets, [](const NamedTriangles& each) { return each.triangles.empty(); });
}

void keepSets(const Scene& of, Scene& scene) {
    for (SceneObject& object : scene.objects) {
        const auto same = std::ranges::find(of.objects, object.id, &SceneObject::id);
        if (same != of.objects.end() && *same->geometry == *object.geometry) object.sets = same->sets;
    }
}

} // namespace tactum
