// How stiff a surface may be rendered at this tick: the ceiling of the loop as it runs, and what oscillations
// left of it.
#pragma once

#include <cstdint>

#include "core/safety/oscillation_detector.h"
#include "core/safety/safe_stiffness.h"

namespace tactum {

/// What is rendered at most.
struct StiffnessBounds {
    double stiffness = 0; ///< N/m
    double damping = 0;   ///< N s/m
    double leaving = 0;   ///< N/m, of what is not there any more, and damps no more
};

/// What the schedule depends on. Frame D, SI.
struct ScheduleInput {
    const DeviceSample& seen;
    double dt = 1e-3;
    bool late = false;                 ///< the tick came more than one period late
    double period = 0;                 ///< s, measured over a longer time; 0: nothing is known
    bool overrideCeiling = false;      ///< the person knows better
    bool grasped = false;              ///< the person says that the whole hand holds the device
    double stiffness = 0, damping = 0; ///< of the surface as authored, in the hand's measure
    double rendered = 0;               ///< N/m, at the last tick
    double load = 0;      ///< N, that the spring pushed with at the last tick; 0: nothing was touched
    bool pushing = false; ///< the device got force at the last tick
    double made = 0;      ///< J, that the surface has made and is damped for; 0: it is not damped
};

/// Three things lower the stiffness, and none of them under load by a step: a loop that is slower than its
/// nominal period, a limit cycle (half of what is left, within kFade), and a surface that gives energy (the
/// same, for as long as it does). What was lowered comes back while nothing is touched: a spring that
/// stiffens under load gives energy. A person who knows better is obeyed from the next contact on. So is one
/// who grasps the device: the hand damps more than the light pinch that the device's figures count on. A
/// grasp that is none shows, because what it touches is softened; after three such contacts within minutes it
/// is no longer believed, until the person says it anew. Thread: real time.
class StiffnessSchedule {
public:
    explicit StiffnessSchedule(const DeviceInfo& device) noexcept
        : loop_(loopFigures(device)), pinch_(device.handDamping), period_(loop_.period) {}

    StiffnessBounds operator()(const ScheduleInput& tick) noexcept;

    const StiffnessCeiling& ceiling() const noexcept { return ceiling_; } ///< of the last tick
    double scale() const noexcept {
        return scale_;
    }                                              ///< part of the stiffness that is left after oscillations
    double goal() const noexcept { return goal_; } ///< where the scale goes
    std::uint64_t oscillations() const noexcept { return oscillations_; } ///< that were noticed
    double period() const noexcept { return period_; }                    ///< s, that the ceiling is for
    double lateness() const noexcept { return tactum::lateness(loop_); }  ///< s, at the nominal period
    bool overriding() const noexcept { return overriding_; }              ///< the person's word is in force
    bool grasping() const noexcept { return grasping_; }                  ///< the hand is believed to grasp
    bool doubted() const noexcept { return doubted_; }                    ///< it says so, and is not believed
    void forgetSwings() noexcept { oscillation_.forget(); } ///< the swing that goes on begins anew

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.loop_, self.period_, self.lateFor_, self.lateTicks_, self.scale_, self.goal_,
              self.oscillation_, self.oscillations_, self.ceiling_, self.overriding_, self.pinch_,
              self.grasping_, self.doubted_, self.softened_, self.doubts_);
    }

private:
    bool overspent(const ScheduleInput& tick) const noexcept;
    void keepTime(const ScheduleInput& tick, double change) noexcept;
    void scaleBy(const ScheduleInput& tick) noexcept;
    void trust(const ScheduleInput& tick, bool loaded) noexcept;
    void grasp(LoopFigures& loop) const noexcept;

    LoopFigures loop_;   ///< of the device; the period is the nominal one
    double pinch_;       ///< N s/m, of the hand in it
    double period_;      ///< s
    double lateFor_ = 0; ///< s, that the late ticks took which follow each other now
    int lateTicks_ = 0;
    double scale_ = 1, goal_ = 1;
    OscillationDetector oscillation_;
    std::uint64_t oscillations_ = 0;
    StiffnessCeiling ceiling_;
    bool overriding_ = false;
    bool grasping_ = false, doubted_ = false, softened_ = false;
    double doubts_ = 0; ///< contacts that were softened while the hand was believed to grasp, some forgotten
};

} // namespace tactum
