// Pictures of 16 bits from formulas.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/surface/texture_image.h"

namespace tactum::samples {

/// `value(u, v)`: from 0 to 1, of u and v from 0 to 1 in the middle of each texel, v upward.
std::shared_ptr<const TextureImage> heightImage(std::string name, int width, int height,
                                                const std::function<double(double u, double v)>& value);

} // namespace tactum::samples
