#include "ui/view/brush_ring.h"

#include <cmath>
#include <numbers>

#include <QPolygonF>

#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

constexpr int kRingCorners = 64;
constexpr double kRingHalo = 3.5, kRingLine = 1.6, kThin = 0.8, kRingMargin = 4; // logical pixels
constexpr double kLargest = 4000; // pixels across: else it is not drawn

QPolygonF ringCircle(const PickHit& at, double radius, const ViewCamera& camera) {
    const Vec3 u = at.normal.unitOrthogonal(), v = at.normal.cross(u);
    QPolygonF polygon;
    for (int i = 0; i <= kRingCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingCorners;
        const auto seen = camera.project(at.point + radius * (std::cos(angle) * u + std::sin(angle) * v));
        if (!seen) return {};
        polygon << *seen;
    }
    return polygon;
}

void drawRing(QPainter& painter, const QPolygonF& outer, const QPolygonF& core, const Theme& theme) {
    const QRectF box = outer.boundingRect().adjusted(-kRingMargin, -kRingMargin, kRingMargin, kRingMargin);
    if (outer.isEmpty() || box.width() > kLargest || box.height() > kLargest) return;
    const QPointF origin = box.topLeft().toPoint();
    drawSmoothly(painter, box, [&](QPainter& inner) {
        inner.translate(-origin);
        inner.setPen(QPen(theme.label, kRingHalo));
        inner.drawPolyline(outer);
        inner.setPen(QPen(theme.accent, kRingLine));
        inner.drawPolyline(outer);
        inner.setPen(QPen(theme.accent, kThin, Qt::DotLine));
        inner.drawPolyline(core);
    });
}

} // namespace

void drawBrushRing(QPainter& painter, const PickHit& at, const BrushRing& ring, const ViewCamera& camera,
                   const Theme& theme) {
    drawRing(painter, ringCircle(at, ring.radius, camera), ringCircle(at, ring.core * ring.radius, camera),
             theme);
}

void drawSelectBrush(QPainter& painter, QPointF at, double radius, const Theme& theme) {
    QPolygonF circle;
    for (int i = 0; i <= kRingCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingCorners;
        circle << at + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    drawRing(painter, circle, {}, theme);
}

} // namespace tactum
