// Building: leaf spheres, a binary tree by halving the longest axis (section 5), folded into wide nodes.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>

#include "core/base/parallel.h"
#include "core/collision/child_fit.h"
#include "core/collision/leaf_box.h"
#include "core/collision/leaf_cover.h"
#include "core/collision/leaf_packing.h"
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
        LeafBox box = LeafBox::empty();
        for (std::size_t i = begin; i < end; ++i)
            box.add(LeafBox(leaves_[i]));
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
    // Few are packed into their leaves.
    std::size_t divide(std::size_t begin, std::size_t end, const LeafBox& box, int depth) {
        if (end - begin <= kMostPacked && depth <= kDeep)
            return begin + packLeaves(std::span(leaves_).subspan(begin, end - begin), kLeafSize);
        int axis = 0;
        box.size().maxCoeff(&axis);
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
    Sphere aroundLeaves(const LeafBox& box, std::size_t begin, std::size_t end) const {
        Sphere sphere;
        sphere.centre = box.middle();
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

// Folds the binary tree into wide nodes: the child with the largest sphere is opened until eight are there.
class Folder {
public:
    Folder(const Builder& tree, const std::vector<LeafSphere>& leafSpheres, const TriangleSoup& soup,
           const Vec3& origin)
        : tree_(tree), leafSpheres_(leafSpheres), soup_(soup), origin_(origin) {
        // Leaves are nearly full, seven of eight on average, and so are the nodes above them.
        leaves.reserve(leafSpheres.size() / 6);
        nodes.reserve(leafSpheres.size() / 24);
        ranges.reserve(leafSpheres.size() / 24);
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
            place(nodes[index], i, child.sphere.centre, child.sphere.radius);
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
            const Triangle part = partOf(leafSpheres_[k], soup_, origin_);
            set(leaf.ax, leaf.ay, leaf.az, i, part.a);
            set(leaf.bx, leaf.by, leaf.bz, i, part.b);
            set(leaf.cx, leaf.cy, leaf.cz, i, part.c);
            leaf.triangle[i] = leafSpheres_[k].triangle;
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

    const Builder& tree_;
    const std::vector<LeafSphere>& leafSpheres_;
    const TriangleSoup& soup_;
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
    fitChildren(folder.nodes, folder.ranges, soup, leafSpheres, origin_);
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
