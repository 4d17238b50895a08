#include "ui/controllers/plot_controller.h"

#include "ui/base/ask_where.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

PlotController::PlotController(const Workbench& bench, ForcePlot& plot)
    : QObject(&bench.window), bench_(bench), plot_(plot) {
    bench.on("export-plot", this, [this] { exportPlot(); });
    connect(&plot, &ForcePlot::exportRequested, this, &PlotController::exportPlot);
}

void PlotController::exportPlot() {
    const QString file = askWhere(&bench_.window, tr("Export the plot"),
                                  {{tr("Numbers"), QStringLiteral("csv")},
                                   {tr("Pictures"), QStringLiteral("png")},
                                   {tr("Drawings"), QStringLiteral("svg")}},
                                  QStringLiteral("touch.csv"));
    if (file.isEmpty()) return;
    const auto written = plot_.exportTo(file);
    if (written)
        bench_.notice.showNote(tr("The plot was written to %1.").arg(file));
    else
        bench_.notice.showError(QString::fromStdString(written.error().text));
}

} // namespace tactum
