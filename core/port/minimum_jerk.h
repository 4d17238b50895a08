// How a person's hand goes from one place to another: with the least jerk.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// From any motion to rest at a place in a given time, with the least jerk on the way (Flash and Hogan 1985):
/// a polynomial of the fifth degree. From rest the speed is 1.875 times the mean one at most, halfway; a new
/// course that begins where another one is goes on without a jump of place, speed or acceleration. SI.
/// Thread: real time.
class MinimumJerk {
public:
    struct State {
        Vec3 position = Vec3::Zero();
        Vec3 velocity = Vec3::Zero();
        Vec3 acceleration = Vec3::Zero();
    };
    static constexpr double kPeakSpeed = 1.875; ///< of the mean speed

    MinimumJerk() = default;
    /// At rest at `to` after `seconds`; at once when they are none.
    MinimumJerk(const State& from, const Vec3& to, double seconds) noexcept;

    /// `seconds` since it began; after its end it rests.
    State at(double seconds) const noexcept;

private:
    State from_;
    Vec3 to_ = Vec3::Zero();
    double duration_ = 0;
};

} // namespace tactum
