// The decoder of each picture format, and what they share. For this folder only: others call readImage().
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/source.h"

namespace tactum {

/// Grey values of 16 bits; the first row is the lowest of the picture, as TextureImage wants it.
struct DecodedImage {
    int width = 0, height = 0;
    int bits = 8; ///< that the file had
    std::vector<std::uint16_t> texels;
    std::string note;

    /// A row as files count them, from the top.
    std::uint16_t* row(int fromTop) {
        return texels.data() + std::size_t(height - 1 - fromTop) * std::size_t(width);
    }
};

/// Room for a picture of that size. Throws ReadFault when it has no texels or too many.
DecodedImage emptyImage(const Source& source, std::uint64_t width, std::uint64_t height, int bits);

/// One decoder each. They throw ReadFault at the first fault, also where the file is cut short.
DecodedImage decodePng(const Source& source);
DecodedImage decodeJpeg(const Source& source);
DecodedImage decodeTiff(const Source& source);

/// The fault that a library's words describe.
[[noreturn]] void failDamaged(const Source& source, const char* words);

/// 0.299 R + 0.587 G + 0.114 B.
inline double luminance(double red, double green, double blue) {
    return 0.299 * red + 0.587 * green + 0.114 * blue;
}

} // namespace tactum
