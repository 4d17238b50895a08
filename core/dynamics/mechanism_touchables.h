// What of the bodies of a mechanism touches, and which two of them may. For this folder.
#pragma once

#include <span>

#include "core/base/result.h"
#include "core/dynamics/mechanism.h"

namespace tactum {

/// Once all bodies have their places. Error: too many of them. Thread: any but real time.
Result<void> addTouchables(Mechanism& made, std::span<const Joint> joints,
                           std::span<const Collider> colliders);

} // namespace tactum
