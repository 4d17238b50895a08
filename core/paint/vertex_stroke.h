// A stroke of the brush over the vertices of a mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/paint/brush.h"
#include "core/paint/soup_reach.h"
#include "core/surface/painted_values.h"

namespace tactum {

/// Begins with the pointer going down, and ends with this object. The same places give the same bits.
///
/// Add, subtract and set work against the values before the stroke, by the greatest falloff of all dabs:
/// where a stroke crosses itself it does no more than once. Smooth goes on from what the dabs before have
/// left. Thread: any but real time, one at a time.
class VertexStroke {
public:
    /// `before`: as many values as the soup has positions, else all are 0. Numbers of the brush are brought
    /// into their ranges.
    VertexStroke(std::shared_ptr<const SoupReach> reach, PaintableSurfaces surfaces,
                 std::shared_ptr<const PaintedValues> before, const Brush& brush);

    /// The pointer is here now: paints the dabs that are due.
    void moveTo(const Dab& at);
    /// It has left the surface: there is no way from the last place to the next one.
    void lift() { path_ = StrokePath(brush_.radius); }
    /// One dab by itself.
    void paint(const Dab& dab);

    /// As they are now; a copy of all.
    std::shared_ptr<const PaintedValues> values() const {
        return std::make_shared<const PaintedValues>(now_);
    }
    const std::vector<float>& now() const { return now_; }

private:
    struct Touched {
        Index position;
        double distance; ///< m
    };

    void gather(const Dab& dab, double radius);
    void smooth(const Dab& dab);

    std::shared_ptr<const SoupReach> reach_;
    PaintableSurfaces surfaces_;
    Brush brush_;
    StrokePath path_;
    std::vector<float> before_, now_;
    std::vector<float> mask_;          ///< the greatest falloff so far
    std::vector<std::uint32_t> dabOf_; ///< the last dab that gathered a position
    std::uint32_t dab_ = 0;
    std::vector<Touched> touched_;
};

} // namespace tactum
