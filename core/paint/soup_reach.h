// Which triangles of a mesh a brush may reach: found in the time that these take, not the mesh.
#pragma once

#include <memory>
#include <vector>

#include "core/paint/dab.h"

namespace tactum {

/// Boxes around runs of triangles along a Morton curve, and boxes around boxes. Built once for a mesh, on a
/// worker: a third of a second for a million triangles. Thread: any but real time; immutable after that.
class SoupReach {
public:
    /// `soup` is not null.
    explicit SoupReach(std::shared_ptr<const TriangleSoup> soup);

    const TriangleSoup& soup() const { return *soup_; }

    /// Calls visit(index) for every triangle that comes within `radius` (m, body frame) of the centre, and
    /// for some that do not; always in the same order.
    template <class Visit> void within(const Vec3& centre, double radius, Visit&& visit) const {
        if (!levels_.empty()) descend(levels_.size() - 1, 0, centre, radius * radius, visit);
    }
    /// Only those that this dab may paint: of an allowed surface, and facing its side. Segments and points
    /// face every side.
    template <class Visit>
    void paintable(const Dab& dab, double radius, const PaintableSurfaces& surfaces, Visit&& visit) const {
        within(dab.centre, radius, [&](Index triangle) {
            if (surfaces(soup_->surfaceOf[triangle]) && faces(triangle, dab.normal)) visit(triangle);
        });
    }

private:
    static constexpr std::size_t kLeaf = 8, kNode = 4; ///< triangles of a leaf, children of a node

    bool faces(Index triangle, const Vec3& normal) const;
    void buildLeaves();

    static double squaredDistance(const Bounds& box, const Vec3& p) {
        return (p - p.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
    }
    template <class Visit>
    void descend(std::size_t level, std::size_t i, const Vec3& centre, double squared, Visit& visit) const {
        if (squaredDistance(levels_[level][i], centre) > squared) return;
        const std::size_t begin = i * (level == 0 ? kLeaf : kNode);
        const std::size_t all = level == 0 ? order_.size() : levels_[level - 1].size();
        const std::size_t end = std::min(begin + (level == 0 ? kLeaf : kNode), all);
        for (std::size_t child = begin; child < end; ++child)
            if (level == 0)
                visit(order_[child]);
            else
                descend(level - 1, child, centre, squared, visit);
    }

    std::shared_ptr<const TriangleSoup> soup_;
    std::vector<Index> order_;                ///< triangles along the curve
    std::vector<std::vector<Bounds>> levels_; ///< leaves first; the last one has one box
};

} // namespace tactum
