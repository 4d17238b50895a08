// Polygons cut into triangles: n-gons, concave ones, and the broken ones that files contain.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Cuts one polygon after the other; keeps its scratch memory between them.
///
/// The polygon is projected along its Newell normal and cut by ear clipping (G. H. Meisters, "Polygons Have
/// Ears", 1975). Corners that lie on an edge between their neighbours stay corners of the mesh. A polygon
/// that crosses itself is still covered, with overlaps. Thread: one at a time, any but real time.
class PolygonCutter {
public:
    /// Triangles as indices into `corners`, wound as the polygon is; valid until the next call. Successive
    /// corners at one place count once; what then is a segment or a point comes out as one (see
    /// TriangleSoup), so the answer is empty only for no corners at all.
    const std::vector<std::array<Index, 3>>& cut(std::span<const Vec3> corners);

    /// Whether the last polygon asked for more work than the bound (20 million tests, about 0.1 s) and its
    /// rest was cut as a fan: covered, but not along its outline.
    bool gaveUp() const { return gaveUp_; }

private:
    using Point = Eigen::Vector2d;
    /// What keeps a corner from being an ear: the first kind is tried first.
    enum class Blocking { Touching, Inside };

    void dropRepeatedCorners(std::span<const Vec3> corners);
    bool project(std::span<const Vec3> corners);
    void cutQuad(std::span<const Vec3> corners);
    void clipEars();
    void classify(std::size_t i);
    bool isEar(std::size_t i, Blocking blocking);
    std::size_t anyEar(std::size_t start, std::size_t left);
    void clip(std::size_t i);
    void fan(std::size_t start);
    double turn(std::size_t a, std::size_t b, std::size_t c) const;

    std::vector<Index> ring_; ///< distinct corners
    std::vector<Point> flat_; ///< of ring_, counter-clockwise
    std::vector<std::size_t> next_, previous_;
    std::vector<char> reflex_; ///< not strictly convex
    std::vector<std::size_t> reflexes_;
    std::vector<std::array<Index, 3>> triangles_;
    double flatness_ = 0; ///< twice the area below which three corners count as collinear
    std::size_t budget_ = 0;
    bool gaveUp_ = false;
};

/// Twice the area vector of a closed polygon (Newell): its normal times twice its area.
Vec3 newellNormal(std::span<const Vec3> corners);

} // namespace tactum
