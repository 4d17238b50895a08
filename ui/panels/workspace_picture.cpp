#include "ui/panels/workspace_picture.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

WorkspacePicture::WorkspacePicture(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("workspace-picture"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("The handle in the device's workspace, as you see it from the front and from above"));
}

void WorkspacePicture::setHandle(const Vec3& handle, double radius) {
    if (!handle.allFinite()) return;
    handle_ = handle;
    farthest_ = std::max(farthest_, handle.norm());
    radius_ = radius > 0 ? radius : farthest_;
    setAccessibleName(tr("Handle at %1, %2, %3 mm in a workspace of %4 mm about the centre")
                          .arg(numberText(1e3 * handle.x(), 0), numberText(1e3 * handle.y(), 0),
                               numberText(1e3 * handle.z(), 0), numberText(1e3 * radius_, 0)));
    update();
}

/// `at`: in parts of the radius, y up.
void WorkspacePicture::drawView(QPainter& painter, const QRectF& box, const QString& name, QPointF at) const {
    constexpr double kDot = 5;
    const double words = painter.fontMetrics().height();
    const double r = 0.5 * std::min(box.width(), box.height() - words) - kDot;
    const QPointF centre(box.center().x(), box.top() + r + kDot);
    painter.setPen(QPen(theme().border, 1));
    painter.setBrush(theme().field);
    painter.drawEllipse(centre, r, r);
    painter.drawLine(centre - QPointF(r, 0), centre + QPointF(r, 0));
    painter.drawLine(centre - QPointF(0, r), centre + QPointF(0, r));
    const double far = std::hypot(at.x(), at.y());
    const bool outside = handle_.norm() > radius_;
    const QPointF inside = far > 1 ? at / far : at; // it stays in the picture
    painter.setPen(Qt::NoPen);
    painter.setBrush(outside ? theme().fault : theme().finger);
    painter.drawEllipse(centre + r * QPointF(inside.x(), -inside.y()), kDot, kDot);
    painter.setPen(theme().textDimmed);
    painter.drawText(QRectF(box.left(), box.bottom() - words, box.width(), words), Qt::AlignCenter,
                     outside ? tr("%1, at the edge").arg(name) : name);
}

void WorkspacePicture::paintEvent(QPaintEvent*) {
    if (!(radius_ > 0)) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Vec3 p = handle_ / radius_;
    const double half = 0.5 * width();
    drawView(painter, QRectF(0, 0, half, height()), tr("front"), {p.x(), p.y()});
    drawView(painter, QRectF(half, 0, half, height()), tr("from above"), {p.x(), -p.z()});
}

} // namespace tactum
