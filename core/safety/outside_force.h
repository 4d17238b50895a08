// A force that somebody outside adds to what the finger feels: within bounds, and not for longer than it is
// asked for.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

/// Who asked for it is silent for so long, then it fades as long again. Unit: s.
inline constexpr double kOutsidePatience = 0.1;
/// It changes by no more than this part of the device's limit in a tick: a step of it is a push and not a
/// knock.
inline constexpr double kOutsideStep = 0.02;
/// What it may give a hand that moves along with it. Unit: W.
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

/// What is added in this tick: `wanted`, N, in the direction of `last`'s tick by a step at most, and less
/// where the finger already moves with it. `limit`: of the device, N. One frame throughout. Thread: real
/// time.
inline Vec3 outsideForce(const Vec3& last, const Vec3& wanted, const Vec3& velocity, double limit) noexcept {
    if (!wanted.allFinite() || !velocity.allFinite()) return Vec3::Zero();
    const double power = wanted.dot(velocity), size = wanted.norm();
    double share = size > limit ? limit / size : 1;
    if (power > 0) share = std::min(share, kOutsidePower / power);
    const Vec3 way = share * wanted - last;
    const double step = kOutsideStep * limit, length = way.norm();
    return length > step ? Vec3(last + step / length * way) : Vec3(share * wanted);
}

} // namespace tactum
