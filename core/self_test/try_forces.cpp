// What the device's motors do: which way they push, what they move, and how strong a newton is.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/self_test/trial.h"

namespace tactum {

using namespace trial_words;

namespace {

constexpr double kGravity = 9.80665;

// A push and a brake, and both the other way: the handle ends where it began.
constexpr double kPush = 0.04;      ///< s, of each half
constexpr double kLookAt = 0.05;    ///< s after the push began: motion is seen by then, whatever the delay
constexpr double kPushEvery = 0.35; ///< s
constexpr double kLeastPush = 2e-4; ///< m: less is no motion

// What holds the handle while it is shaken: soft, so that the delay that is sought cannot make it tremble.
constexpr double kHoldStiffness = 60, kHoldDamping = 3; ///< N/m, N s/m
constexpr double kEase = 1;                             ///< s, on the way to the middle
constexpr double kLowest = 2.5, kHighest = 14;          ///< Hz, of the shaking
constexpr double kSweep = 2;                            ///< s, from slow to fast and back
constexpr double kSlowShare = 0.6;                      ///< of the force, at the lowest

constexpr double kWeighStiffness = 200; ///< N/m, at most
constexpr double kSwingPeriod = 2;      ///< s
constexpr double kSwingForce = 0.8;     ///< N: more than dry friction, which so averages out
constexpr double kLightest = 5e-3;      ///< kg
constexpr double kShareOfWeight = 0.15; ///< of the device's force
constexpr double kLeastExplained = 0.5; ///< of the force: else the figures mean nothing

/// From where it was at the beginning to the middle, without a jolt.
Vec3 eased(const Vec3& begin, double time) {
    const double part = std::clamp(time / kEase, 0.0, 1.0);
    return (1 - part * part * (3 - 2 * part)) * begin;
}

double pushAt(double time) {
    const double phase = std::fmod(time, 2 * kPushEvery);
    const double since = std::fmod(phase, kPushEvery), sign = phase < kPushEvery ? 1 : -1;
    return since < kPush ? sign : since < 2 * kPush ? -sign : 0;
}

const TrialRow& rowAt(const std::vector<TrialRow>& rows, double time) {
    const auto found = std::ranges::lower_bound(rows, time, {}, &TrialRow::time);
    return found == rows.end() ? rows.back() : *found;
}

/// Where pushes along each axis move it, a drift taken off.
Result<std::array<Vec3, 3>> pushesOf(Trial& trial) {
    const double strength = std::min(0.25 * trial.device.maxForce, 1.0);
    std::array<Vec3, 3> moves;
    for (int axis = 0; axis < 3; ++axis) {
        const auto rows = trial.run(2 * kPushEvery, [=](const TrialRow& row, const Vec3&) -> Vec3 {
            return strength * pushAt(row.time) * Vec3::Unit(axis);
        });
        if (!rows) return tl::unexpected(rows.error());
        if (rows->empty()) return std::array{Vec3(Vec3::Zero()), Vec3(Vec3::Zero()), Vec3(Vec3::Zero())};
        const auto moved = [&](double from) -> Vec3 {
            return rowAt(*rows, from + kLookAt).position - rowAt(*rows, from).position;
        };
        moves[std::size_t(axis)] = (moved(0) - moved(kPushEvery)) / 2;
    }
    return moves;
}

void judgePush(Trial& trial, int axis, const Vec3& move) {
    const std::string name = kTrialAxes[std::size_t(axis)];
    int along = 0;
    if (move.cwiseAbs().maxCoeff(&along) < std::max(kLeastPush, 3 * trial.noise)) {
        trial.fault({kNoPush, {name}});
        trial.springs = false;
    } else if (along != axis) {
        trial.fault({kPushAlong, {kTrialAxes[std::size_t(along)], name}});
        trial.springs = false;
    } else if (move[axis] < 0) {
        trial.fault({kPushOtherWay, {name}});
        trial.wiring.motor[std::size_t(axis)] *= -1;
    }
}

/// Along one axis, by a soft spring and a force that rises and falls, now slowly, now fast. All of it comes
/// again and again: were only the end fast, a delay that drifts would look like damping.
Result<std::vector<TrialRow>> shake(Trial& trial, int axis) {
    const double strength = std::min(0.25 * trial.device.maxForce, 2.0), length = trial.pace.shake;
    std::optional<Vec3> begin;
    return trial.run(kEase + length, [=](const TrialRow& row, const Vec3& velocity) mutable -> Vec3 {
        if (!begin) begin = row.position;
        Vec3 force = kHoldStiffness * (eased(*begin, row.time) - row.position) - kHoldDamping * velocity;
        if (const double time = row.time - kEase; time > 0) {
            const double middle = (kLowest + kHighest) / 2, half = kHighest - middle;
            const double sweep = 2 * std::numbers::pi * time / kSweep;
            const double now = middle - half * std::cos(sweep);
            const double turns = middle * time - half * kSweep / (2 * std::numbers::pi) * std::sin(sweep);
            // Slow shaking moves a mass far: it is weaker.
            force[axis] +=
                strength * std::max(kSlowShare, now / kHighest) * std::sin(2 * std::numbers::pi * turns);
        }
        return force;
    });
}

/// The force that holds it, N along y, for each swing.
Result<std::vector<double>> weigh(Trial& trial) {
    const double stiffness = std::min(kWeighStiffness, kHoldDamping / (2 * std::max(1e-3, trial.delay)));
    const double way = std::min(kSwingForce, 0.12 * trial.device.maxForce) / stiffness;
    const double settle = kEase + trial.pace.settle;
    std::optional<Vec3> begin;
    const auto rows = trial.run(settle + trial.pace.swings * kSwingPeriod,
                                [=](const TrialRow& row, const Vec3& velocity) mutable -> Vec3 {
                                    if (!begin) begin = row.position;
                                    Vec3 target = eased(*begin, row.time);
                                    target.y() +=
                                        way * std::sin(2 * std::numbers::pi * row.time / kSwingPeriod);
                                    return stiffness * (target - row.position) - kHoldDamping * velocity;
                                });
    if (!rows) return tl::unexpected(rows.error());
    std::vector<double> sums(std::size_t(trial.pace.swings)), counts(sums.size());
    for (const TrialRow& row : *rows) {
        const double swing = std::floor((row.time - settle) / kSwingPeriod);
        if (swing < 0 || swing >= trial.pace.swings) continue;
        sums[std::size_t(swing)] += row.force.y();
        ++counts[std::size_t(swing)];
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] /= std::max(1.0, counts[i]);
    return sums;
}

/// Of the swings; its error is their scatter.
TrialFigure meanOf(const std::vector<double>& values) {
    double mean = 0, squares = 0;
    for (const double value : values)
        mean += value / double(values.size());
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares) / double(std::max<std::size_t>(1, values.size() - 1))};
}

/// kg of what hangs there, where it can be weighed.
std::optional<double> massToHang(Trial& trial) {
    const double heaviest = kShareOfWeight * trial.device.maxForce / kGravity;
    const auto mass = trial.person.leaves() ? std::nullopt : trial.person.mass(heaviest);
    if (mass && *mass >= kLightest && *mass <= heaviest) return mass;
    trial.leaveOut(mass ? TrialWords(kWeighingMass, {trialNumber("%.0f", 1e3 * heaviest)}) : kWeighing);
    return {};
}

void judgeWeight(Trial& trial, double mass, const TrialFigure& with, const TrialFigure& without) {
    const double felt = with.value - without.value;
    if (felt < 0.1 * mass * kGravity) {
        trial.fault(kNoWeight);
        return;
    }
    const double gain = mass * kGravity / felt;
    trial.forceGain = {gain, gain * std::hypot(with.error, without.error) / felt};
    trial.figure("", kForceScale, "", trial.forceGain, 1);
    if (std::abs(gain - 1) > std::max(kWrongScale, 2 * trial.forceGain.error))
        trial.fault({kNewton, {trialNumber("%.2f", gain)}});
}

} // namespace

Result<void> tryMotors(Trial& trial) {
    if (!trial.springs) return trial.leaveOut(kNoPlaces), Result<void>{};
    if (!trial.does(TrialAsk::LetGo, kLetTwitch, kDirections)) {
        trial.springs = false;
        return {};
    }
    const auto moves = pushesOf(trial);
    if (!moves) return tl::unexpected(moves.error());
    for (int axis = 0; axis < 3; ++axis)
        judgePush(trial, axis, (*moves)[std::size_t(axis)]);
    return {};
}

Result<void> tryDynamics(Trial& trial) {
    if (!trial.springs) return trial.leaveOut(kFiguresNoSpring), Result<void>{};
    if (!trial.does(TrialAsk::LetGo, kLetShake, kFigures)) return {};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name = kTrialAxes[std::size_t(axis)];
        trial.person.hears({kShaking, {name}});
        auto rows = shake(trial, axis);
        if (!rows) return tl::unexpected(rows.error());
        std::erase_if(*rows, [](const TrialRow& row) { return row.time < kEase; });
        const auto found = dynamicsOf(*rows, axis);
        if (found && found->unexplained < kLeastExplained && found->mass.value > 0) {
            trial.dynamics[std::size_t(axis)] = found;
            trial.delay = std::max(trial.delay, found->delay.value);
        } else {
            trial.leaveOut({kFiguresHardly, {name}});
        }
    }
    return {};
}

Result<void> tryWeight(Trial& trial) {
    if (!trial.springs) return trial.leaveOut(kWeighingNoSpring), Result<void>{};
    const auto mass = massToHang(trial);
    if (!mass) return {};
    if (!trial.does(TrialAsk::LetGo, kLetSwing, kWeighing)) return {};
    const auto without = weigh(trial);
    if (!without) return tl::unexpected(without.error());
    if (!trial.does(TrialAsk::Hang, trial_words::kHang, kWeighing)) return {};
    const auto with = weigh(trial);
    if (!with) return tl::unexpected(with.error());
    judgeWeight(trial, *mass, meanOf(*with), meanOf(*without));
    return {};
}

} // namespace tactum
