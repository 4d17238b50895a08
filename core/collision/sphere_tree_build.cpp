// Building: leaf spheres, a binary tree by halving the longest axis (section 5), folded into wide nodes.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>

#include "core/base/parallel.h"
#include "core/collision/leaf_cover.h"
#include "core/collision/sphere_tree.h"

namespace tactum {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr int kLeafSize = SphereTree::kWidth;
// Below this many spheres a second thread costs more than it saves.
constexpr std::size_t kWorthAThread = 1 << 16;
// Halving the longest axis could peel one sphere at a time off a set that crowds geometrically toward a
// point; below this depth the spheres are halved by number, which bounds the depth and with it the sweep's
// stack.
constexpr int kDeep = 64;
constexpr float kOutward = 1 + 1e-6f; // covers the few roundings of one radius computation

struct Sphere {
    Vec3f centre = Vec3f::Zero();
    float radius = 0;
};

// A node of the binary tree: leaves [begin, end) of the ordered spheres; children -1 when it is not divided.
struct BinaryNode {
    Sphere sphere;
    std::uint32_t begin = 0, end = 0;
    std::int32_t left = -1, right = -1;
};

struct Box {
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = -low;
    void add(const LeafSphere& s) {
        low = low.cwiseMin((s.centre.array() - s.radius).matrix());
        high = high.cwiseMax((s.centre.array() + s.radius).matrix());
    }
};

// First heuristic: the smallest sphere around two spheres.
Sphere around(const Sphere& a, const Sphere& b) {
    const Vec3f way = b.centre - a.centre;
    const float distance = way.norm();
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const float radius = 0.5f * (distance + a.radius + b.radius);
    Sphere both;
    both.centre = a.centre + way * ((radius - a.radius) / distance);
    both.radius =
        std::max((both.centre - a.centre).norm() + a.radius, (both.centre - b.centre).norm() + b.radius) *
        kOutward;
    return both;
}

class Builder {
public:
    explicit Builder(std::vector<LeafSphere>& leaves) : leaves_(leaves) {
        nodes_.resize(2 * leaves.size() + 1);
    }

    std::int32_t build(std::size_t begin, std::size_t end, int depth = 0) {
        const std::int32_t index = next_.fetch_add(1, std::memory_order_relaxed);
        BinaryNode& node = nodes_[index];
        node.begin = std::uint32_t(begin);
        node.end = std::uint32_t(end);
        Box box;
        for (std::size_t i = begin; i < end; ++i)
            box.add(leaves_[i]);
        if (end - begin > kLeafSize) {
            const std::size_t middle = divide(begin, end, box, depth);
            buildChildren(node, begin, middle, end, depth + 1);
        }
        node.sphere = aroundLeaves(box, begin, end);
        if (node.left >= 0) {
            const Sphere merged = around(nodes_[node.left].sphere, nodes_[node.right].sphere);
            if (merged.radius < node.sphere.radius) node.sphere = merged;
        }
        return index;
    }

    const BinaryNode& node(std::int32_t i) const { return nodes_[i]; }

private:
    void buildChildren(BinaryNode& node, std::size_t begin, std::size_t middle, std::size_t end, int depth) {
        if (end - begin < kWorthAThread) {
            node.left = build(begin, middle, depth);
            node.right = build(middle, end, depth);
            return;
        }
        auto left = std::async(std::launch::async, [&] { return build(begin, middle, depth); });
        node.right = build(middle, end, depth);
        node.left = left.get();
    }

    // Along the plane through the midpoint of the longest axis; by number where that leaves a side empty.
    std::size_t divide(std::size_t begin, std::size_t end, const Box& box, int depth) {
        int axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const float plane = 0.5f * (box.low[axis] + box.high[axis]);
        const auto first = leaves_.begin() + std::ptrdiff_t(begin),
                   last = leaves_.begin() + std::ptrdiff_t(end);
        auto middle =
            std::partition(first, last, [&](const LeafSphere& s) { return s.centre[axis] < plane; });
        if (depth > kDeep || middle == first || middle == last) {
            middle = first + (last - first) / 2;
            std::nth_element(first, middle, last, [&](const LeafSphere& a, const LeafSphere& b) {
                return a.centre[axis] < b.centre[axis];
            });
        }
        return std::size_t(middle - leaves_.begin());
    }

    // Second heuristic: about the middle of the box, just large enough for the leaf spheres.
    Sphere aroundLeaves(const Box& box, std::size_t begin, std::size_t end) const {
        Sphere sphere;
        sphere.centre = 0.5f * (box.low + box.high);
        for (std::size_t i = begin; i < end; ++i)
            sphere.radius =
                std::max(sphere.radius, (leaves_[i].centre - sphere.centre).norm() + leaves_[i].radius);
        sphere.radius *= kOutward;
        return sphere;
    }

    std::vector<LeafSphere>& leaves_;
    std::vector<BinaryNode> nodes_;
    std::atomic<std::int32_t> next_{0};
};

struct Range {
    std::uint32_t begin = 0, end = 0;
};

// Which leaf spheres lie below each child of each node.
using ChildRanges = std::vector<std::array<Range, SphereTree::kWidth>>;

// Folds the binary tree into wide nodes: the child with the largest sphere is opened until eight are there.
class Folder {
public:
    Folder(const Builder& tree, const std::vector<LeafSphere>& leafSpheres, const TriangleSoup& soup,
           const Vec3& origin)
        : tree_(tree), leafSpheres_(leafSpheres), soup_(soup), origin_(origin) {
        // The binary tree's leaves hold more than half of what fits on average.
        leaves.reserve(leafSpheres.size() / 4);
        nodes.reserve(leafSpheres.size() / 12);
        ranges.reserve(leafSpheres.size() / 12);
    }

    std::vector<SphereTree::Node> nodes;
    std::vector<SphereTree::Leaf> leaves;
    ChildRanges ranges;

    void fold(std::int32_t binary) {
        std::int32_t open[SphereTree::kWidth] = {binary};
        const int count = openChildren(open);
        const std::size_t index = appendNode();
        for (int i = 0; i < count; ++i) {
            const BinaryNode& child = tree_.node(open[i]);
            place(nodes[index], i, child.sphere);
            ranges[index][i] = {child.begin, child.end};
            if (child.left < 0) {
                nodes[index].child[i] = ~std::int32_t(leaves.size());
                foldLeaf(child);
            } else {
                nodes[index].child[i] = std::int32_t(nodes.size());
                fold(open[i]);
            }
        }
    }

private:
    int openChildren(std::int32_t (&open)[SphereTree::kWidth]) const {
        int count = 1;
        while (count < SphereTree::kWidth) {
            int widest = -1;
            for (int i = 0; i < count; ++i) {
                if (tree_.node(open[i]).left < 0) continue;
                if (widest < 0 || tree_.node(open[i]).sphere.radius > tree_.node(open[widest]).sphere.radius)
                    widest = i;
            }
            if (widest < 0) break;
            const BinaryNode& opened = tree_.node(open[widest]);
            open[widest] = opened.left;
            open[count++] = opened.right;
        }
        return count;
    }

    void foldLeaf(const BinaryNode& binary) {
        SphereTree::Leaf& leaf = leaves.emplace_back();
        for (LaneArray* lane :
             {&leaf.ax, &leaf.ay, &leaf.az, &leaf.bx, &leaf.by, &leaf.bz, &leaf.cx, &leaf.cy, &leaf.cz})
            std::fill(std::begin(lane->v), std::end(lane->v), 1e15f);
        for (std::uint32_t k = binary.begin; k < binary.end; ++k) {
            const int i = int(k - binary.begin);
            const LeafSphere& sphere = leafSpheres_[k];
            const auto& corner = soup_.triangles[sphere.triangle];
            const Triangle part =
                pieceOf({soup_.positions[corner[0]] - origin_, soup_.positions[corner[1]] - origin_,
                         soup_.positions[corner[2]] - origin_},
                        sphere.piece);
            set(leaf.ax, leaf.ay, leaf.az, i, part.a);
            set(leaf.bx, leaf.by, leaf.bz, i, part.b);
            set(leaf.cx, leaf.cy, leaf.cz, i, part.c);
            leaf.triangle[i] = sphere.triangle;
        }
    }

    static void set(LaneArray& x, LaneArray& y, LaneArray& z, int i, const Vec3& p) {
        x[i] = float(p.x());
        y[i] = float(p.y());
        z[i] = float(p.z());
    }

    std::size_t appendNode() {
        SphereTree::Node& node = nodes.emplace_back();
        std::fill(std::begin(node.radius.v), std::end(node.radius.v), -1e30f);
        ranges.emplace_back();
        return nodes.size() - 1;
    }

    static void place(SphereTree::Node& node, int i, const Sphere& sphere) {
        node.x[i] = sphere.centre.x();
        node.y[i] = sphere.centre.y();
        node.z[i] = sphere.centre.z();
        node.radius[i] = sphere.radius;
    }

    const Builder& tree_;
    const std::vector<LeafSphere>& leafSpheres_;
    const TriangleSoup& soup_;
    Vec3 origin_;
};

// The pair of planes around what a child holds, where that is flat.
class Flattener {
public:
    Flattener(const TriangleSoup& soup, const std::vector<LeafSphere>& leafSpheres, const Vec3& origin)
        : soup_(soup), leafSpheres_(leafSpheres), origin_(origin) {}

    void flatten(std::vector<SphereTree::Node>& nodes, const ChildRanges& ranges) const {
        parallelFor(nodes.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                for (int i = 0; i < SphereTree::kWidth; ++i)
                    flatten(nodes[k], i, ranges[k][i]);
        });
    }

private:
    // Larger patches are rarely flat, and looking at all their corners at every level would cost the build.
    static constexpr std::uint32_t kLargestPatch = 1024;
    // A patch is worth its planes when they lie this much closer together than its sphere is wide.
    static constexpr double kFlat = 0.3;

    std::array<const Vec3*, 3> corners(std::uint32_t k) const {
        const auto& corner = soup_.triangles[leafSpheres_[k].triangle];
        return {&soup_.positions[corner[0]], &soup_.positions[corner[1]], &soup_.positions[corner[2]]};
    }

    void flatten(SphereTree::Node& node, int i, Range range) const {
        if (range.begin == range.end || range.end - range.begin > kLargestPatch) return;
        Vec3 sum = Vec3::Zero();
        for (std::uint32_t k = range.begin; k < range.end; ++k) {
            const auto [a, b, c] = corners(k);
            sum += (*b - *a).cross(*c - *a);
        }
        if (!(sum.squaredNorm() > 0)) return;
        // The planes are exact for the rounded normal: that it is not quite of unit length is covered by the
        // query's own margin.
        const Vec3f normal = sum.normalized().cast<float>();
        const Vec3 centre = origin_ + Vec3(node.x[i], node.y[i], node.z[i]);
        double low = 1e300, high = -1e300;
        for (std::uint32_t k = range.begin; k < range.end; ++k)
            for (const Vec3* corner : corners(k)) {
                const double height = normal.cast<double>().dot(*corner - centre);
                low = std::min(low, height);
                high = std::max(high, height);
            }
        if (high - low > 2 * kFlat * double(node.radius[i])) return;
        node.nx[i] = normal.x();
        node.ny[i] = normal.y();
        node.nz[i] = normal.z();
        node.offset[i] = float(0.5 * (low + high));
        const double thickness = std::max(high - double(node.offset[i]), double(node.offset[i]) - low);
        node.thickness[i] = std::nextafter(float(thickness), std::numeric_limits<float>::infinity());
    }

    const TriangleSoup& soup_;
    const std::vector<LeafSphere>& leafSpheres_;
    Vec3 origin_;
};

// Zero where single precision does as well with it.
Vec3 originFor(const TriangleSoup& soup) {
    constexpr double kFar = 4; // times as far away as large
    const Bounds box = boundsOf(soup);
    return box.centre().norm() > kFar * box.diagonal() ? box.centre() : Vec3(Vec3::Zero());
}

} // namespace

SphereTree::SphereTree(const TriangleSoup& soup) {
    if (soup.triangles.empty()) return;
    origin_ = originFor(soup);
    std::vector<LeafSphere> leafSpheres = coverWithSpheres(soup, origin_);
    Builder builder(leafSpheres);
    const std::int32_t root = builder.build(0, leafSpheres.size());
    Folder folder(builder, leafSpheres, soup, origin_);
    folder.fold(root);
    Flattener(soup, leafSpheres, origin_).flatten(folder.nodes, folder.ranges);
    nodes_ = std::move(folder.nodes);
    leaves_ = std::move(folder.leaves);
}

std::vector<BoundingSphere> SphereTree::spheresAt(int depth) const {
    std::vector<BoundingSphere> spheres;
    if (nodes_.empty()) return spheres;
    std::vector<std::pair<std::int32_t, int>> open{{0, 0}};
    while (!open.empty()) {
        const auto [index, level] = open.back();
        open.pop_back();
        const Node& node = nodes_[std::size_t(index)];
        for (int i = 0; i < kWidth; ++i) {
            if (node.radius[i] < 0) continue;
            if (level < depth && node.child[i] >= 0)
                open.emplace_back(node.child[i], level + 1);
            else
                spheres.push_back(
                    {origin_.cast<float>() + Vec3f(node.x[i], node.y[i], node.z[i]), node.radius[i]});
        }
    }
    return spheres;
}

} // namespace tactum
