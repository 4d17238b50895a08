// What a person says of a file that leaves its unit or its upright axis open.
#pragma once

#include <filesystem>
#include <optional>

#include "core/files/load_scene.h"
#include "core/scene/placing.h"

namespace tactum {

struct GivenAxes {
    std::optional<double> unit; ///< m that one unit of the file is
    std::optional<bool> zUp;    ///< which axis points up; nothing: as it is
};

/// Takes the scene as it is said, with a finding that says so instead of the reader's guess. What is said of
/// a file that knows its own unit scales it all the same, with a finding. Error: usage, for bodies cannot be
/// set upright.
Result<void> takeAsGiven(LoadedScene& loaded, const GivenAxes& given, const std::filesystem::path& file);

/// The same, and what nobody says and the file leaves open is taken so that the scene has most nearly the
/// size and shape of `like`, the model of before.
Result<void> takeLike(LoadedScene& loaded, GivenAxes given, const Scene& like,
                      const std::filesystem::path& file);

} // namespace tactum
