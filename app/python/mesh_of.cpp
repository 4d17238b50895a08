#include "app/python/mesh_of.h"

#include <algorithm>
#include <cstring>

#include "core/base/text.h"
#include "core/files/scene_of_arrays.h"
#include "core/geometry/soup_builder.h"

namespace tactum::python {
namespace {

std::vector<Vec3> verticesOf(const py::handle& values) {
    const Numbers rows = numbersOf(values, "vertices");
    if (rows.ndim() != 2 || rows.shape(1) != 3 || rows.shape(0) == 0)
        throw Failure("vertices: rows of x, y, z are wanted, at least one");
    std::vector<Vec3> vertices(std::size_t(rows.shape(0)));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertices[i] = Eigen::Map<const Vec3>(rows.data() + 3 * i);
        if (!std::ranges::all_of(vertices[i], isCoordinate))
            throw Failure("vertices: row " + std::to_string(i) + " is farther than 1e6 m from the origin");
    }
    return vertices;
}

TriangleSoup soupOf(const py::handle& vertices, const py::handle& triangles, const py::object& surfaces) {
    TriangleSoup soup;
    soup.positions = verticesOf(vertices);
    const auto corners = indicesOf(triangles, "triangles", 3, soup.positions.size());
    if (corners.empty()) throw Failure("triangles: has no rows");
    for (std::size_t i = 0; i < corners.size(); i += 3)
        soup.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    if (surfaces.is_none()) return soup;
    soup.surfaceOf = indicesOf(surfaces, "surfaces", 1, kMostArraySurfaces);
    if (soup.surfaceOf.size() != soup.triangles.size())
        throw Failure("surfaces: has " + std::to_string(soup.surfaceOf.size()) + " numbers, and there are " +
                      counted(soup.triangles.size(), "triangle"));
    return soup;
}

} // namespace

ObjectHandle addMesh(const SceneHold& to, const ArrayLike& vertices, const ArrayLike& triangles,
                     const py::object& surfaces, const std::string& name) {
    TriangleSoup soup = soupOf(vertices, triangles, surfaces);
    auto loaded =
        unlocked([&](const Progress& progress) { return sceneOfArrays(name, std::move(soup), progress); });
    for (const Finding& finding : loaded.findings)
        to->findings.push_back(lineOf(finding));
    return {to, to->scene.add(std::move(loaded.scene.objects.front())).id};
}

} // namespace tactum::python
