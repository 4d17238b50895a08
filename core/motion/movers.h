// The bodies of a scene that move by themselves, and how they moved in one step.
#pragma once

#include <cassert>
#include <concepts>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/inplace_vector.h"
#include "core/motion/body_motion.h"
#include "core/motion/motion.h"

namespace tactum {

/// A body that moves: along keys, X_WB(t) = rest * motion->at(t), or by forces.
struct Mover {
    std::uint32_t body = 0;               ///< index into World::bodies
    Pose rest;                            ///< X_WB at the time 0
    std::shared_ptr<const Motion> motion; ///< null: forces move it
    int driven = -1;                      ///< which of those that forces move

    Pose poseAt(double t) const noexcept { return rest * motion->at(t); }
};

/// How each mover moved in a step. Of many only those are asked for that are near the proxy: so each is found
/// when it is asked for, and remembered while the step lasts. Thread: real time, one at a time.
class StepMotions {
public:
    StepMotions() = default;
    /// Each as it is given, by its number. Refers to them.
    template <class Given>
    requires std::convertible_to<const Given&, std::span<const BodyMotion>> StepMotions(const Given& given)
        : given_(given) {}
    /// Along their motions from the time `before` to `now`, s; of those that forces move as `driven` has
    /// them. Refers to both.
    StepMotions(std::span<const Mover> movers, double before, double now,
                std::span<const BodyMotion> driven = {})
        : given_(driven), movers_(movers), before_(before), now_(now) {}

    bool empty() const noexcept { return given_.empty() && movers_.empty(); }
    BodyMotion of(int mover) const noexcept;

private:
    struct Found {
        int mover;
        BodyMotion motion;
    };

    std::span<const BodyMotion> given_;
    std::span<const Mover> movers_;
    double before_ = 0, now_ = 0;
    mutable InplaceVector<Found, 16> found_; ///< when it is full it begins anew
};

} // namespace tactum
