// A scene in any format that is written, by the ending of its file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/bundle/output_files.h"
#include "core/files/loss_report.h"
#include "core/scene/scene.h"

namespace tactum {

/// A way out of the program.
struct SceneFormat {
    std::string_view ending; ///< lower case, without dot
    ExportTarget target;
    bool alone; ///< one file, that names no other
};

/// The format of a file's ending. Errors: an ending that is not written, with those that are.
Result<SceneFormat> formatOf(const std::filesystem::path& out);
/// The endings with commas between them; `alone`: only those of one file.
std::string writableEndings(bool alone = false);

/// What writing gave besides the files.
struct WrittenScene {
    std::vector<Loss> losses; ///< everything that the scene has, and what becomes of it there
    bool touches = true;      ///< false: a bundle whose finger path meets nothing
};

/// Whether there is a folder for the result, before the work that it is for.
Result<void> checkFolder(const std::filesystem::path& out);

/// Writes the scene by the ending: .glb, .gltf, .tactum and .zip (bundles), .x3d, .obj, .ply, .stl, .off;
/// whole or not at all, with what lies beside it. Errors: one line with the path and the remedy. Thread: any
/// but real time.
Result<WrittenScene> writeScene(const Scene& scene, const OutputPlaces& places,
                                const Progress& progress = {});

} // namespace tactum
