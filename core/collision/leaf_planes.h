// Half-spaces that are free of the triangles around a moving sphere, remembered from one sweep to the next.
#pragma once

#include <array>

#include "core/base/vec.h"
#include "core/collision/lane_array.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A triangle lies behind the plane through its point nearest to where it was last seen from. What is before
/// that plane need not be looked at again: one plane for each triangle of the leaves that were looked at
/// last. Body frame, metre; positions relative to `origin`.
struct LeafPlanes {
    static constexpr int kSlots = 64;
    static constexpr Index kNone = ~Index(0);

    /// The distance of p from the triangle is at least n . (p - origin) + offset.
    struct alignas(kCacheLine) Slot {
        LaneArray nx, ny, nz, offset;
    };

    Vec3 origin = Vec3::Zero();
    double reach = -1; ///< how far from the origin the planes hold; negative: nothing is known
    std::array<Index, kSlots> leaf;
    std::array<Slot, kSlots> slot;

    bool hold(const Vec3& p) const noexcept {
        return reach > 0 && (p - origin).squaredNorm() <= reach * reach;
    }
    void startAt(const Vec3& p, double within) noexcept {
        origin = p;
        reach = within;
        leaf.fill(kNone);
    }
};

} // namespace tactum
