#include "ui/view/section_gizmo.h"

#include <cmath>
#include <numbers>

#include <QPainter>

namespace tactum {

namespace {

constexpr double kArrow = 78, kTurnRing = 54; // pixels
constexpr double kMoveStep = 5e-3, kTurnStep = std::numbers::pi / 12;

int ringAxis(SectionHandle handle) {
    return handle == SectionHandle::TurnX ? 0 : 1;
}

double inSteps(double value, double step) {
    return step * std::round(value / step);
}

} // namespace

QPolygonF SectionGizmo::rim(const ViewCamera& camera) const {
    std::vector<Vec3> corners;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
        corners.push_back(shown_->frame.apply(reach_ * Vec3(x, y, 0)));
    return onScreen(corners, camera);
}

std::optional<QPointF> SectionGizmo::placeOf(SectionHandle handle, const ViewCamera& camera) const {
    if (!shown_) return std::nullopt;
    const Pose& frame = shown_->frame;
    if (!camera.project(frame.translation)) return std::nullopt;
    const double pixel = camera.pixelSize(frame.translation);
    if (handle == SectionHandle::Move) return camera.project(frame.apply(kArrow * pixel * Vec3::UnitZ()));
    const int about = ringAxis(handle);
    const double part = std::sqrt(0.5) * kTurnRing * pixel; // between the two other axes
    return camera.project(frame.apply(part * (Vec3::Ones() - Vec3::Unit(about))));
}

SectionGizmo::Shapes SectionGizmo::shapes(const ViewCamera& camera) const {
    using enum SectionHandle;
    Shapes all;
    const Vec3& origin = shown_->frame.translation;
    const auto centre = camera.project(origin);
    if (!centre) return all;
    const double pixel = camera.pixelSize(origin);
    const auto tip = placeOf(Move, camera);
    all.push_back({Move, {tip, tip ? QPolygonF({*centre, *tip}) : QPolygonF(), {}}});
    for (const SectionHandle turn : {TurnX, TurnY})
        all.push_back({turn,
                       {placeOf(turn, camera),
                        onScreen(ring(shown_->frame, ringAxis(turn), kTurnRing * pixel), camera),
                        {}}});
    all.push_back({Move, {std::nullopt, rim(camera), {}}});
    return all;
}

SectionPlane SectionGizmo::dragged(QPointF cursor, const ViewCamera& camera, bool snapped) const {
    if (!held_) return shown_.value_or(SectionPlane{});
    SectionPlane plane = held_->value;
    Pose& frame = plane.frame;
    if (held_->handle == SectionHandle::Move) {
        const double along = draggedAlong(frame.translation, plane.normal(), held_->from, cursor, camera);
        frame.translation += (snapped ? inSteps(along, kMoveStep) : along) * plane.normal();
        return plane;
    }
    const int about = ringAxis(held_->handle);
    const double radius = kTurnRing * camera.pixelSize(frame.translation);
    const double angle = draggedAbout(frame, about, radius, held_->from, cursor, camera);
    const Eigen::AngleAxisd turn(snapped ? inSteps(angle, kTurnStep) : angle, Vec3::Unit(about));
    frame.rotation = unitLength(frame.rotation * Quat(turn));
    return plane;
}

void SectionGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme,
                        QPointF cursor) const {
    if (!shown_) return;
    const auto centre = camera.project(shown_->frame.translation);
    const auto tip = placeOf(SectionHandle::Move, camera);
    if (!centre || !tip) return;
    const auto under = lit(cursor, camera);
    const double pixel = camera.pixelSize(shown_->frame.translation);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor edge = under == SectionHandle::Move ? theme.accent : theme.text;
    edge.setAlphaF(0.7f);
    painter.setPen(QPen(edge, 1.4));
    painter.drawPolyline(rim(camera));
    for (const SectionHandle turn : {SectionHandle::TurnX, SectionHandle::TurnY}) {
        QColor colour = under == turn ? theme.accent : theme.text;
        if (under != turn) colour.setAlphaF(0.5f);
        painter.setPen(QPen(colour, under == turn ? 3 : 1.6));
        painter.drawPolyline(onScreen(ring(shown_->frame, ringAxis(turn), kTurnRing * pixel), camera));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        if (const auto dot = placeOf(turn, camera)) painter.drawEllipse(*dot, 4, 4);
        painter.setBrush(Qt::NoBrush);
    }
    const QColor arrow = under == SectionHandle::Move ? theme.accent : theme.axisZ;
    painter.setPen(QPen(arrow, 2.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(*centre, *tip);
    painter.setBrush(arrow);
    painter.setPen(QPen(theme.label, 1));
    painter.drawEllipse(*tip, 5.5, 5.5);
    painter.restore();
}

} // namespace tactum
