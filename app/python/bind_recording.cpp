// Recordings stepped through again.
#include <algorithm>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/scene_handles.h"
#include "app/python/touch_arrays.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"

namespace tactum::python {
namespace {

/// A recording with what it gave again.
struct Played {
    Recording recording;
    ReplayCheck check;
    TouchTrace rows; ///< the time is that since the beginning
};

TouchRow rowOf(const ReplayedStep& step, double begin) {
    return {.t = step.row->time - begin,
            .finger = tactum::vectorOf(step.row->finger),
            .proxy = step.output.proxy,
            .force = step.output.force,
            .contacts = step.output.contacts};
}

Result<Played> played(const std::filesystem::path& file, const Progress& progress) {
    constexpr double kStretch = 0.1; // s, played at once
    auto recording = readRecording(file);
    if (!recording) return tl::unexpected<Error>(recording.error());
    auto player = Player::open(std::make_shared<const RecordedRun>(recording->run), progress);
    if (!player) return tl::unexpected<Error>(player.error());
    Played all{std::move(*recording), {}, {}};
    const double begin = all.recording.run.begin();
    for (double time = begin; !player->atEnd(); time += kStretch) {
        if (progress.isCancelled()) return cancelledError();
        if (progress.report) progress.report(0);
        player->advanceTo(time + kStretch);
        player->takeTrace();
        for (const ReplayedStep& step : player->takeSteps())
            all.rows.push_back(rowOf(step, begin));
    }
    all.check = player->check();
    return all;
}

std::vector<SceneHold> scenesOf(const Played& of) {
    std::vector<SceneHold> scenes;
    for (const RecordedScene& scene : of.recording.run.scenes)
        scenes.push_back(std::make_shared<OpenScene>(OpenScene{*scene.scene, {}, {}, nullptr}));
    return scenes;
}

} // namespace

void bindRecording(py::module_& module) {
    py::class_<Played>(module, "Recording",
                       "A recording of the program's flight recorder or of a World, stepped through again by "
                       "the same functions. Immutable.")
        .def_property_readonly(
            "touch", [](const Played& of) { return touchOf(of.rows); },
            "tactum.results.Touch: What its haptic steps give now; t in s since its beginning.")
        .def_property_readonly(
            "differ", [](const Played& of) { return of.check.differ; },
            "int: Steps whose results are other bits than the recorded ones.")
        .def_property_readonly(
            "first_difference", [](const Played& of) { return of.check.first; },
            "str: A sentence about the first of these; empty where there is none.")
        .def_property_readonly(
            "servo_ticks", [](const Played& of) { return of.check.servoSteps; },
            "int: Ticks of the force loop among the steps; 0 in a recording of a World.")
        .def_property_readonly(
            "reason", [](const Played& of) { return of.recording.reason; }, "str: Why it was saved.")
        .def_property_readonly(
            "device", [](const Played& of) { return of.recording.run.device.name; },
            "str: The name of what led the finger.")
        .def_property_readonly("scenes", scenesOf,
                               "List[Scene]: What was felt, one for each change, in their order.");
    module.def(
        "play",
        [](const std::filesystem::path& file) {
            return unlocked([&](const Progress& progress) { return played(file, progress); });
        },
        py::arg("file"),
        "Steps through a .tactum-recording again and compares every bit. An Error where the file is at "
        "fault. "
        "Thread: any; others go on meanwhile.");
}

} // namespace tactum::python
