#include "ui/engine/axis_capture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tactum {

namespace {
constexpr double kClear = 2; // times as far as along any other axis that is left
}

bool AxisCapture::add(const Vec3& handle) {
    if (complete() || !handle.allFinite()) return false;
    if (!started_) {
        start_ = handle;
        started_ = true;
    }
    const Vec3 way = handle - start_;
    int most = -1;
    double farthest = 0, second = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double far = std::abs(way[axis]);
        if (taken(axis)) continue;
        if (most < 0 || far > farthest) {
            second = farthest;
            farthest = far;
            most = axis;
        } else {
            second = std::max(second, far);
        }
    }
    progress_ = std::clamp(farthest / reach_, 0.0, 1.0);
    if (farthest < reach_ || farthest < kClear * second) return false;
    axes_[step_++] = std::int8_t(way[most] > 0 ? most + 1 : -(most + 1));
    started_ = false;
    progress_ = 0;
    return true;
}

bool AxisCapture::taken(int axis) const {
    for (std::size_t i = 0; i < step_; ++i)
        if (std::abs(axes_[i]) == axis + 1) return true;
    return false;
}

} // namespace tactum
