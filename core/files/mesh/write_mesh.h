// Scenes as files that know bare meshes alone: OBJ with its material library, PLY, STL and OFF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

struct MeshFile {
    std::string name; ///< without folder
    std::string bytes;
};

/// The endings (lower case, without dot) that meshFilesOf() writes: obj, ply, stl, off.
const std::vector<std::string>& writableMeshEndings();

/// The meshes of all objects, in metres and in the world frame at the time 0. The first file is
/// `stem`.`ending`, the others belong beside it and are called as it names them. What each format cannot say
/// is in loss_report.h; what it can say is exact: OBJ and OFF have the shortest text of each number, PLY
/// doubles where floats would not do. The same scene gives the same bytes. Errors: an ending that is not one
/// of those, or more vertices than the format can number. Thread: any but real time.
Result<std::vector<MeshFile>> meshFilesOf(const Scene& scene, std::string_view ending, std::string_view stem);

// For this folder: one format each.
std::vector<MeshFile> asObj(const Scene& scene, std::string_view stem);
std::string asPly(const Scene& scene);
std::string asStl(const Scene& scene);
std::string asOff(const Scene& scene);

} // namespace tactum
