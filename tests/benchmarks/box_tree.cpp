#include "tests/benchmarks/box_tree.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/collision/leaf_cover.h"

namespace tactum::bench {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr int kDeep = 48, kBins = 16;

struct Box {
    Vec3f low = Vec3f::Constant(kInfinite), high = Vec3f::Constant(-kInfinite);

    void add(const Vec3f& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void add(const Box& box) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    Vec3f centre() const { return 0.5f * (low + high); }
    float area() const {
        const Vec3f e = (high - low).cwiseMax(0.0f);
        return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
    }
};

struct Piece {
    Triangle corners;
    Box box;
    Index triangle;
};

struct BinaryNode {
    Box box;
    std::size_t begin = 0, end = 0;
    std::int32_t left = -1, right = -1;
};

// The float below or above a double, wherever the conversion went.
Vec3f outward(const Vec3& p, float direction) {
    Vec3f result;
    for (int k = 0; k < 3; ++k)
        result[k] = std::nextafter(float(p[k]), direction);
    return result;
}

std::vector<Piece> piecesOf(const TriangleSoup& soup) {
    std::vector<Piece> pieces;
    for (const LeafSphere& sphere : coverWithSpheres(soup)) {
        const auto& corner = soup.triangles[sphere.triangle];
        Piece piece;
        piece.corners = pieceOf(
            {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]}, sphere.piece);
        piece.triangle = sphere.triangle;
        for (const Vec3& p : {piece.corners.a, piece.corners.b, piece.corners.c}) {
            piece.box.add(outward(p, -kInfinite));
            piece.box.add(outward(p, kInfinite));
        }
        pieces.push_back(piece);
    }
    return pieces;
}

class Builder {
public:
    Builder(std::vector<Piece>& pieces, BoxTree::Division division) : pieces_(pieces), division_(division) {
        build(0, pieces.size(), 0);
    }

    std::vector<BinaryNode> nodes;

private:
    std::int32_t build(std::size_t begin, std::size_t end, int depth) {
        const std::int32_t index = std::int32_t(nodes.size());
        nodes.emplace_back();
        Box box, centres;
        for (std::size_t i = begin; i < end; ++i) {
            box.add(pieces_[i].box);
            centres.add(pieces_[i].box.centre());
        }
        std::int32_t left = -1, right = -1;
        if (end - begin > std::size_t(kLanes)) {
            const std::size_t middle = divide(begin, end, centres, depth);
            left = build(begin, middle, depth + 1);
            right = build(middle, end, depth + 1);
        }
        nodes[std::size_t(index)] = {box, begin, end, left, right};
        return index;
    }

    std::size_t divide(std::size_t begin, std::size_t end, const Box& centres, int depth) {
        const auto first = pieces_.begin() + std::ptrdiff_t(begin),
                   last = pieces_.begin() + std::ptrdiff_t(end);
        int axis = 0;
        (centres.high - centres.low).maxCoeff(&axis);
        const float plane = division_ == BoxTree::Division::Midpoint
                                ? centres.centre()[axis]
                                : cheapestPlane(begin, end, centres, axis);
        auto middle =
            std::partition(first, last, [&](const Piece& p) { return p.box.centre()[axis] < plane; });
        if (depth > kDeep || middle == first || middle == last) {
            middle = first + (last - first) / 2;
            std::nth_element(first, middle, last, [&](const Piece& a, const Piece& b) {
                return a.box.centre()[axis] < b.box.centre()[axis];
            });
        }
        return std::size_t(middle - pieces_.begin());
    }

    // The boundary of bins, along the longest axis, at which the surface area heuristic is least.
    float cheapestPlane(std::size_t begin, std::size_t end, const Box& centres, int axis) const {
        const float low = centres.low[axis], width = (centres.high[axis] - low) / kBins;
        if (!(width > 0)) return low;
        std::array<Box, kBins> box;
        std::array<float, kBins> count{};
        for (std::size_t i = begin; i < end; ++i) {
            const int bin = std::min(kBins - 1, int((pieces_[i].box.centre()[axis] - low) / width));
            box[std::size_t(bin)].add(pieces_[i].box);
            ++count[std::size_t(bin)];
        }
        std::array<float, kBins> before{};
        Box left, right;
        float heldLeft = 0, heldRight = 0;
        for (std::size_t b = 0; b + 1 < kBins; ++b) {
            left.add(box[b]);
            before[b + 1] = left.area() * (heldLeft += count[b]);
        }
        float least = kInfinite, plane = low;
        for (std::size_t b = kBins - 1; b > 0; --b) {
            right.add(box[b]);
            const float cost = before[b] + right.area() * (heldRight += count[b]);
            if (cost < least) least = cost, plane = low + float(b) * width;
        }
        return plane;
    }

    std::vector<Piece>& pieces_;
    BoxTree::Division division_;
};

// Folds the binary tree into nodes of eight: the child with the largest box is opened first.
class Folder {
public:
    Folder(const std::vector<BinaryNode>& binary, const std::vector<Piece>& pieces)
        : binary_(binary), pieces_(pieces) {}

    std::vector<BoxTree::Node> nodes;
    std::vector<SphereTree::Leaf> leaves;

    std::int32_t fold(std::int32_t root) {
        std::vector<std::int32_t> open{root};
        while (open.size() < std::size_t(kLanes) && openLargest(open)) {
        }
        const std::size_t index = nodes.size();
        BoxTree::Node& node = nodes.emplace_back();
        for (LaneArray* lane : {&node.lx, &node.ly, &node.lz, &node.hx, &node.hy, &node.hz})
            std::fill(std::begin(lane->v), std::end(lane->v), 1e15f);
        for (std::size_t i = 0; i < open.size(); ++i) {
            place(nodes[index], int(i), at(open[i]).box);
            const std::int32_t child = at(open[i]).left < 0 ? ~foldLeaf(at(open[i])) : fold(open[i]);
            nodes[index].child[i] = child;
        }
        return std::int32_t(index);
    }

private:
    const BinaryNode& at(std::int32_t i) const { return binary_[std::size_t(i)]; }

    bool openLargest(std::vector<std::int32_t>& open) const {
        std::int32_t* largest = nullptr;
        for (std::int32_t& i : open)
            if (at(i).left >= 0 && (!largest || at(i).box.area() > at(*largest).box.area())) largest = &i;
        if (!largest) return false;
        const BinaryNode& opened = at(*largest);
        *largest = opened.left;
        open.push_back(opened.right);
        return true;
    }

    static void place(BoxTree::Node& node, int i, const Box& box) {
        node.lx[i] = box.low.x();
        node.ly[i] = box.low.y();
        node.lz[i] = box.low.z();
        node.hx[i] = box.high.x();
        node.hy[i] = box.high.y();
        node.hz[i] = box.high.z();
    }

    std::int32_t foldLeaf(const BinaryNode& binary) {
        SphereTree::Leaf& leaf = leaves.emplace_back();
        const std::array<LaneArray*, 9> lanes{&leaf.ax, &leaf.ay, &leaf.az, &leaf.bx, &leaf.by,
                                              &leaf.bz, &leaf.cx, &leaf.cy, &leaf.cz};
        for (LaneArray* lane : lanes)
            std::fill(std::begin(lane->v), std::end(lane->v), 1e15f);
        for (std::size_t k = binary.begin; k < binary.end; ++k) {
            const int i = int(k - binary.begin);
            const Triangle& t = pieces_[k].corners;
            const std::array<Vec3, 3> corners{t.a, t.b, t.c};
            for (std::size_t c = 0; c < 9; ++c)
                (*lanes[c])[i] = float(corners[c / 3][Eigen::Index(c % 3)]);
            leaf.triangle[i] = pieces_[k].triangle;
        }
        return std::int32_t(leaves.size()) - 1;
    }

    const std::vector<BinaryNode>& binary_;
    const std::vector<Piece>& pieces_;
};

} // namespace

BoxTree::BoxTree(const TriangleSoup& soup, Division division) {
    std::vector<Piece> pieces = piecesOf(soup);
    if (pieces.empty()) return;
    const Builder builder(pieces, division);
    Folder folder(builder.nodes, pieces);
    folder.fold(0);
    nodes_ = std::move(folder.nodes);
    leaves_ = std::move(folder.leaves);
}

} // namespace tactum::bench
