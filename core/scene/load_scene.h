// Opens any file the program knows as a Scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

/// Something about a scene that the person should know.
struct Finding {
    enum class Severity { Note, Warning, Error };
    Severity severity = Severity::Note;
    std::string object;   ///< name of the object, empty for the scene
    std::string sentence; ///< what is the matter, with its count
    std::string remedy;   ///< what to do, or what was done

    bool operator==(const Finding&) const = default;
};

struct LoadedScene {
    Scene scene;
    std::vector<Finding> findings; ///< what the reader repaired, dropped or doubts
};

/// The endings (lower case, without dot) that loadScene reads: obj, ply, stl, off, gltf, glb, x3d, 3ds,
/// fbx, dae.
const std::vector<std::string>& readableEndings();

/// Reads a file by its ending. FBX and DAE say their unit; one unit of the others is a metre. Groups and
/// materials become surfaces; no face is lost without a finding that counts it. Errors: one line that names
/// the file, the place in it (line or byte) and the remedy. Thread: any but real time; long files report
/// progress and stop when cancelled.
Result<LoadedScene> loadScene(const std::filesystem::path& file, const Progress& progress = {});

/// Everything that `tactum check` says: the health of each mesh and every value out of its range.
std::vector<Finding> validate(const Scene& scene);

} // namespace tactum
