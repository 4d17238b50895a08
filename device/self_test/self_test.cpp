#include "device/self_test/self_test.h"

#include <algorithm>
#include <cmath>

#include "device/self_test/trial.h"

namespace tactum {
namespace {

/// In true newtons: what was measured in commanded ones, with the error of a newton.
TrialFigure inNewtons(const TrialFigure& measured, const TrialFigure& gain) {
    return {measured.value * gain.value,
            std::hypot(measured.error * gain.value, measured.value * gain.error)};
}

void addDynamics(Trial& trial, std::size_t axis, const AxisDynamics& found) {
    const std::string along = std::string(" along ") + kTrialAxes[axis];
    const TrialFigure& gain = trial.forceGain;
    trial.figure("", "moving mass" + along, "kg", inNewtons(found.mass, gain));
    trial.figure("", "damping" + along, "N s/m", inNewtons(found.damping, gain), trial.device.damping);
    trial.figure("", "dry friction" + along, "N", inNewtons(found.friction, gain), trial.device.dryFriction);
    trial.figure("", "delay from command to force" + along, "s", found.delay,
                 trial.device.delay / trial.device.rate + trial.device.amplifierLag);
    trial.figure("", "force that the model does not explain" + along, "", {found.unexplained, 0});
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
    trial.figure("damping_N_s_per_m", "least damping", "N s/m", atLeastNothing(least->damping),
                 device.damping);
    trial.figure("dry_friction_N", "least dry friction", "N", atLeastNothing(smooth->friction),
                 device.dryFriction);
    trial.figure("delay_ticks", "longest delay, with the amplifier's lag", "ticks",
                 {late->delay.value * device.rate, late->delay.error * device.rate},
                 device.delay + device.amplifierLag * device.rate);
    trial.figure("amplifier_lag_s", "amplifier's lag, as it stands in the delay", "s", {0, late->delay.error},
                 device.amplifierLag);
    const double said = device.delay + device.amplifierLag * device.rate,
                 found = late->delay.value * device.rate;
    if (found > said + 1)
        trial.fault("Forces come " + trialNumber("%.1f", found) +
                    " ticks after their reading, and the profile says " + trialNumber("%.1f", said) +
                    ": with it surfaces may be too stiff and tremble.");
}

} // namespace

void conclude(Trial& trial) {
    // Noise of a step is at most half of it: more is noise that no step makes.
    if (const double step = std::max(resolutionOf(trial.report.rows), 2 * trial.noise); step > 0)
        trial.figure("position_resolution_m", "resolution of the position", "m", {step, 0.1 * step},
                     trial.device.positionResolution);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (trial.dynamics[axis]) addDynamics(trial, axis, *trial.dynamics[axis]);
    addForProfile(trial);
}

Result<SelfTestReport> selfTest(TrialBench& bench, TrialPerson& person, const DeviceInfo& device,
                                const SelfTestPace& pace) {
    Trial trial(bench, person, device, pace);
    for (const auto part : {tryRest, tryRuler, tryMotors, tryDynamics, tryWeight, tryButtons}) {
        if (person.leaves()) break;
        if (const auto done = part(trial); !done) return tl::unexpected(done.error());
    }
    if (person.leaves()) trial.leaveOut("all that was to come after the end that you asked for");
    conclude(trial);
    return std::move(trial.report);
}

} // namespace tactum
