#include "ui/view/path_gizmo.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

namespace tactum {
namespace {

constexpr double kPathStep = 5e-3; // m
/// Pixels between two dots, and around the cursor where all are drawn.
constexpr double kApart = 30, kAbout = 60;

Vec3 pointOf(const PathMark& mark, int handle) {
    const int count = int(mark.points.size());
    if (handle < count) return mark.points[std::size_t(handle)];
    const int before = handle - count;
    return 0.5 * (mark.points[std::size_t(before)] + mark.points[std::size_t((before + 1) % count)]);
}

} // namespace

int PathGizmo::handles(const PathMark& mark) const {
    const int count = int(mark.points.size());
    return count < 2 ? count : 2 * count - (mark.closed ? 0 : 1);
}

std::optional<QPointF> PathGizmo::placeOf(int handle, const ViewCamera& camera) const {
    if (!shown_ || handle < 0 || handle >= handles(*shown_)) return std::nullopt;
    return camera.project(pointOf(*shown_, handle));
}

PathGizmo::Shapes PathGizmo::shapes(const ViewCamera& camera) const {
    Shapes all;
    for (int i = 0; i < handles(*shown_); ++i)
        all.push_back({i, {placeOf(i, camera), {}, {}}});
    return all;
}

std::vector<Vec3> PathGizmo::dragged(QPointF cursor, const ViewCamera& camera, bool snapped) const {
    if (!held_) return shown_ ? shown_->points : std::vector<Vec3>();
    std::vector<Vec3> points = held_->value.points;
    const int count = int(points.size());
    const Vec3 from = pointOf(held_->value, held_->handle);
    Vec3 way = camera.dragVector(from, cursor - held_->from);
    if (snapped) way = way.unaryExpr([](double x) { return kPathStep * std::round(x / kPathStep); });
    if (held_->handle < count)
        points[std::size_t(held_->handle)] = from + way;
    else
        points.insert(points.begin() + (held_->handle - count + 1), from + way);
    return points;
}

std::vector<int> PathGizmo::drawn(const ViewCamera& camera, QPointF cursor) const {
    std::vector<int> all;
    std::vector<QPointF> apart;
    if (!shown_) return all;
    for (int i = 0; i < handles(*shown_); ++i) {
        const auto dot = placeOf(i, camera);
        if (!dot) continue;
        const bool isApart =
            std::ranges::none_of(apart, [&](QPointF other) { return lengthOf(*dot - other) < kApart; });
        if (isApart) apart.push_back(*dot);
        const bool isHeld = held_ && held_->handle == i;
        if (isApart || isHeld || lengthOf(*dot - cursor) < kAbout) all.push_back(i);
    }
    return all;
}

void PathGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const {
    if (!shown_) return;
    const auto under = lit(cursor, camera);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.accent, 2));
    painter.drawPolyline(onScreen(shown_->curve, camera));
    for (const int handle : drawn(camera, cursor)) {
        const QPointF dot = *placeOf(handle, camera);
        const bool there = handle < int(shown_->points.size());
        const QColor colour = under == handle ? theme.accent : theme.text;
        painter.setBrush(there ? QBrush(colour) : QBrush(Qt::NoBrush));
        painter.setPen(QPen(there ? theme.label : colour, there ? 1 : 1.4));
        painter.drawEllipse(dot, there ? 5.0 : 3.5, there ? 5.0 : 3.5);
    }
    painter.restore();
}

} // namespace tactum
