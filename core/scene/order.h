// The order of the objects of a scene, and where they are next to each other: brought elsewhere in the list,
// aligned, and spread out. Functions on values; the window puts each into one step of its history. Thread:
// any but real time.
#pragma once

#include <span>
#include <vector>

#include "core/scene/arrange.h"

namespace tactum {

/// Brings objects before another one of the list, or to its end for an id that the scene has not; among
/// themselves they keep their order. Before one of themselves they come to where that one is.
void reorder(Scene& scene, std::span<const ObjectId> objects, ObjectId before);
/// Brings them together before the one that is above the first of them, or behind the one below the last. A
/// group that none of them is in is passed as a whole, and they leave theirs only together with all of it: at
/// its edge a part of one stays.
void moveUp(Scene& scene, std::span<const ObjectId> objects);
void moveDown(Scene& scene, std::span<const ObjectId> objects);

/// Which side of a box along an axis, its middle among them.
enum class BoxSide { Low, Middle, High };

/// Moves what goes along, each along one axis of the world (0, 1, 2), until the side of its box is where that
/// of `to` is. m, at the time 0.
void align(Scene& scene, std::span<const GoingAlong> parts, const Bounds& to, int axis, BoxSide side);
/// Moves them along one axis until the middles of their boxes are as far from each other, in the order in
/// which they are; the outer two stay. Two and less stay.
void distribute(Scene& scene, std::span<const GoingAlong> parts, int axis);

} // namespace tactum
