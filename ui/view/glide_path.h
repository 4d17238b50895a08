// The way by which the finger comes to a place on the model without going through it.
#pragma once

#include <functional>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Whether the straight way between two points is free.
using IsFree = std::function<bool(const Vec3& from, const Vec3& to)>;

/// A polyline run through by its length. Unit: metre.
class GlidePath {
public:
    GlidePath() = default;
    explicit GlidePath(std::vector<Vec3> points) : points_(std::move(points)) {}

    double length() const;
    /// The point after a part of the length, 0 to 1. Needs at least one point.
    Vec3 at(double part) const;
    void moveEnd(const Vec3& p) { points_.back() = p; }
    const std::vector<Vec3>& points() const { return points_; }

private:
    std::vector<Vec3> points_;
};

/// From `from` to `hover`, a free point in front of the model, and on to `target`. Straight to `hover` where
/// that is free; else out of the box and around it, along the sphere about the box.
GlidePath planGlide(const Vec3& from, const Vec3& hover, const Vec3& target, const Bounds& box,
                    const IsFree& isFree);

} // namespace tactum
