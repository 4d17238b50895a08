// A model that was exported again: its objects come to where the author has put those of before.
#pragma once

#include <vector>

#include "core/scene/findings.h"
#include "core/scene/scene.h"

namespace tactum {

/// Objects of `onto`, the file of `was` once more, move, turn and grow as their partners in `was` have come
/// to be in `now`; those without a partner, the finger and bodies do as most of the others. A partner has the
/// same plainName(), the first the first where several have. It is found in `now` by its id, which the object
/// takes over; others get ids that are free. What was scaled other than as a whole, or got other triangles in
/// `now`, is said. Thread: any but real time.
std::vector<Finding> keepPlaces(const Scene& was, const Scene& now, Scene& onto);

/// Ids alone, by the names of `now`: objects stay where their file has them. For a file of another kind,
/// whose frame is not that of the one before.
void keepIds(const Scene& now, Scene& onto);

} // namespace tactum
