#include "core/self_test/trial.h"

#include <array>
#include <cstdio>

namespace tactum {
namespace {

constexpr double kShareOfForce = 0.4; ///< of the device's, at most

} // namespace

std::string trialNumber(const char* form, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), form, value);
    return text.data();
}

Trial::Trial(TrialBench& bench, TrialPerson& thePerson, const DeviceInfo& theDevice,
             const SelfTestPace& thePace)
    : person(thePerson), device(theDevice), pace(thePace), bench_(bench) {
    report.device = theDevice;
}

Result<std::vector<TrialRow>> Trial::run(double seconds, const TrialForce& trueForce) {
    return run(seconds, kShareOfForce * device.maxForce, trueForce);
}

Result<std::vector<TrialRow>> Trial::runFree(double seconds) {
    return run(seconds, 0, [](const TrialRow&, const Vec3&) -> Vec3 { return Vec3::Zero(); });
}

Result<std::vector<TrialRow>> Trial::run(double seconds, double limit, const TrialForce& trueForce) {
    auto rows = bench_.run(seconds, limit, [&](const TrialRow& row, const Vec3& velocity) -> Vec3 {
        TrialRow seen = row;
        seen.position = wiring.place(row.position);
        return wiring.command(trueForce(seen, wiring.place(velocity)));
    });
    if (!rows) return rows;
    const double begin = report.rows.empty() ? 0 : report.rows.back().time + 1 / device.rate;
    for (TrialRow& row : *rows) {
        report.rows.push_back(row);
        report.rows.back().time += begin;
        row.position = wiring.place(row.position);
        row.force = wiring.command(row.force);
    }
    return rows;
}

bool Trial::does(TrialAsk ask, const TrialWords& words, const TrialWords& what) {
    if (!person.leaves() && person.does(ask, words)) return true;
    leaveOut(what);
    return false;
}

void Trial::figure(std::string key, TrialWords name, std::string unit, TrialFigure measured,
                   std::optional<double> said) {
    report.figures.push_back({std::move(key), std::move(name), std::move(unit), measured, said});
}

} // namespace tactum
