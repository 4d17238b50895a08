#include "ui/widgets/picture_card.h"

#include <algorithm>

#include <QEvent>
#include <QGridLayout>
#include <QMovie>
#include <QStyleOptionToolButton>
#include <QStylePainter>

#include "ui/base/style.h"
#include "ui/widgets/text_lines.h"

namespace tactum {

namespace {

constexpr int kInside = kRhythm, kLeast = 34 * kRhythm; // pixels

} // namespace

PictureCard::PictureCard(const QString& title, QWidget* parent) : QToolButton(parent) {
    setText(QString(title).replace(u'&', QStringLiteral("&&"))); // of a name, and no letter for Alt
    setIconSize(kPicture);
    setAccessibleName(title);
    setFocusPolicy(Qt::StrongFocus); // the Tab key reaches it too
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

PictureCard::~PictureCard() = default;

void PictureCard::setPicture(const QPixmap& picture) {
    setIcon(picture.isNull() ? QIcon() : QIcon(picture));
}

void PictureCard::setMoving(const QString& file) {
    moving_ = file;
}

bool PictureCard::event(QEvent* event) {
    const bool done = QToolButton::event(event);
    constexpr QEvent::Type kTurns[] = {QEvent::Enter, QEvent::Leave, QEvent::FocusIn, QEvent::FocusOut,
                                       QEvent::Hide};
    if (std::ranges::find(kTurns, event->type()) != std::end(kTurns))
        play(isVisible() && (underMouse() || hasFocus()));
    return done;
}

void PictureCard::play(bool on) {
    const bool still = style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) <= 0;
    if (on == moves() || (on && (moving_.isEmpty() || still))) return;
    movie_.reset(on ? new QMovie(moving_) : nullptr);
    if (movie_) {
        connect(movie_.get(), &QMovie::updated, this, qOverload<>(&QWidget::update));
        movie_->start();
    }
    update();
}

void PictureCard::setDetails(const QStringList& details) {
    details_ = details;
    QStringList spoken = details;
    spoken.removeAll(QString());
    setAccessibleDescription(spoken.join(QStringLiteral(", ")));
    update();
}

QSize PictureCard::sizeHint() const {
    return {kLeast, kPicture.height() + 2 * kInside};
}

QSize PictureCard::minimumSizeHint() const {
    return {kLeast, kPicture.height() + 2 * kInside};
}

void PictureCard::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.text.clear();
    option.icon = QIcon();
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
    const QRect picture(QPoint(kInside, (height() - kPicture.height()) / 2), kPicture);
    paintPicture(painter, picture);
    const QRect words = rect().adjusted(picture.right() + 1 + kInside, kInside, -4 * kInside, -kInside);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(theme().text);
    const QFontMetrics metrics(bold);
    painter.drawText(words.left(), words.top() + metrics.ascent(),
                     metrics.elidedText(accessibleName(), Qt::ElideMiddle, words.width()));
    painter.setFont(font());
    painter.setPen(theme().textDimmed);
    paintDetails(painter, words.adjusted(0, metrics.height() + kInside / 4, 3 * kInside, 0));
}

void PictureCard::paintPicture(QPainter& painter, const QRect& place) {
    const QPixmap now = movie_ ? movie_->currentPixmap() : QPixmap();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!now.isNull())
        painter.drawPixmap(place, now);
    else if (icon().isNull())
        painter.fillRect(place, theme().field);
    else
        icon().paint(&painter, place);
}

void PictureCard::paintDetails(QPainter& painter, const QRect& room) const {
    const QFontMetrics metrics(font());
    const int most = std::max(1, room.height() / metrics.height());
    QStringList lines;
    if (details_.size() == 1)
        lines = linesOf(details_.front(), font(), room.width(), most);
    else
        for (const QString& detail : details_)
            lines << metrics.elidedText(detail, Qt::ElideMiddle, room.width());
    for (int i = 0; i < lines.size(); ++i)
        painter.drawText(room.left(), room.top() + i * metrics.height() + metrics.ascent(), lines[i]);
}

CardGrid::CardGrid(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(kRhythm / 2);
}

int CardGrid::columns() const {
    return std::max(1, width() / kLeast);
}

void CardGrid::add(QWidget* card) {
    cards_ << card;
    arranged_ = 0;
    arrange();
}

void CardGrid::clear() {
    for (QWidget* card : std::exchange(cards_, {})) {
        card->setParent(nullptr);
        card->deleteLater();
    }
}

void CardGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void CardGrid::arrange() {
    if (columns() == arranged_) return;
    for (int i = 0; i < arranged_; ++i)
        grid_->setColumnStretch(i, 0);
    arranged_ = columns();
    for (int i = 0; i < cards_.size(); ++i)
        grid_->addWidget(cards_[i], i / arranged_, i % arranged_); // a widget that is there already moves
    for (int i = 0; i < arranged_; ++i)
        grid_->setColumnStretch(i, 1);
}

} // namespace tactum
