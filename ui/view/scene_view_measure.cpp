// The measure in the view: where its points are put, and when they go.
#include <algorithm>

#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {
/// Pixels about the cursor where a corner of the outline is looked for: half of the clicks on one miss the
/// model.
constexpr double kBeside = 7;
const QPointF kAround[] = {{0, 0},
                           {kBeside, 0},
                           {-kBeside, 0},
                           {0, kBeside},
                           {0, -kBeside},
                           {kBeside, kBeside},
                           {-kBeside, kBeside},
                           {kBeside, -kBeside},
                           {-kBeside, -kBeside}};
constexpr std::size_t kMostPoints = 3;
} // namespace

std::optional<MeasurePoint> SceneView::Impl::measureAt(QPointF cursor, ScenePicker::Patience patience) const {
    for (const QPointF& off : kAround) {
        const auto hit = pick(cursor + off, patience);
        const auto soup = hit ? picker.soupOf(hit->surface.object) : nullptr;
        const auto pose = hit ? model.placeOf(hit->surface.object) : std::nullopt;
        if (!soup || !pose) continue;
        const Vec3 place =
            snappedTo(*soup, hit->triangle, *pose, hit->point, cursor, camera(), view.section());
        if (off.isNull() || place != hit->point)
            return MeasurePoint{hit->surface.object, pose->applyInverse(place), soup};
    }
    return std::nullopt;
}

void SceneView::Impl::measureFrom(QPointF cursor) {
    const auto point = measureAt(cursor, ScenePicker::Patience::Wait);
    if (!point) return;
    if (measure.size() == kMostPoints) measure.clear();
    measure.push_back(*point);
    view.changed();
    emit view.measureChanged(false);
}

void SceneView::Impl::giveUpMeasure() {
    const bool left = measure.empty();
    measure.clear();
    view.changed();
    emit view.measureChanged(left);
}

void SceneView::Impl::weedMeasure() {
    const auto isGone = [&](const MeasurePoint& point) {
        const auto soup = picker.soupOf(point.object);
        return !soup || !model.placeOf(point.object) ||
               (soup != point.of && !haveSameShape(*soup, *point.of));
    };
    measureNext.reset();
    if (std::ranges::any_of(measure, isGone)) view.clearMeasure();
}

void SceneView::Impl::drawMeasured(QPainter& painter, const ViewPane& pane) const {
    const auto placed = [&](const MeasurePoint& point) {
        const auto pose = model.placeOf(point.object);
        return pose ? std::optional(pose->apply(point.p_B)) : std::nullopt;
    };
    drawMeasure(painter, view.measured(), measureNext ? placed(*measureNext) : std::nullopt, pane.camera,
                theme(), coveredIn(pane));
}

std::vector<QRectF> SceneView::measuredBoxes() const {
    const ViewPane& pane = impl_->pane();
    std::vector<QRectF> boxes = measureBoxes(measured(), pane.camera, font(), impl_->coveredIn(pane));
    for (QRectF& box : boxes)
        box.translate(pane.place.topLeft());
    return boxes;
}

void SceneView::setCovered(const QRegion& covered) {
    if (impl_->covered == covered) return;
    impl_->covered = covered;
    changed();
}

std::vector<Vec3> SceneView::measured() const {
    std::vector<Vec3> places;
    for (const MeasurePoint& point : impl_->measure)
        if (const auto pose = impl_->model.placeOf(point.object)) places.push_back(pose->apply(point.p_B));
    return places;
}

void SceneView::clearMeasure() {
    if (impl_->measure.empty()) return;
    impl_->measure.clear();
    changed();
    emit measureChanged(false);
}

} // namespace tactum
