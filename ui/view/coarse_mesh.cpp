#include "ui/view/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/base/vec.h"

namespace tactum {

namespace {

/// Cells that a surface crosses, by its area in cells' faces, over all directions.
constexpr double kCrossed = 1.5;

Vec3 placeOf(const DisplayMesh& mesh, int vertex) {
    const float* p = &mesh.positions[3 * std::size_t(vertex)];
    return {p[0], p[1], p[2]};
}

double areaOf(const DisplayMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.corners)
        area += 0.5 * (placeOf(mesh, b) - placeOf(mesh, a)).cross(placeOf(mesh, c) - placeOf(mesh, a)).norm();
    return area;
}

/// The number of the cell of each vertex: the same for all in one cell.
std::vector<std::uint64_t> cellsOf(const DisplayMesh& mesh, double side) {
    constexpr double kMiddle = 1 << 20; // 21 bits for each direction
    std::vector<std::uint64_t> cells(mesh.positions.size() / 3);
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (const double x : placeOf(mesh, int(i)))
            cells[i] = cells[i] << 21 |
                       std::uint64_t(std::clamp(std::floor(x / side) + kMiddle, 0.0, 2 * kMiddle - 1));
    return cells;
}

/// For each vertex the one that stands for its cell.
std::vector<int> standIns(const DisplayMesh& mesh, double side) {
    const std::vector<std::uint64_t> cells = cellsOf(mesh, side);
    std::vector<int> order(cells.size()), standIn(cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) { return std::pair(cells[std::size_t(i)], i); });
    for (auto from = order.begin(); from != order.end();) {
        const auto to = std::find_if(
            from, order.end(), [&](int i) { return cells[std::size_t(i)] != cells[std::size_t(*from)]; });
        Vec3 mean = Vec3::Zero();
        for (auto it = from; it != to; ++it)
            mean += placeOf(mesh, *it) / double(to - from);
        const int nearest = *std::ranges::min_element(
            from, to, {}, [&](int i) { return (placeOf(mesh, i) - mean).squaredNorm(); });
        for (; from != to; ++from)
            standIn[std::size_t(*from)] = nearest;
    }
    return standIn;
}

} // namespace

std::vector<Index> CoarseMesh::surfaceOf(const std::vector<Index>& exact) const {
    std::vector<Index> surfaces(from.size());
    std::ranges::transform(from, surfaces.begin(), [&](Index i) { return exact[i]; });
    return surfaces;
}

CoarseMesh coarseMesh(const DisplayMesh& mesh, std::size_t triangles) {
    CoarseMesh coarse;
    const double side = std::sqrt(kCrossed * areaOf(mesh) / std::max(1.0, 0.5 * double(triangles)));
    if (!(side > 0)) return coarse;
    const std::vector<int> standIn = standIns(mesh, side);
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        std::array<int, 3> corners = mesh.corners[i];
        for (int& corner : corners)
            corner = standIn[std::size_t(corner)];
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        coarse.corners.push_back(corners);
        coarse.from.push_back(Index(i));
    }
    return coarse;
}

} // namespace tactum
