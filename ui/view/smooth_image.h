// Drawing on top of the view with smooth edges on every context. Private to this folder.
#pragma once

#include <QImage>
#include <QPaintEngine>
#include <QPainter>

namespace tactum {

/// Draws into `box` by the processor: OpenGL without multisampling has no smooth edges. `draw` gets a painter
/// with the box's upper left corner as its origin, the font of `painter` and antialiasing on.
template <class Draw> void drawSmoothly(QPainter& painter, const QRectF& box, Draw draw) {
    const QPointF corner(box.topLeft().toPoint());
    if (painter.paintEngine()->type() == QPaintEngine::User) { // it notes strokes, and has no pixels
        painter.save();
        painter.translate(corner);
        draw(painter);
        return painter.restore();
    }
    const double ratio = painter.device()->devicePixelRatioF();
    QImage image((box.size() * ratio).toSize().expandedTo({1, 1}), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::transparent);
    QPainter inner(&image);
    inner.setRenderHint(QPainter::Antialiasing);
    inner.setFont(painter.font());
    draw(inner);
    inner.end();
    painter.drawImage(corner, image);
}

} // namespace tactum
