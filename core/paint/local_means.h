// What values are on average around a place: for a brush that smooths.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

/// Values are spread over the nodes of a coarse grid, a quarter of the radius apart, and taken back from
/// there: a mean over about that far, in the same time however many there are, on vertices as on texels, and
/// with no regard for seams.
class LocalMeans {
public:
    /// Of the places within kReach radii (m) around the centre.
    LocalMeans(const Vec3& centre, double radius)
        : low_(centre - Vec3::Constant(kReach * radius)), nodesPerMetre_(kNodesToARadius / radius),
          nodes_(kSide * kSide * kSide) {}

    static constexpr double kReach = 1.5;

    void add(const Vec3& place, double value) {
        around(place, [&](std::size_t node, double weight) {
            nodes_[node].weight += weight;
            nodes_[node].sum += weight * value;
        });
    }
    /// At a place where something was added.
    double at(const Vec3& place) const {
        double weight = 0, sum = 0;
        around(place, [&](std::size_t node, double part) {
            weight += part * nodes_[node].weight;
            sum += part * nodes_[node].sum;
        });
        return weight > 0 ? sum / weight : 0;
    }

private:
    static constexpr double kNodesToARadius = 4;
    static constexpr std::size_t kSide = std::size_t(2 * kReach * kNodesToARadius) + 1;

    struct Node {
        double weight = 0, sum = 0;
    };

    /// The eight nodes of the cell, with trilinear weights.
    template <class Visit> void around(const Vec3& place, Visit&& visit) const {
        const Vec3 at = (nodesPerMetre_ * (place - low_)).cwiseMax(0.0).cwiseMin(double(kSide - 1));
        std::array<std::size_t, 3> cell{};
        Vec3 part;
        for (int axis = 0; axis < 3; ++axis) {
            cell[std::size_t(axis)] = std::min(std::size_t(at[axis]), kSide - 2);
            part[axis] = at[axis] - double(cell[std::size_t(axis)]);
        }
        for (unsigned corner = 0; corner < 8; ++corner) {
            std::size_t node = 0;
            double weight = 1;
            for (int axis = 2; axis >= 0; --axis) {
                const bool high = (corner >> axis & 1U) != 0;
                node = node * kSide + cell[std::size_t(axis)] + high;
                weight *= high ? part[axis] : 1 - part[axis];
            }
            visit(node, weight);
        }
    }

    Vec3 low_;
    double nodesPerMetre_;
    std::vector<Node> nodes_;
};

} // namespace tactum
