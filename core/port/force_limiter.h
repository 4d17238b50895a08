// The last act before the device: a force that is finite and never above the limit.
#pragma once

#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

struct ForceLimiter {
    double maxForce = 0;         ///< N, of the device; no scene, file or client can raise it
    std::uint64_t clamped = 0;   ///< forces that were shortened
    std::uint64_t notFinite = 0; ///< forces that were no numbers

    /// The same direction, at most maxForce; zero when any component is not finite. Counts both.
    /// Thread: real time.
    Vec3 operator()(const Vec3& force) noexcept;
};

} // namespace tactum
