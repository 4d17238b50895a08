#include "ui/document/preset_picture.h"

#include <algorithm>
#include <cmath>

#include "core/surface/texture_feel.h"

namespace tactum {

namespace {

constexpr double kRadius = 0.008;  // m: of the ball, so that millimetres are seen
constexpr double kSlippery = 0.25; // static friction from which on nothing shines any more

/// On a ball there are no texture coordinates.
std::vector<TextureLayer> onBall(std::vector<TextureLayer> layers) {
    const auto free = [](TexturePattern& pattern) {
        if (usesUvs(pattern)) pattern.mapping = TextureMapping::Triplanar;
    };
    for (TextureLayer& layer : layers) {
        free(layer.pattern);
        if (layer.mask) free(*layer.mask);
    }
    return layers;
}

std::shared_ptr<const TextureStack> stackOf(const Preset& preset) {
    if (!preset.layers || preset.layers->empty()) return nullptr;
    TriangleSoup soup;
    soup.positions = {Vec3::Zero(), kRadius * Vec3::UnitX(), kRadius * Vec3::UnitY()};
    soup.triangles = {{0, 1, 2}};
    soup.surfaceOf = {0};
    return compileTextures(onBall(*preset.layers), std::make_shared<const TriangleSoup>(std::move(soup)), 0);
}

/// The slope that is seen: of all heights, those with a plane of their own included.
Vec3 slopeAt(const TextureStack* stack, const Vec3& normal, double pixel) {
    if (!stack) return Vec3::Zero();
    TexturePoint point;
    point.normal = normal;
    point.position = kRadius * normal;
    const TextureFeel felt = feel(*stack, point, pixel);
    Vec3 slope = felt.slope;
    for (int i = 0; i < felt.ownPlanes; ++i)
        slope += felt.ownSlopes[std::size_t(i)];
    return slope;
}

/// How much a slippery surface shines.
double shineOf(const Preset& preset) {
    double shine = 0.35;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        if (kMaterialFields[i].parameter == &kStaticFriction && preset.values[i])
            shine = std::clamp(1.1 - *preset.values[i] / (4 * kSlippery), 0.1, 1.0);
    return shine;
}

QRgb pixelOf(const Vec3& linear, double coverage) {
    const auto shown = [&](double c) {
        return int(std::lround(255 * std::pow(std::clamp(c, 0.0, 1.0), 1 / 2.2)));
    };
    return qRgba(shown(linear.x()), shown(linear.y()), shown(linear.z()), int(std::lround(255 * coverage)));
}

} // namespace

QImage presetPicture(const Preset& preset, int side) {
    const auto stack = stackOf(preset);
    const Vec3 own = preset.colour.value_or(Vec3::Constant(0.5));
    const double shine = shineOf(preset), pixel = 2 * kRadius / side;
    const Vec3 light = Vec3(-0.45, 0.6, 0.66).normalized();
    const Vec3 half = (light + Vec3::UnitZ()).normalized();
    QImage picture(side, side, QImage::Format_ARGB32);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = 2 * (x + 0.5) / side - 1, v = 1 - 2 * (y + 0.5) / side;
            const double r = std::hypot(u, v);
            const double coverage = std::clamp((1 - r) * side / 2 + 0.5, 0.0, 1.0); // a soft rim
            const double inside = std::min(1.0, 0.999 / std::max(r, 1e-9));
            Vec3 normal(u * inside, v * inside, 0);
            normal.z() = std::sqrt(std::max(0.0, 1 - normal.squaredNorm()));
            const Vec3 bent = bumpedNormal(normal, slopeAt(stack.get(), normal, pixel));
            const double diffuse = 0.22 + 0.9 * std::max(0.0, bent.dot(light));
            const double gloss = 0.5 * shine * std::pow(std::max(0.0, bent.dot(half)), 30);
            const Vec3 colour = diffuse * own + Vec3::Constant(gloss + 0.015);
            picture.setPixel(x, y, coverage > 0 ? pixelOf(colour, coverage) : 0);
        }
    return picture;
}

} // namespace tactum
