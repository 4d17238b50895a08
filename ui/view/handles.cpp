#include "ui/view/handles.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace tactum {
namespace {

constexpr int kRingParts = 64;
constexpr double kMinDrag = 6; // pixels from the origin: nearer, a ratio means nothing
/// Sine of the angle between the eye and a plane below which no place in it is meant.
constexpr double kEdgeOn = 0.05;

double dot(QPointF a, QPointF b) {
    return a.x() * b.x() + a.y() * b.y();
}

} // namespace

double distanceTo(const QPolygonF& line, QPointF p) {
    double least = std::numeric_limits<double>::infinity();
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF a = line[i - 1], along = line[i] - a;
        const double squared = std::max(dot(along, along), 1e-12);
        const double part = std::clamp(dot(p - a, along) / squared, 0.0, 1.0);
        least = std::min(least, lengthOf(p - a - part * along));
    }
    return least;
}

QPolygonF onScreen(const std::vector<Vec3>& points, const ViewCamera& camera) {
    QPolygonF line;
    for (const Vec3& p : points) {
        const auto seen = camera.project(p);
        if (!seen) return {};
        line << *seen;
    }
    return line;
}

std::vector<Vec3> ring(const Pose& frame, int about, double radius, double along) {
    std::vector<Vec3> points;
    const int u = (about + 1) % 3, v = (about + 2) % 3;
    for (int i = 0; i <= kRingParts; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingParts;
        Vec3 p = Vec3::Zero();
        p[u] = radius * std::cos(angle);
        p[v] = radius * std::sin(angle);
        p[about] = along;
        points.push_back(frame.apply(p));
    }
    return points;
}

const QColor& axisColour(const Theme& theme, int axis) {
    return axis == 0 ? theme.axisX : axis == 1 ? theme.axisY : theme.axisZ;
}

double draggedAlong(const Vec3& origin, const Vec3& direction, QPointF from, QPointF to,
                    const ViewCamera& camera) {
    const auto a = alongLine(origin, direction, camera.ray(from)),
               b = alongLine(origin, direction, camera.ray(to));
    return a && b ? *b - *a : 0;
}

Vec3 draggedIn(const Vec3& origin, const Vec3& normal, QPointF from, QPointF to, const ViewCamera& camera) {
    const auto place = [&](QPointF pixel) -> std::optional<Vec3> {
        const Ray ray = camera.ray(pixel);
        const double toward = ray.direction.dot(normal), away = (origin - ray.origin).dot(normal);
        if (std::abs(toward) < kEdgeOn || away / toward <= 0) return std::nullopt; // beyond the horizon
        return ray.at(away / toward);
    };
    const auto a = place(from), b = place(to);
    return a && b ? Vec3(*b - *a) : Vec3(Vec3::Zero());
}

double draggedAbout(const Pose& frame, int about, double radius, QPointF from, QPointF to,
                    const ViewCamera& camera) {
    const auto points = ring(frame, about, radius);
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto seen = camera.project(points[i]); seen && lengthOf(*seen - from) < least) {
            least = lengthOf(*seen - from);
            nearest = i;
        }
    const Vec3 out = points[nearest] - frame.translation;
    const Vec3 tangent = frame.rotate(Vec3::Unit(about)).cross(out).normalized();
    const auto a = camera.project(points[nearest] - 0.05 * radius * tangent),
               b = camera.project(points[nearest] + 0.05 * radius * tangent);
    if (!a || !b) return 0;
    const QPointF perRadius = (*b - *a) / 0.1; // pixels for a turn by one radian
    // Where the ring leads away from the eye a pixel is no more than a few of its own.
    const double pixels = radius / camera.pixelSize(frame.translation);
    return dot(to - from, perRadius) / std::max(dot(perRadius, perRadius), 0.1 * pixels * pixels);
}

double draggedRound(const Vec3& origin, QPointF from, QPointF to, const ViewCamera& camera) {
    const auto centre = camera.project(origin);
    if (!centre || lengthOf(from - *centre) < kMinDrag || lengthOf(to - *centre) < kMinDrag) return 0;
    const auto angle = [&](QPointF p) { return std::atan2(centre->y() - p.y(), p.x() - centre->x()); };
    return std::remainder(angle(to) - angle(from), 2 * std::numbers::pi);
}

double draggedOut(const Vec3& origin, QPointF from, QPointF to, const ViewCamera& camera) {
    const auto centre = camera.project(origin);
    if (!centre) return 1;
    return std::max(lengthOf(to - *centre), kMinDrag) / std::max(lengthOf(from - *centre), kMinDrag);
}

} // namespace tactum
