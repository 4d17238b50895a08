// A number over a surface together with its gradient: the product rule, written once.
#pragma once

#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

/// Value and gradient of a smooth function at one point of a surface. The gradient is per metre, in the body
/// frame. Thread: real time.
struct TextureField {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
};

inline TextureField operator+(const TextureField& a, const TextureField& b) noexcept {
    return {a.value + b.value, a.gradient + b.gradient};
}
inline TextureField operator-(const TextureField& a, const TextureField& b) noexcept {
    return {a.value - b.value, a.gradient - b.gradient};
}
inline TextureField operator*(const TextureField& a, const TextureField& b) noexcept {
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
}
inline TextureField operator*(double s, const TextureField& a) noexcept {
    return {s * a.value, s * a.gradient};
}
/// From a (weight 0) to b (weight 1).
inline TextureField mixed(const TextureField& a, const TextureField& b, const TextureField& weight) noexcept {
    return a + weight * (b - a);
}

/// A pattern in the flat, in repeats: where on it a point of the surface lies, and how that changes along the
/// surface.
struct FlatPoint {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();                               ///< repeats
    Eigen::Matrix<double, 2, 3> perMetre = Eigen::Matrix<double, 2, 3>::Zero(); ///< repeats/m, body frame
};

/// Beyond this many repeats the pattern ends: there is no precision left for a place in it.
inline constexpr double kMaxRepeats = 1e12;

/// x without its whole number, from 0 to 1; |x| at most kMaxRepeats. Thread: real time.
inline double repeatPart(double x) noexcept {
    const double part = x - double(std::int64_t(x));
    return part < 0 ? part + 1 : part;
}

/// Value of a pattern, from 0 to 1 (beside a hard edge of a picture up to a fifth beyond), and its derivative
/// by the place in repeats.
struct FlatSample {
    double value = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
};

} // namespace tactum
