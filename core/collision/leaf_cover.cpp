#include "core/collision/leaf_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/geometry/triangle.h"

namespace tactum {

namespace {

// A long triangle is halved at most four times: at most sixteen spheres.
constexpr std::uint32_t kSmallestPiece = 1 << 4;
// One sphere wastes little until it is this much larger than a sphere over a compact triangle of equal area.
constexpr double kCompact = 2.0;

// The smallest sphere ballAround three points: on the longest side, or the circumcircle when all angles are
// acute.
Vec3 smallestSphereCentre(const Triangle& t) {
    const Vec3 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
    if (ab.dot(ca) >= 0) return 0.5 * (t.b + t.c);
    if (ab.dot(bc) >= 0) return 0.5 * (t.a + t.c);
    if (bc.dot(ca) >= 0) return 0.5 * (t.a + t.b);
    const Vec3 ac = -ca, normal = ab.cross(ac);
    return t.a + (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) /
                     (2 * normal.squaredNorm());
}

LeafSphere ballAround(const Triangle& t, Index index, std::uint32_t piece) {
    LeafSphere sphere;
    sphere.centre = roundedCentre(smallestSphereCentre(t));
    const Vec3 centre = sphere.centre.cast<double>();
    sphere.radius = radiusAbove(
        std::max({(t.a - centre).squaredNorm(), (t.b - centre).squaredNorm(), (t.c - centre).squaredNorm()}));
    sphere.triangle = index;
    sphere.piece = piece;
    return sphere;
}

// Halves across the longest side.
std::array<Triangle, 2> halves(const Triangle& t) {
    const double ab = (t.b - t.a).squaredNorm(), bc = (t.c - t.b).squaredNorm(),
                 ca = (t.a - t.c).squaredNorm();
    Triangle turned = t; // the longest side becomes ab
    if (bc >= ab && bc >= ca)
        turned = {t.b, t.c, t.a};
    else if (ca >= ab)
        turned = {t.c, t.a, t.b};
    const Vec3 middle = 0.5 * (turned.a + turned.b);
    return {{{turned.a, middle, turned.c}, {middle, turned.b, turned.c}}};
}

void cover(const Triangle& t, Index index, double compactRadius, std::uint32_t piece,
           std::vector<LeafSphere>& out) {
    const LeafSphere sphere = ballAround(t, index, piece);
    if (piece >= kSmallestPiece || sphere.radius <= kCompact * compactRadius) {
        out.push_back(sphere);
        return;
    }
    const auto [first, second] = halves(t);
    cover(first, index, compactRadius, 2 * piece, out);
    cover(second, index, compactRadius, 2 * piece + 1, out);
}

} // namespace

Triangle pieceOf(const Triangle& triangle, std::uint32_t piece) {
    if (piece == 1) return triangle;
    return halves(pieceOf(triangle, piece / 2))[piece % 2];
}

Triangle partOf(const LeafSphere& sphere, const TriangleSoup& soup, const Vec3& origin) {
    const auto& corner = soup.triangles[sphere.triangle];
    return pieceOf({soup.positions[corner[0]] - origin, soup.positions[corner[1]] - origin,
                    soup.positions[corner[2]] - origin},
                   sphere.piece);
}

// GCC 12's vectoriser drops a rounding to float and back (seen at -O2: spheres 7 um too small 1 km from the
// origin); volatile keeps it.
Eigen::Vector3f roundedCentre(const Vec3& centre) {
    Eigen::Vector3f result;
    for (int axis = 0; axis < 3; ++axis) {
        const volatile float rounded = float(centre[axis]);
        result[axis] = rounded;
    }
    return result;
}

float radiusAbove(double distance2) {
    return std::nextafter(float(std::sqrt(distance2)), std::numeric_limits<float>::infinity());
}

std::vector<LeafSphere> coverWithSpheres(const TriangleSoup& soup, const Vec3& origin) {
    const std::size_t count = soup.triangles.size();
    std::vector<std::vector<LeafSphere>> parts(parallelParts(count));
    parallelFor(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
        auto& out = parts[part];
        out.reserve(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            const auto& corner = soup.triangles[i];
            const Triangle t{soup.positions[corner[0]] - origin, soup.positions[corner[1]] - origin,
                             soup.positions[corner[2]] - origin};
            // An equilateral triangle of area A fits a circle of radius 0.877 sqrt(A).
            const double area = 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
            cover(t, Index(i), area > 0 ? 0.877 * std::sqrt(area) : 1e300, 1, out);
        }
    });
    std::vector<LeafSphere> all = std::move(parts.front());
    for (std::size_t k = 1; k < parts.size(); ++k)
        all.insert(all.end(), parts[k].begin(), parts[k].end());
    return all;
}

} // namespace tactum
