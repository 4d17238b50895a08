// A force that somebody outside adds to what the finger feels: within bounds, and not for longer than it is
// asked for.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

/// Who asked for it is silent for so long, then it fades as long again. Unit: s.
inline constexpr double kOutsidePatience = 0.1;
/// It grows and turns by no more than this part of the device's limit in a second, as added damping does: a
/// push and not a knock. Unit: 1/s.
inline constexpr double kOutsideRate = 20;
/// What it may give a hand that moves along with it: 0.5 N at a slow stroke of 0.1 m/s. Beyond it is taken
/// away at once, which is no knock either. Unit: W.
inline constexpr double kOutsidePower = 0.05;

/// What is asked for, and when it was. World frame, N; ns of monotonicNanoseconds().
struct OutsidePush {
    Vec3 force = Vec3::Zero();
    std::int64_t at = 0; ///< 0: never
};

/// What is left of it at a moment. Thread: real time.
inline Vec3 wantedOf(const OutsidePush& push, std::int64_t now) noexcept {
    if (push.at == 0 || !push.force.allFinite()) return Vec3::Zero();
    const double age = 1e-9 * double(now - push.at);
    return std::clamp((2 * kOutsidePatience - age) / kOutsidePatience, 0.0, 1.0) * push.force;
}

/// What is added in this tick of `dt` s: from `last`, N, towards `wanted`, and less where the finger moves
/// with it. `limit`: of the device, N. One frame throughout. Thread: real time.
inline Vec3 outsideForce(const Vec3& last, const Vec3& wanted, const Vec3& velocity, double limit,
                         double dt) noexcept {
    if (!wanted.allFinite() || !velocity.allFinite()) return Vec3::Zero();
    const Vec3 way = (wanted.norm() > limit ? Vec3(limit / wanted.norm() * wanted) : wanted) - last;
    const double step = kOutsideRate * limit * dt, length = way.norm();
    const Vec3 force = length > step ? Vec3(last + step / length * way) : Vec3(last + way);
    const double power = force.dot(velocity);
    return power > kOutsidePower ? Vec3(kOutsidePower / power * force) : force;
}

} // namespace tactum
