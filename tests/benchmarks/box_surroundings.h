// What the sphere tree has for coherent sweeps, for boxes: so that both are measured as a proxy would use
// them.
#pragma once

#include <array>

#include "tests/benchmarks/descent.h"

namespace tactum::bench {
namespace {

/// The boxes that reach into a ball, opened as far as there is room: Neighbourhood over a BoxTree.
class BoxSurroundings {
public:
    explicit BoxSurroundings(std::span<const BoxTree::Node> nodes) : nodes_(nodes) {}

    bool hold(const SpherePath& path) const {
        return holds(path.from, path.radius) && holds(path.from + path.motion, path.radius);
    }

    void gather(const Vec3& centre, double radius) {
        centre_ = centre;
        radius_ = radius;
        const BoxPath ball({centre, Vec3::Zero(), radius});
        size_ = 1;
        bool opened = open(ball, nodes_[0], 0);
        while (opened) {
            opened = false;
            for (int i = size_ - 1; i >= 0; --i)
                if (entries_[std::size_t(i)].child() >= 0)
                    opened |= open(ball, nodes_[std::size_t(entries_[std::size_t(i)].child())], i);
        }
        write();
    }

    bool isEmpty() const { return radius_ < 0; }
    /// Not everything could be opened down to the leaves.
    bool isCrowded() const {
        return std::any_of(entries_.begin(), entries_.begin() + size_,
                           [](const Entry& e) { return e.child() >= 0; });
    }

    std::span<const BoxTree::Node> blocks() const {
        return {block_.data(), std::size_t(size_ + kLanes - 1) / kLanes};
    }

private:
    static constexpr int kRoom = Neighbourhood::kRoom;

    struct Entry {
        const BoxTree::Node* node = nullptr;
        int lane = 0;
        std::int32_t child() const { return node->child[lane]; }
    };

    bool holds(const Vec3& p, double around) const {
        const double room = radius_ - around;
        return room >= 0 && (p - centre_).squaredNorm() <= room * room;
    }

    bool open(const BoxPath& ball, const BoxTree::Node& node, int replaced) {
        unsigned reached = bits(ball.contactTime(node, 1) <= all(1));
        if (size_ - 1 + std::popcount(reached) > kRoom) return false;
        entries_[std::size_t(replaced)] = entries_[std::size_t(--size_)];
        for (; reached != 0; reached &= reached - 1)
            entries_[std::size_t(size_++)] = {&node, std::countr_zero(reached)};
        return true;
    }

    void write() {
        for (std::size_t i = 0; i < blocks().size() * kLanes; ++i) {
            BoxTree::Node& to = block_[i / kLanes];
            const int k = int(i % kLanes);
            if (i >= std::size_t(size_)) {
                to.lx[k] = to.ly[k] = to.lz[k] = to.hx[k] = to.hy[k] = to.hz[k] = 1e15f;
                continue;
            }
            const BoxTree::Node& from = *entries_[i].node;
            const int lane = entries_[i].lane;
            to.lx[k] = from.lx[lane];
            to.ly[k] = from.ly[lane];
            to.lz[k] = from.lz[lane];
            to.hx[k] = from.hx[lane];
            to.hy[k] = from.hy[lane];
            to.hz[k] = from.hz[lane];
            to.child[k] = from.child[lane];
        }
    }

    std::span<const BoxTree::Node> nodes_;
    Vec3 centre_ = Vec3::Zero();
    double radius_ = -1;
    int size_ = 0;
    std::array<Entry, kRoom> entries_;
    std::array<BoxTree::Node, Neighbourhood::kBlocks> block_;
};

/// sweepFrom over boxes, with the same rules for what to gather.
class CoherentBoxes {
public:
    CoherentBoxes(const BoxTree& tree, const TriangleSoup& soup)
        : tree_(tree), soup_(soup), near_(tree.nodes()) {}

    SweepHit sweep(const SpherePath& path, std::span<const Index> excluded) {
        if (near_.isEmpty()) margin_ = kFirstMargin * path.radius;
        SweepHit hit;
        if (near_.hold(path)) {
            hit = descend(path, excluded, near_.blocks());
        } else {
            const double part = std::min(1.0, 0.9 * margin_ / path.motion.norm());
            SpherePath begin = path;
            begin.motion *= part;
            if (!near_.hold(begin)) gatherAround(path);
            hit = descend(begin, excluded, near_.blocks());
            if (hit.t <= 1)
                hit.t *= part;
            else if (part < 1)
                hit = descend(path, excluded, {tree_.nodes().data(), 1});
        }
        if (hit.t <= 1) hint_ = hit.leaf;
        return hit;
    }

private:
    static constexpr double kFirstMargin = 0.5, kMinMargin = 0.4, kMaxMargin = 2;

    void gatherAround(const SpherePath& path) {
        const bool isRoomy = near_.blocks().size() <= std::size_t(Neighbourhood::kBlocks / 2);
        if (!near_.isEmpty()) margin_ *= near_.isCrowded() ? 0.7 : isRoomy ? 1.4 : 1;
        margin_ = std::clamp(margin_, kMinMargin * path.radius, kMaxMargin * path.radius);
        near_.gather(path.from, path.radius + margin_);
    }

    SweepHit descend(const SpherePath& path, std::span<const Index> excluded,
                     std::span<const BoxTree::Node> start) {
        return Descent<BoxTree::Node, BoxPath, false>(tree_.nodes(), tree_.leaves(), soup_, path, excluded,
                                                      work_)
            .run(hint_, start);
    }

    const BoxTree& tree_;
    const TriangleSoup& soup_;
    BoxSurroundings near_;
    double margin_ = 0;
    Index hint_ = 0;
    Work work_;
};

} // namespace
} // namespace tactum::bench
