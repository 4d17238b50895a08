#include "core/scene/surface_colours.h"

#include <algorithm>
#include <array>

namespace tactum {

namespace {

/// Calm and about equally light, so that none looks chosen and relief is seen on all; linear RGB. The first
/// is what a surface has at first.
const std::array<Eigen::Vector3f, 8> kPalette{{{0.72F, 0.72F, 0.74F},
                                               {0.25F, 0.45F, 0.66F},
                                               {0.70F, 0.42F, 0.22F},
                                               {0.32F, 0.52F, 0.30F},
                                               {0.62F, 0.30F, 0.34F},
                                               {0.42F, 0.36F, 0.62F},
                                               {0.66F, 0.58F, 0.24F},
                                               {0.24F, 0.52F, 0.52F}}};

float distanceTo(const Eigen::Vector3f& colour, std::span<const Surface> surfaces) {
    float nearest = 1e9F;
    for (const Surface& surface : surfaces)
        nearest = std::min(nearest, (surface.colour - colour).norm());
    return nearest;
}

} // namespace

Eigen::Vector3f colourApartFrom(std::span<const Surface> surfaces) {
    return *std::ranges::max_element(
        kPalette, {}, [&](const Eigen::Vector3f& colour) { return distanceTo(colour, surfaces); });
}

bool isColoured(const SceneObject& object) {
    return std::ranges::any_of(object.surfaces,
                               [](const Surface& surface) { return surface.colour != Surface{}.colour; });
}

void tellSurfacesApart(Scene& scene) {
    for (SceneObject& object : scene.objects) {
        if (isColoured(object)) continue;
        for (std::size_t i = 1; i < object.surfaces.size(); ++i)
            object.surfaces[i].colour = colourApartFrom(std::span(object.surfaces).first(i));
    }
}

std::vector<SurfaceRef> surfacesColouredLike(const Scene& scene, SurfaceRef ref) {
    constexpr float kScreenStep = 1.0F / 512; // linear: of a bright colour half a step of 8 bits
    const SceneObject* object = scene.find(ref.object);
    if (!object || ref.surface >= object->surfaces.size()) return {};
    const Eigen::Vector3f colour = object->surfaces[ref.surface].colour;
    std::vector<SurfaceRef> result;
    for (const SceneObject& other : scene.objects)
        for (Index s = 0; s < other.surfaces.size(); ++s)
            if ((other.surfaces[s].colour - colour).cwiseAbs().maxCoeff() <= kScreenStep)
                result.push_back({other.id, s});
    return result;
}

} // namespace tactum
