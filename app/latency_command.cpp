#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/terminal_progress.h"
#include "core/loop/wake_latency.h"
#include "core/safety/force_gate.h"

namespace tactum {
namespace {

constexpr double kFelt = 1e-3;   ///< s: a force that stands still so much longer is one that buzzes
constexpr double kSeldom = 1e-3; ///< of the ticks that may be late by kFelt

/// What it means for a hand, and what helps.
std::string verdictOf(const LatencyReport& report) {
    const auto felt = double(report.late.laterThan(kFelt));
    if (report.late.laterThan(kStall) > 0)
        return "A device would lose its force: the guard takes it away where a tick is more than 10 ms late. "
               "docs/guide/real-time.md says what helps.";
    if (felt > kSeldom * double(report.late.ticks()))
        return "Hard surfaces would buzz: more than one tick in a thousand is over 1 ms late. "
               "docs/guide/real-time.md says what helps.";
    return "This machine keeps a device's pace, as busy as it was.";
}

std::string milliseconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f ms", 1e3 * seconds);
    return text;
}

void sayIt(const LatencyReport& report) {
    const LatencyHistogram& late = report.late;
    std::cout << late.ticks() << " ticks at " << report.rate << " Hz. "
              << sentenceOf(report.urgency, report.unlocked) << '\n'
              << "late: half of them " << milliseconds(late.quantile(0.5)) << " or less, 99 % "
              << milliseconds(late.quantile(0.99)) << ", 99.9 % " << milliseconds(late.quantile(0.999))
              << ", the worst " << milliseconds(late.worst()) << '\n'
              << "over 1 ms: " << late.laterThan(kFelt) << ", over 10 ms: " << late.laterThan(kStall) << '\n'
              << verdictOf(report) << '\n';
}

void sayAsJson(const LatencyReport& report) {
    const LatencyHistogram& late = report.late;
    std::cout << nlohmann::ordered_json{{"rate_Hz", report.rate},
                                        {"ticks", late.ticks()},
                                        {"priority", report.urgency.priority},
                                        {"nice", report.urgency.nice},
                                        {"slice", report.urgency.slice},
                                        {"memory_locked", report.unlocked == 0},
                                        {"late_ms",
                                         {{"median", 1e3 * late.quantile(0.5)},
                                          {"p99", 1e3 * late.quantile(0.99)},
                                          {"p99.9", 1e3 * late.quantile(0.999)},
                                          {"worst", 1e3 * late.worst()}}},
                                        {"over_1_ms", late.laterThan(kFelt)},
                                        {"over_10_ms", late.laterThan(kStall)},
                                        {"verdict", verdictOf(report)}}
                     .dump(2)
              << '\n';
}

} // namespace

Result<int> runLatency(const LatencyOptions& options, bool json) {
    const TerminalProgress progress("measuring how late this machine is");
    const auto report = measureLatency(options.rate, options.seconds, progress.progress());
    if (!report) return tl::unexpected(report.error());
    json ? sayAsJson(*report) : sayIt(*report);
    return report->late.laterThan(kStall) > 0 ? int(Error::Kind::Machine) : 0;
}

} // namespace tactum
