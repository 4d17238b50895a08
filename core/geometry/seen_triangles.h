// Which triangles show in which pixels: what is selected by drawing over the view.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/geometry/screen_mask.h"
#include "core/geometry/triangle_set.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A body before the eye.
struct BodyInView {
    std::shared_ptr<const TriangleSoup> soup;
    /// Projection times view times the body's pose, column vectors, clip space as OpenGL has it.
    Eigen::Matrix4d clipFromBody = Eigen::Matrix4d::Identity();
    std::vector<char> shown; ///< of each surface of the soup whether it can be seen
    /// Clip space: what is there gives no negative product with it. Zeros: all is.
    Eigen::Vector4d kept = Eigen::Vector4d::Zero();

    bool operator==(const BodyInView&) const = default;
};

/// All triangles of a body that show in a chosen pixel when everything is transparent. A pixel shows what
/// covers its middle; what covers the middle of none, a segment or a point for one, is in those that it
/// passes. What lies before the near plane is not on the screen; beyond the far plane is. Fails only when
/// cancelled. Cost: about 0.1 s for a million triangles. Thread: any but real time.
Result<TriangleSet> trianglesUnder(const BodyInView& body, const ScreenMask& mask,
                                   const Progress& progress = {});

/// The foremost triangle of every pixel of a view. What covers the middle of no pixel is seen where it lies
/// on the foremost triangle and looks the same way: on a fine mesh most triangles are so small. Immutable;
/// shares the soups. Thread: any but real time, many at a time.
class SeenTriangles {
public:
    /// Fails only when cancelled. About 0.3 s for a million triangles and a million pixels.
    static Result<SeenTriangles> look(std::vector<BodyInView> bodies, int width, int height,
                                      const Progress& progress = {});

    const std::vector<BodyInView>& bodies() const { return bodies_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Calls f(body, triangle), numbers as in bodies(), for what is seen in the chosen pixels of a mask of
    /// this size; a triangle may come often.
    template <class F> void eachUnder(const ScreenMask& mask, F f) const {
        for (int y = mask.top(); y <= mask.bottom(); ++y)
            for (int x = 0; x < width_; ++x) {
                if (!mask.has(x, y)) continue;
                const std::size_t pixel = std::size_t(y) * std::size_t(width_) + std::size_t(x);
                if (front_[pixel].body != kNobody) f(front_[pixel].body, front_[pixel].triangle);
                for (std::size_t i = begin_[pixel]; i < begin_[pixel + 1]; ++i)
                    f(small_[i].body, small_[i].triangle);
            }
    }

private:
    struct Face {
        std::uint32_t body;
        Index triangle;
    };
    static constexpr std::uint32_t kNobody = ~std::uint32_t{0};
    class Looker;

    std::vector<BodyInView> bodies_;
    int width_ = 0, height_ = 0;
    std::vector<Face> front_;          ///< of each pixel
    std::vector<std::uint32_t> begin_; ///< of each pixel in small_, and the end
    std::vector<Face> small_;          ///< seen, and over the middle of no pixel
};

} // namespace tactum
