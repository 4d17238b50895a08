// Observes whether the rendered surface gives the hand more energy than it took, and damps when it does.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// A passivity observer and controller in the time domain (Hannaford and Ryu): E sums f . dx with the
/// positions as they were read; of what goes beyond the threshold a damping takes back, with the velocity as
/// it was read (a filtered one makes it shake). E begins at zero with each contact, and what friction took
/// for ever is no credit: E is never lower than what the spring can still give back.
/// Positive energy is work that the device did on the hand. SI, one frame throughout. Thread: real time.
class Passivity {
public:
    /// The work of the last commanded force up to this position.
    void observe(const Vec3& position) noexcept;
    /// The force with as much damping as the balance asks for, looking one tick ahead.
    Vec3 damped(const Vec3& force, const Vec3& velocity, double dt) noexcept;
    /// What was commanded after all limits; `stored` J lie in the rendered spring.
    void commanded(const Vec3& force, bool touching, double stored) noexcept;

    double energy() const noexcept { return energy_; }   ///< J, given beyond what was taken
    double damping() const noexcept { return damping_; } ///< N s/m, of the last tick; 0: passive by itself

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.last_, self.force_, self.known_, self.energy_, self.damping_);
    }

private:
    Vec3 last_ = Vec3::Zero(), force_ = Vec3::Zero();
    bool known_ = false;
    double energy_ = 0, damping_ = 0;
};

} // namespace tactum
