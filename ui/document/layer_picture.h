// Texture layers as pictures of flat ground, computed by the functions that feel them.
#pragma once

#include <memory>
#include <vector>

#include <QImage>

#include "core/base/progress.h"
#include "core/surface/texture_feel.h"
#include "ui/document/layer_edits.h"

namespace tactum {

/// What a layer's target is at a place: m of height, else the factor of the material's value.
double valueOf(const TextureFeel& feel, TextureTarget target);

/// Each layer that has a plane of its own, which joins no blend, as one that is added to the others: what is
/// seen of a height is the sum.
TextureLayers withoutOwnPlanes(TextureLayers layers);

/// The pattern alone, light where it is high: a square of `pixels`. Of an image one repeat, of the others a
/// few; how it lies on the model makes no difference but for its rotation. Null for what is painted, which
/// lies on no plane, and for a missing image. Some milliseconds. Thread: ui.
QImage patternPicture(const TexturePattern& pattern, int pixels);

/// A square of flat ground with its layers, row 0 at the upper edge.
struct FlatGround {
    int pixels = 0;
    double side = 0; ///< m
    TextureTarget target = TextureTarget::Height;
    std::vector<double> values; ///< of the target, row by row
    double low = 0, high = 0;
    QImage picture; ///< of a height its relief, else its values from dark to light

    /// At a place from 0 to 1, from the left and from the upper edge.
    double at(double x, double y) const;
};

struct FlatWish {
    int pixels = 96;
    double side = 0.03;                           ///< m
    TextureTarget target = TextureTarget::Height; ///< what is seen
    double metresPerUv = 0;                       ///< of the surface; 0 where it has no coordinates
};

/// Patterns lie on the ground as on a model whose mapping is unrolled there; what is painted counts as
/// painted everywhere. Details below two pixels are left out. Thread: any but real time. Empty when
/// cancelled.
FlatGround flatGround(const TextureLayers& layers, const FlatWish& wish, const Progress& progress = {});

} // namespace tactum
