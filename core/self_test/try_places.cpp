// What the device reads: at rest, along a ruler, and of its buttons.
#include <cmath>

#include "core/self_test/trial.h"

namespace tactum {

using namespace trial_words;

namespace {

constexpr double kRulerError = 1e-3; ///< m, of a person who reads a ruler twice
constexpr double kLeastWay = 0.25;   ///< of the ruler's way: less is no motion
constexpr double kRulerLook = 0.3;   ///< s, while it is held
constexpr double kSlowPace = 0.9;    ///< of the rate that the profile says: less is a fault
constexpr std::array kRulerAsks{TrialAsk::Right, TrialAsk::Up, TrialAsk::Toward};
constexpr std::array kRulerWays{kToTheRight, kUpwards, kTowardYou};

std::string axisName(int axis) {
    return kTrialAxes[std::size_t(axis)];
}

/// The way that the readings went while the handle went kRulerWay along an axis; nullopt: left out.
Result<std::optional<Vec3>> wayAlong(Trial& trial, std::size_t axis) {
    const TrialWords way = kRulerWays[axis], what{kRulerAlong, {kTrialAxes[axis]}};
    std::array<Vec3, 2> ends;
    for (std::size_t end = 0; end < 2; ++end) {
        const bool there = end == 0 ? trial.does(TrialAsk::Zero, {kHoldZero, {way}}, what)
                                    : trial.does(kRulerAsks[axis], {kLeadAlong, {way}}, what);
        if (!there) return std::optional<Vec3>{};
        const auto rows = trial.runFree(kRulerLook);
        if (!rows) return tl::unexpected(rows.error());
        ends[end] = middleOf(*rows);
    }
    return std::optional<Vec3>(ends[1] - ends[0]);
}

void judgeScale(Trial& trial, std::size_t axis, double gain) {
    const std::string name = kTrialAxes[axis];
    trial.figure("", {kScaleOf, {name}}, "", {std::abs(gain), kRulerError / kRulerWay}, 1);
    if (gain < 0) trial.fault({kOtherWay, {name, kRulerWays[axis]}});
    if (std::abs(std::abs(gain) - 1) > kWrongScale)
        trial.fault({kScale, {name, trialNumber("%.2f", std::abs(gain))}});
}

/// Exchanged axes; what is read along none, or twice along one, is no place at all.
void judgeAxes(Trial& trial, const TrialWiring& found) {
    std::array<int, 3> times{};
    for (const int axis : found.axis)
        ++times[std::size_t(axis)];
    if (times != std::array{1, 1, 1}) {
        trial.fault(kTwice);
        trial.springs = false;
        return;
    }
    for (int axis = 0; axis < 3; ++axis)
        if (const int read = found.axis[std::size_t(axis)];
            read > axis && found.axis[std::size_t(read)] == axis)
            trial.fault({kExchanged, {axisName(axis), axisName(read)}});
        else if (read != axis && found.axis[std::size_t(read)] != axis)
            trial.fault({kReadAlong, {axisName(axis), axisName(read)}});
    trial.wiring = found;
}

} // namespace

Result<void> tryRest(Trial& trial) {
    if (!trial.does(TrialAsk::LetGo, kLetRest, kRest)) return {};
    trial.person.hears(kListening);
    const auto rows = trial.runFree(trial.pace.rest);
    if (!rows) return tl::unexpected(rows.error());
    const Pace pace = paceOf(*rows);
    trial.figure("", kReadings, "Hz", {pace.rate, 0.01 * pace.rate}, trial.device.rate);
    trial.figure("", kMedian, "s", {pace.median, 0});
    trial.figure("", kLongestGap, "s", {pace.worst, 0});
    if (pace.rate < kSlowPace * trial.device.rate)
        trial.fault({kSlow, {trialNumber("%.0f", pace.rate), trialNumber("%.0f", trial.device.rate)}});
    trial.noise = noiseOf(*rows);
    trial.figure("", kNoise, "m", {trial.noise, 0});
    if (!rows->empty() && rows->back().buttons != 0) trial.fault(kStuck);
    return {};
}

Result<void> tryRuler(Trial& trial) {
    TrialWiring found;
    bool whole = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto way = wayAlong(trial, axis);
        if (!way) return tl::unexpected(way.error());
        if (!*way) continue; // then it is taken to be as it should
        int along = 0;
        if ((*way)->cwiseAbs().maxCoeff(&along) < kLeastWay * kRulerWay) {
            trial.fault({kHardly, {kRulerWays[axis]}});
            whole = trial.springs = false;
            continue;
        }
        const double gain = (**way)[along] / kRulerWay;
        judgeScale(trial, axis, gain);
        found.axis[axis] = along;
        // What is no fault may as well be the ruler's: then the device is believed.
        found.gain[axis] =
            std::copysign(std::abs(std::abs(gain) - 1) > kWrongScale ? std::abs(gain) : 1.0, gain);
    }
    if (whole) judgeAxes(trial, found);
    return {};
}

Result<void> tryButtons(Trial& trial) {
    if (trial.device.buttons == 0) return {};
    const std::string seconds = trialNumber("%.0f", trial.pace.buttons);
    if (!trial.does(TrialAsk::Press, {kPress, {seconds}}, kPressing)) return {};
    const auto rows = trial.runFree(trial.pace.buttons);
    if (!rows) return tl::unexpected(rows.error());
    std::uint32_t ever = 0, always = ~0U;
    for (const TrialRow& row : *rows) {
        ever |= row.buttons;
        always &= row.buttons;
    }
    for (int button = 0; button < trial.device.buttons; ++button)
        if (!(ever >> button & 1U))
            trial.fault({kDeaf, {std::to_string(button + 1), std::to_string(trial.device.buttons)}});
        else if (always >> button & 1U)
            trial.fault({kHeldOn, {std::to_string(button + 1)}});
    if (ever >> trial.device.buttons) trial.fault({kMore, {std::to_string(trial.device.buttons)}});
    return {};
}

} // namespace tactum
