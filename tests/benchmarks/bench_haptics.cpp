// Measures hapticStep over many meshes and prints what it found as Markdown. See --help.

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/measure.h"
#include "tests/benchmarks/subjects.h"
#include "tests/benchmarks/table.h"

using namespace tactum;
using namespace tactum::bench;

namespace {

namespace fs = std::filesystem;

struct Options {
    Selection meshes;
    std::string feel;  ///< name of the only effect; empty for all
    std::string count; ///< mesh whose updates another tool counts
    int repetitions = 5;
    double radius = 0; ///< of the proxy, mm; 0: the scene's
    bool judge = true, list = false, feels = false;
    fs::path instructions, json, write, faults;
};

// "mesh feel number" on each line: what counting tools found.
std::map<std::string, double> readCounts(const fs::path& file) {
    std::map<std::string, double> counts;
    std::ifstream in(file);
    std::string mesh, feel;
    for (double number = 0; in >> mesh >> feel >> number;)
        counts[mesh + " " + feel] = number;
    return counts;
}

[[noreturn]] void fail(const std::string& sentence) {
    std::cerr << sentence << "\n";
    std::exit(1);
}

template <class T> T orFail(Result<T> result) {
    if (!result) fail(result.error().text);
    return std::move(*result);
}

bool isMeasured(const Effect& effect, const Options& options) {
    return options.feel.empty() || options.feel == effect.name;
}

void appendFigures(std::vector<Figures>& all, const Subject& subject, const Options& options,
                   const std::map<std::string, double>& counts) {
    Opened opened = orFail(open(subject));
    if (options.radius > 0) opened.scene.proxyRadius = options.radius * 1e-3;
    for (const Effect& effect : effects()) {
        if (!isMeasured(effect, options)) continue;
        const bool smooth = &effect == &effects().front();
        Figures figures = orFail(
            measure(opened.scene, effect, opened.finger, options.repetitions, options.judge && smooth));
        figures.mesh = subject.name;
        figures.loadSeconds = opened.loadSeconds;
        if (const auto count = counts.find(subject.name + " " + effect.name); count != counts.end())
            figures.instructions = count->second;
        std::cerr << subject.name << ", " << effect.name << ": " << figures.update.median << " ns\n";
        all.push_back(std::move(figures));
    }
}

// Under a tool that counts: prints how many updates there were.
void runCounted(const Options& options) {
    for (const Subject& subject : subjectsOf(options.meshes)) {
        if (subject.name != options.count) continue;
        const Opened opened = orFail(openQuickly(subject));
        for (const Effect& effect : effects())
            if (isMeasured(effect, options))
                std::printf("%zu\n", replayCounted(opened.scene, effect, opened.finger));
    }
}

// What is measured with the present options: for scripts that run another tool over each.
void list(const Options& options) {
    if (options.feels)
        for (const Effect& effect : effects())
            std::printf("%s\n", effect.name);
    if (options.list)
        for (const Subject& subject : subjectsOf(options.meshes))
            std::printf("%s\n", subject.name.c_str());
}

void writeFaults(const std::vector<Figures>& all, const fs::path& file) {
    std::ofstream out(file);
    out << "mesh,row,off_um,clearance_nm\n";
    for (const Figures& f : all)
        if (f.exactness)
            for (const test::RowFault& fault : f.exactness->faults)
                out << f.mesh << ',' << fault.row << ',' << fault.off * 1e6 << ',' << fault.clearance * 1e9
                    << '\n';
}

void print(const std::vector<Figures>& figures) {
    std::printf("%s\n\n%s\n%s", circumstances().c_str(), speedTable(figures).c_str(),
                exactnessTable(figures).c_str());
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Measures the haptic step over a folder of meshes and over generated ones, and prints Markdown");
    options.meshes.addOptions(app);
    app.add_option("--feel", options.feel, "only this feel: smooth, friction ...");
    app.add_option("--repetitions", options.repetitions, "of each path; a row counts at its fastest")
        ->check(CLI::Range(1, 1000));
    app.add_option("--radius", options.radius, "of the proxy, mm; 1 without this")
        ->check(CLI::Range(0.01, 100.0));
    app.add_flag("--judge,!--no-judge", options.judge, "also say how exact the proxy is");
    app.add_option("--instructions", options.instructions, "file of lines MESH FEEL INSTRUCTIONS-PER-UPDATE");
    app.add_option("--json", options.json, "also write the figures there");
    app.add_option("--count", options.count, "only replay the first rows over this mesh, for callgrind");
    app.add_option("--faults", options.faults, "also write which rows are not exact there, as CSV");
    app.add_option("--write", options.write, "only write the generated meshes and fingers into this folder")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--feels", options.feels, "only print the names of the feels");
    app.add_flag("--list", options.list, "only print the names of the meshes");
    CLI11_PARSE(app, argc, argv);

    if (options.list || options.feels) return list(options), 0;
    if (!options.write.empty()) {
        for (const fs::path& file : writeSubjects(options.meshes, options.write))
            fail(file.string() + " cannot be written; make room there");
        return 0;
    }
    if (!options.count.empty()) return runCounted(options), 0;
    const auto counts = readCounts(options.instructions);
    std::vector<Figures> all;
    for (const Subject& subject : subjectsOf(options.meshes))
        appendFigures(all, subject, options, counts);
    print(all);
    if (!options.faults.empty()) writeFaults(all, options.faults);
    if (!options.json.empty()) std::ofstream(options.json) << asJson(all);
}
