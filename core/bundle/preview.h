// A small picture of a scene that needs no display: what an archive shows of its contents.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// One place to look from, for several pictures: from the front, right and above, lit by one lamp, round
/// where the surface feels round or the file has normals, with the relief that is felt down to half a pixel.
/// Thread: any but real time.
class Preview {
public:
    /// The visible objects of this scene fill nine tenths of pictures of width x height pixels.
    Preview(const Scene& scene, int width, int height);

    /// Every visible object at the time 0, in its surfaces' colours: red, green and blue of each pixel, rows
    /// from above, sRGB, 65535 is all of it. The same scene gives the same values.
    std::vector<std::uint16_t> draw(const Scene& scene) const;

private:
    Vec3 pixel(const Vec3& world) const; ///< z toward the eye

    int width_, height_;
    Mat3 turn_; ///< from the world to x right, y up, z toward the eye
    Vec3 centre_ = Vec3::Zero();
    double scale_ = 1; ///< pixels a metre
};

/// The scene as a Preview of its own draws it, as PNG. Thread: any but real time.
std::string previewOf(const Scene& scene, int width = 640, int height = 480);

} // namespace tactum
