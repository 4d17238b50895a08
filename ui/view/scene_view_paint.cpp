// What the view draws over its pictures with a painter.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QOpenGLPaintDevice>
#include <QPainter>

#include "ui/view/axes_gizmo.h"
#include "ui/view/brush_ring.h"
#include "ui/view/pane_mark.h"
#include "ui/view/scene_view_impl.h"
#include "ui/view/view_labels.h"

namespace tactum {

namespace {
const QPointF kNoCursor(-1e6, -1e6);
} // namespace

/// What is drawn over the view to select it.
void SceneView::Impl::drawRegion(QPainter& painter) const {
    if (brushes() && pointer) drawSelectBrush(painter, pane().inside(*pointer), *selectBrush, theme());
    if (!drawsRegion()) return;
    const QPolygonF line =
        drag == ViewDrag::Box ? QPolygonF(QRectF(pressedAt, cursorAt).normalized()) : lasso;
    QColor fill = theme().accent;
    fill.setAlphaF(0.15f);
    painter.setBrush(fill);
    painter.setPen(QPen(theme().label, 3)); // in front of what is selected, too, which has the fill's colour
    painter.drawPolygon(line, Qt::WindingFill);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().labelText, 1, Qt::DashLine));
    painter.drawPolygon(line);
}

void SceneView::Impl::drawHandles(QPainter& painter, const ViewPane& in) const {
    const QPointF cursor = &in == &pane() ? cursorAt : kNoCursor;
    mapping.draw(painter, in.camera, theme(), cursor);
    if (mass) drawMass(painter, *mass, in.camera, theme());
    joint.draw(painter, in.camera, theme(), cursor);
    path.draw(painter, in.camera, theme(), cursor);
    sectionHandles.draw(painter, in.camera, theme(), cursor);
    arranging.draw(painter, in.camera, theme(), cursor, arranged);
}

/// `below`: of the pane's height, what its name takes. Legends are in one pane: they are the same in all.
void SceneView::Impl::drawWords(QPainter& painter, const ViewPane& in, double below) const {
    if (&in == &panes[ViewPanes::kOwn]) {
        const int under = std::max(0, foot - (view.height() - in.place.y() - in.place.height()));
        painter.translate(0, below);
        felt.drawLegends(painter, in.camera.size - QSizeF(0, under + below), theme());
        painter.translate(0, -below);
    }
    if (showsTouch())
        drawTouchLabels(painter, *touch, in.camera, theme(), touchedName,
                        {mark.number, beside.empty() ? QString() : mark.name});
    drawBeside(painter, in.camera);
}

void SceneView::Impl::drawPane(QPainter& painter, std::size_t number) const {
    const ViewPane& in = panes[number];
    const bool active = number == panes.active(), marked = active && handlesDrawn;
    if (hasAxes(in.camera.size, panes.isDivided())) drawAxes(painter, in.camera, theme(), coveredIn(in));
    if (active) {
        drawRegion(painter);
        if (brushAt) drawBrushRing(painter, *brushAt, brush, in.camera, theme());
    }
    drawColliders(
        painter, colliders, [this](ObjectId id) { return model.placeOf(id); }, in.camera, theme());
    if (handlesDrawn) drawHandles(painter, in);
    drawMeasured(painter, in);
    double below = 0;
    if (panes.isDivided())
        below = drawPaneName(painter, paneName(number, in.camera), in.camera.size, theme(), marked,
                             coveredIn(in));
    drawWords(painter, in, below);
    if (panes.isDivided() && marked) drawPaneFrame(painter, in.camera.size, theme());
}

void SceneView::Impl::drawLines(QPainter& painter) const {
    if (!panes.isDivided()) return;
    const QRect first = panes[panes.shown().front()].place;
    const QColor colour = theme().window;
    if (first.width() < view.width())
        painter.fillRect(first.width(), 0, ViewPanes::kGap, view.height(), colour);
    if (first.height() < view.height())
        painter.fillRect(0, first.height(), view.width(), ViewPanes::kGap, colour);
}

// Into the framebuffer that is bound: a painter on the widget would miss the picture when a window is
// grabbed.
void SceneView::paintOver() {
    QOpenGLPaintDevice device((QSizeF(size()) * devicePixelRatioF()).toSize());
    device.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&device);
    drawOver(painter);
    impl_->askForLoupe();
}

void SceneView::drawOver(QPainter& painter) const {
    painter.setFont(font());
    for (const std::size_t number : impl_->panes.shown()) {
        if (!impl_->panes.isDivided()) {
            impl_->drawPane(painter, number);
            break;
        }
        const QRect& place = impl_->panes[number].place;
        painter.save();
        painter.setClipRect(place);
        painter.translate(place.topLeft());
        impl_->drawPane(painter, number);
        painter.restore();
    }
    impl_->drawLines(painter);
}

} // namespace tactum
