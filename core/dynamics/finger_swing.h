// How light a body may be for a finger's spring to push it: a mass on a spring swings, and a step follows so
// much of that.
#pragma once

namespace tactum {

/// Of a swing, in radians, this much is followed in one part of a step; so many parts at most; and in each of
/// them no more than this, or less of the spring is felt.
inline constexpr double kSwing = 0.5, kFastestSwing = 2;
inline constexpr int kSwingParts = 8;

/// kg: what is lighter where it is touched gets only a part of the push of a spring of `stiffness` (N/m) in
/// steps of `dt` (s). Thread: any, real time too.
constexpr double lightestPushed(double stiffness, double dt) noexcept {
    const double most = kFastestSwing * kSwingParts;
    return stiffness * dt * dt / (most * most);
}

} // namespace tactum
