// Making a mechanism of what an author says.
#pragma once

#include <span>

#include "core/base/result.h"
#include "core/dynamics/mechanism.h"

namespace tactum {

/// Makes links of bodies and joints. A joint whose locked axes do not start within 1 mm or 1 mrad of where
/// they are locked, and one that closes a loop, is held by forces instead; one that joins a body to itself or
/// two that stand still does nothing. `airDensity`: kg/m^3, of what they move through. Errors: a value that
/// is not finite or not positive where it must be, a joint that names no body, a path that is no curve
/// (path_curve.h) or that would close a loop. Thread: any but real time.
Result<Mechanism> compileMechanism(std::span<const RigidBody> bodies, std::span<const Joint> joints,
                                   std::span<const Collider> colliders = {}, double airDensity = 0);

} // namespace tactum
