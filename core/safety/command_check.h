// The last judge: whether the command may differ from that of the tick before as it does.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// A command that grows, turns or reverses by more than this part of the device's limit in one tick, beyond
/// what the finger itself explains, is a fault; only what it pushes less counts for nothing.
inline constexpr double kForceJump = 0.6;

/// What explains a change of the command. SI, one frame throughout.
struct Explanation {
    double stiffness = 0; ///< N/m
    double way = 0;       ///< m, of the finger since the last tick
    double damping = 0;   ///< N s/m, of a surface that is hit in this tick
    double speed = 0;     ///< m/s, with which it is hit
};

/// N, of the change that nothing explains; 0 or less: all of it is explained. `expected`: what the last
/// tick's surroundings and additions would push this very finger with. A step is judged whole, in N and not
/// in N/s: an anchor that jumps does so within one tick, however long that is. A reversal counts at most
/// twice what pushes now. Both after everything that is added, and as the device's limit cuts them. Thread:
/// real time.
double suddenChange(const Vec3& command, const Vec3& expected, const Explanation& by) noexcept;

} // namespace tactum
