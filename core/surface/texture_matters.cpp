#include "core/surface/texture_matters.h"

namespace tactum {

bool matters(const PatternField& field, const TexturePattern& pattern) {
    using From = TextureSource;
    const auto is = [&](const Parameter& parameter) { return field.parameter == &parameter; };
    if (pattern.source == From::Painted) return false;
    // One repeat fills the unit square whatever its size.
    if (is(kTextureSize)) return pattern.mapping != TextureMapping::UvUnit;
    if (is(kTextureRadius))
        return pattern.mapping == TextureMapping::Cylindrical || pattern.mapping == TextureMapping::Spherical;
    if (is(kTextureFill) || is(kTextureSoftness))
        return pattern.source == From::Grooves || pattern.source == From::Dots;
    if (is(kTextureOctaves) || is(kTextureSeed)) return pattern.source == From::Noise;
    return true;
}

bool strengthMatters(const TextureLayer& layer) {
    return layer.target != TextureTarget::Height || layer.blend != TextureBlend::Multiply || layer.ownPlane;
}

} // namespace tactum
