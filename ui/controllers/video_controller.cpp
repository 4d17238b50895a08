#include "ui/controllers/video_controller.h"

#include <QActionGroup>
#include <QSettings>

#include "ui/base/ask_where.h"
#include "ui/base/numbers.h"
#include "ui/showing/video_recorder.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

struct VideoSize {
    const char* id;
    QSize size; ///< an invalid one: that of the view
};
constexpr VideoSize kVideoSizes[] = {
    {"video-view", {}}, {"video-720", {1280, 720}}, {"video-1080", {1920, 1080}}};

const QString kSizeKey = QStringLiteral("video/size"), kPlotKey = QStringLiteral("video/plot");

} // namespace

VideoController::VideoController(const Workbench& bench, ForcePlot& plot)
    : QObject(&bench.window), bench_(bench), video_(*new VideoRecorder(bench.view, plot, this)) {
    const QSettings settings;
    auto* sizes = new QActionGroup(this);
    const QString chosen = settings.value(kSizeKey, QLatin1String(kVideoSizes[0].id)).toString();
    bench_.actions[kVideoSizes[0].id].setChecked(true);
    for (const VideoSize& each : kVideoSizes) {
        QAction& action = bench_.actions[each.id];
        sizes->addAction(&action);
        if (chosen == QLatin1String(each.id)) action.setChecked(true);
        connect(&action, &QAction::triggered, this,
                [id = each.id] { QSettings().setValue(kSizeKey, QLatin1String(id)); });
    }
    bench_.actions["video-plot"].setChecked(settings.value(kPlotKey).toBool());
    connect(&bench_.actions["video-plot"], &QAction::toggled, this,
            [](bool on) { QSettings().setValue(kPlotKey, on); });
    connect(&bench_.actions["record-video"], &QAction::triggered, this, &VideoController::recordVideo);
    connect(&video_, &VideoRecorder::failed, this, [this](const QString& sentence) {
        bench_.actions["record-video"].setChecked(false);
        bench_.notice.showError(sentence);
    });
    connect(&video_, &VideoRecorder::ended, this, [this](const QString& file, double seconds, int refused) {
        const QString all = tr("The video was written to %1: %2 s.").arg(file, numberText(seconds, 1));
        bench_.notice.showNote(
            refused == 0 ? all
                         : all + u' ' +
                               tr("%n picture(s) were left out, for the encoder could not follow; a smaller "
                                  "size takes less.",
                                  nullptr, refused));
    });
}

void VideoController::recordVideo(bool on) {
    if (!on) return video_.end();
    const QString file = askWhere(&bench_.window, tr("Record the view"),
                                  {{tr("Videos"), QString::fromLatin1(kWebmEnding)},
                                   {tr("Moving pictures"), QString::fromLatin1(kGifEnding)}},
                                  QStringLiteral("touch.webm"));
    VideoForm form{{}, bench_.actions["video-plot"].isChecked()};
    for (const VideoSize& each : kVideoSizes)
        if (bench_.actions[each.id].isChecked()) form.size = each.size;
    const auto begun = file.isEmpty() ? Result<void>() : video_.begin(file, form);
    if (!begun) bench_.notice.showError(QString::fromStdString(begun.error().text));
    bench_.actions["record-video"].setChecked(video_.recording());
}

} // namespace tactum
