#include "ui/widgets/picture_grid.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QKeyEvent>
#include <QScrollBar>
#include <QSettings>

#include "ui/base/style.h"
#include "ui/widgets/edit_keys.h"
#include "ui/widgets/hinted_tree.h"
#include "ui/widgets/picture_cell.h"

namespace tactum {

namespace {

constexpr int kLeastCell = 8 * kRhythm;

} // namespace

PictureGrid::PictureGrid(const QString& settings, const QString& hint, QWidget* parent)
    : QListWidget(parent), settings_(QStringLiteral("folded/") + settings), hint_(hint) {
    const QStringList kept = QSettings().value(settings_).toStringList();
    folded_ = QSet<QString>(kept.begin(), kept.end());
    // Rows of a list that wraps, and not icons: a heading takes a row of its own there.
    setFlow(LeftToRight);
    setWrapping(true);
    setResizeMode(Adjust);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // else the columns depend on it, and it on the columns
    setMouseTracking(true);
    setEditTriggers(NoEditTriggers);
    setItemDelegate(new PictureCell(this));
    verticalScrollBar()->setSingleStep(3 * kRhythm);
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (!isHeading(item)) emit pictureActivated(item);
    });
    connect(this, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item && item->isHidden()) setFolded(headingOf(item), false); // by its letters, or from outside
    });
}

void PictureGrid::beginGroup(const QString& key, const QString& title) {
    auto* heading = new QListWidgetItem(this);
    heading->setData(PictureCell::kKeyRole, key);
    heading->setData(PictureCell::kTitleRole, title); // no text: letters lead to pictures
    heading->setData(Qt::AccessibleTextRole, title);
    heading->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    showFolds();
}

QListWidgetItem* PictureGrid::add(const QString& name, const QPixmap& picture) {
    auto* item = new QListWidgetItem(name, this);
    item->setData(Qt::DecorationRole, picture);
    const QListWidgetItem* heading = headingOf(item);
    item->setHidden(heading && isFolded(heading));
    return item;
}

void PictureGrid::setAllOpen(bool open) {
    if (std::exchange(allOpen_, open) != open) showFolds();
}

bool PictureGrid::isHeading(const QListWidgetItem* item) {
    return item && item->data(PictureCell::kKeyRole).isValid();
}

QList<QListWidgetItem*> PictureGrid::pictures() const {
    QList<QListWidgetItem*> found;
    for (int i = 0; i < count(); ++i)
        if (!isHeading(item(i))) found << item(i);
    return found;
}

QList<QListWidgetItem*> PictureGrid::headings() const {
    QList<QListWidgetItem*> found;
    for (int i = 0; i < count(); ++i)
        if (isHeading(item(i))) found << item(i);
    return found;
}

QListWidgetItem* PictureGrid::headingOf(const QListWidgetItem* of) const {
    int i = row(of);
    while (i >= 0 && !isHeading(item(i)))
        --i;
    return i < 0 ? nullptr : item(i);
}

bool PictureGrid::isFolded(const QListWidgetItem* heading) const {
    return !allOpen_ && folded_.contains(heading->data(PictureCell::kKeyRole).toString());
}

void PictureGrid::setFolded(QListWidgetItem* heading, bool folded) {
    if (!heading || allOpen_ || isFolded(heading) == folded) return;
    const QString key = heading->data(PictureCell::kKeyRole).toString();
    folded ? void(folded_.insert(key)) : void(folded_.remove(key));
    QSettings().setValue(settings_, QStringList(folded_.begin(), folded_.end()));
    if (folded && currentItem() && headingOf(currentItem()) == heading) setCurrentItem(heading);
    showFolds();
}

void PictureGrid::showFolds() {
    bool folded = false;
    for (int i = 0; i < count(); ++i) {
        QListWidgetItem* each = item(i);
        if (!isHeading(each)) {
            each->setHidden(folded);
            continue;
        }
        folded = isFolded(each);
        each->setData(Qt::AccessibleDescriptionRole, folded ? tr("folded") : tr("unfolded"));
    }
}

int PictureGrid::cellWidth() const {
    const int room = std::max(kLeastCell, maximumViewportSize().width() - 1);
    return room / std::max(1, room / kLeastCell);
}

QModelIndex PictureGrid::nextSeen(int step) const {
    for (int i = currentRow() + step; i >= 0 && i < count(); i += step)
        if (!item(i)->isHidden()) return indexFromItem(item(i));
    return currentIndex();
}

/// The row of cells above or below, and in it what is nearest to the column that the person keeps to.
QModelIndex PictureGrid::nextRow(int step) {
    const QRect from = visualItemRect(currentItem());
    if (!isHeading(currentItem())) column_ = from.center().x();
    std::optional<int> top;
    QListWidgetItem* nearest = currentItem();
    int least = width();
    for (int i = currentRow() + step; i >= 0 && i < count(); i += step) {
        const QRect place = visualItemRect(item(i));
        if (item(i)->isHidden() || place.top() == from.top()) continue;
        if (!top) top = place.top();
        if (place.top() != *top) break;
        const int away = std::abs(place.center().x() - column_);
        if (away < least || nearest == currentItem()) {
            least = away;
            nearest = item(i);
        }
    }
    return indexFromItem(nearest);
}

QModelIndex PictureGrid::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
    if (!currentItem()) return nextSeen(1); // the first
    switch (action) {
    case MoveLeft:
    case MovePrevious:
        return nextSeen(-1);
    case MoveRight:
    case MoveNext:
        return nextSeen(1);
    case MoveUp:
        return nextRow(-1);
    case MoveDown:
        return nextRow(1);
    default:
        return QListWidget::moveCursor(action, modifiers);
    }
}

bool PictureGrid::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool isLetter = !key.text().isEmpty() && key.text().front().isLetterOrNumber() &&
                              !(key.modifiers() & ~Qt::ShiftModifier);
        if (ownActionOf(*this, key) || isEditKey(key) || (typesAhead_ && isLetter)) event->accept();
    }
    return QListWidget::event(event);
}

void PictureGrid::focusInEvent(QFocusEvent* event) {
    const Qt::FocusReason by = event->reason();
    if (by == Qt::MouseFocusReason)
        typesAhead_ = false;
    else if (by == Qt::TabFocusReason || by == Qt::BacktabFocusReason || by == Qt::OtherFocusReason)
        typesAhead_ = true;
    QListWidget::focusInEvent(event);
}

void PictureGrid::keyPressEvent(QKeyEvent* event) {
    if (QAction* own = ownActionOf(*this, *event)) return own->trigger(); // nothing while it is off
    QListWidgetItem* heading = isHeading(currentItem()) ? currentItem() : nullptr;
    const int key = event->key();
    if (heading && (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space))
        return setFolded(heading, !isFolded(heading));
    if (heading &&
        ((key == Qt::Key_Left && !isFolded(heading)) || (key == Qt::Key_Right && isFolded(heading))))
        return setFolded(heading, key == Qt::Key_Left);
    QListWidget::keyPressEvent(event);
}

void PictureGrid::mousePressEvent(QMouseEvent* event) {
    typesAhead_ = false;
    QListWidget::mousePressEvent(event);
    QListWidgetItem* at = itemAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && isHeading(at)) setFolded(at, !isFolded(at));
}

void PictureGrid::paintEvent(QPaintEvent* event) {
    QListWidget::paintEvent(event);
    if (count() == 0) paintHint(*viewport(), hint_);
}

void PictureGrid::changeEvent(QEvent* event) {
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        scheduleDelayedItemsLayout();
}

} // namespace tactum
