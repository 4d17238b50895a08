// Where the person wants the simulated finger: written by the window, read by the simulated hand.
#pragma once

#include "core/base/vec.h"
#include "core/base/wait_free.h"

namespace tactum {

/// What the hand strives for. Frame D, metre.
struct HandGoal {
    Vec3 position = Vec3::Zero();
    bool teleport = false;      ///< jump there at rest instead of moving: used when a model is opened
    std::uint32_t sequence = 0; ///< raised with every teleport, so that each is carried out once; first 1
    bool held = false;          ///< the person has hold of it: the simulated hand's one button
    /// s, in which the hand is led there from wherever it is led to now, with the least jerk
    /// (minimum_jerk.h); 0: at once. Whoever leads may be late or far away: the way there is not his to draw.
    double time = 0;
};

/// Thread: one writer (ui), one reader (servo, real time); wait-free.
using HandTarget = TripleBuffer<HandGoal>;

} // namespace tactum
