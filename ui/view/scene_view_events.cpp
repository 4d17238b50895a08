#include <algorithm>
#include <cmath>
#include <utility>

#include <QContextMenuEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/view/axes_gizmo.h"
#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {

constexpr double kClickPixels = 4;
constexpr double kZoomPerNotch = 0.87;
constexpr double kFineStep = 0.2;
// Between places of a stroke, so that it stays on the surface; and how many of a move are looked at.
constexpr double kStrokePixels = 6, kMaxEventPlaces = 32;
/// Added in linear light to the surface under the cursor.
const QColor kHoverGlow = QColor::fromRgbF(0.075f, 0.1f, 0.115f);

/// `other`: the one of the two that the button does not do by itself.
ViewDrag dragOf(CameraManners::Drag drag, bool other) {
    if (drag == CameraManners::Drag::None) return ViewDrag::None;
    return (drag == CameraManners::Drag::Orbit) != other ? ViewDrag::Orbit : ViewDrag::Pan;
}

Qt::CursorShape shapeOf(Qt::Orientations lines) {
    if (lines == (Qt::Horizontal | Qt::Vertical)) return Qt::SizeAllCursor;
    return lines == Qt::Vertical ? Qt::SplitHCursor : Qt::SplitVCursor;
}

} // namespace

QPoint SceneView::Impl::inScreen(QPointF cursor) const {
    return view.mapToGlobal((cursor + pane().place.topLeft()).toPoint());
}

std::optional<PickHit> SceneView::Impl::pickAt(QPointF place, ScenePicker::Patience patience) const {
    const ViewPane& there = panes[panes.at(place)];
    return picker.cast(there.camera.ray(there.inside(place)), patience);
}

std::optional<PickHit> SceneView::Impl::pick(QPointF cursor, ScenePicker::Patience patience) const {
    return picker.cast(camera().ray(cursor), patience);
}

void SceneView::Impl::pressLeft(QPointF cursor, bool alt) {
    const auto region = std::exchange(regionNext, std::nullopt);
    drag = !region ? ViewDrag::Orbit : region == RegionShape::Box ? ViewDrag::Box : ViewDrag::Lasso;
    lasso = QPolygonF({cursor});
    if (const auto axis = axisUnder(cursor); axis && !region && !alt) {
        drag = ViewDrag::None;
        return lookAlong(*axis);
    }
    // A measure begins at what is seen there, also behind a handle.
    if (region || alt || (tool != ViewTool::Measure && takeHandles(cursor))) return;
    if (brushes()) drag = ViewDrag::Brush;
    if (tool != ViewTool::Touch && tool != ViewTool::Paint) return;
    const auto hit = pick(cursor, ScenePicker::Patience::Wait);
    if (tool == ViewTool::Touch && (hit || isNearFinger(cursor))) takeHold(cursor, hit);
    if (tool == ViewTool::Paint && hit) drag = ViewDrag::Paint;
}

std::optional<Vec3> SceneView::Impl::axisUnder(QPointF cursor) const {
    const ViewPane& in = panes[panes.active()];
    if (!hasAxes(in.camera.size, panes.isDivided())) return std::nullopt;
    return axisAt(cursor, in.camera, coveredIn(in));
}

/// From its end, at the same focus, as far away.
void SceneView::Impl::lookAlong(const Vec3& axis) {
    ViewCamera to = camera();
    to.yaw = std::atan2(axis.x(), axis.z());
    to.pitch = std::asin(axis.y());
    view.flyTo(to);
}

void SceneView::Impl::strokeTo(QPointF cursor, Qt::KeyboardModifiers modifiers) {
    const double places =
        std::clamp(std::ceil(lengthOf(cursor - cursorAt) / kStrokePixels), 1.0, kMaxEventPlaces);
    for (double i = 1; i <= places; ++i) {
        brushAt = pick(cursorAt + i / places * (cursor - cursorAt), ScenePicker::Patience::Wait);
        emit view.stroked(brushAt ? StrokeStep::Move : StrokeStep::Lift, brushAt, modifiers);
    }
    view.changed();
}

void SceneView::Impl::endStroke(StrokeStep how) {
    const ViewDrag ended = drag;
    if (ended != ViewDrag::Paint && ended != ViewDrag::Brush) return;
    drag = ViewDrag::None;
    if (ended == ViewDrag::Paint)
        emit view.stroked(how, std::nullopt, {});
    else
        emit view.selectBrushed(how, cursorAt, cursorAt, {});
}

void SceneView::Impl::letGo(bool givenUp) {
    if (lags()) QCursor::setPos(inScreen(lagging.at())); // where the finger is; Wayland refuses
    drag = ViewDrag::None;
    const bool handled = std::exchange(taken, nullptr);
    for (ViewHandles* each : handles)
        each->letGo();
    arranged.reset();
    if (handled) emit view.handlesLeft(givenUp);
    leaveHand(givenUp);
}

void SceneView::Impl::dragTo(QPointF cursor, Qt::KeyboardModifiers modifiers) {
    const QPointF step = cursor - cursorAt;
    if (drag == ViewDrag::Paint) return strokeTo(cursor, modifiers);
    if (drag == ViewDrag::Brush) emit view.selectBrushed(StrokeStep::Move, cursorAt, cursor, modifiers);
    if (drag == ViewDrag::Lasso) lasso << cursor;
    if (drag == ViewDrag::Orbit) camera().orbit(manners.turnSpeed * step);
    if (drag == ViewDrag::Pan) camera().pan(step);
    if (drag == ViewDrag::Handles) leadHandles(cursor, modifiers);
    if (hand.grip() == Grip::None) return view.changed();
    if (lags()) cursor = lagging.follow(cursor, pushInPicture());
    std::optional<Vec3> touched;
    if (hand.grip() == Grip::Stroke)
        if (const auto hit = pick(cursor, ScenePicker::Patience::Wait)) touched = hit->point;
    hand.moveTo(cursor, camera(), touched, modifiers & Qt::ControlModifier);
    goalMoved();
}

/// A press that did not become a drag chooses what lies there, or, away from the model, nothing.
void SceneView::Impl::release(QPointF cursor, Qt::KeyboardModifiers modifiers) {
    if (drag == ViewDrag::Lines) return endLines(cursor);
    if (drawsRegion()) return endRegion(cursor, modifiers);
    if (drag == ViewDrag::Paint || drag == ViewDrag::Brush) return endStroke(StrokeStep::End);
    const bool clicked = !moved && (drag == ViewDrag::Hand || drag == ViewDrag::Orbit);
    letGo();
    showCursor(cursor);
    if (!clicked) return;
    if (tool == ViewTool::Measure) return measureFrom(cursor);
    const auto hit = pick(cursor, ScenePicker::Patience::Wait);
    emit view.picked(hit, modifiers);
}

void SceneView::Impl::askForMenu(QPointF cursor) {
    emit view.menuAsked(pick(cursor, ScenePicker::Patience::Wait), inScreen(cursor));
}

void SceneView::Impl::endRegion(QPointF cursor, Qt::KeyboardModifiers modifiers) {
    const bool box = drag == ViewDrag::Box;
    letGo();
    showCursor(cursor);
    view.changed();
    if (!moved) return;
    if (box)
        emit view.boxDrawn(QRectF(pressedAt, cursor).normalized(), modifiers);
    else
        emit view.lassoDrawn(lasso, modifiers);
}

void SceneView::Impl::hoverAt(QPointF cursor) {
    const auto hit = pick(cursor, ScenePicker::Patience::Now);
    hoverOn(hit);
    if (tool == ViewTool::Paint) {
        brushAt = hit;
        view.changed();
    }
    if (tool == ViewTool::Measure) {
        measureNext = measureAt(cursor, ScenePicker::Patience::Now);
        view.changed();
    }
    showCursor(cursor);
    // The handle under the mouse is lit, and the ring goes with it.
    if (brushes() || std::ranges::any_of(handles, &ViewHandles::shows)) view.changed();
}

void SceneView::Impl::hoverOn(const std::optional<PickHit>& hit) {
    setHovered(hit ? std::optional(hit->surface) : std::nullopt);
}

void SceneView::Impl::setHovered(std::optional<SurfaceRef> surface) {
    if (surface == hovered) return;
    hovered = surface;
    model.setHighlight(surface, kHoverGlow);
    view.changed();
    emit view.surfaceHovered(surface);
}

/// What lies under a pointer that did not move may be another surface: the camera has turned, or a body has
/// gone by.
void SceneView::rested() {
    if (!impl_->pointer || impl_->drag != ViewDrag::None || impl_->hand.grip() != Grip::None) return;
    impl_->hoverOn(impl_->pickAt(*impl_->pointer, ScenePicker::Patience::Now));
}

bool SceneView::Impl::dragOver(QDropEvent& event) {
    setHovered(view.surfaceAt(event.position()));
    event.setDropAction(Qt::CopyAction);
    event.setAccepted(hovered.has_value());
    return hovered.has_value();
}

/// After the scene has changed: its actors may be new ones.
void SceneView::Impl::refreshHover() {
    if (!hovered) return;
    if (!model.shows(*hovered)) return setHovered(std::nullopt);
    model.setHighlight(hovered, kHoverGlow);
}

void SceneView::Impl::showCursor(QPointF cursor) {
    if (const auto lines = linesUnder(cursor)) return view.setCursor(shapeOf(lines));
    if (hand.grip() != Grip::None) return view.setCursor(lags() ? Qt::BlankCursor : Qt::ClosedHandCursor);
    if (regionNext || drawsRegion() || brushes()) return view.setCursor(Qt::CrossCursor);
    if (drag == ViewDrag::None && axisUnder(cursor)) return view.setCursor(Qt::PointingHandCursor);
    const auto under = [&](const ViewHandles* each) { return each->isUnder(cursor, camera()); };
    if (drag == ViewDrag::Handles || std::ranges::any_of(handles, under))
        return view.setCursor(Qt::SizeAllCursor);
    if (tool == ViewTool::Touch && takesFinger(cursor, pick(cursor, ScenePicker::Patience::Now)))
        return view.setCursor(Qt::OpenHandCursor);
    if (!hovered) return view.setCursor(Qt::ArrowCursor);
    const bool chooses = tool == ViewTool::Select || tool == ViewTool::Arrange;
    view.setCursor(chooses ? Qt::PointingHandCursor : Qt::CrossCursor);
}

void SceneView::Impl::zoomAt(QPointF cursor, double notches) {
    const auto hit = manners.zoomToCursor ? pick(cursor, ScenePicker::Patience::Now) : std::nullopt;
    const Vec3 anchor = hit                    ? hit->point
                        : manners.zoomToCursor ? camera().pointAtDepthOf(camera().focus, cursor)
                                               : camera().focus;
    const double size = extent();
    const double wanted = std::pow(kZoomPerNotch, manners.zoomSpeed * notches);
    const double distance = std::clamp(camera().distance * wanted, 0.01 * size, 50 * size);
    camera().zoomTo(anchor, distance / camera().distance);
    view.changed();
}

bool SceneView::Impl::handKey(int key, QPointF cursor) {
    if (arrangeKey(key)) {
        view.changed();
    } else if (key == Qt::Key_Escape && drag == ViewDrag::Handles) {
        giveUpHandles();
    } else if (key == Qt::Key_Escape && (drag == ViewDrag::Paint || drag == ViewDrag::Brush)) {
        endStroke(StrokeStep::Cancel);
    } else if (key == Qt::Key_Escape && (regionNext || drawsRegion())) {
        regionNext.reset();
        letGo();
        view.changed();
    } else if (key == Qt::Key_Escape && tool == ViewTool::Measure) {
        giveUpMeasure();
    } else if (key == Qt::Key_Escape && brushes()) {
        emit view.selectBrushLeft();
    } else if (key == Qt::Key_Escape && (hand.grip() != Grip::None || hand.gliding())) {
        letGo(true);
        showCursor(cursor);
        return false; // the same key leaves the presentation
    } else if (key == Qt::Key_G && tool != ViewTool::Touch) {
        emit view.mappingAsked();
    } else if (key == Qt::Key_G) {
        if (hand.grip() == Grip::Follow)
            letGo();
        else
            setGrip(Grip::Follow, cursor);
    } else {
        return false;
    }
    showCursor(cursor);
    return true;
}

bool SceneView::Impl::cameraKey(int key) {
    switch (key) {
    case Qt::Key_1:
        view.showStandardView(StandardView::Front);
        return true;
    case Qt::Key_3:
        view.showStandardView(StandardView::Right);
        return true;
    case Qt::Key_7:
        view.showStandardView(StandardView::Top);
        return true;
    case Qt::Key_0:
        view.showStandardView(StandardView::Isometric);
        return true;
    default:
        return false;
    }
}

void SceneView::mousePressEvent(QMouseEvent* event) {
    impl_->flight.stop();
    if (event->button() == Qt::LeftButton && impl_->takeLines(event->position())) return;
    const QPointF cursor = impl_->actAt(event->position());
    if (impl_->drag == ViewDrag::Handles) { // that follow the pointer without a button, or a second button
        if (event->button() != Qt::LeftButton) return impl_->giveUpHandles();
        return impl_->letGo();
    }
    impl_->pressedAt = impl_->cursorAt = cursor;
    impl_->moved = impl_->menuNext = false;
    if (impl_->hand.grip() == Grip::Follow) {
        impl_->letGo();
    } else if (event->button() == Qt::LeftButton) {
        impl_->pressLeft(cursor, event->modifiers() & Qt::AltModifier);
        if (impl_->drag == ViewDrag::Paint)
            emit stroked(StrokeStep::Begin, impl_->pick(cursor, ScenePicker::Patience::Wait),
                         event->modifiers());
        if (impl_->drag == ViewDrag::Brush)
            emit selectBrushed(StrokeStep::Begin, cursor, cursor, event->modifiers());
    } else if (event->button() == Qt::MiddleButton) {
        impl_->drag = dragOf(impl_->manners.middle, event->modifiers() & Qt::ShiftModifier);
        impl_->moved = true; // never a click that chooses
    } else if (event->button() == Qt::RightButton) {
        impl_->menuNext = true;
        impl_->drag = dragOf(impl_->manners.right, false);
    } else {
        return;
    }
    impl_->showCursor(cursor);
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    if (impl_->drag == ViewDrag::Lines) return impl_->leadLines(event->position());
    const QPointF cursor = impl_->pointAt(event->position());
    impl_->pointer = event->position();
    if (lengthOf(cursor - impl_->pressedAt) > kClickPixels) impl_->moved = true;
    if (impl_->drag != ViewDrag::None || impl_->hand.grip() == Grip::Follow)
        impl_->dragTo(cursor, event->modifiers());
    else
        impl_->hoverAt(cursor);
    impl_->cursorAt = cursor;
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton && std::exchange(impl_->menuNext, false)) {
        if (impl_->drag != ViewDrag::None) impl_->letGo();
        if (!impl_->moved) impl_->askForMenu(impl_->pointAt(event->position()));
        return;
    }
    if (impl_->drag == ViewDrag::None) return event->ignore();
    impl_->release(impl_->pointAt(event->position()), event->modifiers());
}

/// Of the mouse it is asked for when the button goes up: where it gives something up there is none.
void SceneView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Mouse)
        emit menuAsked(std::nullopt, mapToGlobal(rect().center()));
    event->accept();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && impl_->evenLines(event->position())) return;
    const QPointF cursor = impl_->actAt(event->position());
    const bool onFinger = impl_->tool == ViewTool::Touch &&
                          impl_->takesFinger(cursor, impl_->pick(cursor, ScenePicker::Patience::Wait));
    if (event->button() == Qt::LeftButton && impl_->tool != ViewTool::Touch)
        if (const auto hit = impl_->pick(cursor, ScenePicker::Patience::Wait); hit && doubleClick_(*hit))
            return;
    if (event->button() != Qt::LeftButton || !onFinger) return mousePressEvent(event);
    impl_->cursorAt = cursor;
    impl_->setGrip(Grip::Follow, cursor);
    impl_->showCursor(cursor);
}

void SceneView::wheelEvent(QWheelEvent* event) {
    impl_->flight.stop();
    const QPointF cursor = impl_->actAt(event->position());
    const double notches = event->angleDelta().y() / 120.0;
    if (impl_->hand.grip() == Grip::None) return impl_->zoomAt(cursor, notches);
    impl_->hand.push(notches, impl_->camera());
    impl_->goalMoved();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    impl_->flight.stop();
    const bool pad = event->modifiers() & Qt::KeypadModifier;
    const double scale = event->modifiers() & Qt::ShiftModifier ? kFineStep : 1;
    if (event->key() == Qt::Key_Home) return fit();
    if (pad && !impl_->holdsArranging() && impl_->cameraKey(event->key())) return;
    impl_->panes.use();
    if (impl_->handKey(event->key(), impl_->pane().inside(mapFromGlobal(QCursor::pos()))) ||
        impl_->nudgeKey(event->key(), scale))
        return;
    VtkWidget::keyPressEvent(event);
}

void SceneView::leaveEvent(QEvent* event) {
    if (!impl_->staysInPane() && impl_->panes.pointNowhere()) {
        changed();
        emit projectionChanged();
    }
    impl_->brushAt.reset();
    impl_->pointer.reset();
    if (std::exchange(impl_->measureNext, std::nullopt) || impl_->brushes()) changed();
    impl_->setHovered(std::nullopt);
    VtkWidget::leaveEvent(event);
}

// What is not ours goes on to the window.
void SceneView::dragEnterEvent(QDragEnterEvent* event) {
    const auto fits = [&](const QString& type) { return event->mimeData()->hasFormat(type); };
    event->setAccepted(std::ranges::any_of(impl_->dropTypes, fits));
}

void SceneView::dragMoveEvent(QDragMoveEvent* event) {
    impl_->dragOver(*event);
}

void SceneView::dragLeaveEvent(QDragLeaveEvent*) {
    impl_->setHovered(std::nullopt);
}

void SceneView::dropEvent(QDropEvent* event) {
    if (!impl_->dragOver(*event)) return;
    const SurfaceRef surface = *impl_->hovered;
    impl_->setHovered(std::nullopt);
    emit droppedOn(surface, *event->mimeData());
}

} // namespace tactum
