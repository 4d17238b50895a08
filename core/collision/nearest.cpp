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
    Search(const CollisionMesh& theMesh, const Vec3& thePlace, std::span<const Sides> theSides) noexcept
        : mesh(theMesh), p(thePlace), sides(theSides) {}

    const CollisionMesh& mesh;
    Vec3 p;
    std::span<const Sides> sides;
    Nearest best{};
    Vec3 normal = Vec3::Zero();      ///< at the best point, of any length
    std::array<Index, 64> sharing{}; ///< the triangles that share it
    int sharingCount = 0;
    std::array<Waiting, kStack> stack;
    int count = 0;

    void open(const SphereTree::Node& node) noexcept;
    void lookAt(const SphereTree::Leaf& leaf) noexcept;
    void lookAt(Index triangle) noexcept;
    bool isNew(Index triangle) noexcept;
    double straightness(const Vec3& normalThere, const Vec3& point) const noexcept;
    Nearest result() const noexcept;
};

/// The nearest child is taken next.
void Search::open(const SphereTree::Node& node) noexcept {
    const int first = count;
    for (int i = 0; i < SphereTree::kWidth; ++i) {
        if (node.radius[i] < 0) continue;
        const Vec3 centre = mesh.tree.origin() + Vec3(node.x[i], node.y[i], node.z[i]);
        const double distance = (p - centre).norm() - double(node.radius[i]);
        if (distance <= best.distance * kSame) stack[std::size_t(count++)] = {distance, node.child[i]};
    }
    std::sort(stack.begin() + first, stack.begin() + count,
              [](const Waiting& a, const Waiting& b) { return a.distance > b.distance; });
}

/// What a triangle adds to the normal at a point of it: its own, by the angle it has at a vertex.
Vec3 normalAt(const Triangle& shape, const ClosestPoint& at) noexcept {
    const Vec3 normal = (shape.b - shape.a).cross(shape.c - shape.a);
    const double length = normal.norm();
    if (!(length > 0)) return Vec3::Zero();
    if (at.feature != Feature::Vertex) return normal / length;
    Eigen::Index corner = 0;
    at.weights.maxCoeff(&corner);
    const std::array<Vec3, 3> p{shape.a, shape.b, shape.c};
    const Vec3 &here = p[std::size_t(corner)], &next = p[std::size_t(corner + 1) % 3];
    const Vec3 one = next - here, other = p[std::size_t(corner + 2) % 3] - here;
    return std::atan2(one.cross(other).norm(), one.dot(other)) * normal / length;
}

/// Long triangles lie in several leaves, but count once.
bool Search::isNew(Index triangle) noexcept {
    const auto end = sharing.begin() + sharingCount;
    if (std::find(sharing.begin(), end, triangle) != end || sharingCount == int(sharing.size())) return false;
    sharing[std::size_t(sharingCount++)] = triangle;
    return true;
}

/// How straight a point of the surface is faced from here, from 0 to 1: the cosine to the normal there. Of
/// several that are as near, the one that is faced the straightest tells the side: from afar the edge of a
/// face that is seen from beside is hardly farther than the face next to it, which is the nearest.
double Search::straightness(const Vec3& normalThere, const Vec3& point) const noexcept {
    const double scale = normalThere.norm() * (p - point).norm();
    return scale > 0 ? std::abs(normalThere.dot(p - point)) / scale : 0;
}

void Search::lookAt(Index triangle) noexcept {
    if (!sides.empty() && sides[mesh.soup->surfaceOf[triangle]] == Sides::None) return;
    const auto& corners = mesh.soup->triangles[triangle];
    const auto& at = mesh.soup->positions;
    const Triangle shape{at[corners[0]], at[corners[1]], at[corners[2]]};
    const ClosestPoint closest = closestPoint(shape, p);
    const double distance = (p - closest.point).norm();
    if (distance > best.distance * kSame) return;
    const bool isFirst = sharingCount == 0 || distance * kSame < best.distance;
    const bool same = !isFirst && (closest.point - best.point).norm() <= (kSame - 1) * distance;
    if (!isFirst && !same &&
        straightness(normalAt(shape, closest), closest.point) <= straightness(normal, best.point))
        return;
    if (!same) {
        best = {distance, triangle, closest.point, 0};
        normal = Vec3::Zero();
        sharingCount = 0;
    }
    if (isNew(triangle)) normal += normalAt(shape, closest);
}

void Search::lookAt(const SphereTree::Leaf& leaf) noexcept {
    constexpr float kUnused = 1e14f; // an unused lane lies beyond
    for (int i = 0; i < SphereTree::kWidth; ++i)
        if (leaf.ax[i] < kUnused) lookAt(leaf.triangle[i]);
}

Nearest Search::result() const noexcept {
    if (sharingCount == 0) return {};
    Nearest found = best;
    const double scale = normal.norm() * best.distance;
    if (scale > 0) found.front = normal.dot(p - best.point) / scale;
    return found;
}

} // namespace

Nearest nearestOn(const CollisionMesh& mesh, const Vec3& p_B, double within,
                  std::span<const Sides> sides) noexcept {
    Search search(mesh, p_B, sides);
    search.best.distance = within;
    const auto& nodes = mesh.tree.nodes();
    if (!nodes.empty()) search.open(nodes.front());
    while (search.count > 0) {
        const Waiting next = search.stack[std::size_t(--search.count)];
        if (next.distance > search.best.distance * kSame) continue;
        if (next.child >= 0)
            search.open(nodes[std::size_t(next.child)]);
        else
            search.lookAt(mesh.tree.leaves()[std::size_t(~next.child)]);
    }
    return search.result();
}

} // namespace tactum
