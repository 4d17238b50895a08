// What is done in the outliner by the mouse: rows that are dragged, and what is selected by rows.
#include <algorithm>

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>

#include "core/scene/groups.h"
#include "core/scene/order.h"
#include "ui/base/style.h"
#include "ui/panels/outliner.h"
#include "ui/panels/outliner_rows.h"

namespace tactum {

// What a press selects is known after it, and what it takes along before it.
void Outliner::mousePressEvent(QMouseEvent* event) {
    const std::vector<ObjectId> selected = document_.selectedObjects();
    pressedAt_ = event->position().toPoint();
    const QTreeWidgetItem* item = itemAt(pressedAt_);
    const bool grabs = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier && item &&
                       kindOf(item) != kSurface && columnAt(pressedAt_.x()) == kName;
    std::vector<ObjectId> grabbed;
    std::set<std::string> groups;
    if (grabs) {
        grabbed = objectsOf(item);
        if (kindOf(item) == kGroup) groups.insert(groupOf(item));
        const bool more = std::ranges::all_of(
            grabbed, [&](ObjectId id) { return std::ranges::find(selected, id) != selected.end(); });
        for (const QTreeWidgetItem* row : selectedItems())
            if (more && kindOf(row) == kGroup) groups.insert(groupOf(row));
        if (more) grabbed = selected;
    }
    HintedTree::mousePressEvent(event);
    held_ = std::move(grabbed), heldGroups_ = std::move(groups);
}

void Outliner::mouseMoveEvent(QMouseEvent* event) {
    if (held_.empty() || !(event->buttons() & Qt::LeftButton)) return HintedTree::mouseMoveEvent(event);
    const QPoint at = event->position().toPoint();
    if (!gap_ && (at - pressedAt_).manhattanLength() < QApplication::startDragDistance()) return;
    gap_ = gapAt(at);
    setCursor(Qt::ClosedHandCursor);
    viewport()->update();
}

void Outliner::mouseReleaseEvent(QMouseEvent* event) {
    const auto held = std::exchange(held_, {});
    const auto groups = std::exchange(heldGroups_, {});
    const auto gap = std::exchange(gap_, std::nullopt);
    HintedTree::mouseReleaseEvent(event);
    unsetCursor();
    viewport()->update();
    if (!held.empty() && gap) bring(held, groups, *gap);
}

/// From above to below. Between the last of a group and what follows is out of it.
std::vector<Outliner::Gap> Outliner::gaps() const {
    std::vector<Gap> all;
    int bottom = 0;
    const auto topOf = [&](const QTreeWidgetItem* item) {
        bottom = std::max(bottom, visualItemRect(item).bottom());
        return visualItemRect(item).top();
    };
    std::string last;
    for (const Listed& each : listed_) {
        const QTreeWidgetItem* group = each.group.empty() ? nullptr : groups_.at(each.group);
        if (group && each.group != last && !group->isHidden()) all.push_back({each.id, {}, topOf(group)});
        last = each.group;
        if (each.item->isHidden() || (group && !group->isExpanded())) continue;
        all.push_back({each.id, each.group, topOf(each.item)});
        if (const int surfaces = each.item->childCount(); each.item->isExpanded() && surfaces > 0)
            topOf(each.item->child(surfaces - 1));
    }
    if (!all.empty()) all.push_back({0, {}, bottom});
    return all;
}

/// The nearest, or on the row of a group, where that comes last in it.
std::optional<Outliner::Gap> Outliner::gapAt(QPoint at) const {
    if (const QTreeWidgetItem* item = itemAt(at); item && kindOf(item) == kGroup) {
        const QRect row = visualItemRect(item);
        const std::string group = groupOf(item);
        const auto last = std::ranges::find(listed_.rbegin(), listed_.rend(), group, &Listed::group);
        const auto behind = last.base();
        if (4 * std::abs(at.y() - row.center().y()) < row.height())
            return Gap{behind == listed_.end() ? 0 : behind->id, group, row.top(), item};
    }
    const std::vector<Gap> all = gaps();
    const auto nearest =
        std::ranges::min_element(all, {}, [&](const Gap& gap) { return std::abs(gap.y - at.y()); });
    return nearest == all.end() ? std::nullopt : std::optional(*nearest);
}

/// What is not held by the row of its group leaves that.
void Outliner::bring(const std::vector<ObjectId>& objects, const std::set<std::string>& groups,
                     const Gap& gap) {
    document_.editOrder(tr("Another order"), [&](Scene& scene) {
        std::vector<ObjectId> goes;
        for (const ObjectId id : objects)
            if (!gap.group.empty() || !groups.contains(scene.find(id)->group)) goes.push_back(id);
        reorder(scene, objects, gap.before);
        putInGroup(scene, goes, gap.group);
    });
    document_.selectObjects(objects);
}

void Outliner::paintEvent(QPaintEvent* event) {
    HintedTree::paintEvent(event);
    if (!gap_) return;
    QPainter painter(viewport());
    if (gap_->onto) {
        painter.setPen(QPen(theme().accent, 2));
        painter.drawRect(visualItemRect(gap_->onto).adjusted(1, 1, -1, -1));
        return;
    }
    const int left = gap_->group.empty() ? 0 : 2 * indentation();
    painter.fillRect(QRect(left, gap_->y - 1, viewport()->width() - left, 2), theme().accent);
}

// In one step, for each is told to all who listen.
void Outliner::showSelection() {
    if (choosing_) return;
    const QScopedValueRollback quiet(filling_, true);
    const SurfaceSet selected(document_.selected());
    const auto active = document_.selection();
    QItemSelection rows;
    std::set<ObjectId> inWholes;
    QTreeWidgetItem* current = active ? itemOf(*active) : nullptr;
    const auto add = [&](QTreeWidgetItem* item) {
        const QModelIndex from = indexFromItem(item, kName);
        rows.append(QItemSelectionRange(from, from.siblingAtColumn(kLock)));
    };
    for (QTreeWidgetItem* whole : chosenWholes(selected)) {
        add(whole);
        if (active && std::ranges::count(objectsOf(whole), active->object)) current = whole;
        for (const ObjectId id : objectsOf(whole))
            inWholes.insert(id);
    }
    for (const Listed& each : listed_)
        for (int child = 0; child < each.item->childCount() && !inWholes.contains(each.id); ++child)
            if (selected.has(refOf(each.item->child(child)))) add(each.item->child(child));
    setCurrentItem(current, kName, QItemSelectionModel::NoUpdate);
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

/// Rows of objects and groups that the person chose, as long as all that is in them is selected.
std::vector<QTreeWidgetItem*> Outliner::chosenWholes(const SurfaceSet& selected) const {
    const auto all = [&](const QTreeWidgetItem* object) {
        for (int child = 0; child < object->childCount(); ++child)
            if (!selected.has(refOf(object->child(child)))) return false;
        return object->childCount() > 0;
    };
    std::map<QTreeWidgetItem*, bool> wholeGroups;
    std::vector<QTreeWidgetItem*> wholes;
    for (const Listed& each : listed_) {
        const bool whole = all(each.item);
        if (whole && chosenObjects_.contains(each.id)) wholes.push_back(each.item);
        if (!chosenGroups_.contains(each.group)) continue;
        const auto group = wholeGroups.try_emplace(groups_.at(each.group), true).first;
        group->second = group->second && whole;
    }
    for (const auto& [row, whole] : wholeGroups)
        if (whole) wholes.push_back(row);
    return wholes;
}

/// The surface of the current row is the active one; an object stands for all of its surfaces.
void Outliner::selectChosen() {
    if (filling_) return;
    SurfaceRefs chosen;
    SurfaceSet seen;
    const auto add = [&](const QTreeWidgetItem* item) {
        if (seen.add(refOf(item))) chosen.push_back(refOf(item));
    };
    const auto addObject = [&](const QTreeWidgetItem* item) {
        for (int i = item->childCount(); i-- > 0;)
            add(item->child(i));
    };
    const auto addRow = [&](const QTreeWidgetItem* item) {
        if (kindOf(item) == kSurface) return add(item);
        if (isObject(item)) return addObject(item);
        for (int i = item->childCount(); i-- > 0;)
            addObject(item->child(i));
    };
    chosenObjects_.clear();
    chosenGroups_.clear();
    for (const QTreeWidgetItem* item : selectedItems()) {
        if (isObject(item)) chosenObjects_.insert(refOf(item).object);
        if (kindOf(item) == kGroup) chosenGroups_.insert(groupOf(item));
        if (item != currentItem()) addRow(item);
    }
    if (currentItem() && currentItem()->isSelected()) {
        const QTreeWidgetItem* current = currentItem();
        std::erase_if(chosen,
                      [&](SurfaceRef ref) { return kindOf(current) == kSurface && ref == refOf(current); });
        seen = SurfaceSet(chosen);
        addRow(current);
    }
    const QScopedValueRollback quiet(choosing_, true);
    document_.select(chosen);
}

} // namespace tactum
