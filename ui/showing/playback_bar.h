// Over the foot of the view while a recording is played: play, speed, time, what happened, and the way back.
#pragma once

#include <QWidget>

#include "core/recording/events.h"
#include "core/recording/player.h"
#include "ui/widgets/scrubber.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace tactum {

/// Shows a recording's time and asks for another one; plays nothing itself. Thread: ui.
class PlaybackBar : public QWidget {
    Q_OBJECT
public:
    explicit PlaybackBar(QWidget* parent = nullptr);

    /// Times in s since the beginning.
    void setRecording(double length, const std::vector<RecordedEvent>& events, double begin);
    /// The names of their devices. The first is shown.
    void setHands(const QStringList& names);
    /// Whose plot, trail and status are shown.
    void showHand(std::size_t hand);
    void display(double time, bool playing, const ReplayCheck& check);
    bool isHeld() const { return scrubber_->isHeld(); }
    double speed() const;
    /// For the keyboard: the next slower or faster one.
    void changeSpeed(int by);

signals:
    void playToggled();
    void soughtTo(double time, bool resting);
    void handChosen(std::size_t hand);
    void left();

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void refreshIcon();
    void tellEvent(double time);
    void tellVerdict(const ReplayCheck& check);

    QToolButton* play_;
    QComboBox *speed_, *hand_;
    Scrubber* scrubber_;
    QLabel* time_;
    QLabel* event_;
    QLabel* verdict_;
    QPushButton* back_;
    std::vector<ScrubberMark> marks_;
    double length_ = 0;
    bool playing_ = false;
};

} // namespace tactum
