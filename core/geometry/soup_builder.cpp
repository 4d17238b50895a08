#include "core/geometry/soup_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactum {

void SoupBuilder::reserve(std::size_t triangles) {
    triangles_.reserve(triangles);
    surfaceOf_.reserve(triangles);
}

void SoupBuilder::add(std::span<const PolygonCorner> corners, Index surface) {
    if (corners.size() == 3) return push(corners[0], corners[1], corners[2], surface);
    outline_.clear();
    for (const PolygonCorner& corner : corners)
        outline_.push_back(pools_->positions[corner.position]);
    for (const auto& t : cutter_.cut(outline_))
        push(corners[t[0]], corners[t[1]], corners[t[2]], surface);
    report_.cutPolygons += corners.size() > 3;
    report_.shortPolygons += corners.size() == 1 || corners.size() == 2;
    report_.emptyPolygons += corners.empty();
    report_.fannedPolygons += cutter_.gaveUp();
}

void SoupBuilder::push(const PolygonCorner& a, const PolygonCorner& b, const PolygonCorner& c,
                       Index surface) {
    track(normalOf_, {a.normal, b.normal, c.normal});
    track(uvOf_, {a.uv, b.uv, c.uv});
    triangles_.push_back({a.position, b.position, c.position});
    surfaceOf_.push_back(surface);
}

/// Keeps the list empty as long as nobody has anything to put into it.
void SoupBuilder::track(std::vector<Index>& indices, const std::array<Index, 3>& three) {
    if (indices.empty()) {
        if (three == std::array{kNone, kNone, kNone}) return;
        indices.reserve(3 * triangles_.capacity());
        indices.assign(3 * triangles_.size(), kNone);
    }
    indices.insert(indices.end(), three.begin(), three.end());
}

TriangleSoup SoupBuilder::finish(std::vector<Vec3> positions, BuildReport& report) {
    TriangleSoup soup;
    soup.positions = std::move(positions);
    soup.triangles = std::move(triangles_);
    soup.surfaceOf = std::move(surfaceOf_);
    if (!normalOf_.empty()) fillNormals(soup, report_);
    if (!uvOf_.empty()) fillUvs(soup, report_);
    report = report_;
    return soup;
}

TriangleSoup SoupBuilder::finishCompact(BuildReport& report) {
    std::vector<Index> newIndex(pools_->positions.size(), kNone);
    std::vector<Vec3> used;
    for (auto& triangle : triangles_)
        for (Index& corner : triangle) {
            Index& mapped = newIndex[corner];
            if (mapped == kNone) {
                mapped = Index(used.size());
                used.push_back(pools_->positions[corner]);
            }
            corner = mapped;
        }
    return finish(std::move(used), report);
}

void SoupBuilder::fillNormals(TriangleSoup& soup, BuildReport& report) const {
    soup.cornerNormals.resize(normalOf_.size());
    for (std::size_t i = 0; i < normalOf_.size(); ++i) {
        const Eigen::Vector3f normal =
            normalOf_[i] == kNone ? Eigen::Vector3f::Zero().eval() : pools_->normals[normalOf_[i]];
        const float length = normal.norm();
        if (length > 1e-20f && std::isfinite(length)) {
            // One that is of unit length but for rounding keeps its bits: reading what was written changes
            // nothing.
            soup.cornerNormals[i] = std::abs(length - 1) < 1e-6f ? normal : (normal / length).eval();
            continue;
        }
        ++report.filledNormals;
        const auto& t = soup.triangles[i / 3];
        const Vec3& a = soup.positions[t[0]];
        const Vec3 own = (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a);
        soup.cornerNormals[i] =
            own.norm() > 0 ? own.normalized().cast<float>().eval() : Eigen::Vector3f::UnitZ().eval();
    }
}

void SoupBuilder::fillUvs(TriangleSoup& soup, BuildReport& report) const {
    soup.cornerUvs.resize(uvOf_.size(), Eigen::Vector2f::Zero());
    for (std::size_t i = 0; i < uvOf_.size(); ++i) {
        const bool usable = uvOf_[i] != kNone && pools_->uvs[uvOf_[i]].allFinite();
        if (usable) soup.cornerUvs[i] = pools_->uvs[uvOf_[i]];
        report.filledUvs += !usable;
    }
}

} // namespace tactum
