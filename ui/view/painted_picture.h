// What the view is asked to show of a painted pattern: plain values.
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/triangle_soup.h"
#include "core/paint/texel_cover.h"
#include "core/scene/scene.h"

namespace tactum {

/// What is painted on one surface: values at the corners, or an image on the texture coordinates.
struct PaintedPart {
    Index surface = 0;
    std::shared_ptr<const PaintedValues> values; ///< one for each position; null: an image, or 0 everywhere
    std::shared_ptr<const TextureImage> image;
    TexelMap map; ///< of the image

    bool operator==(const PaintedPart&) const = default;
};

/// Of one object; without parts: nothing.
struct PaintedPicture {
    ObjectId object = 0;
    std::shared_ptr<const TriangleSoup> soup;
    std::vector<PaintedPart> parts;
};

} // namespace tactum
