// Ten minutes with a device and a person: what the device really is, and what about it is wrong.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/port/haptic_device.h"
#include "core/self_test/identify.h"
#include "core/self_test/trial_bench.h"

namespace tactum {

struct SelfTestFigure {
    std::string key; ///< of the profile where it has one, else of the report alone
    TrialWords name; ///< "damping along x"
    std::string unit;
    TrialFigure measured;
    std::optional<double> said; ///< by the profile of before
};

struct SelfTestReport {
    DeviceInfo device; ///< as its profile says
    std::vector<SelfTestFigure> figures;
    std::vector<TrialWords> faults;  ///< sentences: what is wrong, and what to do
    std::vector<TrialWords> leftOut; ///< what was not tried, and why
    std::vector<TrialRow> rows;      ///< of all experiments, one after the other
};

/// How long it takes, s: shorter where no ten minutes are needed, at the cost of the figures' errors.
struct SelfTestPace {
    double rest = 2;    ///< alone
    double shake = 12;  ///< along each axis
    double settle = 2;  ///< before a weight is weighed
    int swings = 4;     ///< of two seconds, while it is weighed
    double buttons = 8; ///< for pressing all of them
};

/// Goes through all experiments, as the person does them, with at most four tenths of the device's force.
/// What cannot be done after a fault (a motor that pushes the other way is no spring) is left out and said.
/// Error: the bench's, as when the device ran away. Thread: any but real time, for minutes.
Result<SelfTestReport> selfTest(TrialBench& bench, TrialPerson& person, const DeviceInfo& device,
                                const SelfTestPace& pace = {});

/// The measured figures as a profile (device/profile.h), each with its error as its source; only those that a
/// profile has.
std::string profileOfReport(const SelfTestReport& report, const std::string& date);
/// One page, complete in itself, to be read and sent.
std::string htmlOfReport(const SelfTestReport& report, const std::string& date);
/// Every tick: t,x,y,z,force_x,force_y,force_z,buttons,valid.
std::string csvOfReport(const SelfTestReport& report);

/// Those three as profile.json, report.html and ticks.csv in a folder, which is made where it is not there.
Result<void> writeSelfTest(const SelfTestReport& report, const std::string& date,
                           const std::filesystem::path& folder);
/// For them: "2026-01-02", in the time of this machine.
std::string selfTestDate();

} // namespace tactum
