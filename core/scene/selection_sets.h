// Selection sets: triangles of a scene that are kept under a name, to be selected again. Functions on values;
// the window puts each into one step of its history. Thread: any but real time.
//
// A set is what all objects have under one name (SceneObject::sets): it goes, is doubled and is written with
// its objects, and sets of one name that come together are one. It is of triangles, which stay what they are
// when surfaces are split and merged.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Triangles of several objects; none of them is empty.
using SceneTriangles = std::map<ObjectId, TriangleSet>;

/// Of one object, whatever a file says.
inline constexpr std::size_t kMaxSets = 256;
/// Of all sets of an object together: some lines of a file can name the same long list ever again.
constexpr std::size_t mostRanges(std::size_t triangles) {
    return 16 * kMaxSets + 8 * triangles;
}

/// Rising by names that are not empty, each once, with triangles, all of a mesh that has so many; not more
/// than the bounds above.
bool areSetsOf(const std::vector<NamedTriangles>& sets, std::size_t triangles);

/// Each once, rising.
std::vector<std::string> setNames(const Scene& scene);
/// Empty for a name that no set has.
SceneTriangles trianglesOfSet(const Scene& scene, const std::string& name);
/// Makes these the triangles of the set, wherever it was before; no triangles remove it.
void putSet(Scene& scene, const std::string& name, const SceneTriangles& triangles);
/// Both together.
void addToSet(Scene& scene, const std::string& name, const SceneTriangles& triangles);
inline void removeSet(Scene& scene, const std::string& name) {
    putSet(scene, name, {});
}
/// A set of the new name becomes one with it.
void renameSet(Scene& scene, const std::string& from, const std::string& to);

/// The sets of `from`, another form of the object's mesh, for the object: see carriedRanges().
void carrySets(const TriangleSoup& from, SceneObject& object);

/// Gives a scene the sets of another one, for objects of the same number and mesh: a state of the scene that
/// is shown again is how it feels, and not which selections were kept then.
void keepSets(const Scene& of, Scene& scene);

} // namespace tactum
