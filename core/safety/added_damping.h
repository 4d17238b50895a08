// The force of all damping that the servo adds to a surface: bounded, without steps, along the push.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// Added damping is never more than this part of the device's limit.
inline constexpr double kMaxAddedForce = 0.3;
/// It grows and turns by no more than this part of the limit in a second: 2 % in a tick of 1 kHz. What would
/// give energy goes 2.5 times as fast. Unit: 1/s.
inline constexpr double kAddedRate = 20;

/// Asked for along the push alone, so that a frictionless wall stays frictionless, and only where it takes
/// energy. Where a surface that made energy is left, or its push turns, what is there goes within some ticks:
/// at once it would be a step. An encoder that flips between two readings asks for the whole of it in one
/// tick and for the opposite in the next, and gets next to nothing. SI, one frame throughout. Source:
/// docs/stability.md, "What the added damping is". Thread: real time.
class AddedDamping {
public:
    /// N, on the finger, in addition to `push`. `brake`: N, all that is asked for, in any direction;
    /// `sliding`: m/s, of the finger relative to the surface; `limit`: N, of the device.
    Vec3 operator()(const Vec3& push, const Vec3& brake, const Vec3& sliding, double limit,
                    double dt) noexcept;
    /// Nothing is rendered.
    void rest() noexcept { force_.setZero(), out_.setZero(); }
    const Vec3& force() const noexcept { return force_; } ///< N, of the last tick
    /// N, along the last push: above 0 against a finger that goes in.
    double added() const noexcept { return force_.dot(out_); }

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) { visit(self.force_, self.out_); }

private:
    Vec3 force_ = Vec3::Zero();
    Vec3 out_ = Vec3::Zero(); ///< the direction of the last push
};

} // namespace tactum
