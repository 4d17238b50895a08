// Opens any file the program knows as a Scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/findings.h"
#include "core/scene/scene.h"

namespace tactum {

struct LoadedScene {
    Scene scene;
    std::vector<Finding> findings; ///< what the reader repaired, dropped or doubts
    bool ours = false;             ///< written by this program: its size is meant, and it may be written over
    bool unitGuessed = false;      ///< the file does not say: one unit was taken as a metre
    bool upGuessed = false;        ///< the file does not say: y was taken as up
};

/// The endings (lower case, without dot) that loadScene reads: obj, ply, stl, off, gltf, glb, x3d, 3ds,
/// fbx, dae, 3mf, tactum, zip.
const std::vector<std::string>& readableEndings();

/// Whether a reader says by it that a metre is a guess: untrue as soon as another unit is chosen.
bool saysUnit(const Finding& finding);

/// Reads a file by its ending. FBX, DAE and 3MF say their unit; one unit of the others is a metre. Groups and
/// materials become surfaces; no face is lost without a finding that counts it. Errors: one line that names
/// the file, the place in it (line or byte) and the remedy. Thread: any but real time; long files report
/// progress and stop when cancelled.
Result<LoadedScene> loadScene(const std::filesystem::path& file, const Progress& progress = {});

/// The same of a mesh that came in no file: repaired where it has to be, with its findings. Every index is
/// within the soup and the surfaces, every number finite. Errors: cancelled. Thread: any but real time.
Result<LoadedScene> sceneOfMesh(std::string name, TriangleSoup soup, std::vector<Surface> surfaces,
                                const Progress& progress = {});

} // namespace tactum
