#include "core/surface/texture_feel.h"

#include <algorithm>
#include <cmath>

#include "core/surface/image_sample.h"
#include "core/surface/painted_sample.h"

namespace tactum {
FlatSample sampleFlat(const CompiledPattern& pattern, const FlatPoint& point,
                      double smallestFeature) noexcept {
    switch (pattern.source) {
    case TextureSource::Image:
        return sampleImage(*pattern.image, point, smallestFeature);
    case TextureSource::Noise:
        return noise(pattern.octaves, pattern.seed, point, smallestFeature);
    case TextureSource::Grooves:
        return grooves(pattern.wave, point, smallestFeature);
    case TextureSource::Dots:
        return dots(pattern.wave, point, smallestFeature);
    case TextureSource::Weave:
        return weave(point, smallestFeature);
    case TextureSource::Painted:
        break; // lies on no plane
    }
    return {};
}

namespace {

bool isPlace(const FlatPoint& point) noexcept {
    return std::abs(point.at.x()) < kMaxRepeats && std::abs(point.at.y()) < kMaxRepeats &&
           point.perMetre.allFinite();
}

TextureField sample(const CompiledPattern& pattern, const TexturePoint& point,
                    double smallestFeature) noexcept {
    if (pattern.source == TextureSource::Painted) return samplePainted(pattern, point);
    const FlatPoints points = flatPoints(pattern, point);
    TextureField field;
    for (std::size_t i = 0; i < std::size_t(points.count); ++i) {
        const FlatPoint& flat = points.point[i];
        if (!isPlace(flat)) return {};
        const FlatSample one = sampleFlat(pattern, flat, smallestFeature);
        field = field + TextureField{points.weight[i], points.weightGradient[i]} *
                            TextureField{one.value, Vec3(flat.perMetre.transpose() * one.slope)};
    }
    return field;
}

/// A layer of height begins at 0 m, one of anything else at the factor 1.
TextureField blended(const TextureField& below, const CompiledLayer& layer, const TextureField& value,
                     const TextureField& weight) noexcept {
    constexpr TextureField (*one)() = [] { return TextureField{1, Vec3::Zero()}; };
    const bool isHeight = layer.target == TextureTarget::Height;
    const TextureField change = layer.strength * value, amount = isHeight ? change : one() + change;
    switch (layer.blend) {
    case TextureBlend::Add:
        return below + weight * change;
    case TextureBlend::Subtract:
        return below - weight * change;
    case TextureBlend::Multiply:
        return below * mixed(one(), isHeight ? value : amount, weight);
    case TextureBlend::Maximum:
        return mixed(below, amount.value > below.value ? amount : below, weight);
    case TextureBlend::Minimum:
        return mixed(below, amount.value < below.value ? amount : below, weight);
    case TextureBlend::Replace:
        return mixed(below, amount, weight);
    }
    return below;
}

Vec3 bounded(const Vec3& slope) noexcept {
    const double steepness = slope.norm();
    if (!std::isfinite(steepness)) return Vec3::Zero();
    return steepness > kSteepestSlope ? Vec3(slope * (kSteepestSlope / steepness)) : slope;
}

double finiteOr(double value, double otherwise) noexcept {
    return std::isfinite(value) ? value : otherwise;
}

} // namespace

TextureFeel feel(const TextureStack& stack, const TexturePoint& point, double smallestFeature) noexcept {
    TextureFeel result;
    std::array<TextureField, kTextureTargets.size()> sum; // by target
    for (std::size_t i = 1; i < sum.size(); ++i)
        sum[i].value = 1;
    for (const CompiledLayer& layer : stack.layers) {
        const TextureField value = sample(layer.pattern, point, smallestFeature);
        TextureField weight{layer.opacity, Vec3::Zero()};
        if (layer.mask) weight = layer.opacity * sample(*layer.mask, point, smallestFeature);
        TextureField& below = sum[std::size_t(layer.target)];
        if (layer.ownPlane)
            result.ownSlopes[std::size_t(result.ownPlanes++)] =
                bounded((layer.strength * value * weight).gradient);
        else
            below = blended(below, layer, value, weight);
    }
    result.height = finiteOr(sum[0].value, 0);
    result.slope = bounded(sum[0].gradient);
    result.staticFriction = finiteOr(sum[std::size_t(TextureTarget::StaticFriction)].value, 1);
    result.dynamicFriction = finiteOr(sum[std::size_t(TextureTarget::DynamicFriction)].value, 1);
    result.viscosity = finiteOr(sum[std::size_t(TextureTarget::Viscosity)].value, 1);
    result.stiffness = finiteOr(sum[std::size_t(TextureTarget::Stiffness)].value, 1);
    return result;
}

Material modulated(const Material& material, const TextureFeel& feel) noexcept {
    Material result = material;
    result.stiffness = kStiffness.clamped(material.stiffness * feel.stiffness);
    result.staticFriction = kStaticFriction.clamped(material.staticFriction * feel.staticFriction);
    result.dynamicFriction = kDynamicFriction.clamped(material.dynamicFriction * feel.dynamicFriction);
    result.dynamicFriction = std::min(result.dynamicFriction, result.staticFriction);
    result.viscosity = kViscosity.clamped(material.viscosity * feel.viscosity);
    return result;
}

} // namespace tactum
