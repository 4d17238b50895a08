// What a file means that says neither its unit nor which axis is up.
#include "ui/window/main_window.h"

#include <QUndoStack>

#include "ui/panels/import_bar.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"

namespace tactum {

namespace {

/// In the order of kLengthUnits.
constexpr const char* kUnitCommands[] = {"taken-m", "taken-cm", "taken-mm", "taken-in"};
constexpr std::pair<const char*, bool> kUpCommands[] = {{"up-y", false}, {"up-z", true}};
static_assert(std::size(kUnitCommands) == std::size(kLengthUnits));

} // namespace

void MainWindow::connectImport() {
    connect(importBar_, &ImportBar::chosen, this, &MainWindow::takeOtherwise);
    connect(importBar_, &ImportBar::arranged, this, &MainWindow::keepFootFree);
    for (std::size_t i = 0; i < std::size(kUnitCommands); ++i)
        connect(&actions_[kUnitCommands[i]], &QAction::triggered, this, [this, i] {
            if (const auto shown = shownAxes()) takeOtherwise({kLengthUnits[i].metres, shown->zUp});
        });
    for (const auto& [id, zUp] : kUpCommands)
        connect(&actions_[id], &QAction::triggered, this, [this, up = zUp] {
            if (const auto shown = shownAxes()) takeOtherwise({shown->unit, up});
        });
    connect(importBar_, &ImportBar::closed, this, [this] {
        importSeen_ = true;
        showImport();
    });
    connect(&document_, &Document::opened, this, [this] {
        importSeen_ = false;
        endAsking();
    });
    connect(&document_, &Document::geometryUpdated, this, [this] {
        importSeen_ = false;
        endAsking();
    });
    connect(&document_, &Document::added, this, [this] {
        importSeen_ = false;
        endAsking();
    });
    connect(&document_, &Document::openFailed, this, &MainWindow::endAsking); // the choice is as before
    connect(&document_, &Document::editEnded, this, &MainWindow::endAsking);
    connect(&document_, &Document::saved, this, &MainWindow::showImport);
    // A trial is no step of the history, and not there yet when it is announced.
    connect(&document_, &Document::changed, this, &MainWindow::showImport, Qt::QueuedConnection);
    connect(&document_.history(), &QUndoStack::indexChanged, this, &MainWindow::showImport);
    connect(&document_.history(), &QUndoStack::cleanChanged, this, &MainWindow::showImport);
    connect(playback_, &Playback::begun, this, &MainWindow::showImport);
    connect(playback_, &Playback::ended, this, &MainWindow::showImport);
}

/// As what the file was taken, or is about to be.
std::optional<FileAxes> MainWindow::shownAxes() const {
    const TakenAs* taken = document_.takenAs();
    return taken ? std::optional(asked_.value_or(taken->axes)) : std::nullopt;
}

void MainWindow::takeOtherwise(const FileAxes& axes) {
    const auto shown = shownAxes();
    if (!shown || axes == *shown) return showImport(); // a command that holds already stays ticked
    const std::filesystem::path file = document_.takenFile();
    const FileAxes guess = document_.takenAs()->guess;
    if (axes.unit != shown->unit) rememberUnit(file, axes.unit, guess.unit);
    if (axes.zUp != shown->zUp) rememberUp(file, axes.zUp, guess.zUp);
    asked_ = axes;
    notice_->takeBack(fittedNote_); // its size is another one soon
    document_.takeOtherwise({axes.unit, axes.zUp});
    showImport();
}

void MainWindow::endAsking() {
    asked_.reset();
    showImport();
}

/// Offered only while there is nothing to lose: to open a file again begins a new history, and an update ends
/// what could be done again.
void MainWindow::showImport() {
    const TakenAs* offered = importSeen_ || playback_->active() ? nullptr : document_.takenAs();
    showImportCommands(offered);
    if (offered) {
        TakenAs taken = *offered;
        if (asked_) {
            taken.axes = *asked_;
            taken.by = TakenAs::By::Choice;
        }
        importBar_->display(QString::fromStdU16String(document_.takenFile().filename().u16string()), taken,
                            asked_ ? std::nullopt : std::optional(document_.takenAcross()));
    } else
        importBar_->hide();
    keepFootFree();
}

/// What the view says at its lower edge stays above the bars that lie there.
void MainWindow::keepFootFree() {
    const auto heightOf = [](const QWidget& bar) { return bar.isHidden() ? 0 : bar.sizeHint().height(); };
    hint_->keepAbove(heightOf(*importBar_) + heightOf(*playbackBar_));
    view_->setFoot(heightOf(*playbackBar_));
}

void MainWindow::showImportCommands(const TakenAs* taken) {
    const auto shown = shownAxes();
    for (std::size_t i = 0; i < std::size(kUnitCommands); ++i) {
        actions_[kUnitCommands[i]].setEnabled(taken && taken->unitOpen);
        actions_[kUnitCommands[i]].setChecked(shown && shown->unit == kLengthUnits[i].metres);
    }
    for (const auto& [id, zUp] : kUpCommands) {
        actions_[id].setEnabled(taken && taken->upOpen);
        actions_[id].setChecked(shown && shown->zUp == zUp);
    }
}

} // namespace tactum
