// A finger that touches a scene by itself, for those that bring none.
#pragma once

#include <vector>

#include "core/haptics/world.h"
#include "core/scene/finger_path.h"

namespace tactum {

/// 1 kHz, four seconds: from above the middle of the scene down to what is first touched there, a little into
/// it, once around a circle of an eighth of the scene, and up again. Above a scene without anything below its
/// middle it only moves. Thread: any but real time.
std::vector<FingerPoint> sampleStroke(const World& world);

} // namespace tactum
