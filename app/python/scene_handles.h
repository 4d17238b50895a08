// What Python holds of a scene: the scene itself, and names of its objects, surfaces and layers. Nothing is
// copied out: whoever changes a surface changes the scene. All of it is used with the GIL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/python/property.h"
#include "core/haptics/world.h"
#include "core/scene/scene.h"

namespace tactum::python {

/// A scene with where it came from.
struct OpenScene {
    Scene scene;
    std::vector<std::string> findings;
    std::filesystem::path source;      ///< empty: made by hand
    std::shared_ptr<const World> last; ///< compiled last: the next one shares its geometry

    Scene& get() { return scene; }
};
using SceneHold = std::shared_ptr<OpenScene>;

struct ObjectHandle {
    SceneHold of;
    ObjectId id = 0;

    /// Failure where it is not in the scene any more; likewise below.
    SceneObject& get() const;
};

struct SurfaceHandle {
    ObjectHandle object;
    Index index = 0;

    Surface& get() const;
};

struct LayerHandle {
    SurfaceHandle surface;
    std::size_t index = 0;

    TextureLayer& get() const;
};

/// Of one object, or of all.
std::vector<SurfaceHandle> surfacesOf(const ObjectHandle& object);
std::vector<SurfaceHandle> surfacesOf(const SceneHold& scene);
std::vector<LayerHandle> layersOf(const SurfaceHandle& surface);

const Properties<Surface>& surfaceProperties();
const Properties<TextureLayer>& layerProperties();
const Properties<SceneObject>& objectProperties();
const Properties<Scene>& sceneProperties();

// The parts of the module.
void bindParameters(py::module_& module);
void bindLayer(py::module_& module);
void bindSurface(py::module_& module);
void bindObject(py::module_& module);
void bindPreset(py::module_& module);
void bindScene(py::module_& module);
void bindWorld(py::module_& module);
void bindRecording(py::module_& module);

} // namespace tactum::python
