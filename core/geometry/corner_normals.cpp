#include "core/geometry/corner_normals.h"

#include <cmath>

#include "core/base/parallel.h"
#include "core/geometry/edges.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

constexpr Index kNone = ~Index{0};
/// Two sides of one sheet cancel each other but for rounding: then each corner keeps its triangle's.
constexpr double kNothingLeft = 1e-9;

/// The triangles around each corner, as far as they go on smoothly. A fan at a vertex is a ring or has two
/// ends; several may meet at one place.
class Fans {
public:
    Fans(const TriangleSoup& soup, double creaseAngle, const Progress& progress) : soup_(soup) {
        const std::vector<Index> weld = weldMap(soup.positions, Progress{{}, progress.cancelled});
        if (progress.isCancelled()) return;
        std::vector<Corners> welded(soup.triangles.size());
        for (std::size_t t = 0; t < welded.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                welded[t][k] = weld[soup.triangles[t][k]];
        findNormals(welded);
        if (!progress.isCancelled()) findNeighbours(welded, std::cos(creaseAngle));
    }

    /// Of a triangle; zero without an area.
    const Vec3& normal(std::size_t triangle) const { return normals_[triangle]; }

    /// The triangle's normal times its angle at the corner.
    Vec3 weighted(Index corner) const {
        const Vec3& p = place(corner);
        const Vec3 a = place(nextCorner(corner)) - p, b = place(previousCorner(corner)) - p;
        return std::atan2(a.cross(b).norm(), a.dot(b)) * normals_[corner / 3];
    }

    /// Calls f(corner) for each corner of the fan, in their order; a ring begins with the given one.
    template <class F> void forEach(Index corner, F&& f) const {
        Index first = corner;
        for (Index c = before(first); c != kNone && c != corner; c = before(c))
            first = c;
        const Index begin = before(first) == kNone ? first : corner;
        Index c = begin;
        do
            f(c);
        while ((c = after(c)) != kNone && c != begin);
    }

private:
    /// The next corner of the fan across the edge that leaves this one's vertex in its triangle.
    Index after(Index corner) const {
        const Index across = across_[corner];
        return across == kNone ? kNone : nextCorner(across);
    }
    Index before(Index corner) const { return across_[previousCorner(corner)]; }

    const Vec3& place(Index corner) const { return soup_.positions[soup_.triangles[corner / 3][corner % 3]]; }

    void findNormals(const std::vector<Corners>& welded) {
        normals_.assign(welded.size(), Vec3::Zero());
        parallelFor(welded.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                const Vec3& a = soup_.positions[welded[t][0]];
                const Vec3 across =
                    (soup_.positions[welded[t][1]] - a).cross(soup_.positions[welded[t][2]] - a);
                if (const double length = across.norm(); length > 0) normals_[t] = across / length;
            }
        });
    }

    void findNeighbours(const std::vector<Corners>& welded, double leastCosine) {
        across_.assign(3 * welded.size(), kNone);
        const auto isTriangle = [](const Corners& t) { return kindOf(t) == Kind::Triangle; };
        forEachEdge(welded, soup_.positions.size(), isTriangle, [&](Index, std::span<const EdgeUse> uses) {
            if (uses.size() != 2 || uses[0].forward == uses[1].forward) return;
            const Index a = uses[0].corner, b = uses[1].corner;
            if (normals_[a / 3].dot(normals_[b / 3]) >= leastCosine) across_[a] = b, across_[b] = a;
        });
    }

    const TriangleSoup& soup_;
    std::vector<Vec3> normals_;
    std::vector<Index> across_; ///< of each corner: where the neighbour's edge begins, in its own direction
};

} // namespace

Result<std::vector<Eigen::Vector3f>> cornerNormalsOf(const TriangleSoup& soup, double creaseAngle,
                                                     const Progress& progress) {
    if (progress.isCancelled()) return cancelledError();
    const Fans fans(soup, creaseAngle, progress);
    if (progress.isCancelled()) return cancelledError();
    std::vector<Eigen::Vector3f> result(3 * soup.triangles.size(), Eigen::Vector3f::Zero());
    const Progress smoothing = partOf(progress, 0.6, 1);
    ProgressMeter meter(smoothing, result.size(), 1 << 16);
    for (Index corner = 0; corner < Index(result.size()); ++corner) {
        if (!meter.goesOn(corner)) return cancelledError();
        if (!result[corner].isZero(0)) continue; // a corner of a fan that was seen
        Vec3 sum = Vec3::Zero();
        fans.forEach(corner, [&](Index c) { sum += fans.weighted(c); });
        const double length = sum.norm();
        fans.forEach(corner, [&](Index c) {
            const Vec3 normal = length > kNothingLeft ? Vec3(sum / length) : fans.normal(c / 3);
            result[c] = normal.isZero(0) ? Eigen::Vector3f::UnitZ() : Eigen::Vector3f(normal.cast<float>());
        });
    }
    return result;
}

} // namespace tactum
