// The room of the view: which panels stand around it, folded or not.
#include <QDockWidget>
#include <QSettings>

#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/window/folds.h"
#include "ui/window/main_window.h"

namespace tactum {

namespace {

QString foldedKey() {
    return QStringLiteral("window/folded");
}

} // namespace

void MainWindow::connectFolds() {
    const auto connectTo = [this](const char* id, const char* name) {
        auto* dock = findChild<QDockWidget*>(QString::fromLatin1(name));
        QAction& action = actions_[id];
        connect(&action, &QAction::triggered, this, [this, dock](bool folded) {
            plots_ = Plots::AsDecided;
            folds_->setFolded(*dock, folded);
        });
        connect(folds_, &Folds::changed, &action,
                [this, &action, dock] { action.setChecked(folds_->isFolded(*dock)); });
    };
    connectTo("fold-plots", "dock-plot");
    connectTo("fold-lists", "dock-presets");
    connect(folds_, &Folds::decided, this, [this] { plots_ = Plots::AsDecided; });
    connect(view_, &SceneView::handGrabbed, this, [this](bool grabbed) { grabbed_ = grabbed; });
}

/// As they were left; the plots of a person who never decided it are folded until there is something in them.
void MainWindow::restoreFolds() {
    const QSettings settings;
    plots_ = settings.contains(foldedKey()) ? Plots::AsDecided : Plots::Empty;
    folds_->restore(plots_ == Plots::AsDecided ? settings.value(foldedKey()).toStringList()
                                               : QStringList{QStringLiteral("dock-plot")});
}

void MainWindow::saveFolds() const {
    if (plots_ == Plots::AsDecided)
        QSettings().setValue(foldedKey(), shownPanels_.isEmpty() ? folds_->names() : foldedPanels_);
}

/// Once a frame. Not while something is held or touched: the model would move under the finger.
void MainWindow::showPlots() {
    const bool touches = engine_.proxy().output.contacts > 0;
    if (plots_ == Plots::Empty && touches) plots_ = Plots::Due;
    if (plots_ != Plots::Due || grabbed_ || touches || !shownPanels_.isEmpty()) return;
    plots_ = Plots::Shown;
    folds_->setFolded(*findChild<QDockWidget*>(QStringLiteral("dock-plot")), false);
}

void MainWindow::hidePanels(bool hidden) {
    if (hidden) {
        shownPanels_ = saveState();
        foldedPanels_ = folds_->names();
        for (auto* dock : findChildren<QDockWidget*>())
            dock->hide();
    } else if (!shownPanels_.isEmpty()) {
        restoreState(shownPanels_);
        folds_->restore(foldedPanels_);
        shownPanels_.clear();
    }
}

} // namespace tactum
