// A stroke of the brush over several surfaces of a mesh, worked out on a worker.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/paint/image_stroke.h"
#include "core/paint/vertex_stroke.h"

namespace tactum {

/// What was worked out of a mesh for strokes over it. Thread: one at a time.
class PaintGround {
public:
    explicit PaintGround(std::shared_ptr<const TriangleSoup> soup) : soup_(std::move(soup)) {}

    const std::shared_ptr<const TriangleSoup>& soup() const { return soup_; }
    /// A third of a second for a million triangles the first time.
    std::shared_ptr<const SoupReach> reach();
    /// Null where the pattern cannot be laid on the surface.
    std::shared_ptr<const TexelCover> coverOf(Index surface, const TexturePattern& pattern);

private:
    struct Cover {
        Index surface;
        std::shared_ptr<const TexelCover> cover;
    };
    std::shared_ptr<const TriangleSoup> soup_;
    std::shared_ptr<const SoupReach> reach_;
    std::vector<Cover> covers_;
};

/// Where the texels of an image lie on a surface; nothing where they cannot be laid on it. Looks at the whole
/// surface. Thread: any but real time.
std::optional<TexelMap> texelMapOf(const TexturePattern& pattern,
                                   const std::shared_ptr<const TriangleSoup>& soup, Index surface);

/// A place of the pointer, or its leaving the surface.
using PaintStep = std::optional<Dab>;

/// One pattern for each surface. Thread: a worker, one at a time.
class BrushStroke {
public:
    struct Part {
        Index surface = 0;
        TexturePattern pattern; ///< as it was; after work() as it is
    };

    BrushStroke(std::shared_ptr<PaintGround> ground, const Brush& brush, std::vector<Part> parts)
        : ground_(std::move(ground)), brush_(brush), parts_(std::move(parts)) {}

    /// The patterns with these steps painted.
    const std::vector<Part>& work(const std::vector<PaintStep>& steps);

private:
    struct Strokes {
        std::unique_ptr<VertexStroke> values;
        std::unique_ptr<ImageStroke> image;
    };
    void begin();

    std::shared_ptr<PaintGround> ground_;
    Brush brush_;
    std::vector<Part> parts_;
    std::vector<Strokes> strokes_; ///< one for each part, once begun
};

} // namespace tactum
