// As what the objects of a scene meet each other: told, and changed. Thread: any but real time.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/scene/scene.h"

namespace tactum {

enum class ColliderForm : std::uint8_t { Parts, Hull, Box, Sphere, Capsule, Cylinder };

struct ColliderFormName {
    ColliderForm form;
    std::string_view label, sentence;
};
extern const std::array<ColliderFormName, 6> kColliderForms;

/// The shape of a form that has all points inside, in the frame of `pose`, which it sets. What is round lies
/// along the axis that makes it least. Of Parts the hull.
ColliderShape shapeAround(std::span<const Vec3> points, ColliderForm form, Pose& pose);

/// Of an object, or of the body that it belongs to; nothing where nothing meets it, or what does is of
/// another form, or of several.
std::optional<ColliderForm> colliderFormOf(const Scene& scene, ObjectId object);
/// In place of what meets it now: the same materials and filters, around all meshes of its body. Masses stay.
/// An object that still nothing meets gets one if there are bodies.
void setColliderForm(Scene& scene, ObjectId object, ColliderForm form);

} // namespace tactum
