// What the experiments of a self-test share: the bench in true places, the person, and what was found.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/self_test/self_test.h"

namespace tactum {

inline constexpr std::array<const char*, 3> kTrialAxes{"x", "y", "z"};
/// Of a scale: a ruler and the person who reads it are nearer than that.
inline constexpr double kWrongScale = 0.07;

/// A number for a sentence, by printf's form of a double.
std::string trialNumber(const char* form, double value);

/// What of the device is turned round, exchanged or scaled: true place from reading, command from true force.
struct TrialWiring {
    std::array<int, 3> axis{0, 1, 2};     ///< of the reading, for each true one: a permutation
    std::array<double, 3> gain{1, 1, 1};  ///< of the reading, signed
    std::array<double, 3> motor{1, 1, 1}; ///< sign of the motor along each true axis

    Vec3 place(const Vec3& reading) const {
        Vec3 p;
        for (std::size_t i = 0; i < 3; ++i)
            p[int(i)] = reading[axis[i]] / gain[i];
        return p;
    }
    /// The way there and the way back.
    Vec3 command(const Vec3& force) const {
        return {motor[0] * force.x(), motor[1] * force.y(), motor[2] * force.z()};
    }
};

/// Thread of all members: one, not real time.
class Trial {
public:
    Trial(TrialBench& bench, TrialPerson& person, const DeviceInfo& device, const SelfTestPace& pace);

    /// Runs, keeps the rows, and hands them on in true places and forces, which `trueForce` gets and gives
    /// too.
    Result<std::vector<TrialRow>> run(double seconds, const TrialForce& trueForce);
    /// Without any force.
    Result<std::vector<TrialRow>> runFree(double seconds);
    /// False: it is left out, which the report says as `what`.
    bool does(TrialAsk ask, const TrialWords& words, const TrialWords& what);
    void leaveOut(TrialWords what) { report.leftOut.push_back(std::move(what)); }
    void fault(TrialWords sentence) { report.faults.push_back(std::move(sentence)); }
    void figure(std::string key, TrialWords name, std::string unit, TrialFigure measured,
                std::optional<double> said = {});

    TrialPerson& person;
    const DeviceInfo& device;
    const SelfTestPace pace;
    TrialWiring wiring;
    bool springs = true; ///< motors and encoders agree: a spring holds and does not throw
    double noise = 0;    ///< m
    double delay = 0;    ///< s, the longest of an axis
    std::array<std::optional<AxisDynamics>, 3> dynamics;
    TrialFigure forceGain{1, 0}; ///< true newton to a commanded one
    SelfTestReport report;

private:
    Result<std::vector<TrialRow>> run(double seconds, double limit, const TrialForce& trueForce);

    TrialBench& bench_;
};

// The experiments, in this order. Error: the bench's.

Result<void> tryRest(Trial& trial);
Result<void> tryRuler(Trial& trial);
Result<void> tryMotors(Trial& trial);
Result<void> tryDynamics(Trial& trial);
Result<void> tryWeight(Trial& trial);
Result<void> tryButtons(Trial& trial);
/// What the figures of several experiments give together.
void conclude(Trial& trial);

} // namespace tactum
