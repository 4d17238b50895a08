// Nearest points of straight pieces. For this folder. Thread: real time.
#pragma once

#include "core/base/vec.h"

namespace tactum {

struct PointPair {
    Vec3 a, b;
};
/// The nearest points of p1-q1 and p2-q2, each of which may be a point.
PointPair nearestPoints(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2) noexcept;

} // namespace tactum
