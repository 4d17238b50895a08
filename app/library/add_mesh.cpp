// A mesh of a scene that is made of arrays.
#include <algorithm>

#include <tactum/scene.h>

#include "app/library/parts.h"
#include "core/base/text.h"
#include "core/files/scene_of_arrays.h"
#include "core/geometry/soup_builder.h"

namespace tactum::library {
namespace {

std::vector<core::Vec3> positionsOf(std::span<const Vec3> vertices) {
    std::vector<core::Vec3> positions;
    positions.reserve(vertices.size());
    for (const Vec3& vertex : vertices) {
        positions.push_back(inward(vertex));
        if (!std::ranges::all_of(positions.back(), isCoordinate))
            refuse("vertices: " + std::to_string(positions.size() - 1) +
                   " is farther than 1e6 m from the origin, or not finite");
    }
    return positions;
}

std::vector<Index> surfacesOf(std::span<const std::uint32_t> surfaces, std::size_t triangles) {
    if (surfaces.empty()) return std::vector<Index>(triangles, 0);
    if (surfaces.size() != triangles)
        refuse("surfaces: has " + std::to_string(surfaces.size()) + " numbers, and there are " +
               counted(triangles, "triangle"));
    if (std::ranges::max(surfaces) >= kMostArraySurfaces)
        refuse("surfaces: names " + std::to_string(std::ranges::max(surfaces)) + ", and there are " +
               std::to_string(kMostArraySurfaces) + " at most");
    return {surfaces.begin(), surfaces.end()};
}

TriangleSoup soupOf(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> surfaces) {
    if (vertices.empty() || triangles.empty()) refuse("mesh: has no vertices or no triangles");
    TriangleSoup soup;
    soup.positions = positionsOf(vertices);
    for (const Triangle& corners : triangles) {
        if (std::ranges::max(corners) >= vertices.size())
            refuse("triangles: " + std::to_string(soup.triangles.size()) + " names vertex " +
                   std::to_string(std::ranges::max(corners)) + ", and there are " +
                   std::to_string(vertices.size()));
        soup.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    soup.surfaceOf = surfacesOf(surfaces, triangles.size());
    return soup;
}

} // namespace

Object Scene::addMesh(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                      std::span<const std::uint32_t> surfaces, std::string_view name) {
    SceneState& state = *Parts::state(*this);
    auto loaded = valueOf(sceneOfArrays(name, soupOf(vertices, triangles, surfaces)));
    std::ranges::move(linesOf(loaded.findings), std::back_inserter(state.findings));
    return Parts::object(state_, state.scene.add(std::move(loaded.scene.objects.front())).id);
}

} // namespace tactum::library
