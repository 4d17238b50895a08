#include "ui/panels/import_bar.h"

#include <algorithm>

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/numbers.h"
#include "ui/base/style.h"

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

QString how(const TakenAs& taken) {
    switch (taken.by) {
    case TakenAs::By::Guess:
        break;
    case TakenAs::By::Choice:
        return ImportBar::tr("as you chose");
    case TakenAs::By::Before:
        return ImportBar::tr("as before");
    case TakenAs::By::Size:
        return ImportBar::tr("guessed by the size of before");
    }
    return ImportBar::tr("guessed");
}

QString wordsFor(const QString& name, const TakenAs& taken) {
    const QString words = taken.unitOpen && taken.upOpen
                              ? ImportBar::tr("%1 says neither unit nor up axis: %2")
                          : taken.unitOpen ? ImportBar::tr("%1 does not say its unit: %2")
                                           : ImportBar::tr("%1 does not say its up axis: %2");
    return words.arg(name, how(taken));
}

/// What it is in the hand's measure, and what was done to it so that it fits.
QString sizeText(double own, double felt) {
    if (lengthText(own) == lengthText(felt)) return ImportBar::tr("%1 across").arg(lengthText(own));
    return ImportBar::tr("%1 across, scaled to %2").arg(lengthText(own), lengthText(felt));
}

} // namespace

ImportBar::ImportBar(QWidget* parent)
    : QWidget(parent), text_(new QLabel), size_(new QLabel), close_(new QToolButton),
      second_(new QBoxLayout(QBoxLayout::LeftToRight)), third_(new QBoxLayout(QBoxLayout::LeftToRight)),
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
                   tr("Take one unit of the file as 1 %1, now and for other files of its format").arg(name)));
    }
    upChoice_ = makeChoice(*ups_, tr("up is"));
    for (const auto& [id, name] : {std::pair(0, QStringLiteral("y")), {1, QStringLiteral("z")}})
        upChoice_->layout()->addWidget(
            choice(*ups_, id, name, QStringLiteral("import-up-") + name,
                   tr("Take the file with %1 up, now and for other files of its format").arg(name)));
    auto* first = new QHBoxLayout;
    first->setSpacing(kRhythm);
    first->addWidget(text_, 1);
    first->addWidget(close_);
    second_->addWidget(unitChoice_, 0, Qt::AlignLeft);
    third_->addWidget(upChoice_, 0, Qt::AlignLeft);
    third_->addWidget(size_, 1, Qt::AlignRight);
    second_->addLayout(third_, 1);
    size_->setMinimumWidth(1); // cut off before a button is
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, kRhythm / 2, kRhythm, kRhythm);
    column->setSpacing(kRhythm / 2);
    column->addLayout(first);
    column->addLayout(second_);
    connect(units_, &QButtonGroup::idClicked, this, [this](int id) {
        choose({kLengthUnits[id].metres, taken_.axes.zUp});
    });
    connect(ups_, &QButtonGroup::idClicked, this, [this](int id) { choose({taken_.axes.unit, id == 1}); });
    connect(close_, &QToolButton::clicked, this, &ImportBar::closed);
    refreshIcons();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // as high as it has to be
    setFocusPolicy(Qt::TabFocus); // where F6 goes; its proxy is the choice that holds
    hide();
}

QWidget* ImportBar::makeChoice(QButtonGroup& group, const QString& label) {
    group.setExclusive(true);
    auto* choice = new QWidget;
    auto* row = new QHBoxLayout(choice);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kRhythm / 2);
    row->addWidget(labels_.emplace_back(new QLabel(label)));
    return choice;
}

void ImportBar::choose(const FileAxes& axes) {
    if (axes == taken_.axes) return;
    taken_.axes = axes; // the next click goes on from here, whether or not the file has been read by then
    emit chosen(axes);
}

void ImportBar::display(const QString& file, const TakenAs& taken, std::optional<double> across) {
    file_ = file;
    taken_ = taken;
    size_->setText(across ? sizeText(taken.across, *across) : tr("is being read"));
    unitChoice_->setVisible(taken.unitOpen);
    upChoice_->setVisible(taken.upOpen);
    const auto unit = std::ranges::find(kLengthUnits, taken.axes.unit, &LengthUnit::metres);
    QAbstractButton* unitNow = units_->button(int(unit - std::begin(kLengthUnits)));
    QAbstractButton* upNow = ups_->button(taken.axes.zUp ? 1 : 0);
    if (unitNow) unitNow->setChecked(true);
    upNow->setChecked(true);
    setFocusProxy(taken.unitOpen && unitNow ? unitNow : upNow);
    const QString name = text_->fontMetrics().elidedText(file, Qt::ElideMiddle, kLongestName);
    setAccessibleName(wordsFor(name, taken));
    fit();
    show();
}

void ImportBar::arrange(bool inOneRow, bool withLabels, const QString& text) {
    second_->setDirection(inOneRow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    second_->setStretchFactor(third_, inOneRow ? 1 : 0);
    third_->setDirection(withLabels ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    second_->setSpacing(inOneRow ? 2 * kRhythm : kRhythm / 2);
    third_->setSpacing(withLabels ? 2 * kRhythm : kRhythm / 2);
    for (QLabel* label : labels_)
        label->setVisible(withLabels);
    text_->setText(text);
    for (const QWidget* choice : {unitChoice_, upChoice_})
        choice->layout()->invalidate();
    layout()->invalidate();
}

/// Words go before buttons do.
void ImportBar::fit() {
    const int room = parentWidget() ? parentWidget()->width() : QWIDGETSIZE_MAX;
    text_->setToolTip({});
    arrange(true, true, accessibleName());
    if (sizeHint().width() <= room) return emit arranged();
    text_->setToolTip(tr("%1: %2").arg(file_, how(taken_)));
    const int words = room - close_->sizeHint().width() - 4 * kRhythm;
    const auto text = text_->fontMetrics().elidedText(text_->toolTip(), Qt::ElideMiddle, std::max(0, words));
    arrange(false, true, text);
    if (sizeHint().width() > room) arrange(false, false, text);
    emit arranged();
}

/// It goes into what there is, and makes nothing wider.
QSize ImportBar::minimumSizeHint() const {
    return {0, QWidget::minimumSizeHint().height()};
}

bool ImportBar::event(QEvent* event) {
    if (event->type() == QEvent::ParentChange && parentWidget()) parentWidget()->installEventFilter(this);
    return QWidget::event(event);
}

bool ImportBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && !isHidden()) fit();
    return QWidget::eventFilter(watched, event);
}

void ImportBar::refreshIcons() {
    close_->setIcon(icon(QStringLiteral("close")));
}

void ImportBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcons();
    QWidget::changeEvent(event);
}

} // namespace tactum
