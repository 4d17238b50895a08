#include "core/files/save_scene.h"

#include <new>

#include "core/base/atomic_file.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/source.h"

namespace tactum {
namespace {

/// The version of a file that a later program wrote; whatever else is there may be replaced.
std::optional<std::string> laterFormatOf(const std::filesystem::path& file) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) return std::nullopt;
    try {
        return laterFormat(openGltf(Source::open(file, std::uint64_t(8) << 30)).json);
    } catch (const ReadFault&) {
        return std::nullopt; // not a glTF file
    }
}

} // namespace

std::optional<std::string> laterSceneFormat(std::string_view bytes) {
    try {
        return laterFormat(openGltf(Source::ofBytes("scene", bytes)).json);
    } catch (const ReadFault&) {
        return std::nullopt;
    }
}

Result<void> demandReplaceable(const std::filesystem::path& file) {
    if (const auto later = laterFormatOf(file))
        return inputError(shownPath(file) + ": holds a scene of a later Tactum (version " + *later +
                          " of the format), which would be lost; choose another name");
    return {};
}

Result<void> saveScene(const Scene& scene, const std::filesystem::path& file, const Progress& progress,
                       int backups) {
    try {
        if (const auto free = demandReplaceable(file); !free) return free;
        const auto glb = glbOf(scene, partOf(progress, 0, 0.8));
        if (!glb) return tl::unexpected<Error>(glb.error());
        if (progress.isCancelled()) return cancelledError();
        return writeFileAtomically(file, *glb, backups);
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(file) + ": not enough memory to save the scene; close other programs");
    }
}

Result<void> saveScene(const Scene& scene, const std::filesystem::path& file, const Progress& progress) {
    return saveScene(scene, file, progress, kBackups);
}

} // namespace tactum
