// Changes in contact, made slowly enough for a hand: an edit, an undo, another scene, an object that lands on
// the finger. The force itself is never slowed down: inside the loop that makes limit cycles.
#pragma once

#include "core/haptics/contact_model.h"

namespace tactum {

/// A model that the proxy loop has not renewed for so long is no longer believed: zero force. Unit: s.
inline constexpr double kModelPatience = 0.1;
/// A surface that was changed under the finger comes to its place at this speed. Unit: m/s.
inline constexpr double kReturnSpeed = 0.015;
/// An edited stiffness, damping or friction changes the force by no more than this, and on a soft surface by
/// no more than coming or going with kReturnSpeed would. Unit: N/s.
inline constexpr double kEditRate = 10;
/// So does the stiffness where the finger goes from one surface to the next, or the ceiling changes: a step
/// of it under load would be a kick. Unit: N/s.
inline constexpr double kSurfaceRate = 300;
/// What an edit may change the force by at this stiffness in N/m: N/s. Thread: any, real time too.
double editRate(double stiffness) noexcept;

/// What a newer model may put into the spring at once: so much in a second, and the most of it together. A
/// proxy loop that is not much slower than the servo needs less, even where the finger hits a wall.
/// Units: W, J.
inline constexpr double kHandOverPower = 1e-3, kHandOverEnergy = 5e-4;

/// A newer model may turn the force by this part of the device's limit at once, measured as rise(): half of
/// what the guard takes for a fault.
inline constexpr double kMaxTurn = 0.3;

/// What is rendered at most.
struct TransitionBounds {
    double ceiling = 0; ///< N/m: nothing is met stiffer; what is under load when it falls comes down by
                        ///< kSurfaceRate, in an edit by kEditRate: faster, a resting hand would be thrown
    double leaving = 0; ///< N/m, the ceiling of what was touched and is not there any more
    double force = 0;   ///< N, of the device
};

/// What the servo renders instead of the newest model. An edit, of shape too, leaves the
/// rendered proxy where it was, held by as much friction as that takes, and the stiffness what it was; all
/// then go to their new values, and what was moved comes with kReturnSpeed. What is not there any more, or
/// pushes the other way, fades away first; then the proxy's new surroundings are moved so that they begin at
/// the finger, without force, and come back as well. A late model that finds the finger deep in something is
/// met as a restart is. A body that moves by itself goes on as fast as it does, and what it thereby does on
/// the hand is no change. Where the proxy fell from one side of the finger to another, the new surroundings
/// begin with no more push than there was along theirs, and come back as well. Frame D, SI. Thread: real
/// time.
class ContactTransition {
public:
    /// Call at every servo tick. `fresh`: `newest` is another one than at the last call.
    const LocalContactModel& operator()(const LocalContactModel& newest, bool fresh, const Vec3& finger,
                                        const Vec3& velocity, const TransitionBounds& bounds,
                                        double dt) noexcept;
    /// The next model begins at the finger as after a restart of the proxy; until then none is eased.
    void restart() noexcept { begun_ = false; }
    const LocalContactModel& rendered() const noexcept { return rendered_; }
    /// m/s, of the surface itself: without its way back.
    const Vec3& motion() const noexcept { return motion_; }
    /// m/s, of what the surface does on the hand by itself: its motion, and its way back from an event (an
    /// edit, a restart, a fall), which nobody's spring stored.
    Vec3 ownMotion() const noexcept { return heldBack_ > 0 ? motion_ : rendered_.velocity; }
    /// s since the finger that it answers was read, at least, in a tick of `dt`: for anchorOf().
    double since(double dt) const noexcept;
    /// Whether the surroundings are still on their way.
    bool easing() const noexcept { return editing_ || leaving_ || !offset_.isZero(0); }

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.begun_, self.editing_, self.leaving_, self.fallen_, self.offset_, self.heldBack_,
              self.slip_, self.hold_, self.credit_, self.age_, self.revision_, self.restarts_, self.motion_,
              self.rendered_);
    }

private:
    void meet(const LocalContactModel& newest, const Vec3& finger, const TransitionBounds& bounds,
              double dt) noexcept;
    void handOver(const LocalContactModel& newest, const Vec3& before, const Vec3& finger,
                  const TransitionBounds& bounds, double dt) noexcept;
    void turn(const LocalContactModel& newest, const Vec3& before, const Vec3& finger,
              const TransitionBounds& bounds, double dt) noexcept;
    void catchUp(const LocalContactModel& newest) noexcept;
    void slipOn(const LocalContactModel& newest, const Vec3& finger, double dt) noexcept;
    bool lost(const LocalContactModel& newest, const Vec3& finger) const noexcept;
    bool fell(const LocalContactModel& newest, const Vec3& finger, const TransitionBounds& bounds,
              double dt) const noexcept;
    void leave(const Vec3& finger, double ceiling, double dt) noexcept;
    void edit(const LocalContactModel& newest, const Vec3& anchor, const Vec3& finger) noexcept;
    Vec3 motionOf(const LocalContactModel& newest) const noexcept;
    LocalContactModel byNow(const LocalContactModel& newest) const noexcept;
    void approach(const LocalContactModel& before, const Vec3& finger, const Vec3& velocity, double ceiling,
                  double dt) noexcept;

    bool begun_ = false;
    bool editing_ = false;
    bool leaving_ = false;       ///< what is not there any more
    bool fallen_ = false;        ///< and by no edit
    Vec3 offset_ = Vec3::Zero(); ///< of the rendered surroundings from the true ones
    double heldBack_ = 0;        ///< m, of the offset: what newer models would have brought; returns first
    Vec3 slip_ = Vec3::Zero();   ///< of the rendered proxy along its plane, where the true one still sticks
    double hold_ = 0;            ///< least coefficient of friction, after an edit
    double credit_ = 0;          ///< J, that a newer model may bring
    double age_ = 0;             ///< s since the newest model came
    std::uint64_t revision_ = 0;
    std::uint32_t restarts_ = 0;
    Vec3 motion_ = Vec3::Zero(); ///< m/s, of the surface itself: without its way back
    LocalContactModel rendered_;
};

} // namespace tactum
