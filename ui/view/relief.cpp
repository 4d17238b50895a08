#include "ui/view/relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface/texture_feel.h"

namespace tactum {

namespace {

/// Places at which the surface is asked how high it is.
constexpr std::size_t kProbes = 512;

int patternsOf(const CompiledLayer& layer) {
    return layer.mask ? 2 : 1;
}

/// The layers that are drawn, lowest first.
TextureStack drawnOf(const TextureStack& felt) {
    TextureStack drawn = asOneHeight(felt);
    std::erase_if(drawn.layers, [](const CompiledLayer& l) { return l.target != TextureTarget::Height; });
    int patterns = 0;
    const auto first = std::ranges::find_if(drawn.layers, [&](const CompiledLayer& layer) {
        return (patterns += patternsOf(layer)) > kMostReliefPatterns;
    });
    drawn.layers.erase(first, drawn.layers.end());
    drawn.soup = felt.soup;
    drawn.surface = felt.surface;
    return drawn;
}

bool needsCorners(const CompiledPattern& pattern) {
    return usesUvs(pattern) || pattern.source == TextureSource::Painted;
}

/// Weights of corners that are spread evenly over a triangle, for any number of them. Source: the
/// low-discrepancy sequence R2 of Roberts, The Unreasonable Effectiveness of Quasirandom Sequences (2018).
Vec3 spread(std::size_t i) {
    const double x = std::fmod(0.5 + double(i) * 0.7548776662466927, 1.0),
                 y = std::fmod(0.5 + double(i) * 0.5698402909980532, 1.0);
    return x + y < 1 ? Vec3(1 - x - y, x, y) : Vec3(x + y - 1, 1 - x, 1 - y);
}

TexturePoint placeOn(const TriangleSoup& soup, Index face, const Vec3& weights) {
    const auto& t = soup.triangles[face];
    const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
    TexturePoint point;
    point.position = weights[0] * a + weights[1] * b + weights[2] * c;
    point.normal = (b - a).cross(c - a).stableNormalized();
    point.triangle = face;
    point.weights = weights;
    if (soup.cornerUvs.empty()) return point;
    for (std::size_t k = 0; k < 3; ++k)
        point.uv += weights[Eigen::Index(k)] * soup.cornerUvs[3 * std::size_t(face) + k].cast<double>();
    return point;
}

void measure(Relief& relief) {
    const TriangleSoup& soup = *relief.stack->soup;
    std::vector<Index> faces;
    for (Index f = 0; f < Index(soup.triangles.size()); ++f)
        if (soup.surfaceOf[f] == relief.stack->surface) faces.push_back(f);
    if (faces.empty()) return;
    relief.low = 1e300, relief.high = -1e300;
    for (std::size_t i = 0; i < kProbes; ++i) {
        const Index face = faces[i * std::max<std::size_t>(1, faces.size() / kProbes) % faces.size()];
        const double height =
            feel(*relief.stack, placeOn(soup, face, spread(i)), relief.smallestFeature).height;
        relief.low = std::min(relief.low, height);
        relief.high = std::max(relief.high, height);
    }
}

} // namespace

TextureStack asOneHeight(const TextureStack& stack) {
    TextureStack result;
    result.layers = stack.layers;
    std::ranges::stable_partition(result.layers, [](const CompiledLayer& l) { return !l.ownPlane; });
    for (CompiledLayer& layer : result.layers)
        if (std::exchange(layer.ownPlane, false)) layer.blend = TextureBlend::Add;
    return result;
}

std::shared_ptr<const Relief> reliefOf(const std::shared_ptr<const TextureStack>& stack,
                                       double smallestFeature) {
    if (!stack || !stack->soup) return nullptr;
    auto drawn = std::make_shared<const TextureStack>(drawnOf(*stack));
    if (drawn->layers.empty()) return nullptr;
    auto relief = std::make_shared<Relief>();
    relief->smallestFeature = smallestFeature;
    relief->corners = std::ranges::any_of(drawn->layers, [](const CompiledLayer& layer) {
        return needsCorners(layer.pattern) || (layer.mask && needsCorners(*layer.mask));
    });
    relief->stack = std::move(drawn);
    measure(*relief);
    return relief;
}

} // namespace tactum
