#include "ui/view/pane_mark.h"

#include <cmath>
#include <numbers>

#include <QFontMetricsF>
#include <QObject>

#include "ui/view/free_corner.h"
#include "ui/view/smooth_image.h"
#include "ui/view/view_panes.h"

namespace tactum {

namespace {

constexpr double kAngle = 1e-6; ///< rad
constexpr double kNameEdge = 8, kNamePadX = 7, kNamePadY = 3;
constexpr int kFrame = 2;

/// Empty: none.
QString sideOf(const ViewCamera& camera) {
    constexpr double kRightAngle = 0.5 * std::numbers::pi;
    const auto is = [](double angle, double other) {
        return std::abs(std::remainder(angle - other, 4 * kRightAngle)) < kAngle;
    };
    if (is(camera.yaw, 0) && is(camera.pitch, kRightAngle)) return QObject::tr("Top");
    if (is(camera.yaw, 0) && is(camera.pitch, -kRightAngle)) return QObject::tr("Bottom");
    if (!is(camera.pitch, 0)) return {};
    if (is(camera.yaw, 0)) return QObject::tr("Front");
    if (is(camera.yaw, kRightAngle)) return QObject::tr("Right");
    if (is(camera.yaw, 2 * kRightAngle)) return QObject::tr("Back");
    return is(camera.yaw, -kRightAngle) ? QObject::tr("Left") : QString();
}

QString turnedName(std::size_t pane) {
    if (pane == ViewPanes::kOwn) return QObject::tr("Own view");
    return QObject::tr("%1, turned").arg(sideOf(ViewPanes::planned(pane)));
}

} // namespace

QString paneName(std::size_t pane, const ViewCamera& camera) {
    const QString side = sideOf(camera), name = side.isEmpty() ? turnedName(pane) : side;
    return camera.parallel ? QObject::tr("%1, parallel").arg(name) : name;
}

double drawPaneName(QPainter& painter, const QString& whole, const QSizeF& pane, const Theme& theme,
                    bool active, const QRegion& covered) {
    const QFontMetricsF metrics(painter.font());
    const double most = std::max(1.0, pane.width() - 2 * (kNameEdge + kNamePadX));
    const QString name = metrics.elidedText(whole, Qt::ElideRight, most);
    const QSizeF size(std::ceil(metrics.horizontalAdvance(name)) + 2 * kNamePadX,
                      std::ceil(metrics.height()) + 2 * kNamePadY);
    const QRectF box = belowCovers({QPointF(kNameEdge, kNameEdge), size}, pane.height(), covered);
    drawSmoothly(painter, box, [&](QPainter& inner) {
        inner.setPen(Qt::NoPen);
        inner.setBrush(active ? theme.accent : theme.label);
        inner.drawRoundedRect(QRectF({0, 0}, size), 4, 4);
        inner.setPen(active ? theme.accentText : theme.labelText);
        inner.drawText(QRectF({0, 0}, size), Qt::AlignCenter, name);
    });
    return box.bottom();
}

void drawPaneFrame(QPainter& painter, const QSizeF& size, const Theme& theme) {
    const double w = size.width(), h = size.height();
    for (const QRectF& side : {QRectF(0, 0, w, kFrame), QRectF(0, h - kFrame, w, kFrame),
                               QRectF(0, 0, kFrame, h), QRectF(w - kFrame, 0, kFrame, h)})
        painter.fillRect(side, theme.accent);
}

} // namespace tactum
