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

    void add(const Vec3& centre, double radius) {
        low = low.cwiseMin(centre - Vec3::Constant(radius));
        high = high.cwiseMax(centre + Vec3::Constant(radius));
    }
};

namespace {

/// Single precision was rounded outward; poses are not.
constexpr double kPosesRound = 1e-12;

/// Calls f(centre, radius) for the spheres below the root of a mesh, body frame.
template <class F> void forEachSphere(const CollisionMesh& mesh, F&& f) {
    if (mesh.tree.nodes().empty()) return;
    const SphereTree::Node& root = mesh.tree.nodes().front();
    for (int i = 0; i < SphereTree::kWidth; ++i)
        if (root.radius[i] >= 0)
            f(mesh.tree.origin() + Vec3(root.x[i], root.y[i], root.z[i]), double(root.radius[i]));
}

template <class Box> void addPlaces(Box& box, const CollisionMesh& mesh, const Pose& pose) {
    forEachSphere(mesh, [&](const Vec3& centre_B, double radius) {
        const Vec3 centre = pose.apply(centre_B);
        box.add(centre, radius + kPosesRound * centre.norm());
    });
}

// A body that turns stays in a ball about its origin; a translation stays within its control points.
template <class Box> void addPlaces(Box& box, const CollisionMesh& mesh, const Mover& mover) {
    const bool turns = !mover.motion->rotation.times.empty();
    double reach = 0;
    forEachSphere(
        mesh, [&](const Vec3& centre, double radius) { reach = std::max(reach, centre.norm() + radius); });
    for (const Vec3& way : controlPoints(mover.motion->translation)) {
        const Pose pose = mover.rest * Pose{Quat::Identity(), way};
        if (turns)
            box.add(pose.translation, reach + kPosesRound * (reach + pose.translation.norm()));
        else
            addPlaces(box, mesh, pose);
    }
}

} // namespace

NearBodies::NearBodies(std::span<const Obstacle> obstacles, std::span<const Mover> movers)
    : oneSided_(anyOneSided(obstacles)) {
    assertNotRealtime();
    std::vector<Box> boxes;
    for (std::uint32_t body = 0; body < obstacles.size(); ++body) {
        const Obstacle& obstacle = obstacles[body];
        if (obstacle.mover >= 0 && movers[std::size_t(obstacle.mover)].driven >= 0) {
            driven_.push_back(body);
            continue;
        }
        Box& box = boxes.emplace_back();
        box.body = body;
        if (obstacle.mover >= 0)
            addPlaces(box, *obstacle.mesh, movers[std::size_t(obstacle.mover)]);
        else
            addPlaces(box, *obstacle.mesh, obstacle.pose);
    }
    if (boxes.empty()) return;
    nodes_.reserve(2 * boxes.size());
    bodies_.reserve(boxes.size());
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
        nodes_[node].first = std::int32_t(bodies_.size());
        nodes_[node].bodies = std::int32_t(boxes.size());
        std::ranges::sort(boxes, {}, &Box::body);
        for (const Box& box : boxes)
            bodies_.push_back(box.body);
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
