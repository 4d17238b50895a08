#include "core/collision/child_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/parallel.h"

namespace tactum {

namespace {

// Larger patches are rarely flat, and looking at all their corners at every level would cost the build.
constexpr std::uint32_t kLargestPatch = 1024;
// The spheres of more are hardly larger than they need to be.
constexpr std::uint32_t kFew = 64;
// A patch is worth its planes when they lie this much closer together than its sphere is wide.
constexpr double kFlat = 0.3;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Corners = std::span<const Vec3>;

struct Farthest {
    Vec3 corner = Vec3::Zero();
    double distance2 = -1;
};

Farthest farthestFrom(const Vec3& p, Corners corners) {
    Farthest farthest;
    for (const Vec3& corner : corners)
        if (const double distance2 = (corner - p).squaredNorm(); distance2 > farthest.distance2)
            farthest = {corner, distance2};
    return farthest;
}

// Ever shorter ways toward the farthest corner lead to the middle of the smallest sphere (Badoiu and
// Clarkson, Smaller core-sets for balls, 2003); the best place on these ways.
Vec3 middleOf(Corners corners) {
    constexpr int kWays = 8;
    Vec3 low = corners.front(), high = low;
    for (const Vec3& corner : corners) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    Vec3 at = 0.5 * (low + high), middle = at;
    double least = std::numeric_limits<double>::infinity();
    for (int way = 0; way < kWays; ++way) {
        const Farthest farthest = farthestFrom(at, corners);
        if (farthest.distance2 < least) middle = at;
        least = std::min(least, farthest.distance2);
        at += (farthest.corner - at) / (way + 3);
    }
    return middle;
}

void tighten(SphereTree::Node& node, int i, Corners corners) {
    const Eigen::Vector3f centre = roundedCentre(middleOf(corners));
    const float radius = radiusAbove(farthestFrom(centre.cast<double>(), corners).distance2);
    if (radius < node.radius[i]) place(node, i, centre, radius);
}

void flatten(SphereTree::Node& node, int i, Corners corners) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < corners.size(); k += 3)
        sum += (corners[k + 1] - corners[k]).cross(corners[k + 2] - corners[k]);
    if (!(sum.squaredNorm() > 0)) return;
    // The planes are exact for the rounded normal: that it is not quite of unit length is covered by the
    // query's own margin.
    const Eigen::Vector3f normal = sum.normalized().cast<float>();
    const Vec3 centre(node.x[i], node.y[i], node.z[i]);
    double low = 1e300, high = -1e300;
    for (const Vec3& corner : corners) {
        const double height = normal.cast<double>().dot(corner - centre);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (high - low > 2 * kFlat * double(node.radius[i])) return;
    node.nx[i] = normal.x();
    node.ny[i] = normal.y();
    node.nz[i] = normal.z();
    node.offset[i] = float(0.5 * (low + high));
    const double thickness = std::max(high - double(node.offset[i]), double(node.offset[i]) - low);
    node.thickness[i] = std::nextafter(float(thickness), kInfinity);
}

} // namespace

void fitChildren(std::vector<SphereTree::Node>& nodes, const ChildRanges& ranges, const TriangleSoup& soup,
                 const std::vector<LeafSphere>& leafSpheres, const Vec3& origin) {
    parallelFor(nodes.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        std::vector<Vec3> corners;
        for (std::size_t k = begin; k < end; ++k)
            for (int i = 0; i < SphereTree::kWidth; ++i) {
                const LeafRange range = ranges[k][std::size_t(i)];
                const std::uint32_t size = range.end - range.begin;
                if (size == 0 || size > kLargestPatch) continue;
                corners.clear();
                for (std::uint32_t leaf = range.begin; leaf < range.end; ++leaf) {
                    const Triangle part = partOf(leafSpheres[leaf], soup, origin);
                    corners.insert(corners.end(), {part.a, part.b, part.c});
                }
                if (size <= kFew) tighten(nodes[k], i, corners);
                flatten(nodes[k], i, corners);
            }
    });
}

} // namespace tactum
