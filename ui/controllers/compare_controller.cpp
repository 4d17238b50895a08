#include "ui/controllers/compare_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QStandardPaths>

#include "core/base/atomic_file.h"
#include "ui/base/ask_where.h"
#include "ui/controllers/docks.h"
#include "ui/engine/comparison.h"
#include "ui/panels/compare_panel.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {
constexpr double kLastStroke = 10; // s
}

CompareController::CompareController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench),
      comparison_(new Comparison(bench.document, bench.engine, bench.publisher, this)) {
    addDock();
    bench.on("record-stroke", this, [this](bool begins) {
        if (begins)
            comparison_->beginStroke();
        else
            comparison_->endStroke();
    });
    bench.on("take-stroke", this, [this] { comparison_->takeLast(kLastStroke); });
    bench.on("mark-a", this, [this] { comparison_->markA(); });
    bench.on("swap-ab", this, [this] { comparison_->swap(); });
    bench.on("compare-now", this, [this] { comparison_->compare(); });
    bench.on("compare-auto", this, [this](bool automatic) { comparison_->setAutomatic(automatic); });
    bench.on("compare-csv", this, [this] { exportBoth(); });
    connect(comparison_, &Comparison::failed, &bench_.notice, &NoticeBar::showError);
    connect(comparison_, &Comparison::changed, this, &CompareController::showCommands);
    showCommands();
}

void CompareController::addDock() {
    auto* panel = new ComparePanel(*comparison_);
    addTabBeside(bench_.window, bench_.dock("dock-health"), QStringLiteral("dock-compare"), tr("Compare"),
                 panel);
    connect(panel, &ComparePanel::exportAsked, this, &CompareController::exportBoth);
}

void CompareController::showCommands() {
    bench_.actions["record-stroke"].setChecked(comparison_->recording());
    bench_.actions["compare-auto"].setChecked(comparison_->automatic());
    bench_.actions["swap-ab"].setEnabled(comparison_->hasA());
    bench_.actions["compare-now"].setEnabled(comparison_->hasA() && !comparison_->stroke().empty());
    bench_.actions["compare-csv"].setEnabled(comparison_->result().has_value());
}

void CompareController::exportBoth() {
    const auto result = comparison_->result(); // as it is now, whatever is edited while the dialog is open
    if (!result) return;
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString file =
        askWhere(&bench_.window, tr("Export both touches"), {{tr("Tables"), QStringLiteral("csv")}},
                 folder + QStringLiteral("/comparison.csv"));
    if (file.isEmpty()) return;
    const std::filesystem::path path(file.toStdU16String());
    const auto written = writeFileAtomically(path, differenceCsv(*result->a, *result->b), 0);
    if (written)
        bench_.notice.showNote(tr("Both touches were written to %1.").arg(file));
    else
        bench_.notice.showError(QString::fromStdString(written.error().text));
}

} // namespace tactum
