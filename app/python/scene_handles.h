// What Python holds of a scene: the scene itself, and names of its objects, bodies and so on. Nothing is
// copied out: whoever changes a surface changes the scene. All of it is used with the GIL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/python/property.h"
#include "core/haptics/world.h"
#include "core/scene/bodies.h"
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
    /// Of its mesh.
    std::size_t vertices() const;
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
    std::size_t vertices() const { return surface.object.vertices(); }
};

/// The mask of a layer.
struct MaskHandle {
    LayerHandle layer;

    TexturePattern& get() const;
};

struct BodyHandle {
    SceneHold of;
    BodyId id = kWorldBody;

    RigidBody& get() const;
};

/// One of those that hold a body.
struct JointHandle {
    BodyHandle body;
    std::size_t index = 0;

    /// Failure where it is gone, or leaves more free than one axis.
    AxisJoint get() const;
    void put(const AxisJoint& joint) const;
    /// Failure where it is gone.
    void expectThere() const;
};

/// Of one object, or of all.
std::vector<SurfaceHandle> surfacesOf(const ObjectHandle& object);
std::vector<SurfaceHandle> surfacesOf(const SceneHold& scene);
std::vector<LayerHandle> layersOf(const SurfaceHandle& surface);
std::vector<BodyHandle> bodiesOf(const SceneHold& scene);
std::vector<JointHandle> jointsOf(const BodyHandle& body);

const Properties<Surface>& surfaceProperties();
const Properties<TexturePattern>& patternProperties();
const Properties<TextureLayer>& layerProperties();
const Properties<RigidBody>& bodyProperties();
const Properties<AxisJoint>& jointProperties();
const Properties<SceneObject>& objectProperties();
const Properties<Scene>& sceneProperties();

// The parts of the module.
void bindParameters(py::module_& module);
void bindMask(py::module_& module);
void bindLayer(py::module_& module);
void bindSurface(py::module_& module);
void bindJoint(py::module_& module);
void bindBody(py::module_& module);
void bindObject(py::module_& module);
void bindPreset(py::module_& module);
void bindScene(py::module_& module);
void bindWorld(py::module_& module);
void bindRecording(py::module_& module);

} // namespace tactum::python
