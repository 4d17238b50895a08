// Opens any file the program knows in a process of its own: what a hostile file breaks there breaks nothing
// here.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/files/load_scene.h"

namespace tactum {

/// What the import process may use up.
struct ImportLimits {
    std::uint64_t memory = std::uint64_t(4) << 30; ///< bytes of address space, and of the scene
    std::chrono::seconds processor{60};            ///< of all its threads
    std::chrono::seconds patience{300};            ///< as the clock on the wall goes
};
/// At least 4 GiB and twelve times the file; a minute of the processor and a second for each 4 MiB.
ImportLimits limitsFor(std::uint64_t fileBytes);

struct ImportOptions {
    std::filesystem::path worker;       ///< the executable; empty: importWorker()
    std::optional<ImportLimits> limits; ///< none: limitsFor() the file
};

/// `tactum-import`: beside the running program, or in the tree that it was built from.
std::filesystem::path importWorker();

/// What loadScene() gives, read by another process: limited in memory and time, without rights to write, to
/// start anything or to reach the network, and reading nothing outside the file's folder. What comes back is
/// checked again. A note among the findings says which protection this machine lacks. Errors: those of
/// loadScene(), and one line when the process stopped or was stopped. Cancelling ends it within some 20 ms.
/// Thread: any but real time; several may import at once.
Result<LoadedScene> importScene(const std::filesystem::path& file, const Progress& progress = {},
                                const ImportOptions& options = {});

} // namespace tactum
