// A scene as a glTF 2.0 binary: any viewer shows it, readGltf() gives back every value of it
// (docs/format.md).
#pragma once

#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

/// The bytes of a .glb. The same scene gives the same bytes; parts that other programs had put into the file
/// from which the scene came are in it as they were. Errors: cancelled, or larger than the 4 GiB of the
/// format. Thread: any but real time.
Result<std::string> glbOf(const Scene& scene, const Progress& progress = {});

/// The same scene as a .gltf, which is text, with its data in a file beside it.
struct GltfFiles {
    std::string json;
    std::string binaryName, binary; ///< empty for a scene without data
};
/// `stem`: of the .gltf; the other file is called after it. Errors: as glbOf().
Result<GltfFiles> gltfFilesOf(const Scene& scene, std::string_view stem, const Progress& progress = {});

} // namespace tactum
