#include "device/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactum {
namespace {

constexpr double kLongestStep = 0.02; // s
constexpr double kLongestWay = 2;     // s
constexpr double kRate = 1000;        // Hz
constexpr double kFastest = 20;       // m/s: a mouse is faster than a hand

/// How a damped oscillator about its rest point goes on for a time: y(t) = yy y + yv v, v(t) = vy y + vv v.
struct Transition {
    double yy, yv, vy, vv;
};

/// The matrix exponential of y" = -w2 y - 2 decay y'. c and s are cosine and sine(wt)/w of the damped
/// frequency, their hyperbolic kin above critical damping and 1 and t at it, each times the decay.
Transition oscillate(double w2, double decay, double t) noexcept {
    const double square = w2 - decay * decay;
    const double w = std::sqrt(std::abs(square));
    const double fade = std::exp(-decay * t);
    double c = fade, s = fade * t;
    if (square > 0 && w * t > 1e-6) {
        c = fade * std::cos(w * t);
        s = fade * std::sin(w * t) / w;
    } else if (w * t > 1e-6) {
        // Together, not cosh times fade: that overflows for a hand in treacle.
        const double slow = std::exp((w - decay) * t), fast = std::exp(-(w + decay) * t);
        c = 0.5 * (slow + fast);
        s = 0.5 * (slow - fast) / w;
    }
    return {c + decay * s, s, -w2 * s, c - decay * s};
}

} // namespace

SimulatedHand::SimulatedHand(std::shared_ptr<HandTarget> target, SimulatedHandProfile profile)
    : target_(std::move(target)), profile_(profile) {}

DeviceInfo SimulatedHand::info() const {
    return {.name = std::string(kSimulatedHandName),
            .maxForce = profile_.maxForce,
            .workspaceRadius = profile_.workspaceRadius,
            .rate = kRate,
            .damping = profile_.damping,
            .handDamping = 0,
            .buttons = 1,
            .tripSpeed = kFastest,
            .measuresVelocity = true};
}

Result<void> SimulatedHand::open() {
    goal_ = position_ = velocity_ = Vec3::Zero();
    course_ = {};
    underWay_ = 0;
    held_ = false;
    teleported_ = 0;
    return {};
}

void SimulatedHand::close() {}

DeviceSample SimulatedHand::exchange(const DeviceCommand& command, double dt) noexcept {
    const bool jumped = obey(target_->read());
    if (command.force.allFinite()) move(command.force, std::clamp(dt, 0.0, kLongestStep));
    return {.position = position_,
            .velocity = velocity_,
            .buttons = held_ ? 1u : 0u,
            .valid = true,
            .jumped = jumped};
}

bool SimulatedHand::obey(const HandGoal& goal) noexcept {
    held_ = goal.held;
    if (!goal.position.allFinite()) return false;
    const bool jumps = goal.teleport && goal.sequence != teleported_;
    if (jumps || goal.position != goal_) lead(goal.position, jumps ? 0 : goal.time);
    if (!jumps) return false;
    teleported_ = goal.sequence;
    position_ = goal_;
    velocity_ = Vec3::Zero();
    stayInside();
    return true;
}

/// From wherever it is led to now, without a jump of speed or acceleration. What came over a network may say
/// anything.
void SimulatedHand::lead(const Vec3& goal, double seconds) noexcept {
    const double time = std::isfinite(seconds) ? std::clamp(seconds, 0.0, kLongestWay) : 0;
    course_ = MinimumJerk(course_.at(underWay_), goal, time);
    underWay_ = 0;
    goal_ = goal;
}

void SimulatedHand::move(const Vec3& force, double dt) noexcept {
    const Vec3 led = course_.at(underWay_ + 0.5 * dt).position;
    underWay_ += dt;
    const Vec3 rest = led + force / profile_.stiffness;
    const Vec3 y = position_ - rest, v = velocity_;
    const Transition next =
        oscillate(profile_.stiffness / profile_.mass, 0.5 * profile_.damping / profile_.mass, dt);
    position_ = rest + next.yy * y + next.yv * v;
    velocity_ = next.vy * y + next.vv * v;
    stayInside();
}

/// The wall of the workspace takes the outward part of the velocity, so that the hand slides along it.
void SimulatedHand::stayInside() noexcept {
    const double distance = position_.norm();
    if (distance <= profile_.workspaceRadius) return;
    const Vec3 outward = position_ / distance;
    position_ = profile_.workspaceRadius * outward;
    velocity_ -= std::max(0.0, velocity_.dot(outward)) * outward;
}

} // namespace tactum
