// Bodies that are led, along keys say, whatever acts on them: what they touch, and what hangs on them, goes
// with them.
#pragma once

#include <span>
#include <vector>

#include "core/dynamics/dynamics.h"

namespace tactum {

/// Thread: one at a time, any but real time.
class Leader {
public:
    struct Led {
        std::size_t body = 0; ///< of the mechanism; canLead() it
        Pose to;              ///< X_W of its frame
    };

    /// Refers to the mechanism.
    explicit Leader(const Mechanism& mechanism);

    /// Whether a body can be led: nothing moves it, and no joint holds it to the world or to another such
    /// body.
    bool canLead(std::size_t body) const;
    /// Gives them the velocities that take them where they are led by the end of a step of dt > 0, the
    /// shorter way round. What hangs on them feels the blow, and keeps its momentum as far as its joints let
    /// it.
    void lead(std::span<const Led> all, double dt, DynamicState& state);
    /// Puts a body there at once; it stands.
    void put(const Led& one, DynamicState& state) const;

private:
    Pose linkAt(const Led& one) const { return one.to * mechanism_.places[one.body].pose.inverse(); }
    void keepMomentum(DynamicState& state);

    const Mechanism& mechanism_;
    Articulation before_, after_;
    Coordinates momentum_, change_;
};

} // namespace tactum
