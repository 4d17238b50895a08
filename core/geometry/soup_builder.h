// Polygons as the readers find them, gathered into one triangle soup with its surfaces.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

inline constexpr Index kNone = ~Index{0};
/// No coordinate may be farther from the origin: m.
inline constexpr double kFarthest = 1e6;
inline bool isCoordinate(double value) {
    return value >= -kFarthest && value <= kFarthest;
}

/// What the corners of a file refer to.
struct VertexPools {
    std::vector<Vec3> positions;
    std::vector<Eigen::Vector3f> normals; ///< any length
    std::vector<Eigen::Vector2f> uvs;
};

/// One corner of a polygon: places in the pools.
struct PolygonCorner {
    Index position = kNone;
    Index normal = kNone;
    Index uv = kNone;
};

/// What building a soup had to do besides copying.
struct BuildReport {
    std::size_t cutPolygons = 0;    ///< with more than three corners
    std::size_t fannedPolygons = 0; ///< of these, too intricate to be cut along their outline
    std::size_t shortPolygons = 0;  ///< faces with one or two different corners
    std::size_t emptyPolygons = 0;  ///< faces without corners
    std::size_t filledNormals = 0;  ///< corners whose normal was missing, zero or not finite
    std::size_t filledUvs = 0;
};

/// Collects the faces of one object. Every index must be valid for the pools; the readers see to that.
class SoupBuilder {
public:
    explicit SoupBuilder(const VertexPools& pools) : pools_(&pools) {}

    void reserve(std::size_t triangles);
    /// Any number of corners: one is a point, two are a segment.
    void add(std::span<const PolygonCorner> corners, Index surface);
    void addSegment(const PolygonCorner& a, const PolygonCorner& b, Index surface) { push(a, b, b, surface); }
    void addPoint(const PolygonCorner& a, Index surface) { push(a, a, a, surface); }
    std::size_t triangles() const { return triangles_.size(); }
    std::vector<Index>& surfaceOf() { return surfaceOf_; }

    /// The soup over `positions`. Missing normals become the triangle's own, missing uvs (0, 0), as soon as
    /// any corner has one.
    TriangleSoup finish(std::vector<Vec3> positions, BuildReport& report);
    /// The soup over those positions that it uses.
    TriangleSoup finishCompact(BuildReport& report);

private:
    void push(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c, Index surface);
    void track(std::vector<Index>& indices, const std::array<Index, 3>& three);
    void fillNormals(TriangleSoup& soup, BuildReport& report) const;
    void fillUvs(TriangleSoup& soup, BuildReport& report) const;

    const VertexPools* pools_;
    BuildReport report_;
    std::vector<std::array<Index, 3>> triangles_;
    std::vector<Index> surfaceOf_;
    std::vector<Index> normalOf_, uvOf_; ///< three to a triangle; empty until the first corner has one
    PolygonCutter cutter_;
    std::vector<Vec3> outline_; ///< scratch
};

} // namespace tactum
