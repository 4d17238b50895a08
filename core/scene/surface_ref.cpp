#include "core/scene/surface_ref.h"

#include <tuple>

namespace tactum {

std::vector<SurfaceRef> surfacesLike(const Scene& scene, SurfaceRef ref) {
    const SceneObject* object = scene.find(ref.object);
    if (!object || ref.surface >= object->surfaces.size()) return {};
    const auto feel = [](const Surface& s) { return std::tie(s.material, s.shading, s.layers, s.sides); };
    const Surface& model = object->surfaces[ref.surface];
    std::vector<SurfaceRef> result;
    for (const SceneObject& other : scene.objects)
        for (Index s = 0; s < other.surfaces.size(); ++s)
            if (feel(other.surfaces[s]) == feel(model)) result.push_back({other.id, s});
    return result;
}

} // namespace tactum
