// Finds out from a person's motions which axis of the device goes where.
#pragma once

#include <cstddef>

#include "core/port/device_frame.h"

namespace tactum {

/// Three motions of the handle, along the world's x, y and z: to the right, up, and toward the person. The
/// axis along which the handle went farthest, and clearly so, is the one that is meant; one that has been
/// taken is not taken again. Frame D, m.
class AxisCapture {
public:
    /// `reach`: a motion that counts is at least so long.
    explicit AxisCapture(double reach) : reach_(reach) {}

    /// Where the handle is; the first place of a motion is where it starts. True when a motion was
    /// understood.
    bool add(const Vec3& handle);
    /// Of the world's axis that is asked for: 0 to 2, 3 when all are known.
    std::size_t step() const { return step_; }
    bool complete() const { return step_ == 3; }
    /// Once complete.
    const AxisMap& axes() const { return axes_; }
    /// How much of the motion is done, 0 to 1.
    double progress() const { return progress_; }

private:
    bool taken(int axis) const;

    double reach_;
    std::size_t step_ = 0;
    AxisMap axes_{};
    Vec3 start_ = Vec3::Zero();
    bool started_ = false;
    double progress_ = 0;
};

} // namespace tactum
