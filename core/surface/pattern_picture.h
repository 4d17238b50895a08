// A pattern of texture as a picture of flat ground, sampled by the function that is felt.
#pragma once

#include <vector>

#include "core/surface/texture_layer.h"

namespace tactum {

/// A square, row by row from its upper edge.
struct PatternPicture {
    int pixels = 0;  ///< a side
    double side = 0; ///< m
    std::vector<double>
        values; ///< 0 to 1; empty for what is painted, which lies on no plane, and for a missing image
};

/// Of an image one repeat, of the others a few; how it lies on the model makes no difference but for its
/// rotation. Thread: any but real time.
PatternPicture patternOnFlatGround(const TexturePattern& pattern, int pixels);

} // namespace tactum
