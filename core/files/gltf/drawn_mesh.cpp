#include "core/files/gltf/drawn_mesh.h"

#include <algorithm>
#include <numeric>

#include "core/base/single_precision.h"
#include "core/files/corner_pool.h"

namespace tactum {
namespace {

/// A corner as the bits that make its vertex.
using Corners = CornerPool<6>;
using Key = Corners::Key;

class VertexList {
public:
    VertexList(const TriangleSoup& soup, DrawnMesh& mesh) : soup_(soup), mesh_(mesh) {
        const std::size_t count = soup.positions.size();
        for (const Vec3& p : soup.positions)
            mesh.positions.push_back(p.cast<float>());
        if (hasNormals()) mesh.normals.assign(count, Eigen::Vector3f::UnitZ());
        if (hasUvs()) mesh.trueUvs.assign(count, Eigen::Vector2f::Zero());
        taken_.assign(hasNormals() || hasUvs() ? count : 0, 0);
    }

    Index vertexOf(std::size_t corner) {
        const Index position = soup_.triangles[corner / 3][corner % 3];
        if (taken_.empty()) return position;
        if (!taken_[position]) {
            taken_[position] = 1;
            fill(position, corner);
            return position;
        }
        if (keyOfVertex(position, position) == keyOfCorner(corner)) return position;
        const std::size_t before = more_.keys().size();
        const Index number = more_.numberOf(keyOfCorner(corner));
        if (more_.keys().size() > before) append(position, corner);
        return Index(soup_.positions.size()) + number;
    }

private:
    bool hasNormals() const { return !soup_.cornerNormals.empty(); }
    bool hasUvs() const { return !soup_.cornerUvs.empty(); }

    static Key key(Index position, const Eigen::Vector3f& n, const Eigen::Vector2f& uv) {
        return {position, bitsOf(n.x()), bitsOf(n.y()), bitsOf(n.z()), bitsOf(uv.x()), bitsOf(uv.y())};
    }
    Key keyOfCorner(std::size_t corner) const {
        return key(soup_.triangles[corner / 3][corner % 3],
                   hasNormals() ? soup_.cornerNormals[corner] : Eigen::Vector3f::Zero().eval(),
                   hasUvs() ? soup_.cornerUvs[corner] : Eigen::Vector2f::Zero().eval());
    }
    Key keyOfVertex(Index vertex, Index position) const {
        return key(position, hasNormals() ? mesh_.normals[vertex] : Eigen::Vector3f::Zero().eval(),
                   hasUvs() ? mesh_.trueUvs[vertex] : Eigen::Vector2f::Zero().eval());
    }
    void fill(Index vertex, std::size_t corner) {
        if (hasNormals()) mesh_.normals[vertex] = soup_.cornerNormals[corner];
        if (hasUvs()) mesh_.trueUvs[vertex] = soup_.cornerUvs[corner];
    }
    void append(Index position, std::size_t corner) {
        mesh_.copies.push_back(position);
        mesh_.positions.push_back(mesh_.positions[position]);
        if (hasNormals()) mesh_.normals.push_back(soup_.cornerNormals[corner]);
        if (hasUvs()) mesh_.trueUvs.push_back(soup_.cornerUvs[corner]);
    }

    const TriangleSoup& soup_;
    DrawnMesh& mesh_;
    std::vector<char> taken_; ///< whether a corner has given its attributes to the vertex of a position
    Corners more_;            ///< those that need a vertex of their own
};

/// The soup's triangles by surface, then by kind, else as they were.
std::vector<Index> drawingOrder(const TriangleSoup& soup, std::size_t surfaces) {
    const auto bin = [&](std::size_t f) {
        return std::size_t(soup.surfaceOf[f]) * 3 + std::size_t(3 - cornersOf(soup.triangles[f]));
    };
    std::vector<std::size_t> begin(3 * surfaces + 1, 0);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        ++begin[bin(f) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> order(soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        order[begin[bin(f)]++] = Index(f);
    return order;
}

void flipUvs(DrawnMesh& mesh) {
    for (const Eigen::Vector2f& uv : mesh.trueUvs) {
        const float down = float(1 - double(uv.y()));
        mesh.uvs.emplace_back(uv.x(), down);
        const float back = float(1 - double(down));
        mesh.uvsAreExact &= bitsOf(back) == bitsOf(uv.y());
    }
}

} // namespace

DrawnMesh drawn(const TriangleSoup& soup, std::size_t surfaces) {
    DrawnMesh mesh;
    VertexList vertices(soup, mesh);
    mesh.order = drawingOrder(soup, surfaces);
    for (const Index f : mesh.order) {
        const int corners = cornersOf(soup.triangles[f]);
        const Index surface = soup.surfaceOf[f];
        if (mesh.parts.empty() || mesh.parts.back().surface != surface ||
            mesh.parts.back().corners != corners)
            mesh.parts.push_back({surface, corners, {}});
        for (int corner = 0; corner < corners; ++corner)
            mesh.parts.back().vertices.push_back(vertices.vertexOf(3 * std::size_t(f) + std::size_t(corner)));
    }
    if (std::ranges::is_sorted(mesh.order)) mesh.order.clear();
    for (const Vec3& p : soup.positions)
        mesh.positionsAreExact &= asSingle(p) == p;
    flipUvs(mesh);
    return mesh;
}

} // namespace tactum
