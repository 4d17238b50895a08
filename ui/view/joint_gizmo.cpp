#include "ui/view/joint_gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>

namespace tactum {
namespace {

constexpr double kJointArm = 84, kLeastArc = 34; // pixels
constexpr double kFirstTurn = 0.5;               // rad, where a stop that there is not yet stands
constexpr double kSnap = 3 * std::numbers::pi / 180;
constexpr double kHalfTurn = std::numbers::pi;
constexpr int kArcParts = 48;

/// From the axis to the body, of unit length and across the axis: where the angle is 0.
Vec3 zeroOf(const JointMark& mark) {
    const Vec3 out = mark.body - mark.at;
    const Vec3 across = out - out.dot(mark.axis) * mark.axis;
    return across.norm() > 1e-6 ? across.normalized() : mark.axis.unitOrthogonal();
}

double radiusOf(const JointMark& mark, const ViewCamera& camera) {
    const Vec3 out = mark.body - mark.at;
    return std::max((out - out.dot(mark.axis) * mark.axis).norm(), kLeastArc * camera.pixelSize(mark.at));
}

Vec3 onArc(const JointMark& mark, double angle, double radius) {
    const Vec3 zero = zeroOf(mark);
    return mark.at + radius * (std::cos(angle) * zero + std::sin(angle) * mark.axis.cross(zero));
}

/// Where a stop is drawn: rad or m.
double shownAt(const JointMark& mark, JointHandle handle, const ViewCamera& camera) {
    const bool low = handle == JointHandle::Low;
    const double first = mark.turns ? kFirstTurn : 0.5 * kJointArm * camera.pixelSize(mark.at);
    const double at = low ? (mark.hasLow ? mark.low : -first) : (mark.hasHigh ? mark.high : first);
    return mark.turns ? std::clamp(at, -2 * kHalfTurn, 2 * kHalfTurn) : at;
}

Vec3 placeAlong(const JointMark& mark, double value, const ViewCamera& camera) {
    return mark.turns ? onArc(mark, value, radiusOf(mark, camera)) : mark.body + value * mark.axis;
}

/// The angle about the axis where a ray meets the plane of the arc.
std::optional<double> angleAt(const JointMark& mark, const Ray& ray) {
    const double toward = ray.direction.dot(mark.axis);
    if (std::abs(toward) < 0.05) return std::nullopt; // the plane is looked at from its edge
    const Vec3 p = ray.at((mark.at - ray.origin).dot(mark.axis) / toward) - mark.at;
    const Vec3 zero = zeroOf(mark);
    return std::atan2(p.dot(mark.axis.cross(zero)), p.dot(zero));
}

Vec3 snapped(const Vec3& axis) {
    for (int i = 0; i < 3; ++i)
        if (std::abs(axis[i]) > std::cos(kSnap)) return std::copysign(1.0, axis[i]) * Vec3::Unit(i);
    return axis;
}

} // namespace

std::optional<QPointF> JointGizmo::placeOf(JointHandle handle, const ViewCamera& camera) const {
    if (!shown_) return std::nullopt;
    if (handle == JointHandle::Place) return camera.project(shown_->at);
    if (handle == JointHandle::Tip)
        return camera.project(shown_->at + kJointArm * camera.pixelSize(shown_->at) * shown_->axis);
    return camera.project(placeAlong(*shown_, shownAt(*shown_, handle, camera), camera));
}

JointGizmo::Shapes JointGizmo::shapes(const ViewCamera& camera) const {
    Shapes all;
    for (const JointHandle handle :
         {JointHandle::Low, JointHandle::High, JointHandle::Tip, JointHandle::Place})
        all.push_back({handle, {placeOf(handle, camera), {}, {}}});
    return all;
}

JointMark JointGizmo::dragged(QPointF cursor, const ViewCamera& camera) const {
    if (!held_) return shown_.value_or(JointMark{});
    JointMark next = held_->value;
    if (held_->handle == JointHandle::Place) {
        next.at += camera.dragVector(next.at, cursor - held_->from);
        return next;
    }
    if (held_->handle == JointHandle::Tip) {
        const Vec3 tip = next.at + kJointArm * camera.pixelSize(next.at) * next.axis;
        const Vec3 way = tip + camera.dragVector(tip, cursor - held_->from) - next.at;
        if (way.norm() > 1e-12) next.axis = snapped(way.normalized());
        return next;
    }
    const auto now =
        next.turns ? angleAt(next, camera.ray(cursor)) : alongLine(next.body, next.axis, camera.ray(cursor));
    if (!now) return next;
    if (held_->handle == JointHandle::Low)
        next.low = std::min(*now, 0.0), next.hasLow = true;
    else
        next.high = std::max(*now, 0.0), next.hasHigh = true;
    return next;
}

void JointGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const {
    if (!shown_) return;
    const auto place = placeOf(JointHandle::Place, camera), tip = placeOf(JointHandle::Tip, camera);
    if (!place || !tip) return;
    const auto under = lit(cursor, camera);
    const auto colour = [&](JointHandle handle, const QColor& plain) {
        return under == handle ? theme.accent : plain;
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.text, 1.2, Qt::DashLine));
    painter.drawLine(*place - (*tip - *place), *place);
    painter.setPen(QPen(colour(JointHandle::Tip, theme.text), 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(*place, *tip);
    const double low = shownAt(*shown_, JointHandle::Low, camera),
                 high = shownAt(*shown_, JointHandle::High, camera);
    QPolygonF way;
    for (int i = 0; i <= kArcParts; ++i)
        if (const auto seen = camera.project(placeAlong(*shown_, low + (high - low) * i / kArcParts, camera)))
            way << *seen;
    painter.setPen(QPen(theme.accent, 2));
    painter.drawPolyline(way);
    painter.setPen(QPen(theme.label, 1));
    for (const JointHandle handle :
         {JointHandle::Place, JointHandle::Tip, JointHandle::Low, JointHandle::High}) {
        const auto seen = placeOf(handle, camera);
        if (!seen) continue;
        const bool there =
            handle == JointHandle::Low ? shown_->hasLow : handle != JointHandle::High || shown_->hasHigh;
        painter.setBrush(there ? QBrush(colour(handle, theme.text)) : QBrush(Qt::NoBrush));
        if (!there) painter.setPen(QPen(colour(handle, theme.text), 1.4));
        if (handle == JointHandle::Place)
            painter.drawRect(QRectF(*seen - QPointF(5, 5), QSizeF(10, 10)));
        else
            painter.drawEllipse(*seen, 5.0, 5.0);
    }
    painter.restore();
}

} // namespace tactum
