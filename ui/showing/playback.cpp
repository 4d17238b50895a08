#include "ui/showing/playback.h"

#include <algorithm>
#include <filesystem>

#include "core/recording/recording_file.h"
#include "ui/showing/playback_bar.h"

namespace tactum {

namespace {

constexpr double kPlotted = 6;        // s, what the force plot shows
constexpr double kLongestFrame = 0.1; // s: a frame that came late does not make the next one late

Result<Player> playerOf(const QString& file, const Progress& progress) {
    auto recording = readRecording(std::filesystem::path(file.toStdU16String()));
    if (!recording) return tl::unexpected(recording.error());
    return Player::open(std::make_shared<const RecordedRun>(std::move(recording->run)), progress);
}

} // namespace

Playback::Playback(PlaybackBar& bar, QObject* parent) : QObject(parent), bar_(bar) {
    connect(&job_, &BackgroundJob::progressed, this, &Playback::progressed);
    connect(&bar_, &PlaybackBar::playToggled, this, [this] { setPlaying(!playing_); });
    connect(&bar_, &PlaybackBar::soughtTo, this, &Playback::seek);
    connect(&bar_, &PlaybackBar::handChosen, this, &Playback::showHand);
    connect(&bar_, &PlaybackBar::left, this, &Playback::end);
}

void Playback::open(const QString& file) {
    job_.start([this, file](const Progress& progress) -> BackgroundJob::Delivery {
        auto player = std::make_shared<Result<Player>>(playerOf(file, progress));
        if (!*player) return [this, player] { emit failed(QString::fromStdString(player->error().text)); };
        return [this, player, file] { adopt(std::move(**player), file); };
    });
}

void Playback::adopt(Player player, const QString& file) {
    const RecordedRun& run = player.run();
    events_ = eventsOf(run);
    bar_.setRecording(run.end() - run.begin(), events_, run.begin());
    QStringList hands;
    for (std::size_t hand = 0; hand < run.hands(); ++hand)
        hands << QString::fromStdString(run.hand(hand).device.name);
    bar_.setHands(hands);
    player_.emplace(std::move(player));
    file_ = file;
    setPlaying(false);
    seek(0, true);
    hand_ = 0;
    bar_.show();
    emit begun();
}

void Playback::end() {
    job_.cancel();
    if (!active()) return;
    player_.reset();
    file_.clear();
    bar_.hide();
    emit ended();
}

void Playback::setPlaying(bool playing) {
    if (!active()) return;
    // Play at the end begins again.
    if (playing && player_->atEnd()) seek(0, true);
    playing_ = playing;
    clock_.start();
}

double Playback::time() const {
    return player_->time() - player_->run().begin();
}

std::deque<HealthEvent> Playback::eventsSoFar() const {
    std::deque<HealthEvent> events;
    for (const RecordedEvent& event : events_) {
        if (event.time > player_->time()) break;
        const QString text = QString::fromStdString(event.text);
        const int ms = int(1e3 * (event.time - player_->run().begin()));
        events.push_front({QTime(0, 0).addMSecs(ms), event.fault, text, text});
    }
    return events;
}

void Playback::changeSpeed(int by) {
    bar_.changeSpeed(by);
}

void Playback::seek(double time, bool resting) {
    if (!active()) return;
    player_->seek(player_->run().begin() + time, resting ? kPlotted : 0);
    jumped_ = true;
    clock_.start();
}

/// What was drawn over time is stepped through again, for it was another hand's.
void Playback::showHand(std::size_t hand) {
    if (!active()) return;
    hand_ = hand;
    player_->speakOf(hand);
    bar_.showHand(hand);
    seek(time(), true);
}

void Playback::frame() {
    const double passed = std::min(1e-9 * double(clock_.nsecsElapsed()), kLongestFrame);
    clock_.start();
    if (playing_ && !bar_.isHeld()) player_->advanceTo(player_->time() + bar_.speed() * passed);
    if (player_->atEnd()) playing_ = false;
    bar_.display(time(), playing_, player_->check());
}

} // namespace tactum
