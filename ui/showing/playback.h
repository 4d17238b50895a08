// A recording in the window: read on a worker, stepped through frame by frame.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "core/recording/events.h"
#include "core/recording/player.h"
#include "ui/base/background_job.h"
#include "ui/engine/guard_watch.h"

namespace tactum {

class PlaybackBar;

/// Thread: ui. Nothing of the document or the engine is touched; the window listens to begun() and ended().
class Playback : public QObject {
    Q_OBJECT
public:
    explicit Playback(PlaybackBar& bar, QObject* parent = nullptr);

    /// Ends with begun() or failed().
    void open(const QString& file);
    bool opening() const { return job_.running(); }
    /// Safe to call when nothing is played.
    void end();
    bool active() const { return player_.has_value(); }
    const QString& file() const { return file_; }

    /// Once a frame while active: goes on by the time that has passed.
    void frame();
    void setPlaying(bool playing);
    bool playing() const { return playing_; }
    /// s since the beginning. `resting`: with all of the force plot's time before it.
    void seek(double time, bool resting);
    /// `by` speeds of the bar on, or back.
    void changeSpeed(int by);
    double time() const;
    /// What happened in the recording until now, newest first, each at its time since the beginning.
    std::deque<HealthEvent> eventsSoFar() const;

    // Only while active.
    Player& player() { return *player_; }
    /// Whose plot, trail and status are shown, below player().run().hands(): at first the first hand's.
    std::size_t hand() const { return hand_; }
    void showHand(std::size_t hand);
    /// Whether the last frame() jumped: what was drawn over time begins anew.
    bool takeJump() { return std::exchange(jumped_, false); }

signals:
    void begun();
    void ended();
    void failed(const QString& sentence);
    void progressed(double fraction, double secondsLeft);

private:
    void adopt(Player player, const QString& file);

    PlaybackBar& bar_;
    BackgroundJob job_;
    std::optional<Player> player_;
    QString file_;
    std::vector<RecordedEvent> events_;
    QElapsedTimer clock_;
    std::size_t hand_ = 0;
    bool playing_ = false, jumped_ = false;
};

} // namespace tactum
