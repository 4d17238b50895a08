#include "ui/view/mass_mark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>

namespace tactum {
namespace {

constexpr int kEllipseParts = 48;
constexpr double kCentreDot = 3; // pixels

} // namespace

MassMark massMark(const Pose& principal_W, double mass, const Vec3& moments) {
    MassMark mark;
    mark.pose = principal_W;
    for (int i = 0; i < 3; ++i)
        mark.half[i] = std::sqrt(std::max(0.0, 2.5 * (moments.sum() - 2 * moments[i]) / mass));
    return mark;
}

void drawMass(QPainter& painter, const MassMark& mark, const ViewCamera& camera, const Theme& theme) {
    const auto centre = camera.project(mark.pose.translation);
    if (!centre) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.text, 1.2, Qt::DotLine));
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        QPolygonF ellipse;
        for (int i = 0; i <= kEllipseParts; ++i) {
            const double a = 2 * std::numbers::pi * i / kEllipseParts;
            Vec3 point = Vec3::Zero();
            point[u] = mark.half[u] * std::cos(a), point[v] = mark.half[v] * std::sin(a);
            if (const auto seen = camera.project(mark.pose.apply(point))) ellipse << *seen;
        }
        painter.drawPolyline(ellipse);
    }
    painter.setPen(QPen(theme.label, 1));
    painter.setBrush(theme.text);
    painter.drawEllipse(*centre, kCentreDot, kCentreDot);
    painter.restore();
}

} // namespace tactum
