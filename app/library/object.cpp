#include <algorithm>

#include <tactum/scene.h>

#include "app/library/parts.h"
#include "core/base/text.h"
#include "core/geometry/soup_builder.h"
#include "core/scene/arrange.h"

namespace tactum::library {
namespace {

core::Pose placeFrom(const Pose& pose) {
    const core::Vec3 at = inward(pose.position);
    if (!std::ranges::all_of(at, isCoordinate))
        refuse("position: is farther than 1e6 m from the origin, or not finite");
    const Quat turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    if (!(turn.norm() > 1e-6 && turn.norm() < 1e6)) refuse("rotation: has no length that says a turn");
    return {unitLength(turn), at};
}

} // namespace

Object::Object(std::shared_ptr<SceneState> scene, std::uint32_t id) : scene_(std::move(scene)), id_(id) {}

std::string Object::name() const {
    return Parts::get(*this).name;
}

Pose Object::pose() const {
    const core::Pose& pose = Parts::get(*this).pose;
    const Quat& turn = pose.rotation;
    return {outward(pose.translation), {turn.w(), turn.x(), turn.y(), turn.z()}};
}

void Object::setPose(const Pose& pose) {
    Parts::get(*this); // is there
    placeObject(scene_->scene, id_, placeFrom(pose));
}

void Object::setVisible(bool visible) {
    Parts::get(*this).visible = visible;
}

std::vector<Vec3> Object::vertices() const {
    std::vector<Vec3> all;
    if (const auto& mesh = Parts::get(*this).geometry)
        for (const core::Vec3& vertex : mesh->positions)
            all.push_back(outward(vertex));
    return all;
}

std::vector<Triangle> Object::triangles() const {
    std::vector<Triangle> all;
    if (const auto& mesh = Parts::get(*this).geometry)
        for (const auto& corners : mesh->triangles)
            all.push_back({corners[0], corners[1], corners[2]});
    return all;
}

std::vector<Surface> Object::surfaces() const {
    std::vector<Surface> all;
    for (std::size_t i = 0; i < Parts::get(*this).surfaces.size(); ++i)
        all.push_back(Parts::surface(*this, i));
    return all;
}

Surface Object::surface(std::string_view name) const {
    for (const Surface& one : surfaces())
        if (one.name() == name) return one;
    refuse(inQuotes(this->name()) + " has no surface " + inQuotes(name));
}

void Object::set(std::string_view key, double value) {
    for (Surface& surface : surfaces())
        surface.set(key, value);
}

void Object::apply(const Preset& preset) {
    for (Surface& surface : surfaces())
        surface.apply(preset);
}

} // namespace tactum::library
