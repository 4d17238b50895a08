// Where the device's workspace lies in the scene, at one moment.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

/// World axis by world axis, which of the device's axes it is: 1, 2 or 3, negative where it runs the other
/// way.
using AxisMap = std::array<std::int8_t, 3>;
inline constexpr AxisMap kSameAxes{1, 2, 3};

/// p_W = offset + scale * turned(p_D). Forces keep their size: a spring of K N/m in the scene is one of
/// K * scale in the hand. Thread: any, real time too.
struct DeviceFrame {
    double scale = 1;           ///< metres of the scene to a metre of the device
    AxisMap axes = kSameAxes;   ///< a permutation
    Vec3 offset = Vec3::Zero(); ///< of the device's centre in the scene, m

    /// A direction or a force.
    Vec3 turned(const Vec3& v_D) const noexcept {
        Vec3 v_W;
        for (int i = 0; i < 3; ++i)
            v_W[i] =
                axes[std::size_t(i)] > 0 ? v_D[axes[std::size_t(i)] - 1] : -v_D[-axes[std::size_t(i)] - 1];
        return v_W;
    }
    Vec3 turnedBack(const Vec3& v_W) const noexcept {
        Vec3 v_D;
        for (int i = 0; i < 3; ++i) {
            const int axis = axes[std::size_t(i)];
            v_D[(axis > 0 ? axis : -axis) - 1] = axis > 0 ? v_W[i] : -v_W[i];
        }
        return v_D;
    }
    Vec3 pointInWorld(const Vec3& p_D) const noexcept { return offset + scale * turned(p_D); }
    Vec3 pointInDevice(const Vec3& p_W) const noexcept { return turnedBack(p_W - offset) / scale; }
    /// A way or a velocity.
    Vec3 wayInWorld(const Vec3& v_D) const noexcept { return scale * turned(v_D); }
    Vec3 wayInDevice(const Vec3& v_W) const noexcept { return turnedBack(v_W) / scale; }

    bool operator==(const DeviceFrame&) const = default;
};

} // namespace tactum
