#include "ui/view/mapping_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QPainter>

namespace tactum {

namespace {

using Eigen::Vector2d;

constexpr double kArm = 78, kRing = 54;    // pixels
constexpr double kNear = 8, kNearLine = 5; // pixels from which a handle is grabbed
constexpr double kCorner = 34;             // pixels, from the origin to the handle of the size at least
constexpr double kMinDrag = 6;             // pixels from the origin: nearer, a ratio means nothing
constexpr double kRadiusAngle = -0.6;      // rad, where on the circle its handle is
constexpr int kRingParts = 64, kEdgeParts = 12;

int axisOf(MappingHandle handle) {
    switch (handle) {
    case MappingHandle::MoveX:
    case MappingHandle::TurnX:
        return 0;
    case MappingHandle::MoveY:
    case MappingHandle::TurnY:
        return 1;
    default:
        return 2;
    }
}

bool turns(MappingHandle handle) {
    return handle >= MappingHandle::TurnX;
}
bool movesAlong(MappingHandle handle) {
    return handle == MappingHandle::MoveX || handle == MappingHandle::MoveY || handle == MappingHandle::MoveZ;
}
bool isRound(const MappingFrame& frame) {
    return frame.mapping == TextureMapping::Cylindrical || frame.mapping == TextureMapping::Spherical;
}

double lengthOf(QPointF p) {
    return std::hypot(p.x(), p.y());
}
double dot(QPointF a, QPointF b) {
    return a.x() * b.x() + a.y() * b.y();
}

/// From a point to a line in pieces.
double distanceTo(const QPolygonF& line, QPointF p) {
    double least = 1e9;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF a = line[i - 1], along = line[i] - a;
        const double squared = std::max(dot(along, along), 1e-12);
        const double part = std::clamp(dot(p - a, along) / squared, 0.0, 1.0);
        least = std::min(least, lengthOf(p - a - part * along));
    }
    return least;
}

Vec3 axis(const MappingFrame& frame, int i) {
    return frame.pose.rotate(Vec3::Unit(i));
}

/// Where a place of the flat pattern lies, in the frame; metres as flatPoints() counts them. `side`: of the
/// three of a triplanar mapping.
Vec3 onSurface(const MappingFrame& frame, const Vector2d& metres, int side) {
    const double turn = metres.x() / frame.radius, high = metres.y() / frame.radius;
    switch (frame.mapping) {
    case TextureMapping::Cylindrical:
        return {frame.radius * std::cos(turn), frame.radius * std::sin(turn), metres.y()};
    case TextureMapping::Spherical:
        return frame.radius *
               Vec3(std::cos(high) * std::cos(turn), std::cos(high) * std::sin(turn), std::sin(high));
    default:
        break;
    }
    Vec3 p = Vec3::Zero();
    p[(side + 1) % 3] = metres.x();
    p[(side + 2) % 3] = metres.y();
    return p;
}

/// A place of the repeat at the origin of the pattern, in repeats.
Vec3 inRepeat(const MappingFrame& frame, const Vector2d& repeats, int side) {
    const double c = std::cos(frame.rotation), s = std::sin(frame.rotation);
    const Vector2d flat(frame.size * repeats.x(), frame.size * frame.proportion * repeats.y());
    const Vector2d metres = frame.offset + Vector2d(c * flat.x() - s * flat.y(), s * flat.x() + c * flat.y());
    return frame.pose.apply(onSurface(frame, metres, side));
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

std::vector<Vec3> circle(const MappingFrame& frame, int about, double radius, double along = 0) {
    std::vector<Vec3> points;
    const int u = (about + 1) % 3, v = (about + 2) % 3;
    for (int i = 0; i <= kRingParts; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingParts;
        Vec3 p = Vec3::Zero();
        p[u] = radius * std::cos(angle);
        p[v] = radius * std::sin(angle);
        p[about] = along;
        points.push_back(frame.pose.apply(p));
    }
    return points;
}

std::vector<Vec3> repeatEdge(const MappingFrame& frame, int side) {
    static constexpr std::array<std::array<double, 2>, 5> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    std::vector<Vec3> points;
    for (std::size_t i = 1; i < kCorners.size(); ++i)
        for (int k = 0; k <= kEdgeParts; ++k) {
            const double part = double(k) / kEdgeParts;
            const Vector2d from(kCorners[i - 1][0], kCorners[i - 1][1]), to(kCorners[i][0], kCorners[i][1]);
            points.push_back(inRepeat(frame, from + part * (to - from), side));
        }
    return points;
}

/// Flat, seen at the middle of its three sides: the one that looks most to the eye.
int sideOf(const MappingFrame& frame, const ViewCamera& camera) {
    if (frame.mapping != TextureMapping::Triplanar) return 2;
    int best = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(axis(frame, i).dot(camera.forward())) >
            std::abs(axis(frame, best).dot(camera.forward())))
            best = i;
    return best;
}

const QColor& colourOf(const Theme& theme, int axis) {
    return axis == 0 ? theme.axisX : axis == 1 ? theme.axisY : theme.axisZ;
}

/// The part of a ring where it was taken: a drag along its tangent there turns it, however it lies.
double turnOf(const MappingFrame& frame, int about, QPointF from, QPointF to, const ViewCamera& camera) {
    const double radius = kRing * camera.pixelSize(frame.pose.translation);
    const auto points = circle(frame, about, radius);
    std::size_t nearest = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto seen = camera.project(points[i]); seen && lengthOf(*seen - from) < least) {
            least = lengthOf(*seen - from);
            nearest = i;
        }
    const Vec3 out = points[nearest] - frame.pose.translation;
    const Vec3 tangent = axis(frame, about).cross(out).normalized();
    const auto a = camera.project(points[nearest] - 0.05 * radius * tangent),
               b = camera.project(points[nearest] + 0.05 * radius * tangent);
    if (!a || !b) return 0;
    const QPointF perRadius = (*b - *a) / 0.1; // pixels for a turn by one radian
    // Where the ring leads away from the eye a pixel is no more than a few of its own.
    return dot(to - from, perRadius) / std::max(dot(perRadius, perRadius), 0.1 * kRing * kRing);
}

} // namespace

std::vector<MappingHandle> MappingGizmo::handles() const {
    using enum MappingHandle;
    std::vector<MappingHandle> all{Size, Move, MoveX, MoveY, MoveZ, TurnX, TurnY, TurnZ};
    if (isRound(*frame_)) all.insert(all.begin() + 1, Radius);
    return all;
}

std::optional<QPointF> MappingGizmo::placeOf(MappingHandle handle, const ViewCamera& camera) const {
    if (!frame_) return std::nullopt;
    const Vec3& origin = frame_->pose.translation;
    const auto centre = camera.project(origin);
    if (!centre) return std::nullopt;
    const double pixel = camera.pixelSize(origin);
    const int i = axisOf(handle);
    if (handle == MappingHandle::Move) return centre;
    if (movesAlong(handle)) return camera.project(origin + kArm * pixel * axis(*frame_, i));
    if (turns(handle)) {
        const double part = std::sqrt(0.5) * kRing * pixel; // between the two other axes
        return camera.project(origin + part * (axis(*frame_, (i + 1) % 3) + axis(*frame_, (i + 2) % 3)));
    }
    if (handle == MappingHandle::Radius) {
        if (!isRound(*frame_)) return std::nullopt;
        const Vec3 p(std::cos(kRadiusAngle), std::sin(kRadiusAngle), 0);
        return camera.project(frame_->pose.apply(frame_->radius * p));
    }
    const auto corner = camera.project(inRepeat(*frame_, {1, 1}, sideOf(*frame_, camera)));
    if (!corner) return std::nullopt;
    const QPointF out = *corner - *centre;
    const double length = lengthOf(out);
    if (length >= kCorner) return corner;
    return *centre + (length > 1e-6 ? out / length : QPointF(std::sqrt(0.5), -std::sqrt(0.5))) * kCorner;
}

std::optional<MappingHandle> MappingGizmo::at(QPointF cursor, const ViewCamera& camera) const {
    if (!frame_ || !camera.project(frame_->pose.translation)) return std::nullopt;
    for (const MappingHandle handle : handles())
        if (const auto place = placeOf(handle, camera); place && lengthOf(*place - cursor) <= kNear)
            return handle;
    const double pixel = camera.pixelSize(frame_->pose.translation);
    for (const MappingHandle handle : handles()) {
        const int i = axisOf(handle);
        const Vec3& origin = frame_->pose.translation;
        QPolygonF line;
        if (movesAlong(handle))
            line = onScreen(
                {origin + 0.2 * kArm * pixel * axis(*frame_, i), origin + kArm * pixel * axis(*frame_, i)},
                camera);
        else if (turns(handle))
            line = onScreen(circle(*frame_, i, kRing * pixel), camera);
        if (distanceTo(line, cursor) <= kNearLine) return handle;
    }
    return std::nullopt;
}

void MappingGizmo::grab(MappingHandle handle, QPointF cursor) {
    if (frame_) held_ = Grip{handle, cursor, *frame_};
}

MappingFrame MappingGizmo::dragged(QPointF cursor, const ViewCamera& camera) const {
    if (!held_) return frame_.value_or(MappingFrame{});
    MappingFrame next = held_->frame;
    const Vec3 origin = next.pose.translation;
    const int i = axisOf(held_->handle);
    if (held_->handle == MappingHandle::Move) {
        next.pose.translation += camera.dragVector(origin, cursor - held_->from);
    } else if (movesAlong(held_->handle)) {
        const Vec3 direction = axis(next, i);
        const auto from = alongLine(origin, direction, camera.ray(held_->from)),
                   to = alongLine(origin, direction, camera.ray(cursor));
        if (from && to) next.pose.translation += (*to - *from) * direction;
    } else if (turns(held_->handle)) {
        const double angle = turnOf(next, i, held_->from, cursor, camera);
        next.pose.rotation =
            (next.pose.rotation * Quat(Eigen::AngleAxisd(angle, Vec3::Unit(i)))).normalized();
    } else if (const auto centre = camera.project(origin)) {
        const double factor = std::max(lengthOf(cursor - *centre), kMinDrag) /
                              std::max(lengthOf(held_->from - *centre), kMinDrag);
        if (held_->handle == MappingHandle::Size)
            next.size = kTextureSize.clamped(factor * next.size);
        else
            next.radius = kTextureRadius.clamped(factor * next.radius);
    }
    return next;
}

void MappingGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme,
                        QPointF cursor) const {
    if (!frame_) return;
    const Vec3& origin = frame_->pose.translation;
    const auto centre = camera.project(origin);
    if (!centre) return;
    const double pixel = camera.pixelSize(origin);
    const auto under = held_ ? std::optional(held_->handle) : at(cursor, camera);
    const auto strong = [&](MappingHandle handle, QColor colour) {
        return under == handle ? theme.accent : colour;
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    // One repeat, on each side that has one, and the round thing that it lies on.
    const auto dashed = [&](const std::vector<Vec3>& line) {
        painter.setPen(QPen(theme.text, 1.2, Qt::DashLine));
        painter.drawPolyline(onScreen(line, camera));
    };
    if (isRound(*frame_)) {
        const bool isCylinder = frame_->mapping == TextureMapping::Cylindrical;
        dashed(circle(*frame_, 2, frame_->radius));
        for (const double along : {-0.5, 0.5})
            if (isCylinder) dashed(circle(*frame_, 2, frame_->radius, along * frame_->radius));
        for (const int about : {0, 1})
            if (!isCylinder) dashed(circle(*frame_, about, frame_->radius));
    }
    painter.setPen(QPen(theme.text, 1.6));
    for (int side = frame_->mapping == TextureMapping::Triplanar ? 0 : 2; side < 3; ++side)
        painter.drawPolyline(onScreen(repeatEdge(*frame_, side), camera));
    for (const int i : {0, 1, 2}) {
        const auto turn = MappingHandle(int(MappingHandle::TurnX) + i);
        const auto move = MappingHandle(int(MappingHandle::MoveX) + i);
        QColor dim = colourOf(theme, i);
        dim.setAlphaF(0.6f);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(strong(turn, dim), under == turn ? 3 : 1.6));
        painter.drawPolyline(onScreen(circle(*frame_, i, kRing * pixel), camera));
        const auto tip = camera.project(origin + kArm * pixel * axis(*frame_, i));
        if (!tip) continue;
        painter.setPen(QPen(strong(move, colourOf(theme, i)), 2.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*centre, *tip);
        painter.setBrush(strong(move, colourOf(theme, i)));
        painter.drawEllipse(*tip, 4.5, 4.5);
    }
    painter.setPen(QPen(theme.label, 1));
    for (const MappingHandle handle : {MappingHandle::Move, MappingHandle::Size, MappingHandle::Radius}) {
        const auto place = placeOf(handle, camera);
        if (!place) continue;
        painter.setBrush(strong(handle, theme.text));
        if (handle == MappingHandle::Size)
            painter.drawRect(QRectF(*place - QPointF(5, 5), QSizeF(10, 10)));
        else
            painter.drawEllipse(*place, 5.5, 5.5);
    }
    painter.restore();
}

} // namespace tactum
