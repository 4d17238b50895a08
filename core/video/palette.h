// The 256 colours of a GIF. For this folder only.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/video/video_file.h"

namespace tactum {

/// A colour of five bits a channel: 0bRRRRRGGGGGBBBBB. All that a palette tells apart.
using Shade = std::uint16_t;

/// Of a pixel, up or down by its place, another way at each of 8 x 8 pixels: what is lost of one is found in
/// those around it, and in the mean nothing is.
Shade shadeAt(const VideoPicture& picture, int x, int y);

/// Chosen for a picture: the colours of all of it are parted in boxes, again and again the box in which they
/// differ most, each difference counted for every pixel that has it. A large even face with a soft shadow has
/// so many colours then as it is large, which a cut by the widest box alone gives to what is small and
/// colourful (P. Heckbert, "Color image quantization for frame buffer display", 1982, and the measure of X.
/// Wu, "Efficient statistical computations for optimal color quantization", 1991).
class Palette {
public:
    static constexpr int kColours = 256;

    Palette() = default;
    explicit Palette(const VideoPicture& picture);

    struct Colour {
        std::uint8_t red = 0, green = 0, blue = 0;
    };
    const std::vector<Colour>& colours() const { return colours_; }
    /// The nearest colour, and how far away it is in the channel that differs most, 0 to 255.
    std::uint8_t indexOf(Shade shade);
    int distanceOf(Shade shade);

private:
    struct Nearest {
        std::uint8_t index = 0, distance = 0;
        bool known = false;
    };
    const Nearest& nearestTo(Shade shade);

    std::vector<Colour> colours_;
    std::vector<Nearest> nearest_;
};

} // namespace tactum
