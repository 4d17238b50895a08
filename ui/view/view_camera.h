// Where the view looks from: a turntable about a focus, and what lies under a pixel.
#pragma once

#include <optional>
#include <span>

#include <QPointF>
#include <QSizeF>

#include "core/base/vec.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// A half-line of the world frame; direction of unit length.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();

    Vec3 at(double distance) const { return origin + distance * direction; }
};

/// A camera that turns about `focus` with Y up. Plain values; pixels are Qt's logical ones,
/// from the upper left corner. Thread: any.
struct ViewCamera {
    static constexpr double kAway = 50; ///< distances to the focus that a parallel camera stands away

    Vec3 focus = Vec3::Zero();
    double distance = 1;      ///< from the eye to the focus, m
    double yaw = 0;           ///< rad, about Y; 0 looks along -Z
    double pitch = 0;         ///< rad, -pi/2 to pi/2; positive looks down
    double fieldOfView = 0.5; ///< rad, from the lower to the upper edge
    bool parallel = false;    ///< without vanishing points; what is at the focus keeps its size
    QSizeF size = {1, 1};     ///< of the view, pixels

    Vec3 right() const;
    Vec3 up() const;
    Vec3 forward() const;
    /// Where it looks from; far away where the projection is parallel.
    Vec3 eye() const { return focus - (parallel ? kAway : 1) * distance * forward(); }

    /// How far in front of the eye a point lies, m; negative behind it.
    double depth(const Vec3& p_W) const { return (p_W - eye()).dot(forward()); }
    /// The pixel that shows a point; nothing for a point behind the eye.
    std::optional<QPointF> project(const Vec3& p_W) const;
    /// From the world to OpenGL's clip space, column vectors: divided by its last number, a point's first two
    /// are -1 to 1 from the left to the right and from the lower to the upper edge of the view.
    Eigen::Matrix4d clipFromWorld() const;
    /// From the eye through a pixel.
    Ray ray(QPointF pixel) const;
    /// Length of a pixel's side at the depth of a point, m.
    double pixelSize(const Vec3& p_W) const;
    /// The vector in the camera's plane that a drag by `pixels` means at the depth of a point, m.
    Vec3 dragVector(const Vec3& p_W, QPointF pixels) const;
    /// The point of a pixel at the depth of another point.
    Vec3 pointAtDepthOf(const Vec3& p_W, QPointF pixel) const;

    /// Turns by a drag: half a turn for the shorter side of the view.
    void orbit(QPointF pixels);
    /// Moves so that the point at the focus's depth follows the drag.
    void pan(QPointF pixels);
    /// Scales the distance to `anchor`, which keeps its pixel, by `factor` (< 1 comes nearer).
    void zoomTo(const Vec3& anchor_W, double factor);
    /// The largest part of half of its width or height that the points reach from the middle: up to 1 all of
    /// them are in the picture. 0: there are none; infinite: one is behind the eye.
    double filled(std::span<const Vec3> points_W) const;
    /// Stands so far from the focus that they reach that part, > 0. Ignores an empty list.
    void fill(std::span<const Vec3> points_W, double part);
    /// Stands so that the points fill the view with a margin, looking as before, and turns about the centre
    /// of their box from now on. Ignores an empty list.
    void fit(std::span<const Vec3> points_W);
};

/// How far along a line the point is that is nearest to a ray; both directions of unit length. Nothing where
/// the line is looked at along itself.
std::optional<double> alongLine(const Vec3& origin, const Vec3& direction, const Ray& ray);

} // namespace tactum
