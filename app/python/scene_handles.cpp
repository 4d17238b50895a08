#include "app/python/scene_handles.h"

namespace tactum::python {

SceneObject& ObjectHandle::get() const {
    if (SceneObject* object = of->scene.find(id)) return *object;
    throw Failure("object " + std::to_string(id) + " is not in the scene any more");
}

std::size_t ObjectHandle::vertices() const {
    const auto& mesh = get().geometry;
    return mesh ? mesh->positions.size() : 0;
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

TexturePattern& MaskHandle::get() const {
    if (auto& mask = layer.get().mask) return *mask;
    throw Failure("the layer has no mask any more");
}

RigidBody& BodyHandle::get() const {
    if (RigidBody* body = findBody(of->scene, id)) return *body;
    throw Failure("body " + std::to_string(id) + " is not in the scene any more");
}

void JointHandle::expectThere() const {
    body.get();
    if (index >= tactum::jointsOf(body.of->scene, body.id))
        throw Failure("joint " + std::to_string(index) + " is not on its body any more");
}

AxisJoint JointHandle::get() const {
    expectThere();
    if (const auto joint = axisJointOf(body.of->scene, body.id, index)) return *joint;
    throw Failure("joint " + std::to_string(index) +
                  " is neither hinge, slider nor path; remove it and add another one to change it");
}

void JointHandle::put(const AxisJoint& joint) const {
    setAxisJoint(body.of->scene, body.id, joint, index);
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

std::vector<BodyHandle> bodiesOf(const SceneHold& scene) {
    std::vector<BodyHandle> all;
    for (const RigidBody& body : scene->scene.mechanics.bodies)
        all.push_back({scene, body.id});
    return all;
}

std::vector<JointHandle> jointsOf(const BodyHandle& body) {
    body.get(); // is there
    std::vector<JointHandle> all;
    for (std::size_t i = 0; i < tactum::jointsOf(body.of->scene, body.id); ++i)
        all.push_back({body, i});
    return all;
}

} // namespace tactum::python
