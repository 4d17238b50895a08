#include "ui/showing/recording_video.h"

#include "core/video/video_file.h"
#include "ui/base/style.h"
#include "ui/engine/touched.h"
#include "ui/showing/played_touch.h"
#include "ui/showing/video_frame.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace tactum {

namespace {

/// What the window is made of for this, without one.
class PlayedView {
public:
    PlayedView(Player player, const VideoLayout& layout) : player_(std::move(player)), layout_(layout) {
        view_.resize(layout.view.size());
        view_.setTheme(theme().dark);
    }

    const RecordedRun& run() const { return player_.run(); }
    VideoPicture pictureAt(double time);

private:
    void followScene();

    Player player_;
    VideoLayout layout_;
    SceneView view_;
    ForcePlot plot_;
    std::uint64_t shape_ = 0;
};

void PlayedView::followScene() {
    const World* world = player_.world();
    if (!world) return;
    if (world->shapeRevision != shape_) {
        const bool first = shape_ == 0;
        shape_ = world->shapeRevision;
        view_.setScene(*world->scene);
        if (first) view_.fit();
    }
    const auto touched = touchedSurface(player_.proxy().output, *world);
    view_.setTouched(touched ? nameOfSurface(*world->scene, *touched) : QString());
}

VideoPicture PlayedView::pictureAt(double time) {
    player_.advanceTo(time);
    followScene();
    showPlayedHands(player_, 0, view_);
    view_.setWorld(player_.sharedWorld());
    showPlayed(player_, 0, plot_, view_, {});
    QImage plot;
    if (!layout_.plot.isEmpty()) plot = plot_.picture(layout_.plot.size(), layout_.plotScale());
    return videoFrame(layout_, view_.grabPicture(), plot, theme().window);
}

} // namespace

Result<double> writeRecordingVideo(Player player, const RecordingVideo& what, const Progress& progress) {
    const VideoLayout layout = videoLayout({what.height * 16 / 9, what.height}, what.plot);
    auto video = beginVideo(what.file, layout.size.width(), layout.size.height());
    if (!video) return tl::unexpected(video.error());
    PlayedView played(std::move(player), layout);
    const double begin = played.run().begin(), length = played.run().end() - begin;
    const int pictures = int(length * kVideoRate) + 1;
    ProgressMeter meter(progress, std::size_t(pictures), 1);
    int drawn = 0;
    for (; drawn < pictures && meter.goesOn(std::size_t(drawn)); ++drawn) {
        const double time = drawn * kVideoPeriod;
        if (auto added = (*video)->add(played.pictureAt(begin + time), time); !added)
            return tl::unexpected(added.error());
    }
    const double end = drawn < pictures ? drawn * kVideoPeriod : std::max(length, kVideoPeriod);
    if (auto finished = (*video)->finish(end); !finished) return tl::unexpected(finished.error());
    return end;
}

} // namespace tactum
