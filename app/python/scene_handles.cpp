#include "app/python/scene_handles.h"

namespace tactum::python {

SceneObject& ObjectHandle::get() const {
    if (SceneObject* object = of->scene.find(id)) return *object;
    throw Failure("object " + std::to_string(id) + " is not in the scene any more");
}

Surface& SurfaceHandle::get() const {
    SceneObject& owner = object.get();
    if (index < owner.surfaces.size()) return owner.surfaces[index];
    throw Failure("surface " + std::to_string(index) + " is not on its object any more");
}

TextureLayer& LayerHandle::get() const {
    Surface& owner = surface.get();
    if (index < owner.layers.size()) return owner.layers[index];
    throw Failure("layer " + std::to_string(index) + " is not on its surface any more");
}

std::vector<SurfaceHandle> surfacesOf(const ObjectHandle& object) {
    std::vector<SurfaceHandle> all;
    for (Index i = 0; i < object.get().surfaces.size(); ++i)
        all.push_back({object, i});
    return all;
}

std::vector<SurfaceHandle> surfacesOf(const SceneHold& scene) {
    std::vector<SurfaceHandle> all;
    for (const SceneObject& object : scene->scene.objects)
        for (const SurfaceHandle& surface : surfacesOf(ObjectHandle{scene, object.id}))
            all.push_back(surface);
    return all;
}

std::vector<LayerHandle> layersOf(const SurfaceHandle& surface) {
    std::vector<LayerHandle> all;
    for (std::size_t i = 0; i < surface.get().layers.size(); ++i)
        all.push_back({surface, i});
    return all;
}

} // namespace tactum::python
