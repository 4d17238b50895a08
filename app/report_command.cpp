#include <QGuiApplication>

#include "app/commands.h"
#include "app/picture.h"
#include "app/streams.h"
#include "app/terminal_progress.h"
#include "core/archive/sha256.h"
#include "core/files/source.h"
#include "ui/document/preset_store.h"
#include "ui/showing/report_file.h"

namespace tactum {

Result<int> runReport(const ReportOptions& options) {
    const auto loaded = importGiven(options.scene, options.axes);
    if (!loaded) return tl::unexpected(loaded.error());
    qputenv("QT_QPA_PLATFORM", "offscreen"); // letters and pages need no display
    int argc = 1;
    char name[] = "tactum";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Tactum")); // where the person's own presets are
    QCoreApplication::setApplicationName(QStringLiteral("Tactum"));
    const std::vector<Preset> presets = PresetStore::readAll();
    const ReportSubject subject{.scene = loaded->scene,
                                .name = shownPath(options.scene.filename()),
                                .fingerprint = fingerprintOf(options.scene),
                                .version = TACTUM_VERSION,
                                .date = reportDate(),
                                .found = loaded->findings,
                                .presets = presets};
    const TerminalProgress terminal("writing " + shownPath(options.out));
    const auto written = writeReportFile(subject, options.out, terminal.progress());
    if (!written) return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
