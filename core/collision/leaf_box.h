// The box around some leaf spheres.
#pragma once

#include <cstddef>
#include <cstring>
#include <limits>

#include "core/collision/leaf_cover.h"

namespace tactum {

/// Axis-aligned, single precision, to choose by: not rounded outward. Of four numbers, which one instruction
/// takes, the last says nothing.
struct LeafBox {
    Eigen::Array4f low, high;

    /// The numbers are left as they are, for rooms of many boxes.
    LeafBox() = default;
    explicit LeafBox(const LeafSphere& sphere) {
        static_assert(offsetof(LeafSphere, radius) == sizeof(sphere.centre));
        Eigen::Array4f centre;
        std::memcpy(centre.data(), &sphere, sizeof centre); // one load: put together of three it costs ten
        low = centre - sphere.radius;
        high = centre + sphere.radius;
    }
    static LeafBox empty() {
        LeafBox box;
        box.low.setConstant(std::numeric_limits<float>::infinity());
        box.high = -box.low;
        return box;
    }

    void add(const LeafBox& other) {
        low = low.min(other.low);
        high = high.max(other.high);
    }
    Eigen::Vector3f size() const { return (high - low).head<3>().matrix(); }
    Eigen::Vector3f middle() const { return (0.5f * (low + high)).head<3>().matrix(); }
};

} // namespace tactum
