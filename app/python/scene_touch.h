// Scenes compiled and touched for Python: the work, all of it without the GIL.
#pragma once

#include <optional>
#include <vector>

#include "app/python/scene_handles.h"
#include "core/haptics/replay.h"

namespace tactum::python {

/// A World of its own, which shares the geometry of the one before. Thread: with the GIL.
std::shared_ptr<const World> compiled(OpenScene& of);

/// The path that is given, of rows, as a file or, for None, the scene's own. Thread: with the GIL.
std::vector<FingerPoint> pathFor(const OpenScene& of, const py::object& path, std::optional<double> rate);

/// Every one of these scenes over the same path, on all processors. Thread: with the GIL.
std::vector<TouchTrace> touched(OpenScene& of, std::vector<Scene> scenes,
                                const std::vector<FingerPoint>& path);

} // namespace tactum::python
