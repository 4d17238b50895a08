// Grey and coloured pictures as PNG files in memory.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/surface/texture_image.h"

namespace tactum {

/// Values from 0 to 65535, row by row from the top of the picture, `channels` (1 grey, 3 RGB) to a texel.
/// `bits`: 8 or 16; 8 keeps the upper byte rounded. The same values give the same bytes.
/// Empty when cancelled. Thread: any but real time. Throws std::bad_alloc.
std::string encodePng(int width, int height, int channels, int bits, std::span<const std::uint16_t> values,
                      const Progress& progress = {});

/// The finest level of a texture, without loss: 8 bits where every texel is one of 8 bits, else 16.
std::string encodePng(const TextureImage& image, const Progress& progress = {});
/// The finest level in 8 or 16 bits.
std::string encodePng(const TextureImage& image, int bits, const Progress& progress = {});

} // namespace tactum
