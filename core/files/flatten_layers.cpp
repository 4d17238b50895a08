#include "core/files/flatten_layers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/surface/texture_feel.h"

namespace tactum {
namespace {

using Eigen::Vector2d;
using ValueOf = std::function<double(const TextureFeel&)>;
using IsWanted = std::function<bool(TextureTarget)>;

bool isOnUvs(const CompiledLayer& layer) {
    return usesUvs(layer.pattern) && (!layer.mask || usesUvs(*layer.mask));
}

/// Texels for each repeat that show the finest detail of a pattern.
Vector2d texelsPerRepeat(const CompiledPattern& pattern) {
    constexpr double kTexelsPerWave = 8;
    switch (pattern.source) {
    case TextureSource::Image:
        return {pattern.image->width(), pattern.image->height()};
    case TextureSource::Noise:
        return Vector2d::Constant(kTexelsPerWave * std::ldexp(1.0, pattern.octaves - 1));
    case TextureSource::Weave:
        return Vector2d::Constant(kTexelsPerWave * 3); // its third harmonic
    case TextureSource::Grooves:
        return {kTexelsPerWave * std::max(pattern.wave.harmonics, 1), 0}; // the same all along
    case TextureSource::Dots:
        return Vector2d::Constant(kTexelsPerWave * std::max(pattern.wave.harmonics, 1));
    case TextureSource::Painted:
        break; // has no repeats: see paintedTexels()
    }
    return Vector2d::Zero();
}

/// Texels for each metre that show what is painted: four from corner to corner of a triangle of mean size.
double paintedTexels(const TriangleSoup& soup, Index surface) {
    double area = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (soup.surfaceOf[i] != surface) continue;
        const auto& t = soup.triangles[i];
        const Vec3& a = soup.positions[t[0]];
        const double twice = (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).norm();
        area += twice / 2;
        count += twice > 0;
    }
    constexpr double kTexelsPerEdge = 4;
    return count > 0 ? kTexelsPerEdge / std::sqrt(2 * area / double(count)) : 0;
}

bool isWhole(double x) {
    return std::abs(x - std::round(x)) < 1e-6;
}

/// Texels for each unit of u and of v. An image whose texels are not those of the picture needs twice as
/// many.
Vector2d density(const CompiledPattern& pattern, double metresPerUv) {
    const Vector2d texels = texelsPerRepeat(pattern);
    if (!usesUvs(pattern)) // it may lie on the coordinates in any direction
        return Vector2d::Constant((texels.asDiagonal() * pattern.repeatsPerMetre).norm() * metresPerUv);
    const Eigen::Matrix2d perUv = texels.asDiagonal() * pattern.repeatsPerMetre * pattern.metresPerUv;
    const Vector2d shift = texels.asDiagonal() * pattern.repeatsPerMetre * pattern.offset;
    const bool isStraight = std::abs(perUv(0, 1)) + std::abs(perUv(1, 0)) < 1e-9 * perUv.norm();
    const bool isAligned = isStraight && isWhole(shift.x()) && isWhole(shift.y());
    const double more = pattern.source == TextureSource::Image && !isAligned ? 2 : 1;
    return more * Vector2d(perUv.col(0).norm(), perUv.col(1).norm());
}

std::string millimetres(double metres) {
    std::string text;
    appendNumber(text, std::round(metres * 1e6) / 1e3);
    return text + " mm";
}

/// Evaluates the stack of one surface on a canvas.
class Flattener {
public:
    Flattener(const SceneObject& object, Index surface, const Flattening& how, const IsWanted& isWanted,
              ValueOf valueOf)
        : soup_(*object.geometry), surface_(surface), how_(how), valueOf_(std::move(valueOf)) {
        if (const auto compiled = compileTextures(object.surfaces[surface].layers, object.geometry, surface))
            takeLayers(*compiled, isWanted);
    }

    FlatPicture picture() {
        if (!stack_.layers.empty() && soup_.cornerUvs.empty())
            leaveOutUnmapped("the mesh has no texture coordinates");
        if (stack_.layers.empty()) return constant();
        chooseCanvas();
        if (needsCover() && !findCover()) return picture(); // once more, without the layers that need it
        if (smallestFeature_ > 0) loseDetail();
        if (!how_.progress.isCancelled()) evaluate();
        return finish();
    }

private:
    void takeLayers(const TextureStack& compiled, const IsWanted& isWanted) {
        std::size_t added = 0;
        for (const bool ownPlane : {false, true})
            for (CompiledLayer layer : compiled.layers) {
                if (!isWanted(layer.target) || layer.ownPlane != ownPlane) continue;
                if (ownPlane) layer.blend = TextureBlend::Add, layer.ownPlane = false, ++added;
                stack_.layers.push_back(std::move(layer));
            }
        if (added > 0) lose("layers with a plane of their own are added to the height of the others");
    }

    bool needsCover() const {
        return !std::ranges::all_of(stack_.layers, [](auto& l) { return isOnUvs(l); });
    }

    void leaveOutUnmapped(const std::string& reason) {
        const auto count = std::erase_if(stack_.layers, [](auto& layer) { return !isOnUvs(layer); });
        lose((count == 1 ? "1 layer that needs" : std::to_string(count) + " layers that need") +
             " no texture coordinates left out: " + reason);
    }

    FlatPicture constant() {
        FlatPicture picture;
        picture.low = picture.high = picture.mean = valueOf_(TextureFeel{});
        picture.lost = std::move(lost_);
        return picture;
    }

    void chooseCanvas() {
        canvas_ = uvRectangleOf(soup_, surface_);
        metresPerUv_ = metresPerUvOf(soup_, surface_);
        Vector2d most = Vector2d::Zero();
        for (const CompiledLayer& layer : stack_.layers) {
            most = most.cwiseMax(densityOf(layer.pattern));
            if (layer.mask) most = most.cwiseMax(densityOf(*layer.mask));
        }
        wanted_ = (most.cwiseProduct(canvas_.size).array() - 1e-6).ceil().max(1.0).min(1e9);
        const Vector2d sides = wanted_.cwiseMin(double(how_.largestSide));
        canvas_.width = int(sides.x()), canvas_.height = int(sides.y());
        smallestFeature_ = 0;
        for (int i = 0; i < 2; ++i) // grooves need one row alone, which is no lack of detail
            if (sides[i] < wanted_[i])
                smallestFeature_ = std::max(smallestFeature_, metresPerUv_ * canvas_.size[i] / sides[i]);
    }

    Vector2d densityOf(const CompiledPattern& pattern) const {
        if (pattern.source != TextureSource::Painted) return density(pattern, metresPerUv_);
        return Vector2d::Constant(metresPerUv_ * paintedTexels(soup_, surface_));
    }

    void loseDetail() {
        lose("detail finer than " + millimetres(2 * smallestFeature_) + ": the picture would need " +
             std::to_string(std::llround(wanted_.x())) + " x " + std::to_string(std::llround(wanted_.y())) +
             " texels and has " + std::to_string(canvas_.width) + " x " + std::to_string(canvas_.height));
    }

    /// False when the layers that needed it had to go.
    bool findCover() {
        cover_ = coverOf(canvas_, soup_, surface_, partOf(how_.progress, 0, kCoverPart));
        if (cover_.withoutArea > 0)
            lose("triangles without an area in texture coordinates show nothing: " +
                 std::to_string(cover_.withoutArea));
        if (cover_.overlaps == 0) return true;
        cover_ = {};
        leaveOutUnmapped("texture coordinates of different places overlap");
        return false;
    }

    void evaluate() {
        values_.resize(canvas_.texels());
        const Progress all = partOf(how_.progress, needsCover() ? kCoverPart : 0, 1);
        parallelFor(values_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
            // The first part is on the thread of the caller, and takes as long as each of the others.
            const Progress mine = part == 0 ? all : Progress{{}, all.cancelled};
            constexpr std::size_t kLook = 2048; // texels: some milliseconds
            ProgressMeter meter(mine, end - begin, kLook);
            for (std::size_t i = begin; i < end && meter.goesOn(i - begin); ++i)
                values_[i] = valueAt(i);
        });
    }

    double valueAt(std::size_t texel) const {
        const auto width = std::size_t(canvas_.width);
        TexturePoint point;
        point.uv = canvas_.uvAt(int(texel % width), int(texel / width));
        if (cover_.triangleOf.empty()) {
            // Only coordinates count; for the filter they lie on a plane of the average scale.
            if (metresPerUv_ > 0) point.uvGradient = Eigen::Matrix<double, 2, 3>::Identity() / metresPerUv_;
        } else if (cover_.triangleOf[texel] == UvCover::kNothing) {
            return kBeside;
        } else {
            placeOn(cover_.triangleOf[texel], point);
        }
        return valueOf_(feel(stack_, point, smallestFeature_));
    }

    void placeOn(Index index, TexturePoint& point) const {
        const auto& t = soup_.triangles[index];
        const Triangle triangle{soup_.positions[t[0]], soup_.positions[t[1]], soup_.positions[t[2]]};
        CornerUvs uvs;
        for (std::size_t k = 0; k < 3; ++k)
            uvs[k] = soup_.cornerUvs[3 * std::size_t(index) + k].cast<double>();
        const Vec3 weights = uvWeights(soup_, index, point.uv);
        point.position = weights[0] * triangle.a + weights[1] * triangle.b + weights[2] * triangle.c;
        point.normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
        point.uvGradient = uvGradientOf(triangle, uvs);
        point.triangle = index;
        point.weights = weights;
    }

    FlatPicture finish() {
        FlatPicture picture = constant(); // what is beside the surface
        const double beside = picture.low;
        std::size_t count = 0;
        double sum = 0, low = 1e300, high = -1e300;
        for (const double value : values_)
            if (!std::isnan(value))
                ++count, sum += value, low = std::min(low, value), high = std::max(high, value);
        if (count == 0 || how_.progress.isCancelled()) return picture;
        picture.canvas = canvas_;
        picture.low = low, picture.high = high, picture.mean = sum / double(count);
        if (high == low) return picture;
        std::vector<std::uint16_t> texels;
        texels.reserve(values_.size());
        for (const double value : values_) {
            const double shown = std::isnan(value) ? std::clamp(beside, low, high) : value;
            texels.push_back(std::uint16_t(std::lround(65535 * ((shown - low) / (high - low)))));
        }
        if (how_.progress.isCancelled()) return picture;
        picture.image = std::make_shared<const TextureImage>(canvas_.width, canvas_.height, std::move(texels),
                                                             "flattened");
        return picture;
    }

    void lose(std::string sentence) { lost_.push_back(std::move(sentence)); }

    static constexpr double kCoverPart = 0.25; ///< of the time, where a cover is needed
    static constexpr double kBeside =
        std::numeric_limits<double>::quiet_NaN(); ///< value of a texel off the surface

    const TriangleSoup& soup_;
    const Index surface_;
    const Flattening& how_;
    const ValueOf valueOf_;
    TextureStack stack_;
    UvCanvas canvas_;
    UvCover cover_;
    Vector2d wanted_ = Vector2d::Ones(); ///< texels to show every detail
    double metresPerUv_ = 0;
    double smallestFeature_ = 0; ///< m: what a texel of a capped picture cannot show
    std::vector<double> values_;
    std::vector<std::string> lost_;
};

/// Whether layers of a target change a value of the material.
bool counts(TextureTarget target, double Material::*value) {
    if (value == &Material::stiffness) return target == TextureTarget::Stiffness;
    if (value == &Material::viscosity) return target == TextureTarget::Viscosity;
    if (value == &Material::staticFriction) return target == TextureTarget::StaticFriction;
    // Dynamic friction is never felt above static friction.
    return value == &Material::dynamicFriction &&
           (target == TextureTarget::DynamicFriction || target == TextureTarget::StaticFriction);
}

} // namespace

FlatPicture flattenHeight(const SceneObject& object, Index surface, const Flattening& how) {
    return Flattener(
               object, surface, how, [](TextureTarget target) { return target == TextureTarget::Height; },
               [](const TextureFeel& felt) { return felt.height; })
        .picture();
}

FlatPicture flattenFactor(const SceneObject& object, Index surface, TextureTarget wanted,
                          const Flattening& how) {
    return Flattener(
               object, surface, how, [wanted](TextureTarget target) { return target == wanted; },
               [wanted](const TextureFeel& felt) {
                   switch (wanted) {
                   case TextureTarget::StaticFriction:
                       return felt.staticFriction;
                   case TextureTarget::DynamicFriction:
                       return felt.dynamicFriction;
                   case TextureTarget::Viscosity:
                       return felt.viscosity;
                   case TextureTarget::Stiffness:
                       return felt.stiffness;
                   default:
                       return felt.height;
                   }
               })
        .picture();
}

FlatPicture flattenFelt(const SceneObject& object, Index surface, double Material::*value,
                        const Flattening& how) {
    const Material& material = object.surfaces[surface].material;
    return Flattener(
               object, surface, how, [value](TextureTarget target) { return counts(target, value); },
               [&material, value](const TextureFeel& felt) { return modulated(material, felt).*value; })
        .picture();
}

} // namespace tactum
