// What a file means that says neither its unit nor which axis is up.
#include "ui/main_window.h"

#include <QUndoStack>

#include "ui/panels/import_bar.h"
#include "ui/playback.h"
#include "ui/touch_hint.h"

namespace tactum {

void MainWindow::connectImport() {
    connect(importBar_, &ImportBar::unitChosen, this, [this](double unit) {
        const TakenAs taken = *document_.takenAs();
        rememberUnit(document_.path(), unit, taken.guess.unit);
        document_.reopen({unit, taken.axes.zUp});
    });
    connect(importBar_, &ImportBar::upChosen, this, [this](bool zUp) {
        const TakenAs taken = *document_.takenAs();
        rememberUp(document_.path(), zUp, taken.guess.zUp);
        document_.reopen({taken.axes.unit, zUp});
    });
    connect(importBar_, &ImportBar::closed, this, [this] {
        importSeen_ = true;
        showImport();
    });
    connect(&document_, &Document::opened, this, [this] {
        importSeen_ = false;
        showImport();
    });
    connect(&document_, &Document::openFailed, this, &MainWindow::showImport); // the choice is as before
    connect(&document_, &Document::saved, this, &MainWindow::showImport);
    // A trial is no step of the history, and not there yet when it is announced.
    connect(&document_, &Document::changed, this, &MainWindow::showImport, Qt::QueuedConnection);
    connect(&document_.history(), &QUndoStack::indexChanged, this, &MainWindow::showImport);
    connect(&document_.history(), &QUndoStack::cleanChanged, this, &MainWindow::showImport);
    connect(playback_, &Playback::begun, this, &MainWindow::showImport);
    connect(playback_, &Playback::ended, this, &MainWindow::showImport);
}

/// To open a file again begins a new history, so that it is offered only while there is nothing to lose.
void MainWindow::showImport() {
    const auto& taken = document_.takenAs();
    if (taken && !importSeen_ && !document_.modified() && !playback_->active())
        importBar_->display(QString::fromStdU16String(document_.path().filename().u16string()), *taken,
                            boundsOf(document_.scene()).diagonal());
    else
        importBar_->hide();
    hint_->keepAbove(importBar_->isHidden() ? 0 : importBar_->sizeHint().height());
}

} // namespace tactum
