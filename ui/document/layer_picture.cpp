#include "ui/document/layer_picture.h"

#include <algorithm>
#include <cmath>

#include "core/surface/pattern_picture.h"

namespace tactum {

namespace {

constexpr double kFinest = 2; // pixels
// A relief that is as steep as this on average needs no exaggeration to be seen.
constexpr double kSeenSlope = 0.5;
constexpr double kMaxExaggeration = 40;

/// A square in the plane z = 0 about the origin; `metresPerUv`: what a unit of its coordinates is long.
std::shared_ptr<const TriangleSoup> squareOf(double side, double metresPerUv) {
    auto soup = std::make_shared<TriangleSoup>();
    const double h = 0.5 * side;
    soup->positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    soup->triangles = {{0, 1, 2}, {0, 2, 3}};
    soup->surfaceOf = {0, 0};
    for (const auto& corners : soup->triangles)
        for (const Index corner : corners)
            soup->cornerUvs.push_back((soup->positions[corner].head<2>() / metresPerUv).cast<float>());
    return soup;
}

/// The pattern on flat ground, where every mapping without coordinates is the same.
TexturePattern unrolled(TexturePattern pattern) {
    if (!usesUvs(pattern)) {
        pattern.mapping = TextureMapping::Planar;
        pattern.frame = {};
    }
    if (pattern.source == TextureSource::Painted)
        pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(4, 1.0F));
    return pattern;
}

TextureLayers unrolled(TextureLayers layers) {
    for (TextureLayer& layer : layers) {
        layer.pattern = unrolled(layer.pattern);
        if (layer.mask) layer.mask = unrolled(*layer.mask);
    }
    return layers;
}

/// Samples a stack over a square about the origin.
class Ground {
public:
    Ground(const TextureLayers& layers, double side, int pixels, double metresPerUv)
        : side_(side), pixels_(pixels), metresPerUv_(metresPerUv > 0 ? metresPerUv : side),
          stack_(compileTextures(unrolled(layers), squareOf(side, metresPerUv_), 0)) {}

    explicit operator bool() const { return stack_ != nullptr; }

    /// At the centre of a pixel, from the upper left corner.
    TextureFeel at(int column, int row) const {
        TexturePoint point;
        const double pixel = side_ / pixels_;
        point.position = {(column + 0.5) * pixel - 0.5 * side_, 0.5 * side_ - (row + 0.5) * pixel, 0};
        point.uv = point.position.head<2>() / metresPerUv_;
        point.uvGradient(0, 0) = point.uvGradient(1, 1) = 1 / metresPerUv_;
        return feel(*stack_, point, kFinest * pixel);
    }

private:
    double side_;
    int pixels_;
    double metresPerUv_;
    std::shared_ptr<const TextureStack> stack_;
};

QRgb grey(double part) {
    const int value = std::clamp(int(std::lround(255 * part)), 0, 255);
    return qRgb(value, value, value);
}

/// Lit from the upper left, steeper than it is where it is hardly seen.
QImage reliefOf(const std::vector<Vec3>& slopes, int pixels) {
    double squares = 0;
    for (const Vec3& slope : slopes)
        squares += slope.squaredNorm();
    const double steepness = std::sqrt(squares / double(slopes.size()));
    const double gain = steepness > 0 ? std::clamp(kSeenSlope / steepness, 1.0, kMaxExaggeration) : 1.0;
    const Vec3 light = Vec3(-0.5, 0.6, 0.75).normalized();
    QImage picture(pixels, pixels, QImage::Format_RGB32);
    for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column) {
            const Vec3& slope = slopes[std::size_t(row * pixels + column)];
            const double lit = (Vec3::UnitZ() - gain * slope).normalized().dot(light);
            picture.setPixel(column, row, grey(0.14 + 0.68 * std::max(lit, 0.0)));
        }
    return picture;
}

QImage mapOf(const FlatGround& ground) {
    QImage picture(ground.pixels, ground.pixels, QImage::Format_RGB32);
    const double range = ground.high - ground.low;
    for (int row = 0; row < ground.pixels; ++row)
        for (int column = 0; column < ground.pixels; ++column) {
            const double value = ground.values[std::size_t(row * ground.pixels + column)];
            picture.setPixel(column, row,
                             grey(range > 1e-9 ? 0.12 + 0.76 * (value - ground.low) / range : 0.5));
        }
    return picture;
}

} // namespace

double valueOf(const TextureFeel& feel, TextureTarget target) {
    switch (target) {
    case TextureTarget::Height:
        return feel.height;
    case TextureTarget::StaticFriction:
        return feel.staticFriction;
    case TextureTarget::DynamicFriction:
        return feel.dynamicFriction;
    case TextureTarget::Viscosity:
        return feel.viscosity;
    case TextureTarget::Stiffness:
        return feel.stiffness;
    }
    return 0;
}

TextureLayers withoutOwnPlanes(TextureLayers layers) {
    const auto isOwn = [](const TextureLayer& l) { return l.ownPlane && l.target == TextureTarget::Height; };
    std::stable_partition(layers.begin(), layers.end(), [&](const TextureLayer& l) { return !isOwn(l); });
    for (TextureLayer& layer : layers)
        if (isOwn(layer)) {
            layer.ownPlane = false;
            layer.blend = TextureBlend::Add;
        }
    return layers;
}

QImage patternPicture(const TexturePattern& pattern, int pixels) {
    const PatternPicture flat = patternOnFlatGround(pattern, pixels);
    if (flat.values.empty()) return {};
    QImage picture(pixels, pixels, QImage::Format_RGB32);
    for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column)
            picture.setPixel(column, row, grey(flat.values[std::size_t(row * pixels + column)]));
    return picture;
}

double FlatGround::at(double x, double y) const {
    if (values.empty()) return 0;
    const auto pixel = [&](double part) { return std::clamp(int(part * pixels), 0, pixels - 1); };
    return values[std::size_t(pixel(y) * pixels + pixel(x))];
}

FlatGround flatGround(const TextureLayers& layers, const FlatWish& wish, const Progress& progress) {
    FlatGround result{wish.pixels, wish.side, wish.target, {}, 1e300, -1e300, {}};
    const Ground ground(withoutOwnPlanes(layers), wish.side, wish.pixels, wish.metresPerUv);
    std::vector<Vec3> slopes;
    for (int row = 0; row < wish.pixels; ++row) {
        if (progress.isCancelled()) return {};
        for (int column = 0; column < wish.pixels; ++column) {
            const TextureFeel feel = ground ? ground.at(column, row) : TextureFeel{};
            const double value = valueOf(feel, wish.target);
            result.values.push_back(value);
            result.low = std::min(result.low, value);
            result.high = std::max(result.high, value);
            slopes.push_back(feel.slope);
        }
    }
    result.picture = wish.target == TextureTarget::Height ? reliefOf(slopes, wish.pixels) : mapOf(result);
    return result;
}

} // namespace tactum
