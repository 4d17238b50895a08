// Where a brush comes down, and the way of dabs that make a stroke.
#pragma once

#include <optional>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Body frame.
struct Dab {
    Vec3 centre = Vec3::Zero(); ///< m
    /// Unit length: of the triangle that was hit, by the order of its corners and not turned to the eye.
    /// Triangles that face the other way are not painted: the back of a thin sheet stays as it is.
    Vec3 normal = Vec3::UnitZ();
};

/// Which surfaces a stroke may paint, by their index; the others are locked.
struct PaintableSurfaces {
    std::vector<bool> allowed; ///< empty: all of them

    bool operator()(Index surface) const {
        return allowed.empty() || (surface < allowed.size() && allowed[surface]);
    }
};

/// Places the dabs of a stroke a quarter of the radius apart along the straight ways between the places of
/// the pointer, wherever these are: a stroke does not depend on how often the pointer is read. Where the
/// surface is curved, places a few dabs apart keep the ways on it.
class StrokePath {
public:
    explicit StrokePath(double radius) : spacing_(radius / kDabsToARadius) {}

    static constexpr double kDabsToARadius = 4;

    /// Calls paint(dab) for those that are due on the way from the last place to this one; at the first place
    /// for one there.
    template <class Paint> void moveTo(const Dab& at, Paint&& paint) {
        constexpr double kRounding = 1e-9; // of the spacing: a way in two pieces is as long as in one
        if (!last_) {
            paint(at);
            last_ = at;
            due_ = spacing_;
            return;
        }
        const Vec3 way = at.centre - last_->centre;
        const double length = way.norm();
        for (; due_ <= length + kRounding * spacing_; due_ += spacing_)
            paint(between(*last_, at, length > 0 ? due_ / length : 1));
        due_ -= length;
        last_ = at;
    }

private:
    static Dab between(const Dab& a, const Dab& b, double part) {
        const Vec3 normal = a.normal + part * (b.normal - a.normal);
        const double norm = normal.norm();
        return {a.centre + part * (b.centre - a.centre), norm > 0 ? Vec3(normal / norm) : b.normal};
    }

    double spacing_; ///< m
    double due_ = 0; ///< m from the last place to the next dab
    std::optional<Dab> last_;
};

} // namespace tactum
