// Observes whether the rendered surface makes energy, and damps when it does.
#pragma once

#include "core/control/haptic_device.h"

namespace tactum {

/// A rendered spring for the energy balance of one tick. SI, one frame throughout.
struct RenderedSpring {
    Vec3 force = Vec3::Zero();    ///< N, commanded after all limits
    double stored = 0;            ///< J, that the spring holds and may still give back
    Vec3 velocity = Vec3::Zero(); ///< m/s, of the surface: what a moving body does on the hand is its own work
};

/// A passivity observer and controller in the time domain (Hannaford and Ryu). The balance sums the work on
/// the hand and what the spring still holds, less what the device's own damping and friction take for
/// certain: a passive surface never brings it above zero. Of what goes beyond the threshold a damping takes
/// back. What was taken for ever is no credit, what was given is forgotten slowly: a surface that the finger
/// bounces on is one contact. SI. Thread: real time.
class Passivity {
public:
    explicit Passivity(const DeviceInfo& device) noexcept
        : ownDamping_(device.damping), friction_(device.dryFriction) {}

    /// The work of the last command up to this reading, `dt` s later.
    void observe(const Vec3& position, const Vec3& velocity, double dt) noexcept;
    /// The damping that the balance asks for now, N s/m; `velocity` is relative to the surface.
    double damping(double stored, const Vec3& velocity, double dt) noexcept;
    void commanded(const RenderedSpring& spring) noexcept;

    double energy() const noexcept { return given_ + spring_.stored; } ///< J, made by the surface
    double lastDamping() const noexcept { return damping_; }           ///< N s/m; 0: passive by itself

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.last_, self.force_, self.known_, self.energy_, self.damping_);
    }

private:
    double ownDamping_, friction_;
    Vec3 last_ = Vec3::Zero();
    bool known_ = false;
    RenderedSpring spring_; ///< of the last tick
    double given_ = 0;      ///< J
    double damping_ = 0;
};

} // namespace tactum
