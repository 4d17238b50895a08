// A grid of cubes that knows how far each is from those that hold something. Private to this folder.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

/// In steps to any of the 26 neighbours, at most 255. Places are in cubes, from the grid's lowest corner.
class CubeDistances {
public:
    explicit CubeDistances(const std::array<int, 3>& count)
        : count_(count), cubes_(std::size_t(count[0]) * std::size_t(count[1]) * std::size_t(count[2]), 255) {
        for (int i = 0; i < 27; ++i) {
            const Eigen::Vector3i step = stepTo(i);
            offsets_[std::size_t(i)] = (step.z() * count[1] + step.y()) * count[0] + step.x();
        }
    }

    std::size_t size() const { return cubes_.size(); }
    bool holds(const Eigen::Vector3i& at) const {
        return (at.array() >= 0).all() && at.x() < count_[0] && at.y() < count_[1] && at.z() < count_[2];
    }
    std::size_t indexOf(const Eigen::Vector3i& at) const {
        return (std::size_t(at.z()) * std::size_t(count_[1]) + std::size_t(at.y())) * std::size_t(count_[0]) +
               std::size_t(at.x());
    }
    Eigen::Vector3i cubeOf(std::size_t index) const {
        const int i = int(index), row = i / count_[0];
        return {i % count_[0], row % count_[1], row / count_[1]};
    }
    bool isOutermost(std::size_t index) const {
        const Eigen::Vector3i at = cubeOf(index);
        return !holds(at - Eigen::Vector3i::Ones()) || !holds(at + Eigen::Vector3i::Ones());
    }
    /// How far a place in the grid is from its end in a direction of unit length; a little less, so that all
    /// places on the way are in it.
    float wayOut(const Eigen::Vector3f& from, const Eigen::Vector3f& toward) const {
        constexpr float kLess = 1 - 1e-4F;
        float least = std::numeric_limits<float>::max();
        for (int i = 0; i < 3; ++i) {
            const float room = toward[i] > 0 ? float(count_[std::size_t(i)]) - from[i] : from[i];
            if (toward[i] != 0) least = std::min(least, room / std::abs(toward[i]));
        }
        return kLess * least;
    }
    static Eigen::Vector3i cubeAt(const Vec3& p) { return p.array().floor().cast<int>(); }
    int at(std::size_t cube) const { return cubes_[cube]; }

    /// Something is there. Which cube that is; none outside of the grid.
    std::optional<std::size_t> put(const Vec3& p) {
        const Eigen::Vector3i at = cubeAt(p);
        if (!holds(at)) return std::nullopt;
        cubes_[indexOf(at)] = 0;
        return indexOf(at);
    }
    /// After all was put: by the neighbours that come before each cube, there and back.
    void spread() {
        for (std::size_t i = 0; i < size(); ++i)
            spreadTo(i, 0, 13);
        for (std::size_t i = size(); i-- > 0;)
            spreadTo(i, 14, 27);
    }
    template <class Visit> void forEachNeighbour(std::size_t cube, Visit visit) const {
        forSome(cube, 0, 13, visit);
        forSome(cube, 14, 27, visit);
    }
    /// Of each cube whether a way through faces of empty ones leads there from the first, which is empty:
    /// none leads into a closed surface.
    std::vector<bool> reached() const {
        std::vector<bool> all(size(), false);
        std::vector<std::size_t> ahead{0};
        all[0] = true;
        const auto look = [&](std::size_t cube) {
            if (all[cube] || cubes_[cube] == 0) return;
            all[cube] = true;
            ahead.push_back(cube);
        };
        while (!ahead.empty()) {
            const std::size_t cube = ahead.back();
            ahead.pop_back();
            for (const int face : {4, 10, 12, 14, 16, 22})
                forSome(cube, face, face + 1, look);
        }
        return all;
    }

private:
    /// The neighbours from `begin` to `end` of 27, of which the fourteenth is the cube itself.
    template <class Visit> void forSome(std::size_t cube, int begin, int end, Visit visit) const {
        const Eigen::Vector3i at = cubeOf(cube);
        const bool all = !isOutermost(cube);
        for (int i = begin; i < end; ++i)
            if (all || holds(at + stepTo(i))) visit(std::size_t(int(cube) + offsets_[std::size_t(i)]));
    }
    static Eigen::Vector3i stepTo(int neighbour) {
        return {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
    }
    void spreadTo(std::size_t cube, int begin, int end) {
        int nearest = cubes_[cube];
        forSome(cube, begin, end, [&](std::size_t other) { nearest = std::min(nearest, cubes_[other] + 1); });
        cubes_[cube] = std::uint8_t(nearest);
    }

    std::array<int, 3> count_;
    std::vector<std::uint8_t> cubes_;
    std::array<int, 27> offsets_; ///< from a cube to its neighbours, itself in the middle
};

} // namespace tactum
