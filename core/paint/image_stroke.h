// A stroke of the brush over a mesh, into the image that lies on its texture coordinates.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/paint/brush.h"
#include "core/paint/soup_reach.h"
#include "core/paint/texel_cover.h"

namespace tactum {

/// As VertexStroke, on the texels of an image: each whose centre lies on a triangle within reach, by its
/// place on the surface. A texel beside all triangles takes the value of the nearest point of one, if it
/// is read there: so no gap shows along the seams of the coordinates. What the image shows
/// in several places is painted in all of them. Thread: any but real time, one at a time; ten bytes a texel
/// while it lasts.
class ImageStroke {
public:
    /// `cover` is of the soup, of all surfaces that show the image, and as large as it.
    ImageStroke(std::shared_ptr<const SoupReach> reach, PaintableSurfaces surfaces,
                std::shared_ptr<const TexelCover> cover, std::shared_ptr<const TextureImage> before,
                const Brush& brush);

    /// The pointer is here now: paints the dabs that are due.
    void moveTo(const Dab& at);
    /// It has left the surface: there is no way from the last place to the next one.
    void lift() { path_ = StrokePath(brush_.radius); }
    /// One dab by itself.
    void paint(const Dab& dab);

    /// As it is now: the one before where nothing has changed, else one of 16 bits.
    std::shared_ptr<const TextureImage> image();

private:
    struct Touched {
        std::size_t texel;
        Vec3 place;      ///< on the surface
        double distance; ///< m
    };

    void gather(const Dab& dab, double radius);
    void gather(Index triangle, const Vec3& centre, double radius);
    void touch(std::size_t texel, const Vec3& place, double distance);
    void set(std::size_t texel, double value);
    void smooth(const Dab& dab);

    std::shared_ptr<const SoupReach> reach_;
    PaintableSurfaces surfaces_;
    std::shared_ptr<const TexelCover> cover_;
    std::shared_ptr<const TextureImage> before_, image_;
    Brush brush_;
    StrokePath path_;
    std::vector<std::uint16_t> now_;
    std::vector<float> mask_; ///< the greatest falloff so far
    std::vector<Touched> touched_;
    std::vector<std::uint32_t> slotOf_; ///< of a texel in touched_, where that is of the texel
    std::vector<std::uint8_t> changed_; ///< tiles
    int tilesAcross_ = 0;
};

} // namespace tactum
