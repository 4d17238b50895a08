// The view as a video while it is used.
#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QImage>
#include <QLabel>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "core/video/video_worker.h"
#include "ui/showing/video_frame.h"

namespace tactum {

class ForcePlot;
class SceneView;

/// What of the window is in a video.
struct VideoForm {
    QSize size; ///< pixels; an invalid one: that of the view
    bool plot = false;
};

/// Takes the pictures that the view draws anyway, thirty a second at most, at the times when they were drawn,
/// and has them encoded on another thread. The view shows a red dot and the time meanwhile, which are not in
/// the video. Thread: ui.
class VideoRecorder : public QObject {
    Q_OBJECT
public:
    VideoRecorder(SceneView& view, ForcePlot& plot, QObject* parent = nullptr);
    /// A video that goes on is ended first.
    ~VideoRecorder() override;

    /// Errors: those of beginVideo().
    Result<void> begin(const QString& file, const VideoForm& form);
    void end();
    bool recording() const { return worker_ && !ending_; }

signals:
    /// The file is complete. `refused`: pictures for which the encoder had no time.
    void ended(const QString& file, double seconds, int refused);
    void failed(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void tick();
    void askForPicture();
    void offer();
    void watch();
    void placeBadge();
    double now() const { return double(clock_.nsecsElapsed()) * 1e-9; }

    QPointer<SceneView> view_; ///< the window's other parts may go first
    ForcePlot& plot_;
    QLabel* badge_;
    std::unique_ptr<VideoWorker> worker_;
    QString file_;
    VideoLayout layout_;
    QImage newest_;      ///< of the view
    bool asked_ = false; ///< for the next one
    std::optional<double> ending_;
    QElapsedTimer clock_;
    QTimer ticker_;
};

} // namespace tactum
