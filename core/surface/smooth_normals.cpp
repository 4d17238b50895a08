#include "core/surface/smooth_normals.h"

#include <algorithm>
#include <tuple>

#include "core/base/realtime.h"
#include "core/geometry/topology.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

using Normal = Eigen::Vector3f;

// Normals that files round to a few digits are the same still.
constexpr float kSameNormal = 1e-3f;
// Places that differ by less than about this part of the mesh's size are the same.
constexpr double kSamePlace = 1e-9;

/// One triangle's side: the places of its ends, the lower first, and the triangle's normals there.
struct Side {
    Index low, high;
    Index triangle;
    std::uint8_t opposite; ///< the corner that is not on it
    Normal atLow, atHigh;
};

bool isBefore(const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.opposite) < std::tie(b.low, b.high, b.triangle, b.opposite);
}

/// Turned to one side or the other: a proxy does not feel which.
bool goesOn(const Side& a, const Side& b) {
    const auto same = [&](float sign) {
        return (a.atLow - sign * b.atLow).norm() < kSameNormal &&
               (a.atHigh - sign * b.atHigh).norm() < kSameNormal;
    };
    return same(1) || same(-1);
}

std::vector<Side> sidesOf(const TriangleSoup& soup, std::span<const Normal> corners,
                          const std::vector<Index>& place) {
    std::vector<Side> sides;
    sides.reserve(3 * soup.triangles.size());
    for (Index i = 0; i < Index(soup.triangles.size()); ++i)
        for (std::uint8_t k = 0; k < 3; ++k) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            Side side{place[soup.triangles[i][a]], place[soup.triangles[i][b]], i, k,
                      corners[3 * i + a],          corners[3 * i + b]};
            if (side.low > side.high) {
                std::swap(side.low, side.high);
                std::swap(side.atLow, side.atHigh);
            }
            sides.push_back(side);
        }
    std::ranges::sort(sides, isBefore);
    return sides;
}

/// Like the weld map, but for the last digits of the coordinates: formulas and exporters lose them.
std::vector<Index> roundedWeldMap(const TriangleSoup& soup) {
    const double cell = std::max(boundsOf(soup).diagonal(), 1e-300) * kSamePlace;
    std::vector<Vec3> rounded;
    rounded.reserve(soup.positions.size());
    for (const Vec3& p : soup.positions)
        rounded.push_back((p / cell).array().round());
    return weldMap(rounded);
}

std::vector<std::uint8_t> seamsOf(const TriangleSoup& soup, std::span<const Normal> corners) {
    const std::vector<Index> place = roundedWeldMap(soup);
    const std::vector<Side> sides = sidesOf(soup, corners, place);
    std::vector<std::uint8_t> seams(soup.triangles.size(), 0);
    std::vector<char> ends(soup.positions.size(), 0); // of each place: some edge of it is a seam
    for (std::size_t i = 0, j; i < sides.size(); i = j) {
        for (j = i + 1; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;)
            ++j;
        if (j - i == 2 && goesOn(sides[i], sides[i + 1])) continue;
        ends[sides[i].low] = ends[sides[i].high] = 1;
        for (std::size_t k = i; k < j; ++k)
            seams[sides[k].triangle] |= std::uint8_t(1 << sides[k].opposite);
    }
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (ends[place[soup.triangles[i][k]]]) seams[i] |= std::uint8_t(8 << k);
    return seams;
}

} // namespace

Result<std::shared_ptr<const SmoothNormals>>
compileNormals(const Shading& shading, const std::shared_ptr<const TriangleSoup>& soup,
               std::span<const std::shared_ptr<const SmoothNormals>> known, const Progress& progress) {
    assertNotRealtime();
    if (!shading.on || !soup) return nullptr;
    const bool fromFile = shading.normals == NormalSource::File && !soup->cornerNormals.empty();
    const double angle = fromFile ? -1 : kCreaseAngle.clamped(shading.creaseAngle);
    for (const auto& normals : known)
        if (normals && normals->creaseAngle == angle && haveSameShape(*normals->soup, *soup)) return normals;
    auto result = std::make_shared<SmoothNormals>();
    result->soup = soup;
    result->creaseAngle = angle;
    if (!fromFile) {
        auto computed = cornerNormalsOf(*soup, angle, progress);
        if (!computed) return tl::unexpected(computed.error());
        result->computed = std::move(*computed);
    }
    result->corners = fromFile ? soup->cornerNormals : result->computed;
    result->seams = seamsOf(*soup, result->corners);
    return std::shared_ptr<const SmoothNormals>(std::move(result));
}

} // namespace tactum
