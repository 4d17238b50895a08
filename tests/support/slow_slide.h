// What a finger feels of a flat surface with a relief, found as slowly as can be: the proxy goes on by a
// micrometre at a time for as long as friction lets it.
//
// It shares nothing with core/proxy: no plane, no search, no factor of a slope. Friction holds while the
// force on the proxy leans from the felt normal by less than its angle; else the proxy goes toward where it
// would rest without friction. So wherever there are several places of rest it comes to the first one, which
// is where something without mass stops.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "core/surface/material.h"

namespace tactum::test {

class SlowSlide {
public:
    using Place = Eigen::Vector2d;
    static constexpr double kStride = 1e-6; ///< m

    /// `slope`: of the height, m/m. `material`: what rubs at a place.
    SlowSlide(std::function<Place(const Place&)> slope, std::function<Material(const Place&)> material)
        : slope_(std::move(slope)), material_(std::move(material)) {}

    /// The finger is there, so deep below the surface on which the proxy's centre goes, m. Gives the way from
    /// finger to proxy along the surface: times the stiffness it is the force.
    Place to(const Place& finger, double depth) {
        if (!(depth > 0)) at_.reset();
        if (!at_ || !(depth > 0)) {
            if (depth > 0) at_ = finger;
            return Place::Zero();
        }
        Place last = Place::Zero(); // a way that turns back has passed its end by less than a stride
        const Place from = *at_;
        for (Place way = wayToGo(finger, depth); way.squaredNorm() > 0 && way.dot(last) >= 0;
             way = wayToGo(finger, depth)) {
            *at_ += way;
            last = way;
            slips_ = true;
        }
        lately_ = std::max((*at_ - from).norm(), kDecay * lately_);
        if (last.isZero() && (isWellInside(finger, depth) || lately_ <= kRest)) slips_ = false;
        return *at_ - finger;
    }
    const Place& at() const { return *at_; }

private:
    // docs/physics/friction.md: what waits on the edge of its cone slips on until it has rested for a while.
    static constexpr double kDecay = 0.9, kRest = 0.5e-6; ///< m, in a tick of a millisecond
    static constexpr double kWellInside = 0.8;

    bool isWellInside(const Place& finger, double depth) const {
        const Place slope = slope_(*at_), wish = finger - depth * slope - *at_;
        return wish.norm() <= kWellInside * heldOf(slope, depth, wish.normalized());
    }
    /// The next stride; zero where friction holds.
    Place wayToGo(const Place& finger, double depth) const {
        const Place slope = slope_(*at_), wish = finger - depth * slope - *at_;
        const double length = wish.norm(), hold = heldOf(slope, depth, wish / length);
        if (!(length - hold > 0.1 * kStride)) return Place::Zero();
        return kStride / length * wish;
    }
    /// How much of a wish in this direction stays: where the force leans from the felt normal by the angle of
    /// friction, found by halves.
    double heldOf(const Place& slope, double depth, const Place& way) const {
        const Material material = material_(*at_);
        const double friction = slips_ ? material.dynamicFriction : material.staticFriction;
        const Eigen::Vector3d felt = Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
        double low = 0, high = 10 * depth;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            const Place back = -depth * slope - middle * way;
            const Eigen::Vector3d force = Eigen::Vector3d(back.x(), back.y(), depth).normalized();
            (felt.cross(force).norm() <= friction * felt.dot(force) ? low : high) = middle;
        }
        return low;
    }

    std::function<Place(const Place&)> slope_;
    std::function<Material(const Place&)> material_;
    std::optional<Place> at_;
    bool slips_ = false;
    double lately_ = 0; ///< how far it went in a tick, m
};

} // namespace tactum::test
