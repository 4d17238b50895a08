#include "core/collision/leaf_packing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>

#include "core/collision/leaf_box.h"

namespace tactum {

namespace {

// Room for as many as there may be is not filled before it is used.
struct Place {
    float along;
    std::uint32_t sphere;
};

struct Cut {
    float cost = std::numeric_limits<float>::infinity();
    std::size_t at = 0;
};

class Packing {
public:
    Packing(std::span<const LeafSphere> spheres, std::size_t leafSize)
        : spheres_(spheres), size_(spheres.size()), leafSize_(leafSize) {
        LeafBox all = LeafBox::empty();
        for (std::size_t i = 0; i < size_; ++i) {
            boxes_[i] = LeafBox(spheres[i]);
            all.add(boxes_[i]);
        }
        all.size().minCoeff(&shortestAxis_);
    }

    int shortestAxis() const { return shortestAxis_; }

    /// The best cut along an axis, and the order there.
    Cut along(int axis, std::array<Place, kMostPacked>& order) {
        for (std::size_t i = 0; i < size_; ++i)
            order[i] = {spheres_[i].centre[axis], std::uint32_t(i)};
        std::sort(order.begin(), order.begin() + std::ptrdiff_t(size_),
                  [](const Place& a, const Place& b) { return a.along < b.along; });
        LeafBox first = LeafBox::empty(), second = first;
        for (std::size_t i = 1; i < size_; ++i) {
            first.add(boxes_[order[i - 1].sphere]);
            if (fills(i)) firstCost_[i] = cost(first, i);
        }
        Cut best;
        for (std::size_t i = size_ - 1; i > 0; --i) {
            second.add(boxes_[order[i].sphere]);
            if (!fills(i)) continue;
            const float both = firstCost_[i] + cost(second, size_ - i);
            if (both < best.cost) best = {both, i};
        }
        return best;
    }

private:
    bool fills(std::size_t i) const { return i % leafSize_ == 0 || (size_ - i) % leafSize_ == 0; }

    float cost(const LeafBox& box, std::size_t count) const {
        return box.size().squaredNorm() * float((count + leafSize_ - 1) / leafSize_);
    }

    std::span<const LeafSphere> spheres_;
    std::size_t size_, leafSize_;
    int shortestAxis_ = 0;
    std::array<LeafBox, kMostPacked> boxes_;
    std::array<float, kMostPacked> firstCost_;
};

} // namespace

std::size_t packLeaves(std::span<LeafSphere> spheres, std::size_t leafSize) {
    assert(spheres.size() > leafSize && spheres.size() <= kMostPacked);
    Packing packing(spheres, leafSize);
    std::array<Place, kMostPacked> order, best;
    Cut cut;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == packing.shortestAxis()) continue;
        const Cut found = packing.along(axis, order);
        if (cut.at != 0 && !(found.cost < cut.cost)) continue;
        cut = found;
        best = order;
    }
    if (cut.at == 0) return leafSize; // larger than numbers are: any order does
    std::array<LeafSphere, kMostPacked> before;
    std::ranges::copy(spheres, before.begin());
    for (std::size_t i = 0; i < spheres.size(); ++i)
        spheres[i] = before[best[i].sphere];
    return cut.at;
}

} // namespace tactum
