#include "ui/controllers/room_controller.h"

#include <utility>

#include <QDockWidget>
#include <QSettings>
#include <QShortcut>

#include "core/runtime/engine.h"
#include "ui/controllers/dock_widths.h"
#include "ui/controllers/folds.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"

namespace tactum {

namespace {

const QString kGeometryKey = QStringLiteral("window/geometry"), kStateKey = QStringLiteral("window/state"),
              kFoldedKey = QStringLiteral("window/folded"), kWidthsKey = QStringLiteral("window/widths");

} // namespace

RoomController::RoomController(const Workbench& bench, Folds& folds)
    : QObject(&bench.window), bench_(bench), folds_(folds), widths_(*new DockWidths(bench.window)) {
    QAction& panels = bench.actions["panels"];
    connect(&panels, &QAction::toggled, this, &RoomController::hidePanels);
    // Only while the view has the focus: elsewhere Tab moves on, as everybody expects of it.
    auto* tab = new QShortcut(Qt::Key_Tab, &bench.view, nullptr, nullptr, Qt::WidgetShortcut);
    connect(tab, &QShortcut::activated, &panels, &QAction::toggle);
    connectFold("fold-plots", "dock-plot");
    connectFold("fold-lists", "dock-presets");
    connect(&folds, &Folds::decided, this, [this] { plots_ = Plots::AsDecided; });
    connect(&bench.view, &SceneView::handGrabbed, this, [this](bool grabbed) { grabbed_ = grabbed; });
    connect(&bench.playback, &Playback::begun, this, [this] {
        if (plots_ == Plots::Empty) plots_ = Plots::Due;
    });
}

void RoomController::connectFold(const char* command, const char* name) {
    QAction& action = bench_.actions[command];
    QDockWidget& dock = bench_.dock(name);
    bench_.on(command, this, [this, &dock](bool folded) {
        plots_ = Plots::AsDecided;
        folds_.setFolded(dock, folded);
    });
    connect(&folds_, &Folds::changed, &action,
            [this, &action, &dock] { action.setChecked(folds_.isFolded(dock)); });
}

/// The plots of a person who never decided it are folded until there is something in them.
void RoomController::restore() {
    const QSettings settings;
    bench_.window.restoreGeometry(settings.value(kGeometryKey).toByteArray());
    bench_.window.restoreState(settings.value(kStateKey).toByteArray());
    widths_.restore(settings.value(kWidthsKey).toList());
    plots_ = settings.contains(kFoldedKey) ? Plots::AsDecided : Plots::Empty;
    folds_.restore(plots_ == Plots::AsDecided ? settings.value(kFoldedKey).toStringList()
                                              : QStringList{QStringLiteral("dock-plot")});
}

void RoomController::save() const {
    QSettings settings;
    settings.setValue(kGeometryKey, bench_.window.saveGeometry());
    settings.setValue(kStateKey, hidesPanels() ? shownPanels_ : bench_.window.saveState());
    settings.setValue(kWidthsKey, widths_.widths());
    if (plots_ == Plots::AsDecided)
        settings.setValue(kFoldedKey, hidesPanels() ? foldedPanels_ : folds_.names());
}

/// Shows the plots once something was felt; not while something is held or touched: the model would move
/// under the finger; nor while a video is recorded, which would go on in another size.
void RoomController::frame() {
    const bool touches = bench_.engine.proxy().output.contacts > 0;
    if (plots_ == Plots::Empty && touches) plots_ = Plots::Due;
    const bool busy = grabbed_ || touches || bench_.actions["record-video"].isChecked();
    if (plots_ != Plots::Due || busy || hidesPanels()) return;
    plots_ = Plots::Shown;
    folds_.setFolded(bench_.dock("dock-plot"), false);
}

void RoomController::clearForStart() {
    QAction& panels = bench_.actions["panels"];
    clearedForStart_ = !panels.isChecked();
    panels.setChecked(true);
}

void RoomController::leaveStart() {
    if (std::exchange(clearedForStart_, false)) bench_.actions["panels"].setChecked(false);
}

void RoomController::hidePanels(bool hidden) {
    if (hidden) {
        shownPanels_ = bench_.window.saveState();
        foldedPanels_ = folds_.names();
        for (auto* dock : bench_.window.findChildren<QDockWidget*>())
            dock->hide();
    } else if (hidesPanels()) {
        QList<QDockWidget*> wanted; // in the meantime
        for (auto* dock : bench_.window.findChildren<QDockWidget*>())
            if (dock->isVisible()) wanted << dock;
        bench_.window.restoreState(shownPanels_);
        folds_.restore(foldedPanels_);
        shownPanels_.clear();
        for (auto* dock : wanted)
            folds_.bringForward(*dock);
    }
}

} // namespace tactum
