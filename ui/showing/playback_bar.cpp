#include "ui/showing/playback_bar.h"

#include <algorithm>

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4};
constexpr int kOwnSpeed = 3; // index of 1

QString speedText(double speed) {
    return QString::number(speed) + QStringLiteral("\u00d7");
}

QLabel* figures(const QString& name, const QString& widest) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setFont(figureFont());
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest));
    return label;
}

} // namespace

PlaybackBar::PlaybackBar(QWidget* parent)
    : QWidget(parent), play_(new QToolButton), speed_(new QComboBox), hand_(new QComboBox),
      scrubber_(new Scrubber),
      time_(figures(QStringLiteral("playback-time"), QStringLiteral("00.00 / 00.00 s"))), event_(new QLabel),
      verdict_(new QLabel), back_(new QPushButton(tr("Back to live"))) {
    setObjectName(QStringLiteral("playback"));
    setAttribute(Qt::WA_StyledBackground);
    play_->setObjectName(QStringLiteral("playback-play"));
    play_->setIconSize({24, 24});
    play_->setAutoRaise(true);
    play_->setAccessibleName(tr("Play or pause the recording"));
    for (const double speed : kSpeeds)
        speed_->addItem(speedText(speed), speed);
    speed_->setCurrentIndex(kOwnSpeed);
    speed_->setObjectName(QStringLiteral("playback-speed"));
    speed_->setToolTip(tr("Speed of the playback"));
    speed_->setAccessibleName(speed_->toolTip());
    hand_->setObjectName(QStringLiteral("playback-hand"));
    hand_->setToolTip(tr("Whose plots, trail and status are shown"));
    hand_->setAccessibleName(hand_->toolTip());
    hand_->hide();
    event_->setObjectName(QStringLiteral("playback-event"));
    event_->setProperty("dimmed", true);
    event_->setMinimumWidth(1);
    verdict_->setObjectName(QStringLiteral("playback-verdict"));
    back_->setObjectName(QStringLiteral("playback-back"));
    back_->setToolTip(tr("Close the recording and go on with the open model"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kRhythm, kRhythm / 2, kRhythm, kRhythm / 2);
    column->setSpacing(0);
    auto* line = new QHBoxLayout;
    auto* words = new QHBoxLayout;
    line->setSpacing(kRhythm);
    words->setSpacing(2 * kRhythm);
    line->addWidget(play_);
    line->addWidget(speed_);
    line->addWidget(scrubber_, 1);
    line->addWidget(time_);
    line->addWidget(hand_);
    line->addWidget(back_);
    words->addWidget(event_, 1);
    words->addWidget(verdict_);
    column->addLayout(line);
    column->addLayout(words);
    connect(play_, &QToolButton::clicked, this, &PlaybackBar::playToggled);
    connect(scrubber_, &Scrubber::moved, this, &PlaybackBar::soughtTo);
    connect(hand_, &QComboBox::activated, this, [this](int hand) { emit handChosen(std::size_t(hand)); });
    connect(back_, &QPushButton::clicked, this, &PlaybackBar::left);
    refreshIcon();
    hide();
}

void PlaybackBar::setRecording(double length, const std::vector<RecordedEvent>& events, double begin) {
    length_ = length;
    marks_.clear();
    for (const RecordedEvent& event : events)
        marks_.push_back({event.time - begin, event.fault, QString::fromStdString(event.text)});
    scrubber_->setRecording(length, marks_);
    speed_->setCurrentIndex(kOwnSpeed);
}

void PlaybackBar::setHands(const QStringList& names) {
    hand_->clear();
    for (const QString& name : names)
        hand_->addItem(QStringLiteral("%1 \u00b7 %2").arg(hand_->count() + 1).arg(name), name);
    hand_->setVisible(names.size() > 1);
}

void PlaybackBar::showHand(std::size_t hand) {
    hand_->setCurrentIndex(int(hand));
}

void PlaybackBar::display(double time, bool playing, const ReplayCheck& check) {
    scrubber_->display(time);
    time_->setText(tr("%1 / %2 s").arg(numberText(time, 2), numberText(length_, 2)));
    if (playing != playing_) {
        playing_ = playing;
        refreshIcon();
    }
    tellEvent(time);
    tellVerdict(check);
}

double PlaybackBar::speed() const {
    return speed_->currentData().toDouble();
}

void PlaybackBar::changeSpeed(int by) {
    speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + by, 0, speed_->count() - 1));
}

// What happened last: beside the picture of the moment it says how it came to it.
void PlaybackBar::tellEvent(double time) {
    const auto next = std::ranges::upper_bound(marks_, time, {}, &ScrubberMark::time);
    QString text = hand_->count() < 2
                       ? tr("Recording: finger, proxy and forces are those of then")
                       : tr("Recording of several hands; plots, trail and status are those of %1")
                             .arg(hand_->currentData().toString());
    if (next != marks_.begin()) {
        const ScrubberMark& last = *std::prev(next);
        text = tr("%1 s: %2").arg(numberText(last.time, 2), last.text);
    }
    event_->setText(event_->fontMetrics().elidedText(text, Qt::ElideRight, event_->width()));
    event_->setToolTip(text);
}

void PlaybackBar::tellVerdict(const ReplayCheck& check) {
    const bool same = check.differ == 0;
    verdict_->setText(same ? tr("\u2713 the same bits as recorded")
                           : tr("\u26a0 %n step(s) are not as recorded", nullptr, int(check.differ)));
    verdict_->setToolTip(same ? tr("Every step since the last jump gave what it gave then.")
                              : QString::fromStdString(check.first));
    if (verdict_->property("fault").toBool() == !same) return;
    verdict_->setProperty("fault", !same);
    repolish(*verdict_);
}

void PlaybackBar::refreshIcon() {
    play_->setIcon(icon(playing_ ? QStringLiteral("pause") : QStringLiteral("play"), theme().text));
    play_->setToolTip(playing_ ? tr("Pause (Space)") : tr("Play (Space)"));
}

void PlaybackBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcon();
    QWidget::changeEvent(event);
}

} // namespace tactum
