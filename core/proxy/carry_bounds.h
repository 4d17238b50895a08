// What keeps the proxy out of the bodies while these move: half-spaces, and the place that they leave.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/geometry/triangle_soup.h"
#include "core/proxy/nearest_point.h"

namespace tactum {

/// Between surfaces that leave less room than it needs the proxy gives way by at most this part of its
/// radius.
inline constexpr double kMaxGive = 0.9;

/// A primitive that bounds the proxy's centre, as a half-space where its body is at the end of its way.
struct Bound {
    std::uint32_t body = 0; ///< index of the obstacle
    Index triangle = 0;
    ConstraintPlane plane; ///< world frame
};

/// The bounds of one piece of a step. Thread: real time, every member.
class CarryBounds {
public:
    void clear() { count_ = 0; }
    bool full() const { return count_ == kMaxPlanes; }
    /// Does nothing when full.
    void add(const Bound& bound) {
        if (!full()) bounds_[std::size_t(count_++)] = bound;
    }
    std::span<const Bound> all() const { return {bounds_.data(), std::size_t(count_)}; }

    struct Place {
        Vec3 at = Vec3::Zero(); ///< world frame
        double give = 0;        ///< by how much every bound had to give way for it, m
    };
    /// The place nearest to the goal that all bounds allow. Where they exclude each other they give way
    /// evenly, by as little as leaves a place; none where kMaxGive of the radius is not enough.
    std::optional<Place> nearestTo(const Vec3& goal, double radius) const noexcept;

private:
    NearestPoint nearest(const Vec3& goal, double give) const noexcept;

    std::array<Bound, kMaxPlanes> bounds_;
    int count_ = 0;
};

} // namespace tactum
