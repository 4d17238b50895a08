#include "core/paint/soup_reach.h"

#include <algorithm>
#include <cstdint>

#include "core/base/realtime.h"

namespace tactum {
namespace {

/// The lowest 21 bits, two zeros between each two of them.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t mortonCode(const Vec3& part) {
    constexpr double kCells = 1 << 21;
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis)
        code |= spread(std::uint64_t(std::clamp(part[axis] * kCells, 0.0, kCells - 1))) << axis;
    return code;
}

} // namespace

SoupReach::SoupReach(std::shared_ptr<const TriangleSoup> soup) : soup_(std::move(soup)) {
    assertNotRealtime();
    const auto& positions = soup_->positions;
    const Bounds box = boundsOf(*soup_);
    const double size = box.empty() ? 1 : std::max((box.high - box.low).maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint64_t, Index>> codes;
    codes.reserve(soup_->triangles.size());
    for (const auto& t : soup_->triangles) {
        const Vec3 middle = (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3;
        codes.emplace_back(mortonCode((middle - box.low) / size), Index(codes.size()));
    }
    std::ranges::sort(codes);
    order_.reserve(codes.size());
    for (const auto& [code, triangle] : codes)
        order_.push_back(triangle);
    if (order_.empty()) return;
    buildLeaves();
    while (levels_.back().size() > 1) {
        const std::vector<Bounds>& below = levels_.back();
        std::vector<Bounds> boxes((below.size() + kNode - 1) / kNode);
        for (std::size_t i = 0; i < below.size(); ++i) {
            boxes[i / kNode].add(below[i].low);
            boxes[i / kNode].add(below[i].high);
        }
        levels_.push_back(std::move(boxes));
    }
}

void SoupReach::buildLeaves() {
    std::vector<Bounds> boxes((order_.size() + kLeaf - 1) / kLeaf);
    for (std::size_t i = 0; i < order_.size(); ++i)
        for (const Index corner : soup_->triangles[order_[i]])
            boxes[i / kLeaf].add(soup_->positions[corner]);
    levels_.push_back(std::move(boxes));
}

bool SoupReach::faces(Index triangle, const Vec3& normal) const {
    const auto& t = soup_->triangles[triangle];
    if (t[1] == t[2]) return true;
    const Vec3& a = soup_->positions[t[0]];
    return (soup_->positions[t[1]] - a).cross(soup_->positions[t[2]] - a).dot(normal) > 0;
}

} // namespace tactum
