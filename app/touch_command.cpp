#include <algorithm>
#include <chrono>
#include <iostream>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "app/commands.h"
#include "app/picture.h"
#include "app/results.h"
#include "app/streams.h"
#include "app/terminal_progress.h"
#include "core/files/read_finger_path.h"
#include "core/files/source.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "core/vibration/vibration_files.h"

namespace tactum {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::size_t peakRssBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
}

std::size_t hierarchyBytes(const World& world) {
    std::size_t bytes = 0;
    for (const WorldBody& body : world.bodies)
        bytes += body.mesh->tree.bytes();
    return bytes;
}

void applyOverrides(Scene& scene, const TouchOptions& options) {
    if (options.fitDiagonal) fitDiagonal(scene, *options.fitDiagonal);
    if (options.proxyRadius) scene.proxyRadius = *options.proxyRadius;
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces) {
            for (const MaterialOverride& given : options.materials)
                surface.material = withValue(surface.material, *given.field, given.value);
            if (options.shading) surface.shading.on = *options.shading;
            if (options.sides) surface.sides = *options.sides;
        }
}

bool touches(const TouchRow& row) {
    return row.contacts > 0;
}

/// What each hand felt.
nlohmann::ordered_json summaryOfHands(const TouchOptions& options, const std::vector<TouchTrace>& hands) {
    auto json = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < hands.size(); ++i) {
        double largest = 0;
        for (const TouchRow& row : hands[i])
            largest = std::max(largest, row.force.norm());
        json.push_back({{"path", shownPath(options.paths[i])},
                        {"touching_updates", std::ranges::count_if(hands[i], touches)},
                        {"largest_force_n", largest}});
    }
    return json;
}

nlohmann::ordered_json summaryOfTouch(const World& world, const TouchTrace& rows, double load, double build) {
    std::size_t triangles = 0;
    for (const WorldBody& body : world.bodies)
        triangles += body.mesh->soup->triangles.size();
    const UpdateTimes times = updateTimes(rows);
    nlohmann::ordered_json json;
    json["version"] = 1; // of docs/schema
    json["triangles"] = triangles;
    json["load_s"] = load;
    json["build_s"] = build;
    json["updates"] = rows.size();
    json["update_ns"] = {{"mean", times.mean},
                         {"median", times.median},
                         {"p99", times.p99},
                         {"p999", times.p999},
                         {"max", times.max}};
    json["peak_rss_bytes"] = peakRssBytes();
    json["hierarchy_bytes"] = hierarchyBytes(world);
    return json;
}

Result<void> writeVibration(const TouchOptions& options, const TouchTrace& rows) {
    const auto vibration = vibrationOf(rows);
    if (!vibration) return tl::unexpected(vibration.error());
    const auto bytes = vibrationBytes(*vibration, *options.vibration, shownPath(options.scene.filename()));
    return bytes ? writeFile(*options.vibration, *bytes) : tl::unexpected(bytes.error());
}

// Everything that was asked for in files; the first that cannot be written ends it.
Result<void> writeResults(const TouchOptions& options, const Scene& scene,
                          const std::vector<TouchTrace>& hands, const std::string& summary) {
    for (std::size_t i = 0; i < options.outs.size(); ++i)
        if (auto written = writeFile(options.outs[i], touchCsv(hands[i])); !written) return written;
    if (options.summary)
        if (auto written = writeFile(*options.summary, summary + '\n'); !written) return written;
    if (options.vibration)
        if (auto written = writeVibration(options, hands[0]); !written) return written;
    if (options.picture) return writePicture(scene, hands[0], *options.picture);
    return {};
}

Result<std::vector<FingerPath>> readPaths(const std::vector<std::filesystem::path>& files) {
    std::vector<FingerPath> paths;
    for (const std::filesystem::path& file : files) {
        auto path = readFingerPath(file);
        if (!path) return tl::unexpected(path.error());
        paths.push_back(std::move(*path));
    }
    return paths;
}

/// Where none is given the scene brings one.
Result<void> addScenesOwn(std::vector<FingerPath>& paths, const TouchOptions& options, const Scene& scene) {
    if (!paths.empty()) return {};
    if (!scene.finger)
        return tl::unexpected(
            Error{Error::Kind::Usage,
                  shownPath(options.scene) + ": has no finger path in it; give one with --path"});
    paths.push_back(*scene.finger);
    return {};
}

void noteIdleHands(const TouchOptions& options, const std::vector<TouchTrace>& hands) {
    for (std::size_t i = 0; i < hands.size(); ++i)
        if (std::ranges::none_of(hands[i], touches))
            std::cerr << "note: the finger path "
                      << shownPath(options.paths.empty() ? options.scene : options.paths[i])
                      << " touches nothing; is it in metres, and where the scene is?\n";
}

} // namespace

Result<int> runTouch(const TouchOptions& options) {
    if (options.vibration)
        if (const auto known = checkVibrationFile(*options.vibration); !known)
            return tl::unexpected(known.error());
    auto paths = readPaths(options.paths);
    if (!paths) return tl::unexpected(paths.error());
    const auto loading = Clock::now();
    auto loaded = importGiven(options.scene, options.axes);
    if (!loaded) return tl::unexpected(loaded.error());
    applyOverrides(loaded->scene, options);
    if (const auto found = addScenesOwn(*paths, options, loaded->scene); !found)
        return tl::unexpected(found.error());
    const double load = secondsSince(loading);
    const auto building = Clock::now();
    const auto world = compile(loaded->scene);
    if (!world) return tl::unexpected(world.error());
    const double build = secondsSince(building);
    const std::vector<TouchTrace> hands = [&] {
        const TerminalProgress terminal("touching " + shownPath(options.scene));
        return replay(**world, *paths, terminal.progress()).value(); // nobody cancels it
    }();
    noteIdleHands(options, hands);
    auto json = summaryOfTouch(**world, hands[0], load, build);
    if (hands.size() > 1) json["hands"] = summaryOfHands(options, hands);
    const std::string summary = json.dump();
    if (const auto written = writeResults(options, loaded->scene, hands, summary); !written)
        return tl::unexpected(written.error());
    if (std::ranges::find(options.outs, "-") == options.outs.end() && !isDash(options.summary))
        if (const auto written = writeFile("-", summary + '\n'); !written)
            return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
