// Groups: objects that an author keeps together under a name. Functions on values; the window puts each into
// one step of its history. Thread: any but real time.
//
// A group is what all objects have under one name (SceneObject::group): it goes with the last of them, none
// is in two, and none holds itself. Objects of one body are in it together, and those of a group stand next
// to each other in the scene. Nothing that is felt depends on it.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Each once, in the order of the scene.
std::vector<std::string> groupNames(const Scene& scene);
/// In the order of the scene; empty for a name that no group has.
std::vector<ObjectId> objectsOfGroup(const Scene& scene, const std::string& name);
/// With all others of the groups that these objects are in, in the order of the scene.
std::vector<ObjectId> withTheirGroups(const Scene& scene, std::span<const ObjectId> objects);
/// Those of which all objects are among these.
std::set<std::string> wholeGroups(const Scene& scene, std::span<const ObjectId> objects);
/// `wanted`, or "lid 2" where a group is called "lid" already.
std::string freeGroupName(const Scene& scene, const std::string& wanted);

/// Puts objects, with the others of their bodies, into a group, whichever they were in; an empty name takes
/// them out of it. Where they come to stand is gatherGroups()' to say.
void putInGroup(Scene& scene, std::span<const ObjectId> objects, const std::string& name);
/// Into a new one, "Group 1", in the place of the first of them. Its name; empty where no object is known.
std::string groupTogether(Scene& scene, std::span<const ObjectId> objects);
/// Takes apart the groups that these objects are in; all that was in them stays where it is.
void ungroup(Scene& scene, std::span<const ObjectId> objects);
/// By a free name. Nothing for an empty one.
void renameGroup(Scene& scene, const std::string& from, const std::string& to);

/// Brings the objects of each group together, to the first of them, in their order; those of a body into the
/// group of the first of these.
void gatherGroups(Scene& scene);

} // namespace tactum
