// An image read with the detail that the servo can render: cubics through every
// texel of a level, linear between two levels.
#pragma once

#include "core/surface/texture_field.h"
#include "core/surface/texture_image.h"

namespace tactum {

/// An image that lies more than this times denser one way than the other is blurred the other way.
inline constexpr int kMaxStretch = 8;
/// Places that are averaged at most where the image lies stretched on the surface.
inline constexpr int kMaxProbes = 2 * kMaxStretch;

/// Value and slope of the image there, the slope being exactly that of the interpolated value, and
/// continuous.
///
/// A circle of the diameter `smallestFeature` (m) on the surface covers an ellipse of texels. The level of
/// detail is that in which the short axis of the ellipse is one texel; along the long axis samples are
/// averaged under a raised cosine. So details vanish by their length in metres in every direction, however
/// the coordinates are stretched, mirrored or skewed, much as kept() says of the formulas: nothing is left
/// up to `smallestFeature`, and a slope is whole within 2 % from eight times of it. 0 asks for all
/// details. Thread: real time; at most 72 x kMaxProbes texels, 72 where the image is not stretched.
FlatSample sampleImage(const TextureImage& image, const FlatPoint& point, double smallestFeature) noexcept;

} // namespace tactum
