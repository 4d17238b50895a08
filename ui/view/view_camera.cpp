#include "ui/view/view_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tactum {

namespace {

constexpr double kMargin = 1.2;

/// What one sees on the way to a point.
struct Toward {
    double aside; ///< from the middle, m over the half of the view's side of 1 m there
    double ahead; ///< from the focus on, m; nothing of it counts in parallel

    Toward(const ViewCamera& camera, const Vec3& p_W) {
        const Vec3 p = p_W - camera.focus;
        const double tan = std::tan(0.5 * camera.fieldOfView),
                     wide = camera.size.width() / camera.size.height();
        aside = std::max(std::abs(p.dot(camera.right())) / (tan * wide), std::abs(p.dot(camera.up())) / tan);
        ahead = camera.parallel ? 0 : p.dot(camera.forward());
    }
};

} // namespace

Vec3 ViewCamera::right() const {
    return {std::cos(yaw), 0, -std::sin(yaw)};
}

Vec3 ViewCamera::forward() const {
    return {-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

Vec3 ViewCamera::up() const {
    return right().cross(forward());
}

double ViewCamera::pixelSize(const Vec3& p_W) const {
    const double from = parallel ? distance : std::abs(depth(p_W));
    return 2 * std::tan(0.5 * fieldOfView) * from / size.height();
}

std::optional<QPointF> ViewCamera::project(const Vec3& p_W) const {
    if (depth(p_W) <= 1e-9 * distance) return std::nullopt;
    const Vec3 d = (p_W - eye()) / pixelSize(p_W);
    return QPointF(0.5 * size.width() + d.dot(right()), 0.5 * size.height() - d.dot(up()));
}

Eigen::Matrix4d ViewCamera::clipFromWorld() const {
    constexpr double kNear = 1e-3, kFar = 1e3; // of the distance to the focus
    const double scale = 1 / std::tan(0.5 * fieldOfView), near = kNear * distance, far = kFar * distance;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero(), view = Eigen::Matrix4d::Identity();
    clip(0, 0) = scale * size.height() / size.width();
    clip(1, 1) = scale;
    clip(2, 2) = (near + far) / (near - far);
    clip(2, 3) = 2 * near * far / (near - far);
    clip(3, 2) = -1;
    if (parallel) {
        clip.topLeftCorner<2, 2>() /= distance;
        clip(2, 2) = 2 / (near - far);
        clip(2, 3) = (near + far) / (near - far);
        clip(3, 2) = 0;
        clip(3, 3) = 1;
    }
    view.topLeftCorner<3, 3>() << right().transpose(), up().transpose(), -forward().transpose();
    view.topRightCorner<3, 1>() = -(view.topLeftCorner<3, 3>() * eye());
    return clip * view;
}

Ray ViewCamera::ray(QPointF pixel) const {
    const Vec3 at = pointAtDepthOf(focus, pixel);
    if (parallel) return {at - kAway * distance * forward(), forward()};
    return {eye(), (at - eye()).normalized()};
}

Vec3 ViewCamera::dragVector(const Vec3& p_W, QPointF pixels) const {
    return pixelSize(p_W) * (pixels.x() * right() - pixels.y() * up());
}

Vec3 ViewCamera::pointAtDepthOf(const Vec3& p_W, QPointF pixel) const {
    const QPointF fromCentre = pixel - QPointF(0.5 * size.width(), 0.5 * size.height());
    return eye() + depth(p_W) * forward() + dragVector(p_W, fromCentre);
}

void ViewCamera::orbit(QPointF pixels) {
    const double perPixel = std::numbers::pi / std::max(1.0, std::min(size.width(), size.height()));
    yaw = std::remainder(yaw - perPixel * pixels.x(), 2 * std::numbers::pi);
    pitch = std::clamp(pitch + perPixel * pixels.y(), -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
}

void ViewCamera::pan(QPointF pixels) {
    focus -= dragVector(focus, pixels);
}

void ViewCamera::zoomTo(const Vec3& anchor_W, double factor) {
    focus = anchor_W + factor * (focus - anchor_W);
    distance *= factor;
}

double ViewCamera::filled(std::span<const Vec3> points_W) const {
    double most = 0;
    for (const Vec3& p_W : points_W) {
        const Toward point(*this, p_W);
        const double depth = distance + point.ahead;
        most = std::max(most, depth > 0 ? point.aside / depth : std::numeric_limits<double>::infinity());
    }
    return most;
}

void ViewCamera::fill(std::span<const Vec3> points_W, double part) {
    double least = -std::numeric_limits<double>::infinity();
    for (const Vec3& p_W : points_W) {
        const Toward point(*this, p_W);
        least = std::max(least, point.aside / part - point.ahead);
    }
    if (least > 0) distance = least;
}

void ViewCamera::fit(std::span<const Vec3> points_W) {
    Bounds box;
    for (const Vec3& p : points_W)
        box.add(p);
    if (box.empty()) return;
    focus = box.centre();
    if (!(box.diagonal() > 0)) return;
    fill(points_W, 1 / kMargin);
    distance = std::max(distance, 0.1 * box.diagonal());
}

std::optional<double> alongLine(const Vec3& origin, const Vec3& direction, const Ray& ray) {
    const double c = direction.dot(ray.direction), sine = 1 - c * c;
    if (sine < 1e-4) return std::nullopt;
    const Vec3 apart = origin - ray.origin;
    return (c * ray.direction.dot(apart) - direction.dot(apart)) / sine;
}

} // namespace tactum
