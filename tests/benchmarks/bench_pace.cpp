// What a haptic step costs at the pace of a hand: one a millisecond, as a loop wakes for it, instead of one
// right after the other. Between two steps the caches forget the mesh, and a rehearsal reminds them. See
// --help.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/replay.h"
#include "core/loop/metronome.h"
#include "core/runtime/proxy_loop.h"
#include "tests/benchmarks/one_core.h"
#include "tests/benchmarks/subjects.h"

using namespace tactum;
using namespace tactum::bench;

namespace {

constexpr double kPeriod = 1e-3; // s, from row to row of a path

struct Options {
    Selection meshes;
    std::size_t rows = 4000;
    int repetitions = 2;
    std::string json;
};

[[noreturn]] void fail(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::exit(1);
}

/// The step that a hand makes next, if it goes on as it does: what the proxy loop rehearses.
HapticInput expectedAfter(const HapticInput& input) {
    return {.finger = input.finger + kPeriod * input.fingerVelocity, .fingerVelocity = input.fingerVelocity};
}

/// One step a millisecond along the path. With a rehearsal where the proxy loop would make one.
TouchTrace pacedReplay(const World& world, const FingerPath& path, bool rehearsed) {
    TouchTrace trace;
    trace.reserve(path.size());
    const auto state = std::make_unique<SimState>();
    const auto copy = std::make_unique<HandState>();
    HapticInput input;
    state->time = path.front().t - kPeriod;
    Metronome metronome(1 / kPeriod);
    for (const FingerPoint& point : path) {
        metronome.wait();
        if (rehearsed && !trace.empty() && 1e-9 * double(trace.back().updateNs) <= kRehearsed * kPeriod)
            rehearse(world, *state, state->time, expectedAfter(input), kPeriod, *copy);
        input.finger = point.position;
        if (!trace.empty()) input.fingerVelocity = (point.position - trace.back().finger) / kPeriod;
        const std::int64_t begin = monotonicNanoseconds();
        const HapticOutput output = hapticStep(world, *state, input, kPeriod);
        const std::int64_t took = monotonicNanoseconds() - begin;
        trace.push_back({.t = point.t, .finger = point.position, .proxy = output.proxy, .updateNs = took});
    }
    return trace;
}

/// Each row at its fastest. Fails where a proxy is elsewhere than in the first trace: what is measured would
/// not be the same steps.
UpdateTimes fastestOf(int repetitions, TouchTrace& reference, auto&& run) {
    TouchTrace fastest;
    for (int i = 0; i < repetitions; ++i) {
        const TouchTrace rows = run();
        if (reference.empty()) reference = rows;
        if (fastest.empty()) fastest = rows;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (rows[k].proxy != reference[k].proxy) fail("row " + std::to_string(k) + " differs");
            fastest[k].updateNs = std::min(fastest[k].updateNs, rows[k].updateNs);
        }
    }
    return updateTimes(fastest);
}

void report(const std::string& mesh, const std::vector<std::pair<const char*, UpdateTimes>>& paces,
            nlohmann::json& all) {
    std::printf("| %s |", mesh.c_str());
    nlohmann::json row{{"mesh", mesh}};
    for (const auto& [name, times] : paces) {
        std::printf(" %.2f / %.2f / %.1f |", 1e-3 * times.mean, 1e-3 * double(times.median),
                    1e-3 * double(times.p999));
        row[name] = {{"mean_us", 1e-3 * times.mean},
                     {"median_us", 1e-3 * double(times.median)},
                     {"p999_us", 1e-3 * double(times.p999)},
                     {"max_us", 1e-3 * double(times.max)}};
    }
    std::printf("\n");
    std::fflush(stdout);
    all.push_back(row);
}

void measure(const Subject& subject, const Options& options, nlohmann::json& all) {
    const auto opened = open(subject);
    if (!opened) fail(opened.error().text);
    const auto world = compile(opened->scene);
    if (!world) fail(world.error().text);
    FingerPath path = opened->finger;
    path.resize(std::min(path.size(), options.rows));
    const OneCore pinned;
    TouchTrace reference;
    const auto times = [&](auto&& run) { return fastestOf(options.repetitions, reference, run); };
    report(subject.name,
           {{"back_to_back", times([&] { return replay(**world, path); })},
            {"paced", times([&] { return pacedReplay(**world, path, false); })},
            {"rehearsed", times([&] { return pacedReplay(**world, path, true); })}},
           all);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Measures the smooth haptic step back to back, one a millisecond, and the same rehearsed, and "
        "prints Markdown: mean, median and 99.9th percentile in us");
    options.meshes.addOptions(app);
    app.add_option("--rows", options.rows, "of each path")->check(CLI::Range(1, 1000000));
    app.add_option("--repetitions", options.repetitions, "of each path; a row counts at its fastest")
        ->check(CLI::Range(1, 1000));
    app.add_option("--json", options.json, "also write the figures there");
    CLI11_PARSE(app, argc, argv);

    std::printf("| mean / median / p99.9 us | back to back | one step a millisecond | the same, rehearsed |\n"
                "| :-- | --: | --: | --: |\n");
    nlohmann::json all = nlohmann::json::array();
    for (const Subject& subject : subjectsOf(options.meshes))
        measure(subject, options, all);
    if (!options.json.empty()) std::ofstream(options.json) << all.dump(2) << "\n";
}
