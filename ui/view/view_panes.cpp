#include "ui/view/view_panes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/view_stage.h"

namespace tactum {

namespace {

constexpr double kLeastPart = 0.1;
constexpr int kLeastSide = 40; ///< of a pane, logical pixels, where there is room
constexpr double kNearLine = 4;
constexpr double kQuarter = 0.5 * std::numbers::pi;

/// Where the second of two panes begins.
int cut(int length, double part, bool divided) {
    if (!divided) return length + ViewPanes::kGap;
    const int least = std::min(kLeastSide, (length - ViewPanes::kGap) / 2);
    const int first = std::clamp(int(std::lround(part * length)) - ViewPanes::kGap / 2, least,
                                 length - ViewPanes::kGap - least);
    return first + ViewPanes::kGap;
}

std::vector<std::size_t> panesOf(ViewSplit split) {
    switch (split) {
    case ViewSplit::One:
        return {ViewPanes::kOwn};
    case ViewSplit::Columns:
    case ViewSplit::Rows:
        return {ViewPanes::kOwn, ViewPanes::kRight};
    case ViewSplit::Four:
        break;
    }
    return {ViewPanes::kTop, ViewPanes::kOwn, ViewPanes::kFront, ViewPanes::kRight};
}

bool hasColumns(ViewSplit split) {
    return split == ViewSplit::Columns || split == ViewSplit::Four;
}

bool hasRows(ViewSplit split) {
    return split == ViewSplit::Rows || split == ViewSplit::Four;
}

double fromRect(const QRect& rect, QPointF p) {
    return std::hypot(std::max({rect.left() - p.x(), p.x() - rect.right(), 0.0}),
                      std::max({rect.top() - p.y(), p.y() - rect.bottom(), 0.0}));
}

} // namespace

ViewCamera ViewPanes::planned(std::size_t number) {
    ViewCamera camera = defaultCamera();
    if (number == kOwn) return camera;
    camera.parallel = true;
    camera.yaw = number == kRight ? kQuarter : 0;
    camera.pitch = number == kTop ? kQuarter : 0;
    return camera;
}

ViewPanes::ViewPanes() {
    plan();
}

void ViewPanes::plan() {
    for (std::size_t i = 0; i < kCount; ++i) {
        ViewPane& pane = panes_[i];
        const QSizeF size = pane.camera.size;
        pane.camera = planned(i);
        pane.camera.size = size;
        pane.fitted = false;
    }
    panes_[kOwn].camera.parallel = ownParallel_;
}

void ViewPanes::setSplit(ViewSplit split) {
    split_ = split;
    shown_ = panesOf(split);
    for (std::size_t* number : {&active_, &used_})
        if (std::ranges::find(shown_, *number) == shown_.end()) *number = kOwn;
    layOut(view_);
}

void ViewPanes::setDivision(QPointF parts) {
    division_ = {std::clamp(parts.x(), kLeastPart, 1 - kLeastPart),
                 std::clamp(parts.y(), kLeastPart, 1 - kLeastPart)};
    layOut(view_);
}

void ViewPanes::layOut(QSize view) {
    view_ = view;
    const int right = cut(view.width(), division_.x(), hasColumns(split_));
    const int below = cut(view.height(), division_.y(), hasRows(split_));
    const int columns = hasColumns(split_) ? 2 : 1;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const bool isRight = int(i) % columns == 1, isBelow = int(i) / columns == 1;
        const QPoint from(isRight ? right : 0, isBelow ? below : 0);
        const QPoint to(isRight ? view.width() : right - kGap, isBelow ? view.height() : below - kGap);
        ViewPane& pane = panes_[shown_[i]];
        pane.place = QRect(from, QSize(to.x() - from.x(), to.y() - from.y()));
        resize(pane);
    }
}

void ViewPanes::resize(ViewPane& pane) const {
    if (pane.camera.size == pane.place.size()) return;
    const double part = pane.camera.filled(spanning_);
    pane.camera.size = pane.place.size();
    if (pane.fitted && part > 0 && std::isfinite(part)) pane.camera.fill(spanning_, part);
}

void ViewPanes::setParallel(std::size_t number, bool parallel) {
    ViewCamera& camera = panes_[number].camera;
    const double part = camera.filled(spanning_);
    camera.parallel = parallel;
    if (panes_[number].fitted && part > 0 && part <= 1) camera.fill(spanning_, part);
    if (number == kOwn) ownParallel_ = parallel;
}

std::size_t ViewPanes::at(QPointF place) const {
    return *std::ranges::min_element(
        shown_, {}, [&](std::size_t number) { return fromRect(panes_[number].place, place); });
}

bool ViewPanes::pointAt(QPointF place) {
    const std::size_t number = at(place);
    return std::exchange(active_, number) != number;
}

bool ViewPanes::pointNowhere() {
    return std::exchange(active_, used_) != used_;
}

Qt::Orientations ViewPanes::linesAt(QPointF place) const {
    const QRect& first = panes_[shown_.front()].place;
    const auto isNear = [](double at, int end) { return std::abs(at - end - 0.5 * kGap) <= kNearLine; };
    Qt::Orientations lines;
    if (hasColumns(split_) && isNear(place.x(), first.x() + first.width())) lines |= Qt::Vertical;
    if (hasRows(split_) && isNear(place.y(), first.y() + first.height())) lines |= Qt::Horizontal;
    return lines;
}

void ViewPanes::lead(Qt::Orientations lines, QPointF place) {
    QPointF parts = division_;
    if (lines & Qt::Vertical) parts.setX(place.x() / std::max(1, view_.width()));
    if (lines & Qt::Horizontal) parts.setY(place.y() / std::max(1, view_.height()));
    setDivision(parts);
}

void ViewPanes::even(Qt::Orientations lines) {
    lead(lines, QPointF(0.5 * view_.width(), 0.5 * view_.height()));
}

} // namespace tactum
