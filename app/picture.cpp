#include "app/picture.h"

#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdio>

#include <QApplication>

#include "app/terminal_progress.h"
#include "core/files/source.h"
#include "core/recording/player.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/showing/recording_video.h"
#include "ui/view/surface_format.h"
#include "ui/view/touch_picture.h"

namespace tactum {

namespace {

/// What draws without a window of its own; the person's settings are not for it.
class WithoutWindow {
public:
    WithoutWindow() { std::setlocale(LC_NUMERIC, "C"); } // the application takes over the user's

private:
    int argc_ = 1;
    char name_[7] = "tactum";
    char* argv_[2] = {name_, nullptr};
    const bool format_ = (useViewSurfaceFormat(), true);
    QApplication application_{argc_, argv_};
};

/// While it lives Ctrl+C asks the work to end instead of the program; then the program ends as it would have.
class Interruption {
public:
    Interruption() : before_(std::signal(SIGINT, [](int) { asked_ = true; })) {}
    ~Interruption() {
        std::signal(SIGINT, before_);
        if (asked_) std::raise(SIGINT);
    }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    const std::atomic<bool>& asked() const { return asked_; }

private:
    static inline std::atomic<bool> asked_{false};
    void (*before_)(int);
};

} // namespace

Result<void> writePicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& file) {
    const WithoutWindow program;
    return writeTouchPicture(scene, rows, file, QSize(1600, 1200));
}

Result<void> writeVideo(const std::shared_ptr<const RecordedRun>& run, const std::filesystem::path& file,
                        int height, bool plot) {
    const Interruption interruption;
    auto player = Player::open(run);
    if (!player) return tl::unexpected(player.error());
    const WithoutWindow program;
    applyTheme(ThemeChoice::Dark);
    const TerminalProgress terminal("drawing " + shownPath(file));
    Progress progress = terminal.progress();
    progress.cancelled = &interruption.asked();
    const auto written = writeRecordingVideo(std::move(*player), {file, height, plot}, progress);
    if (!written) return tl::unexpected(written.error());
    if (progress.isCancelled())
        std::fprintf(stderr, "stopped: %s holds the first %s s\n", shownPath(file).c_str(),
                     numberText(*written, 1).toUtf8().constData());
    return {};
}

} // namespace tactum
