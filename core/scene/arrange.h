// Objects moved, turned and scaled by an author, with everything that goes along with them. Functions on
// values; the window puts each into one step of its history. Thread: any but real time.
#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Takes p_W to about + move + scale * turn * (p_W - about).
struct Arrangement {
    Vec3 about = Vec3::Zero(); ///< m, world frame: what stays when nothing moves
    Vec3 move = Vec3::Zero();  ///< m, world frame
    Quat turn = Quat::Identity();
    double scale = 1; ///< > 0

    bool changesNothing() const;
    Vec3 apply(const Vec3& p_W) const { return about + move + scale * (turn * (p_W - about)); }
    /// Of something that keeps its own size in its own frame.
    Pose apply(const Pose& pose) const { return {unitLength(turn * pose.rotation), apply(pose.translation)}; }
};

/// What is arranged together. All of it in the order of the scene, each once.
struct GoingAlong {
    std::vector<ObjectId> objects;
    std::vector<BodyId> bodies;
    std::vector<std::size_t> colliders; ///< of the still world, by their places in Mechanics
    std::vector<std::uint32_t> parts;   ///< of the still world: Collider::part

    bool has(ObjectId object) const;
};

/// These objects with what bodies meet of them, all others of the same bodies, and all that hangs on these by
/// joints.
GoingAlong goingAlong(const Scene& scene, std::span<const ObjectId> objects);

/// Arranges what goes along: places, meshes and motions by keys, the bodies where they begin with their
/// centres and moments, what others meet of them, and the joints that they hang on, whose axes stay where
/// they are on the body. A path stays where it is unless what it is fixed to goes along. Masses, springs and
/// textures stay.
void arrange(Scene& scene, const GoingAlong& along, const Arrangement& by);

/// Puts an object to where `pose` is, with all that goes along: moved and turned about its own origin. What
/// goes alone gets the very numbers. The object is in the scene; `pose` has unit length.
void placeObject(Scene& scene, ObjectId id, const Pose& pose);

/// What bodies meet of an object, by the places in Mechanics: the colliders of its body, or those of the
/// still world that stand for it, which lie in it or are most like it.
std::vector<std::size_t> collidersOf(const Scene& scene, const SceneObject& object);

} // namespace tactum
