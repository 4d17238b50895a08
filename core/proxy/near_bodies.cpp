#include "core/proxy/near_bodies.h"

#include <algorithm>

#include "core/base/realtime.h"
#include "core/proxy/straddled_bodies.h"

namespace tactum {
namespace {

constexpr std::size_t kLeaf = 8; ///< bodies

} // namespace

struct NearBodies::Box {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    std::uint32_t body = 0;

    void add(const Box& other) { low = low.cwiseMin(other.low), high = high.cwiseMax(other.high); }
    Vec3 middle() const { return 0.5 * (low + high); }

    /// Around the spheres below the root of its mesh.
    static Box around(const Obstacle& obstacle, std::uint32_t body) {
        Box box;
        box.body = body;
        const SphereTree& tree = obstacle.mesh->tree;
        if (tree.nodes().empty()) return box;
        const SphereTree::Node& root = tree.nodes().front();
        for (int i = 0; i < SphereTree::kWidth; ++i) {
            if (!(root.radius[i] >= 0)) continue;
            const Vec3 centre = obstacle.pose.apply(tree.origin() + Vec3(root.x[i], root.y[i], root.z[i]));
            // Single precision was rounded outward; the pose is not.
            const double radius = double(root.radius[i]) + 1e-12 * centre.norm();
            box.low = box.low.cwiseMin(centre - Vec3::Constant(radius));
            box.high = box.high.cwiseMax(centre + Vec3::Constant(radius));
        }
        return box;
    }
};

NearBodies::NearBodies(std::span<const Obstacle> obstacles) : oneSided_(anyOneSided(obstacles)) {
    assertNotRealtime();
    std::vector<Box> boxes;
    for (std::uint32_t body = 0; body < obstacles.size(); ++body) {
        if (obstacles[body].mover >= 0)
            moving_.push_back(body);
        else
            boxes.push_back(Box::around(obstacles[body], body));
    }
    if (boxes.empty()) return;
    nodes_.reserve(2 * boxes.size());
    still_.reserve(boxes.size());
    nodes_.emplace_back();
    split(0, boxes);
}

/// At the middle one along the longest side of where the boxes' middles are.
void NearBodies::split(std::size_t node, std::span<Box> boxes) {
    Box all, middles;
    for (const Box& box : boxes) {
        all.add(box);
        const Vec3 middle = box.middle();
        middles.low = middles.low.cwiseMin(middle), middles.high = middles.high.cwiseMax(middle);
    }
    nodes_[node].low = all.low, nodes_[node].high = all.high;
    if (boxes.size() <= kLeaf) {
        nodes_[node].first = std::int32_t(still_.size());
        nodes_[node].bodies = std::int32_t(boxes.size());
        std::ranges::sort(boxes, {}, &Box::body);
        for (const Box& box : boxes)
            still_.push_back(box.body);
        return;
    }
    int axis = 0;
    (middles.high - middles.low).maxCoeff(&axis);
    const std::size_t half = boxes.size() / 2;
    std::ranges::nth_element(boxes, boxes.begin() + std::ptrdiff_t(half), [axis](const Box& a, const Box& b) {
        const double x = a.middle()[axis], y = b.middle()[axis];
        return x != y ? x < y : a.body < b.body;
    });
    const std::size_t first = nodes_.size();
    nodes_[node].first = std::int32_t(first);
    nodes_.resize(first + 2);
    split(first, boxes.first(half));
    split(first + 1, boxes.subspan(half));
}

} // namespace tactum
