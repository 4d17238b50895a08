// Scenes put together of several, and parts of them doubled or taken out. Functions on values; the window
// puts each into one step of its history. Thread: any but real time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/scene/arrange.h"
#include "core/scene/scene.h"

namespace tactum {

/// Everything that a scene has.
GoingAlong allOf(const Scene& scene);

/// `wanted`, or "cup 2" where an object is called "cup" already; case alone is no difference.
std::string freeName(const Scene& scene, const std::string& wanted);

/// Puts copies of these parts of `from` behind what `scene` has, which may be a copy of it: geometry and
/// images are shared. Objects get free names and ids larger than `above` and than any that is there; they
/// are given back in their order. A whole group becomes another one with a free name; of a part of one in
/// `scene` the copies are in it, too. Joints hold the copies of what they hold; what stays behind in the same
/// scene holds its copies as well.
std::vector<ObjectId> addCopies(Scene& scene, const Scene& from, const GoingAlong& what, ObjectId above = 0);

/// All of another scene, beside what is there. As soon as something moves by forces, bodies can lie on what
/// stands still. An empty scene becomes the other one; one with objects keeps its proxy radius, its finger
/// and, where it has bodies, its gravity, air and scales, and leaves out the other one's cameras, and what
/// other programs had put into its file.
std::vector<ObjectId> addScene(Scene& scene, Scene other, ObjectId above = 0);

/// What went with objects that were removed.
struct Removed {
    std::size_t objects = 0, joints = 0;
    std::vector<std::string> loose; ///< bodies that hung on them, and hang on nothing now
};
/// Takes objects out, with what bodies meet of them, the bodies that move nothing else, and their joints.
Removed removeObjects(Scene& scene, std::span<const ObjectId> objects);

} // namespace tactum
