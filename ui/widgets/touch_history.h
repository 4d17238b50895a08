// What the plots know of the last seconds of touch: one row for each servo tick.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/haptics/haptic_step.h"
#include "core/haptics/moving_bodies.h"
#include "core/runtime/trace_point.h"

namespace tactum {

/// SI, world frame.
struct TouchSample {
    double t = 0;
    Vec3 finger = Vec3::Zero(), proxy = Vec3::Zero(), force = Vec3::Zero();
    double magnitude = 0, normal = 0, tangential = 0; ///< N, of the force
    double ratio = 0;                                 ///< tangential by normal; 0 without a push
    double staticFriction = 0, dynamicFriction = 0;   ///< of the contact that pushes most
    double lag = 0;                                   ///< m, from the finger to the proxy
    double energy = 0;                                ///< J, made by the surface: see Passivity
    double servoRate = 0, proxyRate = 0;              ///< Hz
    // Of the selected body, once a frame: rad or m and their rates, N m or N, J.
    double jointAngle = 0, jointWay = 0, jointTurning = 0, jointSpeed = 0;
    double jointTorque = 0, jointForce = 0;
    double kinetic = 0, potential = 0;
    bool touching = false, slipping = false;
    std::uint32_t surface = 0; ///< see TouchHistory::nameOf()
};

/// What comes with the ticks of one frame.
struct TouchFrame {
    const HapticOutput* touch = nullptr; ///< of the last of them
    double proxyRate = 0;                ///< Hz
    BodyReading body{};                  ///< the selected one, if it moves
    std::string surface{};               ///< the name of the one that is touched; empty for none
};

/// Thread: ui.
class TouchHistory {
public:
    static constexpr double kSpan = 30; ///< s that are kept

    /// Time that goes back, or jumps, begins a new history.
    void add(const std::vector<TracePoint>& points, const TouchFrame& frame);
    void clear() {
        samples_.clear();
        names_.resize(1);
    }
    /// Of the surface that is touched; empty for none.
    const std::string& nameOf(const TouchSample& sample) const { return names_[sample.surface]; }
    const std::deque<TouchSample>& samples() const { return samples_; }
    double end() const { return samples_.empty() ? 0 : samples_.back().t; }
    /// The sample nearest to a time; null when there is none.
    const TouchSample* at(double t) const;

private:
    bool slips(const TouchSample& now) const;
    double rate(double t) const;

    std::uint32_t numberOf(const std::string& name);

    std::deque<TouchSample> samples_;
    std::vector<std::string> names_{1}; ///< each once; the first is empty
};

/// The samples from a time on as CSV: a line of names with their units, then a row for each servo tick;
/// decimal points, and as many digits as read back to the same number. Times count from the first row.
std::string csvOf(const TouchHistory& history, double from);

} // namespace tactum
