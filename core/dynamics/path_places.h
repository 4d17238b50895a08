// Where the curve of a path goes, for who makes one or draws it.
#pragma once

#include <optional>
#include <vector>

#include "core/dynamics/path.h"

namespace tactum {

/// So many places and one more, evenly along it, in its own frame: x along it, y up. None where no curve goes
/// through its points. Thread: any but real time.
std::vector<Pose> placesAlong(const JointPath& path, int parts);
/// The one that is nearest to another place; nothing where no curve goes through its points. Thread: any but
/// real time.
std::optional<Pose> nearestOn(const JointPath& path, const Pose& to);

} // namespace tactum
