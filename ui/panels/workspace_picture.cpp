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

void WorkspacePicture::setAim(const std::optional<Vec3>& aim) {
    aim_ = aim;
    update();
}

/// `at` and `aim`: in parts of the radius, y up.
void WorkspacePicture::drawView(QPainter& painter, const QRectF& box, const QString& name, QPointF at,
                                QPointF aim) const {
    constexpr double kDot = 5;
    const double words = painter.fontMetrics().height();
    const double edge = 2 * kDot + 1; // a ring or a dot on the border is seen whole
    const double r = 0.5 * std::min(box.width(), box.height() - words) - edge;
    const QPointF centre(box.center().x(), box.top() + r + edge);
    const auto inside = [](QPointF p) { return p / std::max(1.0, std::hypot(p.x(), p.y())); };
    painter.setPen(QPen(theme().border, 1));
    painter.setBrush(theme().field);
    painter.drawEllipse(centre, r, r);
    painter.drawLine(centre - QPointF(r, 0), centre + QPointF(r, 0));
    painter.drawLine(centre - QPointF(0, r), centre + QPointF(0, r));
    const bool outside = handle_.norm() > radius_;
    at = inside(at); // it stays in the picture
    aim = inside(aim);
    if (aim_) {
        painter.setPen(QPen(theme().proxy, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre + r * QPointF(aim.x(), -aim.y()), 2 * kDot, 2 * kDot);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(outside ? theme().fault : theme().finger);
    painter.drawEllipse(centre + r * QPointF(at.x(), -at.y()), kDot, kDot);
    painter.setPen(theme().textDimmed);
    painter.drawText(QRectF(box.left(), box.bottom() - words, box.width(), words), Qt::AlignCenter,
                     outside ? tr("%1, at the edge").arg(name) : name);
}

void WorkspacePicture::paintEvent(QPaintEvent*) {
    if (!(radius_ > 0)) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Vec3 p = handle_ / radius_;
    const Vec3 aim = aim_.value_or(Vec3::Zero()) / radius_;
    const double half = 0.5 * width();
    drawView(painter, QRectF(0, 0, half, height()), tr("front"), {p.x(), p.y()}, {aim.x(), aim.y()});
    drawView(painter, QRectF(half, 0, half, height()), tr("from above"), {p.x(), -p.z()},
             {aim.x(), -aim.z()});
}

} // namespace tactum
