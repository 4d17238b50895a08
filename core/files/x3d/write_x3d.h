// A scene for H3DAPI, the other open program that renders haptic surfaces: X3D with its nodes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/files/loss_report.h"
#include "core/scene/scene.h"

namespace tactum {

/// The most that deviceinfo.x3d lets H3D command: what a light desk device gives for as long as one likes. N
inline constexpr double kX3dForceLimit = 3;
/// What lies beside the scene. In a bundle there is one scene alone; in a folder each has files of its own.
struct X3dNames {
    std::string maps = "maps"; ///< the folder of the images
    std::string device = "deviceinfo.x3d";

    /// Those of `stem`.x3d: `stem`-maps and `stem`-deviceinfo.x3d.
    static X3dNames beside(std::string_view stem);
};

struct X3dImage {
    std::string name;  ///< beside the scene, as its url says: a folder, a slash and plain letters
    std::string bytes; ///< PNG, 8 bits grey
};

struct X3dExport {
    std::string scene;
    std::string device;           ///< what H3D keeps apart
    std::vector<X3dImage> images; ///< depth maps and maps of parameters, in the order of the scene
    std::vector<Loss> losses;     ///< those of the table, and what flattening this scene's layers lost
};

/// Units, frames and sides are ours: metres, y up, counter-clockwise fronts. Poses and motions are Transforms
/// with interpolators, the numbers of a surface absolute. A surface with layers of height is a
/// DepthMapSurface, one with other layers a HapticTexturesSurface, one with friction a FrictionalSurface, any
/// other a SmoothSurface; what H3D cannot say stands in a MetadataSet under it. The same scene gives the same
/// bytes. Thread: any but real time.
X3dExport x3dOf(const Scene& scene, const X3dNames& names = {});
/// The same for somebody who waits: large pictures take seconds. Error: cancelled.
Result<X3dExport> x3dOf(const Scene& scene, const X3dNames& names, const Progress& progress);

} // namespace tactum
