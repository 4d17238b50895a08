// Observes whether the rendered surface makes energy, and damps when it does.
#pragma once

#include <array>

#include "core/port/haptic_device.h"

namespace tactum {

/// From so much energy on the surface is damped: above what quantised positions make the observer err,
/// (Delta / 2) (TV(F) + F_max). Unit: J.
inline constexpr double kPassivityThreshold = 1e-3;
/// What the damping does not take back makes the surface softer (StiffnessSchedule). A tap of 0.35 m/s that
/// comes late by four ticks, in a hand that takes it up, makes less than that; what a tap makes grows with
/// the stiffness, and so does this in a grasp. Unit: J.
inline constexpr double kSofteningThreshold = 3e-3;

/// From a command to its force, at most `most`. The amplifier's time constant answers a ramp by just so much
/// later, so it is a delay like the other: left out, what is given at each turn of a swing is not seen, and
/// what nobody holds swings for ever. Rounded up, because it is the delay that is taken too short that hides
/// a swing. Unit: ticks.
int ticksUntilFelt(const DeviceInfo& device, int most) noexcept;

/// What is rendered at one tick. SI, one frame throughout.
struct RenderedSpring {
    Vec3 force = Vec3::Zero(); ///< N, on the finger, with all that is added to the spring
    double stiffness = 0;      ///< N/m; that it rises is the work of whoever changed it
    double stretch = 0;        ///< m
    double limit = 0;          ///< N, that the device can push with
    /// m/s, of the surface: what a moving body does on the hand is its own work.
    Vec3 velocity = Vec3::Zero();

    /// J, that the hand may still get back.
    double stored() const noexcept;
};

/// A passivity observer and controller in the time domain (Hannaford and Ryu). The balance sums the work on
/// the hand and what the spring still holds, less what the device's own damping and friction take for
/// certain: a passive surface never brings it above zero. What goes beyond the threshold a damping takes
/// back, all of it. What was taken for ever is no credit, what was given is forgotten slowly: a surface that
/// the finger bounces on is one contact. SI. Thread: real time.
class Passivity {
public:
    explicit Passivity(const DeviceInfo& device) noexcept;

    /// The work up to this reading, `dt` s after the last one, of the command that has reached the device.
    void observe(const Vec3& position, const Vec3& velocity, double dt) noexcept;
    /// The damping that the balance asks for if `spring` is rendered, N s/m; `velocity` is relative to the
    /// surface.
    double damping(const RenderedSpring& spring, const Vec3& velocity, double dt) noexcept;
    /// Instead: nothing is rendered.
    void rest() noexcept {
        damping_ = 0;
        taking_ = false;
    }
    void commanded(const RenderedSpring& spring) noexcept;
    /// The newest command never reached the device: nothing acted in its place.
    void notSent() noexcept { commanded_[0] = {}; }

    double energy() const noexcept { return given_ + stored_; } ///< J, made by the surface
    double lastDamping() const noexcept { return damping_; }    ///< N s/m; 0: passive by itself

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.ownDamping_, self.friction_, self.resolution_, self.last_, self.rest_, self.restedFor_,
              self.known_, self.commanded_, self.given_, self.stored_, self.taking_, self.damping_);
        visit.index(self.delay_, kLongestDelay + 1);
    }

private:
    static constexpr int kLongestDelay = 7; ///< ticks

    double granted(const RenderedSpring& spring) const noexcept;
    double noise() const noexcept;
    void notice(const Vec3& position, double dt) noexcept;
    bool resting() const noexcept;

    double ownDamping_, friction_, resolution_;
    int delay_; ///< ticks
    Vec3 last_ = Vec3::Zero();
    Vec3 rest_ = Vec3::Zero(); ///< what the finger has not left by more than a count
    double restedFor_ = 0;     ///< s
    bool known_ = false;
    std::array<RenderedSpring, kLongestDelay + 1> commanded_{}; ///< newest first
    double given_ = 0, stored_ = 0;                             ///< J
    bool taking_ = false; ///< back what was made, until nothing is left of it
    double damping_ = 0;
};

} // namespace tactum
