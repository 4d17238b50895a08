// Where there is room for what comes into a scene, and what things stand on. By the boxes of objects in the
// world frame, at the time 0, y up, in metres; hidden objects do not count. Thread: any but real time.
#pragma once

#include <span>

#include "core/scene/arrange.h"

namespace tactum {

/// The box of these objects.
Bounds boundsOf(const Scene& scene, std::span<const ObjectId> objects);

/// The way of a box that comes from elsewhere to a free place of the scene, as near to its middle as there is
/// one: on the floor, which is a flat object beneath all others, else beside everything with its lower side
/// as low as all that is there. Into an empty scene it comes to stand on the origin.
Vec3 wayToRoom(const Scene& scene, const Bounds& box);

/// The way of a box that is in the scene to the nearest free place at its height, along x or along z.
Vec3 wayBeside(const Scene& scene, const Bounds& box);

/// How far up these must move to stand on the box beneath them, or on the floor; beneath the floor, > 0, else
/// < 0. Where nothing is beneath them, as low as the lowest of the others, or on the plane y = 0 where there
/// are none.
double wayToGround(const Scene& scene, const GoingAlong& along);

} // namespace tactum
