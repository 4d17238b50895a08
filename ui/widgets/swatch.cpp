#include "ui/widgets/swatch.h"

#include <QGuiApplication>
#include <QPainter>

#include "ui/base/screen_colour.h"

namespace tactum {

QPixmap swatch(const Eigen::Vector3f& linear) {
    const qreal ratio = qApp->devicePixelRatio();
    QPixmap pixmap(QSize(16, 16) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(screenColour(linear));
    painter.drawRoundedRect(QRectF(3, 3, 10, 10), 2.5, 2.5);
    return pixmap;
}

// What has no picture of its own for a selected row is tinted by the style.
QIcon swatchIcon(const Eigen::Vector3f& linear) {
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected, QIcon::Disabled})
        icon.addPixmap(swatch(linear), mode);
    return icon;
}

} // namespace tactum
