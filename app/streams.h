// "-" for a scene: standard input, and standard output for what is written.
#pragma once

#include <filesystem>
#include <string>

#include "app/given_axes.h"
#include "core/base/result.h"
#include "core/base/scratch_folder.h"
#include "core/files/load_scene.h"

namespace tactum {

/// A sentence about the one file in a folder, which comes or goes by a pipe, with what the person knows it
/// as.
Error renamed(Error error, const ScratchFolder& of, const std::string& name);

/// importScene() of a file, or for "-" of standard input, whose format is told by its first bytes; taken
/// as the person says it is.
Result<LoadedScene> importGiven(const std::filesystem::path& file, const GivenAxes& axes = {});

} // namespace tactum
