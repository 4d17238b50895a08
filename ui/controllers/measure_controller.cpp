#include "ui/controllers/measure_controller.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>

#include "ui/document/document.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

MeasureController::MeasureController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), strip_(new ToolStrip) {
    fillStrip();
    bench.on("measure-copy", this, [this] { copy(); });
    bench.on("measure-clear", this, [this] { bench_.view.clearMeasure(); });
    for (const char* id : {"touch", "select", "paint", "arrange"})
        connect(&bench_.actions[id], &QAction::toggled, this, [this, id](bool on) {
            if (on) toolBefore_ = id;
        });
    connect(&bench_.actions["measure"], &QAction::toggled, this, [this] { show(); });
    connect(&bench_.view, &SceneView::measureChanged, this, [this](bool left) {
        if (left) bench_.actions[toolBefore_].trigger();
        show();
    });
    connect(&bench_.document, &Document::changed, this, [this](const SceneChange& change) {
        if (change.what == SceneChange::What::Everything) bench_.view.clearMeasure();
    });
    show();
}

void MeasureController::fillStrip() {
    strip_->setObjectName(QStringLiteral("measure-strip"));
    strip_->addLabel(tr("Two clicks: distance; a third: angle at the second"));
    strip_->addAction(&bench_.actions["measure-copy"], tr("Copy"));
    strip_->addAction(&bench_.actions["measure-clear"], tr("Clear"));
    bench_.strips().addWidget(strip_, 0, Qt::AlignLeft);
}

void MeasureController::copy() {
    const auto numbers = numbersOf(bench_.view.measured());
    if (!numbers) return;
    QGuiApplication::clipboard()->setText(measuredLines(*numbers));
    bench_.notice.showNote(tr("The measure is on the clipboard."));
}

void MeasureController::show() {
    const std::size_t points = bench_.view.measured().size();
    strip_->setVisible(points > 0 || bench_.actions["measure"].isChecked());
    bench_.actions["measure-copy"].setEnabled(points > 1);
    bench_.actions["measure-clear"].setEnabled(points > 0);
}

} // namespace tactum
