// What is painted around a place of a mesh as a polynomial: how it rises there, and how that changes.
#pragma once

#include <array>
#include <vector>

#include "core/surface/painted_ground.h"
#include "core/surface/painted_values.h"

namespace tactum {

/// Of a polynomial of third degree through the value at a place, by least squares through those around it.
struct PaintedFit {
    Vec3 rise = Vec3::Zero(); ///< across the place's normal, body frame, 1/m
    Mat3 bend = Mat3::Zero(); ///< its derivative along the surface: symmetric, across the normal, 1/m^2
};

/// Fits one place after another.
class PaintedFitter {
public:
    /// All three outlive it. Thread: any but real time, each with its own.
    PaintedFitter(const TriangleSoup& soup, const PaintedGround& ground, const PaintedValues& values)
        : soup_(soup), ground_(ground), values_(values) {}

    /// Takes the corners of the triangles there, of those across their edges and of the next ones, turned
    /// into the plane across the place's normal as if the surface were unrolled. What is linear is met
    /// exactly; what too few corners leave open does not bend. Level where all triangles there are.
    PaintedFit at(Index place);

private:
    using Vec2 = Eigen::Vector2d;
    using Corners = std::array<Vec2, 3>; ///< of a triangle, in the plane
    struct Sample {
        Vec2 at;
        double rise;
        int ring;
    };

    void gather(Index place, const Eigen::Matrix<double, 3, 2>& plane);
    void addFlat(const Vec2& p, double riseP, const Vec2& q, double riseQ);
    void beyond(Index triangle, const Corners& at, std::size_t side, int ring);
    void take(Index position, const Vec2& at, int ring);
    double partWithin(const Vec2& plain, const Vec2& curved) const;
    bool isLevelAt(Index place) const;
    bool isAtARim(Index place) const;
    Eigen::Matrix2d evenly() const;

    const TriangleSoup& soup_;
    const PaintedGround& ground_;
    const PaintedValues& values_;
    Index place_ = 0;
    int rings_ = 0;
    double here_ = 0;
    Vec2 flux_ = Vec2::Zero(); ///< of the slopes of the triangles around the place, by their areas
    double area_ = 0;
    std::vector<Sample> samples_;
};

} // namespace tactum
