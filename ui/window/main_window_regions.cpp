// Selecting by drawing over the view: box, lasso and brush as commands.
#include "ui/window/main_window.h"

#include "ui/showing/playback.h"
#include "ui/tools/region_select.h"
#include "ui/tools/select_tool.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr double kLargerBrush = 1.15;

} // namespace

void MainWindow::connectRegions() {
    QAction& brush = actions_["select-brush"];
    for (const auto& [id, shape] :
         {std::pair("box", RegionShape::Box), std::pair("lasso", RegionShape::Lasso)})
        connect(&actions_[id], &QAction::triggered, this, [this, shape = shape] {
            actions_["select"].trigger();
            view_->beginRegion(shape);
        });
    const auto showBrush = [this, &brush] {
        view_->setSelectBrush(brush.isChecked() ? std::optional(regions_->brushRadius()) : std::nullopt);
    };
    connect(&brush, &QAction::toggled, this, [this, showBrush](bool on) {
        if (on) actions_["select"].trigger();
        showBrush();
    });
    connect(view_, &SceneView::selectBrushLeft, &brush, [&brush] { brush.setChecked(false); });
    connect(&actions_["select"], &QAction::toggled, &brush, [&brush](bool on) {
        if (!on) brush.setChecked(false);
    });
    for (const auto& [id, factor] :
         {std::pair("brush-bigger", kLargerBrush), std::pair("brush-smaller", 1 / kLargerBrush)})
        connect(&actions_[id], &QAction::triggered, this, [this, showBrush, factor = factor] {
            if (!actions_["select"].isChecked()) return;
            regions_->scaleBrush(factor);
            showBrush();
        });
    actions_["through"].setChecked(true);
    connect(&actions_["through"], &QAction::toggled, regions_, &RegionSelect::setThrough);
    // A recording shows surfaces of another scene.
    connect(view_, &SceneView::boxDrawn, this, [this](const QRectF& box, auto modifiers) {
        if (!playback_->active()) regions_->takeBox(box, selectModeOf(modifiers));
    });
    connect(view_, &SceneView::lassoDrawn, this, [this](const QPolygonF& line, auto modifiers) {
        if (!playback_->active()) regions_->takeLasso(line, selectModeOf(modifiers));
    });
    connect(view_, &SceneView::selectBrushed, this,
            [this](StrokeStep step, QPointF from, QPointF to, auto modifiers) {
                if (!playback_->active()) regions_->brush(step, from, to, selectModeOf(modifiers));
            });
    connect(regions_, &RegionSelect::progressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Looking which triangles lie there"), fraction, secondsLeft, false);
    });
    connect(regions_, &RegionSelect::finished, notice_, &NoticeBar::endProgress);
}

} // namespace tactum
