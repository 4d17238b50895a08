#include "app/python/scene_touch.h"

#include <algorithm>
#include <thread>

#include <pybind11/stl/filesystem.h>

#include "core/files/read_finger_path.h"
#include "core/haptics/compile.h"

namespace tactum::python {
namespace {

Result<TouchTrace> touchedOnce(const Scene& scene, const World& previous,
                               const std::vector<FingerPoint>& path, const Progress& progress) {
    const auto world = compile(scene, &previous, progress);
    if (!world) return tl::unexpected<Error>(world.error());
    return replay(**world, path, progress);
}

/// One after the other, each by whichever thread is free; only the first hears of signals.
Result<std::vector<TouchTrace>> touchedAll(const std::vector<Scene>& scenes, const World& previous,
                                           const std::vector<FingerPoint>& path, const Progress& progress) {
    std::vector<Result<TouchTrace>> traces(scenes.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&](const Progress& of) {
        for (std::size_t i = next++; i < scenes.size(); i = next++)
            traces[i] = touchedOnce(scenes[i], previous, path, of);
    };
    {
        std::vector<std::jthread> others;
        const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
        while (others.size() + 1 < std::min(most, scenes.size()))
            others.emplace_back([&] { work({{}, progress.cancelled}); });
        work(progress);
    }
    std::vector<TouchTrace> all;
    for (Result<TouchTrace>& trace : traces) {
        if (!trace) return tl::unexpected<Error>(trace.error());
        all.push_back(std::move(*trace));
    }
    return all;
}

} // namespace

std::shared_ptr<const World> compiled(OpenScene& of) {
    const auto world = unlocked([scene = of.scene, last = of.last](const Progress& progress) {
        return compile(scene, last.get(), progress);
    });
    of.last = world;
    return world;
}

std::vector<FingerPoint> pathFor(const OpenScene& of, const py::object& path, std::optional<double> rate) {
    if (path.is_none()) {
        if (!of.scene.finger) throw Failure("path: the scene has none of its own; give rows of t, x, y, z");
        if (rate) throw Failure("rate: the scene's own path has its times; leave it out");
        return *of.scene.finger;
    }
    if (!py::isinstance<py::str>(path) && !py::hasattr(path, "__fspath__")) return fingerPathOf(path, rate);
    if (rate) throw Failure("rate: the path of a file has its times; leave it out");
    const auto file = path.cast<std::filesystem::path>();
    return unlocked([&](const Progress&) { return readFingerPath(file); });
}

std::vector<TouchTrace> touched(OpenScene& of, std::vector<Scene> scenes,
                                const std::vector<FingerPoint>& path) {
    const auto shared = compiled(of);
    return unlocked([&](const Progress& progress) { return touchedAll(scenes, *shared, path, progress); });
}

} // namespace tactum::python
