#include "core/self_test/self_test.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/self_test/trial.h"

namespace tactum {

using namespace trial_words;

namespace {

/// In true newtons: what was measured in commanded ones, with the error of a newton.
TrialFigure inNewtons(const TrialFigure& measured, const TrialFigure& gain) {
    return {measured.value * gain.value,
            std::hypot(measured.error * gain.value, measured.value * gain.error)};
}

void addDynamics(Trial& trial, std::size_t axis, const AxisDynamics& found) {
    const TrialWords along = kTrialAxes[axis];
    const TrialFigure& gain = trial.forceGain;
    trial.figure("", {kMass, {along}}, "kg", inNewtons(found.mass, gain));
    trial.figure("", {kDamping, {along}}, "N s/m", inNewtons(found.damping, gain), trial.device.damping);
    trial.figure("", {kFriction, {along}}, "N", inNewtons(found.friction, gain), trial.device.dryFriction);
    trial.figure("", {kDelay, {along}}, "s", found.delay,
                 trial.device.delay / trial.device.rate + trial.device.amplifierLag);
    trial.figure("", {kUnexplained, {along}}, "", {found.unexplained, 0});
}

/// The axis that has the least, or the most, of something.
template <class Less> const AxisDynamics* extreme(const Trial& trial, Less less) {
    const AxisDynamics* best = nullptr;
    for (const auto& found : trial.dynamics)
        if (found && (!best || less(*found, *best))) best = &*found;
    return best;
}

/// What the ceiling rests on must hold along every axis: the least damping, the longest delay.
void addForProfile(Trial& trial) {
    const auto* const least =
        extreme(trial, [](const auto& a, const auto& b) { return a.damping.value < b.damping.value; });
    if (!least) return;
    const auto* const smooth =
        extreme(trial, [](const auto& a, const auto& b) { return a.friction.value < b.friction.value; });
    const auto* const late =
        extreme(trial, [](const auto& a, const auto& b) { return a.delay.value > b.delay.value; });
    const DeviceInfo& device = trial.device;
    const auto atLeastNothing = [&](TrialFigure measured) {
        measured.value = std::max(0.0, measured.value);
        return inNewtons(measured, trial.forceGain);
    };
    trial.figure("damping_N_s_per_m", kLeastDamping, "N s/m", atLeastNothing(least->damping), device.damping);
    trial.figure("dry_friction_N", kLeastFriction, "N", atLeastNothing(smooth->friction), device.dryFriction);
    trial.figure("delay_ticks", kLongestDelay, kTicks,
                 {late->delay.value * device.rate, late->delay.error * device.rate},
                 device.delay + device.amplifierLag * device.rate);
    trial.figure("amplifier_lag_s", kLag, "s", {0, late->delay.error}, device.amplifierLag);
    const double said = device.delay + device.amplifierLag * device.rate,
                 found = late->delay.value * device.rate;
    if (found > said + 1) trial.fault({kLate, {trialNumber("%.1f", found), trialNumber("%.1f", said)}});
}

} // namespace

void conclude(Trial& trial) {
    // Noise of a step is at most half of it: more is noise that no step makes.
    if (const double step = std::max(resolutionOf(trial.report.rows), 2 * trial.noise); step > 0)
        trial.figure("position_resolution_m", kResolution, "m", {step, 0.1 * step},
                     trial.device.positionResolution);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (trial.dynamics[axis]) addDynamics(trial, axis, *trial.dynamics[axis]);
    addForProfile(trial);
}

Result<SelfTestReport> selfTest(TrialBench& bench, TrialPerson& person, const DeviceInfo& device,
                                const SelfTestPace& pace) {
    Trial trial(bench, person, device, pace);
    constexpr std::array parts{tryRest, tryRuler, tryMotors, tryDynamics, tryWeight, tryButtons};
    static_assert(parts.size() == std::size(kTrialParts));
    for (std::size_t part = 0; part < parts.size() && !person.leaves(); ++part) {
        person.begins(TrialPart(part));
        if (const auto done = parts[part](trial); !done) return tl::unexpected(done.error());
    }
    if (person.leaves()) trial.leaveOut(kAllAfter);
    conclude(trial);
    return std::move(trial.report);
}

} // namespace tactum
