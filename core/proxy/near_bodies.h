// Which of many obstacles are near a place: a hierarchy over bodies, above the one that each has over its
// triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/proxy/contact.h"

namespace tactum {

/// A tree of boxes over the obstacles, of those that move along keys over all of their way. Those that forces
/// move may be anywhere: they are asked for each time. Built once for a World, then only read. World frame,
/// metre.
class NearBodies {
public:
    NearBodies() = default;
    /// O(n log n), by the spheres below each mesh's root. `movers`: what the obstacles' `mover` names.
    /// Thread: any but real time.
    explicit NearBodies(std::span<const Obstacle> obstacles, std::span<const Mover> movers = {});

    /// Whether any obstacle has surfaces that are felt from one side alone.
    bool oneSided() const noexcept { return oneSided_; }
    /// Calls seen(index) once for each obstacle that may reach into the ball, at some time if it moves; in
    /// the same order each time. Thread: real time; logarithmic in the obstacles that are not near.
    template <class Seen> void forEach(const Vec3& centre, double reach, Seen&& seen) const noexcept {
        std::array<std::int32_t, kDeepest> open;
        int count = 0;
        if (!nodes_.empty()) open[std::size_t(count++)] = 0;
        while (count > 0) {
            const Node& node = nodes_[std::size_t(open[std::size_t(--count)])];
            const Vec3 outside = (node.low - centre).cwiseMax(centre - node.high).cwiseMax(0.0);
            if (outside.squaredNorm() > reach * reach) continue;
            if (node.bodies == 0) {
                open[std::size_t(count++)] = node.first + 1;
                open[std::size_t(count++)] = node.first;
            }
            for (std::int32_t i = 0; i < node.bodies; ++i)
                seen(bodies_[std::size_t(node.first + i)]);
        }
        for (const std::uint32_t body : driven_)
            seen(body);
    }

private:
    static constexpr int kDeepest = 64; ///< halves of 2^32 bodies, two open at each depth

    struct Node {
        Vec3 low, high;
        std::int32_t first = 0;  ///< of its two children, or of its bodies in bodies_
        std::int32_t bodies = 0; ///< 0: an inner node
    };
    struct Box;
    void split(std::size_t node, std::span<Box> boxes);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> bodies_;
    std::vector<std::uint32_t> driven_; ///< by forces
    bool oneSided_ = false;
};

/// The same, or every one of `count` obstacles where there is no hierarchy. Thread: real time.
template <class Seen>
void forEachNear(const NearBodies* near, std::size_t count, const Vec3& centre, double reach,
                 Seen&& seen) noexcept {
    if (near) return near->forEach(centre, reach, seen);
    for (std::uint32_t body = 0; body < count; ++body)
        seen(body);
}

} // namespace tactum
