#include "core/collision/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactum {
namespace {

/// The builder bounds the depth to 64 levels and 32 halvings; each leaves at most seven children waiting.
constexpr int kStack = (64 + 32) * (SphereTree::kWidth - 1) + SphereTree::kWidth;
constexpr double kSame = 1 + 1e-9; ///< distances closer than that are one

struct Waiting {
    double distance; ///< of the child's sphere, at least
    std::int32_t child;
};

struct Search {
    const CollisionMesh& mesh;
    Vec3 p;
    Nearest best;
    std::array<Waiting, kStack> stack;
    int count = 0;

    void open(const SphereTree::Node& node) noexcept;
    void lookAt(const SphereTree::Leaf& leaf) noexcept;
    void lookAt(Index triangle) noexcept;
};

/// The nearest child is taken next.
void Search::open(const SphereTree::Node& node) noexcept {
    const int first = count;
    for (int i = 0; i < SphereTree::kWidth; ++i) {
        if (node.radius[i] < 0) continue;
        const double distance = (p - Vec3(node.x[i], node.y[i], node.z[i])).norm() - double(node.radius[i]);
        if (distance <= best.distance * kSame) stack[std::size_t(count++)] = {distance, node.child[i]};
    }
    std::sort(stack.begin() + first, stack.begin() + count,
              [](const Waiting& a, const Waiting& b) { return a.distance > b.distance; });
}

void Search::lookAt(Index triangle) noexcept {
    const auto& corners = mesh.soup->triangles[triangle];
    const auto& at = mesh.soup->positions;
    const Triangle shape{at[corners[0]], at[corners[1]], at[corners[2]]};
    const Vec3 point = closestPoint(shape, p).point;
    const Vec3 way = p - point;
    const double distance = way.norm();
    if (distance > best.distance * kSame) return;
    const Vec3 normal = (shape.b - shape.a).cross(shape.c - shape.a);
    const double scale = normal.norm() * distance;
    const double front = scale > 0 ? normal.dot(way) / scale : 0;
    const bool same = distance * kSame >= best.distance;
    if (same && std::abs(front) <= std::abs(best.front)) return;
    best = {std::min(distance, best.distance), triangle, point, front};
}

void Search::lookAt(const SphereTree::Leaf& leaf) noexcept {
    constexpr float kUnused = 1e14f; // an unused lane lies beyond
    for (int i = 0; i < SphereTree::kWidth; ++i)
        if (leaf.ax[i] < kUnused) lookAt(leaf.triangle[i]);
}

} // namespace

Nearest nearestOn(const CollisionMesh& mesh, const Vec3& p_B, double within) noexcept {
    Search search{.mesh = mesh, .p = p_B, .best = {}, .stack = {}};
    search.best.distance = within;
    const auto& nodes = mesh.tree.nodes();
    if (!nodes.empty()) search.open(nodes.front());
    bool found = false;
    while (search.count > 0) {
        const Waiting next = search.stack[std::size_t(--search.count)];
        if (next.distance > search.best.distance * kSame) continue;
        if (next.child >= 0)
            search.open(nodes[std::size_t(next.child)]);
        else
            search.lookAt(mesh.tree.leaves()[std::size_t(~next.child)]);
        found = found || search.best.distance < within;
    }
    return found ? search.best : Nearest{};
}

} // namespace tactum
