// Finger paths that show what a sample is for.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/finger_path.h"

namespace tactum::samples {

/// The radius of every sample's proxy: a finger so far above a surface touches it. m
inline constexpr double kFingerRadius = 1e-3;

/// Where the finger is at a time, in the coordinates of its sample.
struct FingerKey {
    double t; ///< s
    Vec3 at;
};

/// A path as a scene holds it: 1 kHz, positions to a tenth of a micrometre, so that the last digit of a
/// formula does not change the file.
std::shared_ptr<const std::vector<FingerPoint>> fingerPath(double seconds,
                                                           const std::function<Vec3(double t)>& at);

/// From key to key, each time from rest to rest. `place`: to the world frame.
std::shared_ptr<const std::vector<FingerPoint>> fingerPath(std::span<const FingerKey> keys,
                                                           const std::function<Vec3(const Vec3&)>& place);

} // namespace tactum::samples
