#include "core/surface/smooth_normals.h"

#include <algorithm>
#include <array>

#include "core/base/realtime.h"
#include "core/geometry/corner_normals.h"
#include "core/geometry/edges.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

using Normal = Eigen::Vector3f;

// Normals that files round to a few digits are the same still.
constexpr float kSameNormal = 1e-3f;
// Places that differ by less than about this part of the mesh's size are the same.
constexpr double kSamePlace = 1e-9;

/// Whether the normals go on from one triangle to the other. Turned to one side or the other: a proxy does
/// not feel which.
bool goOn(std::span<const Normal> corners, const EdgeUse& a, const EdgeUse& b) {
    const auto at = [&](const EdgeUse& use, bool low) {
        return corners[low == use.forward ? use.corner : nextCorner(use.corner)];
    };
    const auto same = [&](float sign) {
        return std::ranges::all_of(std::array{true, false}, [&](bool low) {
            return (at(a, low) - sign * at(b, low)).norm() < kSameNormal;
        });
    };
    return same(1) || same(-1);
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

void findSeams(const TriangleSoup& soup, SmoothNormals& normals) {
    const std::vector<Index> place = roundedWeldMap(soup);
    std::vector<Corners> placed(soup.triangles);
    for (Corners& t : placed)
        for (Index& corner : t)
            corner = place[corner];
    normals.seams.assign(placed.size(), 0);
    normals.across.assign(placed.size(), {normals.kNothing, normals.kNothing, normals.kNothing});
    std::vector<char> ends(place.size(), 0); // of each place: some edge of it is a seam
    const auto any = [](const Corners&) { return true; };
    // An edge is named by the corner that is not on it.
    const auto opposite = [](const EdgeUse& use) { return previousCorner(use.corner) % 3; };
    forEachEdge(placed, place.size(), any, [&](Index low, std::span<const EdgeUse> uses) {
        if (uses.size() == 2 && goOn(normals.corners, uses[0], uses[1])) {
            for (std::size_t i = 0; i < 2; ++i)
                normals.across[uses[i].corner / 3][opposite(uses[i])] = uses[1 - i].corner / 3;
            return;
        }
        ends[low] = ends[uses[0].high] = 1;
        for (const EdgeUse& use : uses)
            normals.seams[use.corner / 3] |= std::uint8_t(1 << opposite(use));
    });
    for (std::size_t i = 0; i < placed.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (ends[placed[i][k]]) normals.seams[i] |= std::uint8_t(8 << k);
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
    findSeams(*soup, *result);
    return std::shared_ptr<const SmoothNormals>(std::move(result));
}

} // namespace tactum
