// The texture layers of a surface as one picture, for formats that know no layers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/files/uv_canvas.h"
#include "core/scene/scene.h"

namespace tactum {

/// One quantity over the texture coordinates of a surface: value = low + texel (high - low), texel from 0
/// to 1.
struct FlatPicture {
    /// 16 bits, linear, over the rectangle of `canvas`; null where the value is the same everywhere.
    std::shared_ptr<const TextureImage> image;
    double low = 0, high = 0, mean = 0; ///< m, or a factor, or the unit of the material's value
    UvCanvas canvas;
    std::vector<std::string> lost; ///< a sentence for everything that the picture does not show
};

/// A larger picture is not made. Texels.
inline constexpr int kLargestFlatSide = 4096;

/// How large a picture may get, and who watches. What is given back after a cancel is of no use.
struct Flattening {
    int largestSide = kLargestFlatSide; ///< texels
    Progress progress;
};

/// The height that the surface is felt with, evaluated by feel() of core/surface, in m. Layers with a plane
/// of their own are added up. A layer that needs no texture coordinates can be shown only where the mesh has
/// some, each for one place of the surface: elsewhere it is left out. The picture has a texel for each texel
/// of the finest image, and eight for the finest wave of a formula, up to the largest side. The object must
/// have a geometry and the surface. Thread: any but real time.
FlatPicture flattenHeight(const SceneObject& object, Index surface, const Flattening& how = {});

/// The factor by which layers change a value of the material; 1 where they do not.
FlatPicture flattenFactor(const SceneObject& object, Index surface, TextureTarget target,
                          const Flattening& how = {});

/// A value of the material as it is felt: times its factor, inside its range.
FlatPicture flattenFelt(const SceneObject& object, Index surface, double Material::*value,
                        const Flattening& how = {});

} // namespace tactum
