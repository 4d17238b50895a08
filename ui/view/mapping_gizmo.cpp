#include "ui/view/mapping_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QPainter>

namespace tactum {

namespace {

using Eigen::Vector2d;

constexpr double kArm = 78, kRing = 54; // pixels
constexpr double kCorner = 34;          // pixels, from the origin to the handle of the size at least
constexpr double kRadiusAngle = -0.6;   // rad, where on the circle its handle is
constexpr int kEdgeParts = 12;

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

} // namespace

std::optional<QPointF> MappingGizmo::placeOf(MappingHandle handle, const ViewCamera& camera) const {
    if (!shown_) return std::nullopt;
    const Vec3& origin = shown_->pose.translation;
    const auto centre = camera.project(origin);
    if (!centre) return std::nullopt;
    const double pixel = camera.pixelSize(origin);
    const int i = axisOf(handle);
    if (handle == MappingHandle::Move) return centre;
    if (movesAlong(handle)) return camera.project(origin + kArm * pixel * axis(*shown_, i));
    if (turns(handle)) {
        const double part = std::sqrt(0.5) * kRing * pixel; // between the two other axes
        return camera.project(origin + part * (axis(*shown_, (i + 1) % 3) + axis(*shown_, (i + 2) % 3)));
    }
    if (handle == MappingHandle::Radius) {
        if (!isRound(*shown_)) return std::nullopt;
        const Vec3 p(std::cos(kRadiusAngle), std::sin(kRadiusAngle), 0);
        return camera.project(shown_->pose.apply(shown_->radius * p));
    }
    const auto corner = camera.project(inRepeat(*shown_, {1, 1}, sideOf(*shown_, camera)));
    if (!corner) return std::nullopt;
    const QPointF out = *corner - *centre;
    const double length = lengthOf(out);
    if (length >= kCorner) return corner;
    return *centre + (length > 1e-6 ? out / length : QPointF(std::sqrt(0.5), -std::sqrt(0.5))) * kCorner;
}

MappingGizmo::Shapes MappingGizmo::shapes(const ViewCamera& camera) const {
    using enum MappingHandle;
    const Vec3& origin = shown_->pose.translation;
    Shapes all;
    if (!camera.project(origin)) return all;
    const double pixel = camera.pixelSize(origin);
    for (const MappingHandle handle : {Size, Radius, Move, MoveX, MoveY, MoveZ, TurnX, TurnY, TurnZ}) {
        HandleShape shape{placeOf(handle, camera), {}, {}};
        const int i = axisOf(handle);
        const Vec3 arm = kArm * pixel * axis(*shown_, i);
        if (movesAlong(handle)) shape.line = onScreen({origin + 0.2 * arm, origin + arm}, camera);
        if (turns(handle)) shape.line = onScreen(ring(shown_->pose, i, kRing * pixel), camera);
        all.push_back({handle, std::move(shape)});
    }
    return all;
}

MappingFrame MappingGizmo::dragged(QPointF cursor, const ViewCamera& camera) const {
    if (!held_) return shown_.value_or(MappingFrame{});
    MappingFrame next = held_->value;
    const Vec3 origin = next.pose.translation;
    const int i = axisOf(held_->handle);
    const double pixel = camera.pixelSize(origin);
    if (held_->handle == MappingHandle::Move) {
        next.pose.translation += camera.dragVector(origin, cursor - held_->from);
    } else if (movesAlong(held_->handle)) {
        const Vec3 direction = axis(next, i);
        next.pose.translation += draggedAlong(origin, direction, held_->from, cursor, camera) * direction;
    } else if (turns(held_->handle)) {
        const double angle = draggedAbout(next.pose, i, kRing * pixel, held_->from, cursor, camera);
        next.pose.rotation =
            (next.pose.rotation * Quat(Eigen::AngleAxisd(angle, Vec3::Unit(i)))).normalized();
    } else {
        const double factor = draggedOut(origin, held_->from, cursor, camera);
        if (held_->handle == MappingHandle::Size)
            next.size = kTextureSize.clamped(factor * next.size);
        else
            next.radius = kTextureRadius.clamped(factor * next.radius);
    }
    return next;
}

void MappingGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme,
                        QPointF cursor) const {
    if (!shown_) return;
    const Vec3& origin = shown_->pose.translation;
    const auto centre = camera.project(origin);
    if (!centre) return;
    const double pixel = camera.pixelSize(origin);
    const auto under = lit(cursor, camera);
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
    if (isRound(*shown_)) {
        const bool isCylinder = shown_->mapping == TextureMapping::Cylindrical;
        dashed(ring(shown_->pose, 2, shown_->radius));
        for (const double along : {-0.5, 0.5})
            if (isCylinder) dashed(ring(shown_->pose, 2, shown_->radius, along * shown_->radius));
        for (const int about : {0, 1})
            if (!isCylinder) dashed(ring(shown_->pose, about, shown_->radius));
    }
    painter.setPen(QPen(theme.text, 1.6));
    for (int side = shown_->mapping == TextureMapping::Triplanar ? 0 : 2; side < 3; ++side)
        painter.drawPolyline(onScreen(repeatEdge(*shown_, side), camera));
    for (const int i : {0, 1, 2}) {
        const auto turn = MappingHandle(int(MappingHandle::TurnX) + i);
        const auto move = MappingHandle(int(MappingHandle::MoveX) + i);
        QColor dim = axisColour(theme, i);
        dim.setAlphaF(0.6f);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(strong(turn, dim), under == turn ? 3 : 1.6));
        painter.drawPolyline(onScreen(ring(shown_->pose, i, kRing * pixel), camera));
        const auto tip = camera.project(origin + kArm * pixel * axis(*shown_, i));
        if (!tip) continue;
        painter.setPen(QPen(strong(move, axisColour(theme, i)), 2.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*centre, *tip);
        painter.setBrush(strong(move, axisColour(theme, i)));
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
