#include "ui/panels/hand_list.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "ui/base/hand_colours.h"
#include "ui/base/style.h"
#include "ui/engine/device_link.h"
#include "ui/engine/hand_name.h"
#include "ui/widgets/columns.h"

namespace tactum {

namespace {

/// The finger, and the proxy before it, as the view draws them.
QIcon handIcon(const HandColours& colours, qreal ratio) {
    constexpr int kHandIcon = 2 * kRhythm;
    QPixmap picture(QSize(kHandIcon, kHandIcon) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.finger);
    painter.drawEllipse(QRectF(1, 5, 10, 10));
    painter.setBrush(colours.proxy);
    painter.drawEllipse(QRectF(7, 1, 8, 8));
    return picture;
}

} // namespace

HandList::HandList(DeviceLink& link, QWidget* parent)
    : QWidget(parent), link_(link), column_(columnIn(this, kRhythm / 2)) {
    setObjectName(QStringLiteral("hand-list"));
    column_->setContentsMargins(12, 0, 12, 0);
    auto* about = dimmedLine(tr("Status, health, plots and trail are those of the chosen hand."));
    about->setObjectName(QStringLiteral("hand-list-about"));
    column_->addWidget(about);
    hide();
}

void HandList::display() {
    const std::size_t count = link_.hands().count();
    setVisible(count > 1);
    if (rows_.size() != count) {
        while (rows_.size() < count)
            addRow();
        while (rows_.size() > count) {
            rows_.back().line->deleteLater();
            rows_.back().line->hide();
            rows_.pop_back();
        }
        colour();
    }
    for (std::size_t hand = 0; hand < count; ++hand) {
        QToolButton& button = *rows_[hand].button;
        if (const QString text = textOf(hand); text != button.text()) button.setText(text);
        button.setChecked(hand == link_.hands().chosen());
        if (rows_[hand].remove) rows_[hand].remove->setVisible(link_.hasCatalogue());
    }
}

QString HandList::textOf(std::size_t hand) const {
    const Hands& hands = link_.hands();
    return QStringLiteral("%1 \u00b7 %2")
        .arg(handName(hands, hand), link_.gone(hand)    ? tr("not there any more")
                                    : hands.armed(hand) ? tr("forces on")
                                                        : tr("forces off"));
}

void HandList::addRow() {
    const std::size_t hand = rows_.size();
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kRhythm / 2);
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("hand-%1").arg(hand));
    button->setToolTip(tr("Show the status, health, plots and trail of this hand"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setProperty("choice", true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, [this, hand] { emit handChosen(hand); });
    row->addWidget(button, 1);
    rows_.push_back({line, button});
    if (hand > 0) { // Disconnect is for the first, which always is there
        auto* remove = new QToolButton;
        remove->setObjectName(QStringLiteral("hand-remove-%1").arg(hand));
        remove->setText(tr("Remove"));
        remove->setAccessibleName(tr("Remove hand %1").arg(hand + 1));
        remove->setToolTip(tr("Give this device back. The forces of all hands are off then"));
        connect(remove, &QToolButton::clicked, this, [this, hand] { emit removePressed(hand); });
        row->addWidget(remove);
        rows_.back().remove = remove;
    }
    column_->insertWidget(int(hand), line);
}

void HandList::colour() {
    for (std::size_t hand = 0; hand < rows_.size(); ++hand)
        rows_[hand].button->setIcon(handIcon(handColours(theme(), hand), devicePixelRatioF()));
}

void HandList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) colour();
    QWidget::changeEvent(event);
}

} // namespace tactum
