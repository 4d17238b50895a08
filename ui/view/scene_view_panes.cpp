// The panes of the view: how it is divided, and which of them the mouse and the keys act upon.
#include <algorithm>

#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {

/// Whether two cameras look the same way from the same place, however large their pictures are.
bool looksAlike(ViewCamera a, const ViewCamera& b) {
    return a.focus == b.focus && a.distance == b.distance && a.yaw == b.yaw && a.pitch == b.pitch &&
           a.fieldOfView == b.fieldOfView && a.parallel == b.parallel;
}

bool holds(const ViewCamera& camera, std::span<const Vec3> points_W) {
    const QRectF picture({0, 0}, camera.size);
    return std::ranges::all_of(points_W, [&](const Vec3& p_W) {
        const auto at = camera.project(p_W);
        return at && picture.contains(*at);
    });
}

} // namespace

void SceneView::Impl::fit(ViewPane& pane) {
    panes.layOut(view.size());
    pane.camera.fieldOfView = defaultCamera().fieldOfView; // that of a saved camera may be another
    pane.camera.fit(spanning);
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

// What was seen whole is to be seen whole in a narrower pane, and as before once it is alone again.
void SceneView::Impl::changeSplit(ViewSplit split) {
    ViewPane& own = panes[ViewPanes::kOwn];
    panes.layOut(view.size());
    const bool untouched = undivided && looksAlike(own.camera, narrowed);
    if (untouched) {
        const QSizeF size = own.camera.size;
        own.camera = *undivided;
        own.camera.size = size;
    }
    ViewCamera alone = own.camera;
    alone.size = view.size();
    panes.setSplit(split);
    undivided.reset();
    if (!panes.isDivided() || !own.fitted) return;
    undivided = own.camera;
    if (holds(alone, spanning) && !holds(own.camera, spanning)) fit(own);
    narrowed = own.camera;
}

void SceneView::setSplit(ViewSplit split) {
    if (split == this->split()) return;
    impl_->endStroke(StrokeStep::Cancel);
    impl_->letGo();
    impl_->flight.stop();
    impl_->changeSplit(split);
    if (context()) makeCurrent();
    impl_->stage.setCameras(impl_->panes.shown().size());
    if (context()) doneCurrent();
    changed();
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

bool SceneView::showsPlan() const {
    return impl_->pane().plan;
}

QPointF SceneView::Impl::pointAt(QPointF place) {
    if (!staysInPane() && panes.pointAt(place)) view.changed();
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

} // namespace tactum
