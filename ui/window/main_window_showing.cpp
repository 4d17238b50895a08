// Showing a scene to others: a video of the view, the view alone on the screen.
#include <QActionGroup>
#include <QKeyEvent>
#include <QSettings>

#include "ui/base/ask_where.h"
#include "ui/base/numbers.h"
#include "ui/showing/presentation.h"
#include "ui/showing/video_recorder.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

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

void MainWindow::connectShowing() {
    presentation_ = new Presentation(*this, *view_);
    connect(&actions_["present"], &QAction::toggled, this, &MainWindow::present);
    connect(&actions_["panels"], &QAction::triggered, &actions_["present"], [this] {
        if (presentation_->on()) panelsWereHidden_ = actions_["panels"].isChecked();
    });
    connectVideo();
}

void MainWindow::connectVideo() {
    video_ = new VideoRecorder(*view_, *docks_.plot, this);
    const QSettings settings;
    auto* sizes = new QActionGroup(this);
    const QString chosen = settings.value(kSizeKey, QLatin1String(kVideoSizes[0].id)).toString();
    actions_[kVideoSizes[0].id].setChecked(true);
    for (const VideoSize& each : kVideoSizes) {
        QAction& action = actions_[each.id];
        sizes->addAction(&action);
        if (chosen == QLatin1String(each.id)) action.setChecked(true);
        connect(&action, &QAction::triggered, this,
                [id = each.id] { QSettings().setValue(kSizeKey, QLatin1String(id)); });
    }
    actions_["video-plot"].setChecked(settings.value(kPlotKey).toBool());
    connect(&actions_["video-plot"], &QAction::toggled, this,
            [](bool on) { QSettings().setValue(kPlotKey, on); });
    connect(&actions_["record-video"], &QAction::triggered, this, &MainWindow::recordVideo);
    connect(video_, &VideoRecorder::failed, this, [this](const QString& sentence) {
        actions_["record-video"].setChecked(false);
        notice_->showError(sentence);
    });
    connect(video_, &VideoRecorder::ended, this, [this](const QString& file, double seconds, int refused) {
        const QString all = tr("The video was written to %1: %2 s.").arg(file, numberText(seconds, 1));
        notice_->showNote(
            refused == 0 ? all
                         : all + u' ' +
                               tr("%n picture(s) were left out, for the encoder could not follow; a smaller "
                                  "size takes less.",
                                  nullptr, refused));
    });
}

void MainWindow::recordVideo(bool on) {
    if (!on) return video_->end();
    const QString file = askWhere(this, tr("Record the view"),
                                  {{tr("Videos"), QString::fromLatin1(kWebmEnding)},
                                   {tr("Moving pictures"), QString::fromLatin1(kGifEnding)}},
                                  QStringLiteral("touch.webm"));
    VideoForm form{{}, actions_["video-plot"].isChecked()};
    for (const VideoSize& each : kVideoSizes)
        if (actions_[each.id].isChecked()) form.size = each.size;
    const auto begun = file.isEmpty() ? Result<void>() : video_->begin(file, form);
    if (!begun) notice_->showError(QString::fromStdString(begun.error().text));
    actions_["record-video"].setChecked(video_->recording());
}

void MainWindow::present(bool on) {
    QAction& panels = actions_["panels"];
    if (on) panelsWereHidden_ = panels.isChecked();
    panels.setChecked(on || panelsWereHidden_);
    presentation_->set(on);
}

/// What nobody else wanted.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && presentation_->on() && !event->isAutoRepeat())
        actions_["present"].setChecked(false);
    else
        QMainWindow::keyPressEvent(event);
}

} // namespace tactum
