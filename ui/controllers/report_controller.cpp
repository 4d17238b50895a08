#include "ui/controllers/report_controller.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>

#include "core/archive/sha256.h"
#include "ui/base/ask_where.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"
#include "ui/document/preset_store.h"
#include "ui/document/recent_files.h"
#include "ui/engine/guard_watch.h"
#include "ui/showing/report_file.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

ReportController::ReportController(const Workbench& bench, const GuardWatch& guard,
                                   const QStringList& samples)
    : QObject(&bench.window), bench_(bench), guard_(guard), samples_(samples) {
    bench.on("export-report", this, [this] { ask(); });
}

void ReportController::ask() {
    const QString file =
        askWhere(&bench_.window, tr("Export a report"),
                 {{tr("Pages"), QStringLiteral("html")}, {tr("Printed pages"), QStringLiteral("pdf")}},
                 placeToSave(bench_.document.path(), samples_));
    if (!file.isEmpty()) write(file);
}

namespace {
/// As a page shows it sharply.
ReportPicture pictureOf(const QImage& picture) {
    constexpr int kWidest = 1280;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    const QImage fits =
        picture.width() > kWidest ? picture.scaledToWidth(kWidest, Qt::SmoothTransformation) : picture;
    fits.save(&buffer, "PNG");
    return {bytes.toStdString(), fits.width(), fits.height()};
}
} // namespace

/// Of the scene as it is and is seen now, on a worker.
void ReportController::write(const QString& file) {
    const bool saved = !bench_.document.modified() && !bench_.document.path().empty();
    const DeviceInfo& info = bench_.engine.device();
    const ReportDevice device{info.name, info.maxForce, info.maxStiffness, guard_.ceiling().value};
    auto* job = new BackgroundJob(this);
    connect(job, &BackgroundJob::progressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Writing the report"), fraction, secondsLeft, true);
    });
    connect(&bench_.notice, &NoticeBar::cancelled, job, &BackgroundJob::cancel);
    connect(job, &BackgroundJob::finished, job, &QObject::deleteLater);
    job->start([this, file, device, scene = std::make_shared<const Scene>(bench_.document.scene()),
                title = bench_.document.title().toStdString(), found = bench_.document.findings(),
                source = saved ? bench_.document.path() : std::filesystem::path(),
                seen = pictureOf(bench_.view.grabWithoutHandles()),
                version = QCoreApplication::applicationVersion().toStdString()](const Progress& progress) {
        const std::vector<Preset> presets = PresetStore::readAll();
        const ReportSubject subject{
            *scene, title, fingerprintOf(source), version, reportDate(), found, presets, device, seen};
        const auto written = writeReportFile(subject, file.toStdU16String(), progress);
        return BackgroundJob::Delivery([this, file, written] {
            bench_.notice.endProgress();
            if (written)
                bench_.notice.showNote(tr("The report was written to %1.").arg(file));
            else
                bench_.notice.showError(QString::fromStdString(written.error().text));
        });
    });
}

} // namespace tactum
