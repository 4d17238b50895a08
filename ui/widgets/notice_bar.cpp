#include "ui/widgets/notice_bar.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {
constexpr int kNoteTime = 30000; // ms: what was done long ago is no news; errors stay
}

NoticeBar::NoticeBar(QWidget* parent)
    : QWidget(parent), icon_(new QLabel), text_(new QLabel), inside_(new QBoxLayout(QBoxLayout::LeftToRight)),
      buttons_(new QHBoxLayout), bar_(new QProgressBar), cancel_(new QPushButton(tr("Cancel"))),
      act_(new QPushButton), also_(new QPushButton), close_(new QToolButton) {
    setObjectName(QStringLiteral("notice"));
    setAttribute(Qt::WA_StyledBackground);
    text_->setObjectName(QStringLiteral("notice-text"));
    text_->setTextFormat(Qt::PlainText); // names and sentences come from files and servers
    text_->setWordWrap(true);
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a path is one long word
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setFixedWidth(20 * kRhythm);
    cancel_->setObjectName(QStringLiteral("notice-cancel"));
    act_->setObjectName(QStringLiteral("notice-act"));
    also_->setObjectName(QStringLiteral("notice-also"));
    close_->setIcon(icon(QStringLiteral("close")));
    close_->setIconSize({16, 16});
    close_->setAccessibleName(tr("Close this message"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, kRhythm, 6);
    row->setSpacing(kRhythm);
    row->addWidget(icon_);
    row->addLayout(inside_, 1);
    row->addWidget(close_);
    inside_->setSpacing(kRhythm);
    inside_->addWidget(text_, 1);
    buttons_->setSpacing(kRhythm);
    buttons_->addStretch(1);
    for (QWidget* widget : {static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_),
                            static_cast<QWidget*>(act_), static_cast<QWidget*>(also_)})
        buttons_->addWidget(widget);
    inside_->addLayout(buttons_);
    connect(close_, &QToolButton::clicked, this, &QWidget::hide);
    connect(cancel_, &QPushButton::clicked, this, &NoticeBar::cancelled);
    connect(act_, &QPushButton::clicked, this, [this] { press(&Message::action); });
    connect(also_, &QPushButton::clicked, this, [this] { press(&Message::alsoAction); });
    fading_.setSingleShot(true);
    connect(&fading_, &QTimer::timeout, this, [this] {
        if (property("severity").toString() == QLatin1String("note")) hide();
    });
    hide();
}

void NoticeBar::press(std::function<void()> Message::*which) {
    const auto action = message_ ? (*message_).*which : nullptr;
    hide();
    if (action) action();
}

QString NoticeBar::text() const {
    return isVisible() ? text_->text() : QString();
}

void NoticeBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) close_->setIcon(icon(QStringLiteral("close")));
    QWidget::changeEvent(event);
}

/// Where the buttons would leave little to the words, they stand below them.
void NoticeBar::fit() {
    constexpr int kLeast = 40 * kRhythm; // for words in a line
    int taken = 0;
    for (const QWidget* each : {static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_),
                                static_cast<QWidget*>(act_), static_cast<QWidget*>(also_)})
        if (!each->isHidden()) taken += std::max(each->minimumWidth(), each->sizeHint().width()) + kRhythm;
    const bool below = taken > 0 && width() - taken < kLeast;
    inside_->setDirection(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void NoticeBar::setSeverity(const QString& severity) {
    setProperty("severity", severity);
    repolish(*this);
    const bool progress = severity == QLatin1String("progress");
    bar_->setVisible(progress);
    close_->setVisible(!progress);
    icon_->setVisible(!progress);
}

void NoticeBar::showMessage(Message message) {
    const bool note = message.severity == QLatin1String("note");
    icon_->setPixmap(icon(message.severity, note ? theme().accent : theme().fault).pixmap(16, 16));
    text_->setText(message.sentence);
    cancel_->hide();
    act_->setText(message.button);
    act_->setVisible(!message.button.isEmpty());
    also_->setText(message.also);
    also_->setVisible(!message.also.isEmpty());
    setSeverity(message.severity);
    fit();
    setAccessibleName(message.sentence);
    if (note && message.button.isEmpty())
        fading_.start(kNoteTime);
    else
        fading_.stop();
    message_ = std::move(message);
    show();
}

void NoticeBar::offer(const QString& sentence, const QString& severity, const QString& button,
                      std::function<void()> action) {
    showMessage({sentence, severity, button, std::move(action)});
}

void NoticeBar::alsoOffer(const QString& button, std::function<void()> action) {
    if (!message_) return;
    Message message = *message_;
    message.also = button;
    message.alsoAction = std::move(action);
    const bool waits = property("severity") == QLatin1String("progress");
    if (waits)
        message_ = std::move(message);
    else
        showMessage(std::move(message));
}

void NoticeBar::takeBack(const QString& sentence) {
    if (!message_ || message_->sentence != sentence) return;
    message_.reset();
    if (property("severity") != QLatin1String("progress")) hide();
}

void NoticeBar::takeBackAlso(const QString& sentence) {
    if (message_ && message_->sentence == sentence) alsoOffer({}, {});
}

void NoticeBar::withdraw(const QString& button) {
    if (!message_ || message_->button != button) return;
    message_.reset();
    if (property("severity") != QLatin1String("progress")) hide();
}

/// Whoever hides it has done with its message, too.
void NoticeBar::hideEvent(QHideEvent* event) {
    if (!event->spontaneous()) message_.reset();
    QWidget::hideEvent(event);
}

void NoticeBar::showProgress(const QString& what, double fraction, double secondsLeft, bool cancellable) {
    text_->setText(secondsLeft < 0 ? what : tr("%1 - about %2 left").arg(what, durationText(secondsLeft)));
    bar_->setValue(int(1000 * fraction));
    cancel_->setVisible(cancellable);
    act_->hide();
    also_->hide();
    fading_.stop();
    setSeverity(QStringLiteral("progress"));
    fit();
    show();
}

void NoticeBar::endProgress() {
    if (property("severity").toString() != QLatin1String("progress")) return;
    if (message_)
        showMessage(*message_);
    else
        hide();
}

} // namespace tactum
