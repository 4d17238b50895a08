// Where the triangles of a mesh lie on the texels of an image.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/paint/dab.h"
#include "core/surface/texture_stack.h"

namespace tactum {

/// From texture coordinates to texels: perUv uv + shift, where the centre of texel i lies at i + 0.5. The
/// image repeats.
struct TexelMap {
    int width = 1, height = 1;
    Eigen::Matrix2d perUv = Eigen::Matrix2d::Identity();
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();

    std::size_t texels() const { return std::size_t(width) * std::size_t(height); }
    /// The texel of the image at any place of its repeats, in row-major order.
    std::size_t wrapped(int x, int y) const {
        const auto part = [](int i, int size) {
            return std::size_t(i >= 0 && i < size ? i
                                                  : (i % size + size) % size); // a division takes its time
        };
        return part(y, height) * std::size_t(width) + part(x, width);
    }
    bool operator==(const TexelMap&) const = default;
};

/// Of a pattern whose source is Image and that lies on texture coordinates.
TexelMap texelMapOf(const CompiledPattern& pattern);

/// Whole texels from `low` to before `high`.
struct TexelBox {
    Eigen::Vector2i low = Eigen::Vector2i::Zero(), high = Eigen::Vector2i::Zero();

    static TexelBox around(const Eigen::Vector2d& least, const Eigen::Vector2d& most);
    double area() const {
        return double(std::max(high.x() - low.x(), 0)) * double(std::max(high.y() - low.y(), 0));
    }
};

/// A triangle on the texels, not wrapped.
class TexelTriangle {
public:
    /// The soup has texture coordinates.
    TexelTriangle(const TriangleSoup& soup, Index triangle, const TexelMap& map);

    const std::array<Eigen::Vector2d, 3>& corners() const { return corners_; }
    bool hasArea() const { return std::isfinite(perArea_); }
    /// Of its corners at a place, also beside it; sum 1.
    Vec3 weightsAt(const Eigen::Vector2d& place) const {
        const Eigen::Vector2d p = place - corners_[0];
        const double second = crossed(p, corners_[2] - corners_[0]) * perArea_,
                     third = crossed(corners_[1] - corners_[0], p) * perArea_;
        return {1 - second - third, second, third};
    }
    /// Those of its point nearest to a place, and how far apart they are, in texels.
    std::pair<Vec3, double> nearestTo(const Eigen::Vector2d& place) const;

    static bool isInside(const Vec3& weights) {
        constexpr double kRounding = 1e-9; // centres on an edge belong to both sides
        return weights.minCoeff() >= -kRounding;
    }

private:
    static double crossed(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    }

    std::array<Eigen::Vector2d, 3> corners_;
    double perArea_ = 0;
};

/// Which texels have their centre on a triangle of some surfaces: a margin must not be painted over them.
/// Built once for a mesh and a map, on a worker: its time goes with the texels that the triangles cover.
class TexelCover {
public:
    TexelCover(const TriangleSoup& soup, const PaintableSurfaces& surfaces, const TexelMap& map);

    const TexelMap& map() const { return map_; }
    bool isCovered(std::size_t texel) const { return covered_[texel] != 0; }
    /// How many texels and rows of triangles it took to tell: no more than 64 for each texel of the image and
    /// a million, whatever the coordinates are.
    std::size_t lookedAt() const { return lookedAt_; }

private:
    void add(const TexelTriangle& triangle);
    void addRow(const TexelTriangle& triangle, int y, double left, double right);

    TexelMap map_;
    std::vector<std::uint8_t> covered_;
    double budget_; ///< texels that may still be looked at
    std::size_t lookedAt_ = 0;
};

} // namespace tactum
