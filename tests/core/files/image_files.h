// Small pictures as the bytes of a file, written by hand so that every byte is known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tactum {

struct PngForm {
    int depth = 8;
    int colour = 0; ///< as in the file: 0 grey, 2 RGB, 3 palette, 4 grey and alpha
    bool interlaced = false;
    std::string extra; ///< chunks before the picture
};
std::string pngChunk(const std::string& type, const std::string& data);
/// `pixels`: one string of the pixel's bytes for each, row by row from the top; depths of 8 and 16.
std::string asPng(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& pixels,
                  const PngForm& form = {});

struct TiffForm {
    int bits = 8;
    int samples = 1;
    int format = 1;      ///< 1 whole numbers, 3 floating point
    int photometric = 1; ///< 0 white is zero, 1 black is zero, 2 RGB
    int tile = 0;        ///< side of a tile, a multiple of 16; 0 for one strip
};
/// Little-endian, uncompressed. `data` as it stands in the file.
std::string asTiff(std::uint32_t width, std::uint32_t height, const std::string& data,
                   const TiffForm& form = {});

} // namespace tactum
