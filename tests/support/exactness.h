// How exact a replay was, judged by other means than the program's: a grid and a slow descent.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_soup.h"
#include "core/haptics/replay.h"

namespace tactum::test {

/// The triangles of a soup in the cells of a regular grid: finds what is near without any tree.
class TriangleGrid {
public:
    /// `cell` in m; it grows where the grid would have more than a few million cells. Keeps a reference to
    /// the soup.
    TriangleGrid(const TriangleSoup& soup, double cell);

    /// Calls seen(index) for every triangle that may come within `reach` of p, some more than once.
    template <class Seen> void near(const Vec3& p, double reach, Seen&& seen) const {
        const Cell low = cellAt(p - Vec3::Constant(reach)), high = cellAt(p + Vec3::Constant(reach));
        for (int z = low.z(); z <= high.z(); ++z)
            for (int y = low.y(); y <= high.y(); ++y) {
                const std::size_t row = indexOf({low.x(), y, z});
                const std::size_t end = row + std::size_t(high.x() - low.x()) + 1;
                for (std::uint32_t k = first_[row]; k < first_[end]; ++k)
                    seen(triangles_[k]);
            }
    }
    const TriangleSoup& soup() const { return soup_; }

private:
    using Cell = Eigen::Vector3i;
    Cell cellAt(const Vec3& p) const; ///< the nearest one for a point outside
    std::size_t indexOf(const Cell& cell) const;
    template <class Seen> void eachCellOf(std::size_t triangle, Seen&& seen) const;

    const TriangleSoup& soup_;
    Vec3 low_ = Vec3::Zero();
    double cell_ = 1;
    Cell cells_ = Cell::Ones();
    std::vector<std::uint32_t> first_; ///< of each cell in triangles_, and the end
    std::vector<Index> triangles_;
};

/// How far the centre p is from the nearest triangle, looked for within `reach`; reach if there is none.
double clearance(const TriangleGrid& grid, const Vec3& p, double reach);

/// How far a frictionless proxy of radius r is from a local minimum of the distance to the finger: the length
/// of the way that a slow descent still finds from there, every part of it certain to be free. Metre; 0 at a
/// minimum, up to rounding. It goes by steps of a quarter of the radius at most, each to the nearest point of
/// the room that the tangent planes of everything near leave: a triangle's C-obstacle is convex and lies
/// behind its plane.
double distanceFromMinimum(const TriangleGrid& grid, double r, const Vec3& proxy, const Vec3& finger);

/// A row that is not as it should be: more than 10 um from a local minimum, or overlapping by more than 2 nm.
struct RowFault {
    std::size_t row = 0;
    double off = 0, clearance = 0; ///< m
};

/// What a replay of a frictionless proxy should keep to, over all its rows.
struct Exactness {
    std::size_t rows = 0;
    std::size_t farRows = 0;      ///< more than 1 mm from a local minimum
    std::size_t offRows = 0;      ///< more than 10 um
    double worst = 0;             ///< m from a local minimum
    double smallestClearance = 0; ///< of the proxy's surface, m; negative when it overlaps
    double deepest = 0;           ///< largest distance between finger and proxy, m
    std::vector<RowFault> faults;
    bool closed = false;        ///< the mesh has an inside
    std::size_t insideRows = 0; ///< whose proxy lies behind the surface; an open one may be gone around
};

/// Proxy and finger in the frame of the soup; the first row is outside.
Exactness exactnessOf(const TriangleSoup& soup, double r, const TouchTrace& rows);

} // namespace tactum::test
