#include "ui/view/axes_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>

#include "ui/view/free_corner.h"
#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

constexpr double kSide = 92, kReach = 31, kBall = 9, kAxesCorner = 8;
constexpr double kRoom =
    200; ///< of a pane that has one: it would fill a smaller one, whose name says how it looks

struct AxisEnd {
    Vec3 axis;
    QString letter; ///< empty at the negative end
    QColor colour;
    QPointF tip;  ///< from the centre of the cross
    double depth; ///< away from the eye
};

/// The farthest first.
std::array<AxisEnd, 6> axisEnds(const ViewCamera& camera, const Theme& theme) {
    const std::array<QColor, 3> colours{theme.axisX, theme.axisY, theme.axisZ};
    std::array<AxisEnd, 6> ends;
    for (int i = 0; i < 6; ++i) {
        const Vec3 axis = (i < 3 ? 1 : -1) * Vec3::Unit(i % 3);
        ends[i] = {axis, i < 3 ? QString("XYZ"[i]) : QString(), colours[i % 3],
                   kReach * QPointF(axis.dot(camera.right()), -axis.dot(camera.up())),
                   axis.dot(camera.forward())};
    }
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
    return ends;
}

void drawEnd(QPainter& painter, const AxisEnd& end, const Theme& theme) {
    const QRectF ball(end.tip - QPointF(kBall, kBall), QSizeF(2 * kBall, 2 * kBall));
    QColor colour = end.colour;
    if (end.letter.isEmpty()) { // the negative end: a small dim ball
        colour.setAlphaF(0.45f);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(end.tip, 0.5 * kBall, 0.5 * kBall);
        return;
    }
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0, 0), end.tip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(ball);
    painter.setPen(theme.dark ? QColor(0x14, 0x16, 0x1a) : QColor(Qt::white));
    painter.drawText(ball, Qt::AlignCenter, end.letter);
}

} // namespace

QRectF axesPlace(QSizeF view, const QRegion& covered) {
    const QRectF corner(view.width() - kSide - kAxesCorner, kAxesCorner, kSide, kSide);
    return belowCovers(corner, view.height(), covered);
}

bool hasAxes(QSizeF pane, bool divided) {
    return !divided || std::min(pane.width(), pane.height()) >= kRoom;
}

std::optional<Vec3> axisAt(QPointF place, const ViewCamera& camera, const QRegion& covered) {
    const QPointF from = place - axesPlace(camera.size, covered).center();
    const auto ends = axisEnds(camera, themeFor(true)); // whatever their colours
    const auto hit = std::find_if(ends.rbegin(), ends.rend(), [&](const AxisEnd& end) {
        return std::hypot(from.x() - end.tip.x(), from.y() - end.tip.y()) <= kBall;
    });
    return hit == ends.rend() ? std::nullopt : std::optional(hit->axis);
}

void drawAxes(QPainter& painter, const ViewCamera& camera, const Theme& theme, const QRegion& covered) {
    drawSmoothly(painter, axesPlace(camera.size, covered), [&](QPainter& inner) {
        QFont font = inner.font();
        font.setPixelSize(11);
        font.setBold(true);
        inner.setFont(font);
        inner.translate(0.5 * kSide, 0.5 * kSide);
        for (const AxisEnd& end : axisEnds(camera, theme))
            drawEnd(inner, end, theme);
    });
}

} // namespace tactum
