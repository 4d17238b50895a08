// The panes of the view: how it is divided, and which of them the mouse and the keys act upon.
#include <algorithm>

#include "ui/view/scene_view_impl.h"

namespace tactum {

void SceneView::Impl::fit(ViewPane& pane) {
    panes.layOut(view.size());
    pane.camera.fieldOfView = defaultCamera().fieldOfView; // that of a saved camera may be another
    pane.camera.fit(panes.spanning());
    // Else again once the size is known.
    const bool isSeen = std::ranges::any_of(panes.shown(), [&](std::size_t i) { return &panes[i] == &pane; });
    pane.fitted = isSeen && view.isVisible() && picker.bounds().diagonal() > 0;
}

double SceneView::Impl::finestPixel(const Vec3& p_W) const {
    double finest = camera().pixelSize(p_W);
    for (const std::size_t number : panes.shown())
        finest = std::min(finest, panes[number].camera.pixelSize(p_W));
    return finest;
}

void SceneView::setSplit(ViewSplit split) {
    if (split == this->split()) return;
    impl_->endStroke(StrokeStep::Cancel);
    impl_->letGo();
    impl_->flight.stop();
    impl_->panes.layOut(size()); // the own view stands where it does in all of it
    impl_->panes.setSplit(split);
    if (context()) makeCurrent();
    impl_->stage.setCameras(impl_->panes.shown().size());
    if (context()) doneCurrent();
    changed();
    emit projectionChanged();
}

ViewSplit SceneView::split() const {
    return impl_->panes.split();
}

void SceneView::setDivision(QPointF parts) {
    impl_->panes.setDivision(parts);
    changed();
}

QPointF SceneView::division() const {
    return impl_->panes.division();
}

std::vector<QRect> SceneView::pictures() {
    impl_->panes.layOut(size());
    return panes();
}

std::vector<QRect> SceneView::panes() const {
    std::vector<QRect> places;
    for (const std::size_t number : impl_->panes.shown())
        places.push_back(impl_->panes[number].place);
    return places;
}

const ViewCamera& SceneView::cameraOf(std::size_t pane) const {
    return impl_->panes[impl_->panes.shown()[pane]].camera;
}

std::size_t SceneView::activePane() const {
    const auto shown = impl_->panes.shown();
    return std::size_t(std::ranges::find(shown, impl_->panes.active()) - shown.begin());
}

bool SceneView::ownIsActive() const {
    return impl_->panes.active() == ViewPanes::kOwn;
}

void SceneView::setParallel(bool parallel) {
    impl_->panes.setParallel(impl_->panes.active(), parallel);
    changed();
    emit projectionChanged();
}

void SceneView::planViews() {
    impl_->panes.plan();
    fitAll();
    emit projectionChanged();
}

QPointF SceneView::Impl::pointAt(QPointF place) {
    if (!staysInPane() && panes.pointAt(place)) {
        view.changed();
        emit view.projectionChanged();
    }
    return pane().inside(place);
}

QPointF SceneView::Impl::actAt(QPointF place) {
    const QPointF cursor = pointAt(place);
    panes.use();
    return cursor;
}

Qt::Orientations SceneView::Impl::linesUnder(QPointF cursor) const {
    if (drag == ViewDrag::Lines) return ledLines;
    if (staysInPane()) return {};
    return panes.linesAt(cursor + pane().place.topLeft());
}

bool SceneView::Impl::takeLines(QPointF place) {
    const Qt::Orientations lines = staysInPane() ? Qt::Orientations() : panes.linesAt(place);
    if (!lines) return false;
    drag = ViewDrag::Lines;
    ledLines = lines;
    return true;
}

void SceneView::Impl::leadLines(QPointF place) {
    panes.lead(ledLines, place);
    view.changed();
}

void SceneView::Impl::endLines(QPointF cursor) {
    drag = ViewDrag::None;
    showCursor(cursor);
    emit view.divided();
}

bool SceneView::Impl::evenLines(QPointF place) {
    const Qt::Orientations lines = staysInPane() ? Qt::Orientations() : panes.linesAt(place);
    if (!lines) return false;
    panes.even(lines);
    view.changed();
    emit view.divided();
    return true;
}

} // namespace tactum
