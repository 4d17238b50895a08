// Comparing a stroke over two states of the scene: its dock, its commands, its file.
#include <QAction>
#include <QDockWidget>
#include <QStandardPaths>

#include "core/base/atomic_file.h"
#include "ui/ask_where.h"
#include "ui/comparison.h"
#include "ui/main_window.h"
#include "ui/panels/compare_panel.h"
#include "ui/panels/notice_bar.h"

namespace tactum {

namespace {
constexpr double kLastStroke = 10; // s
}

void MainWindow::addCompareDock() {
    auto* panel = new ComparePanel(*comparison_);
    addTabBeside(*this, *findChild<QDockWidget*>(QStringLiteral("dock-health")),
                 QStringLiteral("dock-compare"), tr("Compare"), panel);
    connect(panel, &ComparePanel::exportAsked, this, &MainWindow::exportComparison);
}

void MainWindow::connectCompare() {
    const auto on = [this](const char* id, auto act) {
        connect(&actions_[id], &QAction::triggered, this, act);
    };
    on("record-stroke", [this](bool begins) {
        if (begins)
            comparison_->beginStroke();
        else
            comparison_->endStroke();
    });
    on("take-stroke", [this] { comparison_->takeLast(kLastStroke); });
    on("mark-a", [this] { comparison_->markA(); });
    on("swap-ab", [this] { comparison_->swap(); });
    on("compare-now", [this] { comparison_->compare(); });
    on("compare-auto", [this](bool automatic) { comparison_->setAutomatic(automatic); });
    on("compare-csv", [this] { exportComparison(); });
    connect(comparison_, &Comparison::failed, notice_, &NoticeBar::showError);
    connect(comparison_, &Comparison::changed, this, &MainWindow::followComparison);
    followComparison();
}

void MainWindow::followComparison() {
    actions_["record-stroke"].setChecked(comparison_->recording());
    actions_["compare-auto"].setChecked(comparison_->automatic());
    actions_["swap-ab"].setEnabled(comparison_->hasA());
    actions_["compare-now"].setEnabled(comparison_->hasA() && !comparison_->stroke().empty());
    actions_["compare-csv"].setEnabled(comparison_->result().has_value());
}

void MainWindow::exportComparison() {
    const auto result = comparison_->result(); // as it is now, whatever is edited while the dialog is open
    if (!result) return;
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString file = askWhere(this, tr("Export both touches"), {{tr("Tables"), QStringLiteral("csv")}},
                                  folder + QStringLiteral("/comparison.csv"));
    if (file.isEmpty()) return;
    const std::filesystem::path path(file.toStdU16String());
    const auto written = writeFileAtomically(path, differenceCsv(*result->a, *result->b), 0);
    if (written)
        notice_->showNote(tr("Both touches were written to %1.").arg(file));
    else
        notice_->showError(QString::fromStdString(written.error().text));
}

} // namespace tactum
