#include "ui/panels/import_bar.h"

#include <algorithm>

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/numbers.h"
#include "ui/style.h"

namespace tactum {

namespace {

constexpr int kLongestName = 240; // pixels

QToolButton* choice(QButtonGroup& group, int id, const QString& text, const QString& name,
                    const QString& sentence) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(sentence);
    button->setAccessibleName(sentence);
    button->setCheckable(true);
    button->setProperty("choice", true);
    group.addButton(button, id);
    return button;
}

QString wordsFor(const QString& name, const TakenAs& taken) {
    const bool guessed = taken.axes == taken.guess;
    if (taken.unitOpen && taken.upOpen)
        return guessed ? ImportBar::tr("%1 says neither unit nor up axis: guessed").arg(name)
                       : ImportBar::tr("%1 says neither unit nor up axis: as you chose").arg(name);
    if (taken.unitOpen)
        return guessed ? ImportBar::tr("%1 does not say its unit: guessed").arg(name)
                       : ImportBar::tr("%1 does not say its unit: as you chose").arg(name);
    return guessed ? ImportBar::tr("%1 does not say its up axis: guessed").arg(name)
                   : ImportBar::tr("%1 does not say its up axis: as you chose").arg(name);
}

/// What it is in the hand's measure, and what was done to it so that it fits.
QString sizeText(double own, double felt) {
    if (lengthText(own) == lengthText(felt)) return ImportBar::tr("%1 across").arg(lengthText(own));
    return ImportBar::tr("%1 across, scaled to %2").arg(lengthText(own), lengthText(felt));
}

} // namespace

ImportBar::ImportBar(QWidget* parent)
    : QWidget(parent), text_(new QLabel), size_(new QLabel), close_(new QToolButton),
      units_(new QButtonGroup(this)), ups_(new QButtonGroup(this)) {
    setObjectName(QStringLiteral("import"));
    setAttribute(Qt::WA_StyledBackground);
    text_->setObjectName(QStringLiteral("import-text"));
    text_->setTextFormat(Qt::PlainText); // names are others'
    size_->setObjectName(QStringLiteral("import-size"));
    close_->setObjectName(QStringLiteral("import-close"));
    close_->setIconSize({16, 16});
    close_->setAccessibleName(tr("Close: unit and up axis are right"));
    close_->setToolTip(close_->accessibleName());
    unitChoice_ = makeChoice(*units_, tr("1 unit is"));
    for (int i = 0; i < int(std::size(kLengthUnits)); ++i) {
        const QString name = QString::fromUtf8(kLengthUnits[i].name.data(), kLengthUnits[i].name.size());
        unitChoice_->layout()->addWidget(
            choice(*units_, i, name, QStringLiteral("import-unit-") + name,
                   tr("Open the file again with one unit as 1 %1, now and for other files of its format")
                       .arg(name)));
    }
    upChoice_ = makeChoice(*ups_, tr("up is"));
    for (const auto& [id, name] : {std::pair(0, QStringLiteral("y")), {1, QStringLiteral("z")}})
        upChoice_->layout()->addWidget(
            choice(*ups_, id, name, QStringLiteral("import-up-") + name,
                   tr("Open the file again with %1 up, now and for other files of its format").arg(name)));
    auto* first = new QHBoxLayout;
    first->setSpacing(kRhythm);
    first->addWidget(text_, 1);
    first->addWidget(close_);
    auto* second = new QHBoxLayout;
    second->setSpacing(2 * kRhythm);
    second->addWidget(unitChoice_);
    second->addWidget(upChoice_);
    second->addStretch(1);
    second->addWidget(size_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, kRhythm / 2, kRhythm, kRhythm);
    column->setSpacing(kRhythm / 2);
    column->addLayout(first);
    column->addLayout(second);
    connect(units_, &QButtonGroup::idClicked, this, [this](int id) {
        const double unit = kLengthUnits[id].metres;
        if (unit != taken_.axes.unit) emit unitChosen(unit);
    });
    connect(ups_, &QButtonGroup::idClicked, this, [this](int id) {
        if ((id == 1) != taken_.axes.zUp) emit upChosen(id == 1);
    });
    connect(close_, &QToolButton::clicked, this, &ImportBar::closed);
    refreshIcons();
    hide();
}

QWidget* ImportBar::makeChoice(QButtonGroup& group, const QString& label) {
    group.setExclusive(true);
    auto* choice = new QWidget;
    auto* row = new QHBoxLayout(choice);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kRhythm / 2);
    row->addWidget(new QLabel(label));
    return choice;
}

void ImportBar::display(const QString& file, const TakenAs& taken, double across) {
    taken_ = taken;
    text_->setText(wordsFor(text_->fontMetrics().elidedText(file, Qt::ElideMiddle, kLongestName), taken));
    size_->setText(sizeText(taken.across, across));
    unitChoice_->setVisible(taken.unitOpen);
    upChoice_->setVisible(taken.upOpen);
    const auto unit = std::ranges::find(kLengthUnits, taken.axes.unit, &LengthUnit::metres);
    if (auto* button = units_->button(int(unit - std::begin(kLengthUnits)))) button->setChecked(true);
    ups_->button(taken.axes.zUp ? 1 : 0)->setChecked(true);
    setAccessibleName(text_->text());
    show();
}

void ImportBar::refreshIcons() {
    close_->setIcon(icon(QStringLiteral("close")));
}

void ImportBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcons();
    QWidget::changeEvent(event);
}

} // namespace tactum
