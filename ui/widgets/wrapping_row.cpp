#include "ui/widgets/wrapping_row.h"

#include <algorithm>

#include <QLabel>

namespace tactum {

WrappingRow::WrappingRow(QWidget* parent) : QLayout(parent) {}

WrappingRow::~WrappingRow() {
    for (QLayoutItem* item : items_)
        delete item;
}

void WrappingRow::addGap() {
    addItem(new QSpacerItem(2 * spacing(), 0));
}

void WrappingRow::addItem(QLayoutItem* item) {
    items_.push_back(item);
    invalidate();
}

QLayoutItem* WrappingRow::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[std::size_t(index)] : nullptr;
}

QLayoutItem* WrappingRow::takeAt(int index) {
    QLayoutItem* item = itemAt(index);
    if (item) items_.erase(items_.begin() + index);
    return item;
}

QSize WrappingRow::sizeOf(const QLayoutItem& item) {
    return item.sizeHint().expandedTo(item.minimumSize()).boundedTo(item.maximumSize());
}

std::vector<WrappingRow::Unit> WrappingRow::units() const {
    std::vector<Unit> all;
    bool goesOn = false;
    for (QLayoutItem* item : items_) {
        if (item->isEmpty() && !item->spacerItem()) continue; // hidden
        if (!goesOn) all.emplace_back();
        Unit& unit = all.back();
        unit.width += sizeOf(*item).width() + (unit.items.empty() ? 0 : spacing());
        unit.items.push_back(item);
        goesOn = item->spacerItem() || qobject_cast<QLabel*>(item->widget());
    }
    return all;
}

int WrappingRow::widthOf(const std::vector<Unit>& row) const {
    int width = 0;
    for (const Unit& unit : row)
        width += unit.width + (width > 0 ? spacing() : 0);
    return width;
}

int WrappingRow::heightOf(const std::vector<Unit>& row) {
    int height = 0;
    for (const Unit& unit : row)
        for (const QLayoutItem* item : unit.items)
            height = std::max(height, sizeOf(*item).height());
    return height;
}

std::vector<std::vector<WrappingRow::Unit>> WrappingRow::rowsIn(int width) const {
    const QMargins margins = contentsMargins();
    const int room = width - margins.left() - margins.right();
    std::vector<std::vector<Unit>> rows;
    const auto place = [&](Unit unit) {
        const bool fits = !rows.empty() && widthOf(rows.back()) + spacing() + unit.width <= room;
        if (!fits) rows.emplace_back();
        rows.back().push_back(std::move(unit));
    };
    for (const Unit& unit : units()) {
        if (unit.width <= room)
            place(unit);
        else // words that leave no room for what follows them
            for (QLayoutItem* item : unit.items)
                place({{item}, std::min(sizeOf(*item).width(), room)});
    }
    return rows;
}

int WrappingRow::heightForWidth(int width) const {
    const QMargins margins = contentsMargins();
    int height = margins.top() + margins.bottom();
    const auto rows = rowsIn(width);
    for (const auto& row : rows)
        height += heightOf(row);
    return height + std::max(int(rows.size()) - 1, 0) * spacing();
}

QSize WrappingRow::sizeHint() const {
    const QMargins margins = contentsMargins();
    const std::vector<Unit> all = units();
    return {widthOf(all) + margins.left() + margins.right(),
            heightOf(all) + margins.top() + margins.bottom()};
}

QSize WrappingRow::minimumSize() const {
    const QMargins margins = contentsMargins();
    int widest = 0;
    for (const Unit& unit : units())
        for (const QLayoutItem* item : unit.items)
            widest = std::max(widest, sizeOf(*item).width());
    return {widest + margins.left() + margins.right(), sizeHint().height()};
}

void WrappingRow::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    const QRect inside = rect.marginsRemoved(contentsMargins());
    int y = inside.top();
    for (const auto& row : rowsIn(rect.width())) {
        const int height = heightOf(row);
        int x = inside.left();
        for (const Unit& unit : row)
            for (QLayoutItem* item : unit.items) {
                const QSize size = sizeOf(*item).boundedTo({inside.width(), QWIDGETSIZE_MAX});
                item->setGeometry({{x, y + (height - size.height()) / 2}, size});
                x += size.width() + spacing();
            }
        y += height + spacing();
    }
}

} // namespace tactum
