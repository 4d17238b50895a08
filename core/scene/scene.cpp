#include "core/scene/scene.h"

#include "core/scene/placing.h"

#include <algorithm>

#include "core/motion/motion_build.h"
#include "core/scene/object_bounds.h"

namespace tactum {

// Ids are given in rising order, so that an object is at its number or, where others are gone, before it.
SceneObject* Scene::find(ObjectId id) {
    for (std::size_t i = std::min<std::size_t>(id, objects.size()); i > 0 && objects[i - 1].id >= id; --i)
        if (objects[i - 1].id == id) return &objects[i - 1];
    auto it =
        std::find_if(objects.begin(), objects.end(), [&](const auto& object) { return object.id == id; });
    return it == objects.end() ? nullptr : &*it;
}

const SceneObject* Scene::find(ObjectId id) const {
    return const_cast<Scene*>(this)->find(id);
}

SceneObject& Scene::add(SceneObject object) {
    object.id = 1;
    for (const auto& other : objects)
        object.id = std::max(object.id, other.id + 1);
    return objects.emplace_back(std::move(object));
}

Bounds boundsOf(const SceneObject& object) {
    const Mat3 rotation = object.pose.rotation.toRotationMatrix(); // three times as fast as the quaternion
    Bounds box;
    for (const auto& triangle : object.geometry->triangles)
        for (Index corner : triangle)
            box.add(rotation * object.geometry->positions[corner] + object.pose.translation);
    return box;
}

Bounds boundsOf(const Scene& scene) {
    Bounds box;
    for (const SceneObject& object : scene.objects) {
        const Bounds part = boundsOf(object);
        if (part.empty()) continue;
        box.add(part.low);
        box.add(part.high);
    }
    return box;
}

std::size_t triangleCount(const Scene& scene) {
    std::size_t count = 0;
    for (const auto& object : scene.objects)
        count += object.geometry->triangles.size();
    return count;
}

void fitDiagonal(Scene& scene, double diagonal) {
    const Bounds box = boundsOf(scene);
    if (!(box.diagonal() > 0)) return;
    scaleScene(scene, diagonal / box.diagonal(), box.centre());
}

} // namespace tactum
