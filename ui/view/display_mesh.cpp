#include "ui/view/display_mesh.h"

#include <algorithm>

#include "core/geometry/corner_normals.h"

namespace tactum {

namespace {

using Normal = Eigen::Vector3f;
using Corners = std::array<int, 3>;

/// Normals closer than about a degree share a vertex.
constexpr float kSameNormal = 0.9998f;

void append(std::vector<float>& list, const Eigen::Vector3f& v) {
    list.insert(list.end(), v.data(), v.data() + 3);
}

void addPart(DisplaySurface& surface, const Corners& c) {
    if (c[0] == c[1] && c[1] == c[2])
        surface.points.push_back(c[0]);
    else if (c[1] == c[2])
        surface.segments.insert(surface.segments.end(), c.begin(), c.begin() + 2);
    else
        surface.triangles.insert(surface.triangles.end(), c.begin(), c.end());
}

/// Makes vertices on demand: one for each position and normal that differ.
class VertexSplitter {
public:
    VertexSplitter(const TriangleSoup& soup, DisplayMesh& mesh)
        : soup_(soup), mesh_(mesh), first_(soup.positions.size(), -1) {}

    int vertex(Index position, const Normal& normal) {
        for (int v = first_[position]; v >= 0; v = next_[v])
            if (Eigen::Map<const Normal>(&mesh_.normals[3 * v]).dot(normal) >= kSameNormal) return v;
        append(mesh_.positions, soup_.positions[position].cast<float>());
        append(mesh_.normals, normal);
        next_.push_back(first_[position]);
        return first_[position] = int(next_.size()) - 1;
    }

private:
    const TriangleSoup& soup_;
    DisplayMesh& mesh_;
    std::vector<int> first_, next_; ///< the vertices of a position as a linked list
};

/// One corner of a segment or point keeps one vertex whatever its normals are.
Corners split(VertexSplitter& splitter, const std::array<Index, 3>& t, const Normal* normals) {
    Corners corners;
    for (int i = 0; i < 3; ++i) {
        const int repeated = i > 0 && t[i] == t[i - 1] ? i - 1 : -1;
        corners[i] = repeated >= 0 ? corners[repeated] : splitter.vertex(t[i], normals[i]);
    }
    return corners;
}

DisplayMesh splitMesh(const TriangleSoup& soup, const std::vector<Normal>& normals) {
    DisplayMesh mesh;
    mesh.corners.reserve(soup.triangles.size());
    VertexSplitter splitter(soup, mesh);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
        mesh.corners.push_back(split(splitter, soup.triangles[f], &normals[3 * f]));
    return mesh;
}

} // namespace

std::vector<DisplaySurface> bySurface(const std::vector<std::array<int, 3>>& corners,
                                      const std::vector<Index>& surfaceOf, std::size_t surfaceCount) {
    std::vector<DisplaySurface> surfaces(surfaceCount);
    for (std::size_t f = 0; f < corners.size(); ++f)
        addPart(surfaces[surfaceOf[f]], corners[f]);
    return surfaces;
}

DisplayMesh flatMesh(const TriangleSoup& soup) {
    DisplayMesh mesh;
    mesh.positions.reserve(3 * soup.positions.size());
    for (const Vec3& p : soup.positions)
        append(mesh.positions, p.cast<float>());
    mesh.corners.reserve(soup.triangles.size());
    for (const auto& t : soup.triangles)
        mesh.corners.push_back({int(t[0]), int(t[1]), int(t[2])});
    return mesh;
}

DisplayMesh smoothMesh(const TriangleSoup& soup, const Progress& progress) {
    if (!soup.cornerNormals.empty()) return splitMesh(soup, soup.cornerNormals);
    const auto normals = cornerNormalsOf(soup, kDrawnCrease, progress);
    return normals ? splitMesh(soup, *normals) : flatMesh(soup);
}

} // namespace tactum
