// What people do with a haptic device, drawn at random: strokes of every kind, taps, holds.
#pragma once

#include "tests/physics/closed_loop.h"

namespace tactum::test {

/// Leads the goal of the arm's spring over the surface z = `height`.
class HandScript {
public:
    /// Taps are no faster than `fastest`, m/s.
    HandScript(std::uint64_t seed, double height, double fastest = 2)
        : random_(seed), height_(height), fastest_(fastest) {}

    /// Where the hand wants to be now; `dt` s after the last call.
    Vec3 goal(double dt);

private:
    enum class Kind { Line, Circle, Tap, Hold };
    void begin();

    Rng random_;
    double height_, fastest_;
    Kind kind_ = Kind::Hold;
    Vec3 from_ = Vec3::Zero(), at_ = Vec3::Zero();
    Vec3 way_ = Vec3::Zero(); ///< of a line, m
    double depth_ = 0;        ///< m below the surface
    double size_ = 0;         ///< m, of a circle or a tap
    double hertz_ = 1;
    double time_ = 0, length_ = 0; ///< s
};

} // namespace tactum::test
