#include "ui/showing/video_recorder.h"

#include <QEvent>

#include "ui/base/style.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace tactum {

VideoRecorder::VideoRecorder(SceneView& view, ForcePlot& plot, QObject* parent)
    : QObject(parent), view_(&view), plot_(plot), badge_(new QLabel(&view)) {
    badge_->setObjectName(QStringLiteral("video-badge"));
    badge_->setAttribute(Qt::WA_TransparentForMouseEvents);
    badge_->setFont(figureFont());
    badge_->hide();
    view_->installEventFilter(this);
    ticker_.setTimerType(Qt::PreciseTimer);
    ticker_.setInterval(int(1000 * kVideoPeriod));
    connect(&ticker_, &QTimer::timeout, this, &VideoRecorder::tick);
}

VideoRecorder::~VideoRecorder() {
    if (view_) view_->takeNextPicture({});
    if (recording()) worker_->finish(now());
}

Result<void> VideoRecorder::begin(const QString& file, const VideoForm& form) {
    const QSize seen = (QSizeF(view_->size()) * view_->devicePixelRatioF()).toSize();
    layout_ = form.size.isValid() ? videoLayout(form.size, form.plot) : videoLayoutAround(seen, form.plot);
    auto video = beginVideo(file.toStdU16String(), layout_.size.width(), layout_.size.height());
    if (!video) return tl::unexpected(video.error());
    worker_ = std::make_unique<VideoWorker>(std::move(*video));
    file_ = file;
    newest_ = {};
    ending_.reset();
    clock_.start();
    askForPicture();
    view_->update(); // what stands still is in it too
    ticker_.start();
    tick();
    badge_->show();
    return {};
}

void VideoRecorder::end() {
    if (!recording()) return;
    ending_ = now();
    worker_->finish(*ending_);
    view_->takeNextPicture({});
    badge_->hide();
}

void VideoRecorder::askForPicture() {
    asked_ = true;
    view_->takeNextPicture([this](const QImage& picture) {
        asked_ = false;
        newest_ = picture;
        offer();
    });
}

void VideoRecorder::offer() {
    QImage plot;
    if (!layout_.plot.isEmpty()) plot = plot_.picture(layout_.plot.size(), layout_.plotScale());
    worker_->offer([layout = layout_, view = newest_, plot,
                    around = theme().window] { return videoFrame(layout, view, plot, around); },
                   now());
}

void VideoRecorder::tick() {
    watch();
    if (!recording()) return;
    // Nothing was drawn since the last time: the plot goes on nevertheless.
    if (asked_ && !newest_.isNull() && !layout_.plot.isEmpty()) offer();
    if (!asked_) askForPicture();
    const int seconds = int(now());
    badge_->setText(QStringLiteral("<span style='color:%1'>\u25cf</span> %2:%3")
                        .arg(theme().fault.name())
                        .arg(seconds / 60)
                        .arg(seconds % 60, 2, 10, QLatin1Char('0')));
    placeBadge();
}

/// Whether the file is complete, or cannot become longer.
void VideoRecorder::watch() {
    const VideoWorker::State state = worker_->state();
    if (!state.ended) return;
    const double seconds = ending_.value_or(0);
    ticker_.stop();
    view_->takeNextPicture({});
    badge_->hide();
    worker_.reset();
    if (state.error)
        emit failed(QString::fromStdString(state.error->text));
    else
        emit ended(file_, seconds, int(state.refused));
}

bool VideoRecorder::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) placeBadge();
    return QObject::eventFilter(watched, event);
}

void VideoRecorder::placeBadge() {
    badge_->adjustSize();
    constexpr int kBesideAxes = 14 * kRhythm; // which stand in the corner
    badge_->move(view_->width() - badge_->width() - kBesideAxes, 2 * kRhythm);
}

} // namespace tactum
