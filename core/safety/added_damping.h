// The force of all damping that the servo adds to a surface: bounded, without steps, and never sideways.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// Added damping is never more than this part of the device's limit.
inline constexpr double kMaxAddedForce = 0.3;
/// It changes by no more than this part of the limit in a second: 2 % in a tick of 1 kHz. Unit: 1/s.
inline constexpr double kAddedRate = 20;

/// Acts along the push alone, so that a frictionless wall stays frictionless, and only where it takes energy:
/// it goes on for some ticks where a surface that made energy is left, which would be a step else. An encoder
/// that flips between two readings asks for the whole of it in one tick and for the opposite in the next, and
/// gets next to nothing. SI, one frame throughout. Source: docs/stability.md, "What leaves is what is
/// judged". Thread: real time.
class AddedDamping {
public:
    /// N, on the finger, in addition to `push`. `brake`: N, all that is asked for, in any direction;
    /// `sliding`: m/s, of the finger relative to the surface; `limit`: N, of the device.
    Vec3 operator()(const Vec3& push, const Vec3& brake, const Vec3& sliding, double limit,
                    double dt) noexcept;
    /// Nothing is rendered.
    void rest() noexcept { added_ = 0, out_.setZero(); }
    Vec3 force() const noexcept { return added_ * out_; } ///< N, of the last tick
    double added() const noexcept {
        return added_;
    } ///< N, along the push: above 0 against a finger that goes in

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) { visit(self.added_, self.out_); }

private:
    double added_ = 0;
    Vec3 out_ = Vec3::Zero(); ///< the direction of the last push
};

} // namespace tactum
