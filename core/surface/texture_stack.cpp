#include "core/surface/texture_stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/realtime.h"

namespace tactum {
namespace {

TexturePattern madeSafe(TexturePattern pattern) {
    for (const PatternField& field : kPatternFields)
        pattern.*field.value = field.parameter->clamped(pattern.*field.value);
    return pattern;
}

void placeFrame(CompiledPattern& compiled, const TexturePattern& pattern) {
    const double norm = pattern.frame.rotation.norm();
    if (!std::isfinite(norm) || norm < 1e-6 || !pattern.frame.translation.allFinite()) return;
    compiled.axes = pattern.frame.rotation.normalized().toRotationMatrix().transpose();
    compiled.origin = pattern.frame.translation;
}

/// Repeats per metre: the pattern turned by `rotation`, a repeat `size` wide.
Eigen::Matrix2d repeatsPerMetre(const TexturePattern& pattern) {
    const double c = std::cos(pattern.rotation), s = std::sin(pattern.rotation);
    Eigen::Matrix2d turn;
    turn << c, s, -s, c;
    double proportion = 1; // of height to width; the unit square is filled whatever the image's proportions
    if (pattern.source == TextureSource::Image && pattern.mapping != TextureMapping::UvUnit)
        proportion = double(pattern.image->height()) / pattern.image->width();
    return Eigen::Vector2d(1 / pattern.size, 1 / (pattern.size * proportion)).asDiagonal() * turn;
}

double metresPerRadian(const TexturePattern& pattern) {
    const double turn = 2 * std::numbers::pi;
    const double repeats = std::max(1.0, std::round(turn * pattern.radius / pattern.size));
    return repeats * pattern.size / turn;
}

using Stacks = std::span<const std::shared_ptr<const TextureStack>>;

using SharedValues = std::shared_ptr<const PaintedValues>;

/// What stacks of the same mesh and surface know of what is painted: its slopes, if they are of the same
/// values, and the ground that any are made on.
struct KnownPaint {
    std::shared_ptr<const PaintedSlopes> slopes;
    std::shared_ptr<const PaintedGround> ground;
};

KnownPaint knownPaint(const SharedValues& values, const TriangleSoup* soup, Index surface, Stacks known) {
    KnownPaint found;
    const auto look = [&](const CompiledPattern& other) {
        if (!other.slopes) return;
        found.ground = other.slopes->ground();
        if (other.painted == values) found.slopes = other.slopes;
    };
    for (const auto& before : known) {
        if (!before || before->surface != surface || before->soup.get() != soup) continue;
        for (const CompiledLayer& layer : before->layers) {
            look(layer.pattern);
            if (layer.mask) look(*layer.mask);
        }
    }
    return found;
}

std::shared_ptr<const PaintedSlopes> slopesOf(const CompiledPattern& pattern, Index surface, Stacks known) {
    auto found = knownPaint(pattern.painted, pattern.soup.get(), surface, known);
    if (found.slopes) return found.slopes;
    if (!found.ground) found.ground = std::make_shared<const PaintedGround>(pattern.soup, surface);
    return std::make_shared<const PaintedSlopes>(*pattern.soup, std::move(found.ground), *pattern.painted);
}

bool isPaintedAnew(const TexturePattern& pattern, const TriangleSoup& soup, Index surface, Stacks known) {
    const SharedValues& values = pattern.painted.values;
    return pattern.source == TextureSource::Painted && values && values->size() == soup.positions.size() &&
           !knownPaint(values, &soup, surface, known).slopes;
}

/// Empty when it cannot be felt. `stack`: for its mesh.
std::optional<CompiledPattern> compiled(const TexturePattern& wanted, const TextureStack& stack,
                                        Stacks known) {
    const TexturePattern pattern = madeSafe(wanted);
    const double metresPerUv = stack.metresPerUv;
    if (pattern.source == TextureSource::Image && !pattern.image) return std::nullopt;
    if (usesUvs(pattern) && !(metresPerUv > 0)) return std::nullopt;
    CompiledPattern result;
    if (pattern.source == TextureSource::Painted) {
        result.painted = pattern.painted.values;
        result.soup = stack.soup;
        if (!result.painted || result.painted->size() != stack.soup->positions.size()) return std::nullopt;
        result.slopes = slopesOf(result, stack.surface, known);
    }
    result.source = pattern.source;
    result.mapping = pattern.mapping;
    result.image = pattern.image;
    result.metresPerUv = pattern.mapping == TextureMapping::UvUnit ? pattern.size : metresPerUv;
    placeFrame(result, pattern);
    result.radius = pattern.radius;
    result.metresPerRadian = metresPerRadian(pattern);
    result.offset = {pattern.offsetU, pattern.offsetV};
    result.repeatsPerMetre = repeatsPerMetre(pattern);
    result.wave = waveShape(pattern.fill, pattern.softness);
    result.octaves = int(std::lround(pattern.octaves));
    result.seed = 64 * std::uint32_t(std::lround(pattern.seed)); // octaves count on from it
    return result;
}

std::optional<CompiledLayer> compiled(const TextureLayer& layer, const TextureStack& stack, Stacks known) {
    if (!layer.enabled) return std::nullopt;
    const auto pattern = compiled(layer.pattern, stack, known);
    if (!pattern) return std::nullopt;
    CompiledLayer result;
    result.pattern = *pattern;
    if (layer.mask) {
        result.mask = compiled(*layer.mask, stack, known);
        if (!result.mask) return std::nullopt; // a layer without its mask would be felt everywhere
    }
    result.target = layer.target;
    result.blend = layer.blend;
    result.strength = strengthParameter(layer.target).clamped(layer.strength);
    result.opacity = kTextureOpacity.clamped(layer.opacity);
    result.ownPlane = layer.ownPlane && layer.target == TextureTarget::Height;
    return result;
}

bool isTriplanar(const CompiledPattern& pattern) {
    return pattern.source != TextureSource::Painted && pattern.mapping == TextureMapping::Triplanar;
}

bool asksForUvs(const TextureLayer& layer) {
    return layer.enabled && (usesUvs(layer.pattern) || (layer.mask && usesUvs(*layer.mask)));
}

double knownMetresPerUv(const TextureStack& wanted, Stacks known) {
    for (const auto& stack : known)
        if (stack && stack->soup == wanted.soup && stack->surface == wanted.surface &&
            stack->metresPerUv >= 0)
            return stack->metresPerUv;
    return metresPerUvOf(*wanted.soup, wanted.surface);
}

void limitOwnPlanes(std::vector<CompiledLayer>& layers) {
    int planes = 0;
    for (CompiledLayer& layer : layers)
        layer.ownPlane = layer.ownPlane && ++planes <= kMaxOwnPlanes;
}

} // namespace

std::shared_ptr<const TextureStack>
compileTextures(const std::vector<TextureLayer>& layers, const std::shared_ptr<const TriangleSoup>& soup,
                Index surface, std::span<const std::shared_ptr<const TextureStack>> known) {
    assertNotRealtime();
    if (layers.empty() || !soup) return nullptr;
    for (const auto& stack : known)
        if (stack && stack->soup == soup && stack->surface == surface && stack->source == layers)
            return stack;
    auto stack = std::make_shared<TextureStack>();
    stack->source = layers;
    stack->soup = soup;
    stack->surface = surface;
    if (std::any_of(layers.begin(), layers.end(), asksForUvs))
        stack->metresPerUv = knownMetresPerUv(*stack, known);
    for (const TextureLayer& layer : layers)
        if (auto ready = compiled(layer, *stack, known);
            ready && stack->layers.size() < std::size_t(kMaxTextureLayers))
            stack->layers.push_back(std::move(*ready));
    limitOwnPlanes(stack->layers);
    stack->asksForTurning = std::ranges::any_of(stack->layers, [](const CompiledLayer& layer) {
        return isTriplanar(layer.pattern) || (layer.mask && isTriplanar(*layer.mask));
    });
    if (stack->layers.empty()) return nullptr;
    return stack;
}

bool arePaintedAnew(const std::vector<TextureLayer>& layers, const TriangleSoup& soup, Index surface,
                    Stacks known) {
    return std::ranges::any_of(layers, [&](const TextureLayer& layer) {
        return layer.enabled && (isPaintedAnew(layer.pattern, soup, surface, known) ||
                                 (layer.mask && isPaintedAnew(*layer.mask, soup, surface, known)));
    });
}

double metresPerUvOf(const TriangleSoup& soup, Index surface) {
    assertNotRealtime();
    if (soup.cornerUvs.empty()) return 0;
    double area = 0, uvArea = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (soup.surfaceOf[i] != surface) continue;
        const auto& t = soup.triangles[i];
        const Vec3& a = soup.positions[t[0]];
        area += (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).norm();
        const Eigen::Vector2d o = soup.cornerUvs[3 * i].cast<double>(),
                              u = soup.cornerUvs[3 * i + 1].cast<double>() - o,
                              v = soup.cornerUvs[3 * i + 2].cast<double>() - o;
        uvArea += std::abs(u.x() * v.y() - u.y() * v.x());
    }
    const double scale = std::sqrt(area / uvArea);
    return std::isfinite(scale) ? scale : 0;
}

} // namespace tactum
