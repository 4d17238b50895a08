#include "ui/panels/outliner.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/scene/groups.h"
#include "ui/base/style.h"
#include "ui/panels/outliner_rows.h"
#include "ui/widgets/swatch.h"

namespace tactum {

namespace {

QTreeWidgetItem* makeItem(SurfaceRef ref, Kind kind) {
    auto* item = new QTreeWidgetItem;
    item->setData(kName, kKindRole, kind);
    item->setData(kName, kObjectRole, ref.object);
    item->setData(kName, kSurfaceRole, ref.surface);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

QString hintOfNothing() {
    return Outliner::tr(
        "The objects of the scene and their surfaces.\n\nOpen a model (Ctrl+O), add one or a simple "
        "form (File > Add), or drop one on the window.");
}

} // namespace

Outliner::Outliner(Document& document, QWidget* parent)
    : HintedTree(hintOfNothing(), parent), document_(document) {
    setObjectName(QStringLiteral("outliner"));
    setAccessibleName(tr("Outliner"));
    setColumnCount(3);
    setSelectionMode(ExtendedSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    header()->setSectionResizeMode(kEye, QHeaderView::Fixed);
    header()->resizeSection(kEye, 3 * kRhythm);
    header()->setSectionResizeMode(kLock, QHeaderView::Fixed);
    header()->resizeSection(kLock, 3 * kRhythm);
    header()->setStretchLastSection(false);
    connect(&document_, &Document::changed, this, &Outliner::follow);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &Outliner::selectChosen);
    connect(this, &QTreeWidget::itemChanged, this, &Outliner::rename);
    connect(this, &QTreeWidget::itemClicked, this, &Outliner::toggle);
    connect(this, &QTreeWidget::itemCollapsed, this, [this](const QTreeWidgetItem* item) {
        if (filling_) return;
        if (kindOf(item) == kGroup) folded_.insert(groupOf(item));
        if (isObject(item)) foldedObjects_.insert(refOf(item).object);
    });
    connect(this, &QTreeWidget::itemExpanded, this, [this](const QTreeWidgetItem* item) {
        if (filling_) return;
        if (kindOf(item) == kGroup) folded_.erase(groupOf(item));
        if (isObject(item)) foldedObjects_.erase(refOf(item).object);
    });
    connect(&document_, &Document::opened, this, [this] {
        folded_.clear(), foldedObjects_.clear();
        rebuild();
    });
    rebuild();
}

void Outliner::follow(const SceneChange& change) {
    using What = SceneChange::What;
    if (change.what == What::Selection)
        showSelection();
    else if (change.what == What::Everything || change.what == What::Objects ||
             change.what == What::Surfaces || change.what == What::Names || change.what == What::Bodies ||
             change.what == What::Material) // for its colour
        refresh();
}

void Outliner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) rebuild();
    HintedTree::changeEvent(event);
}

void Outliner::rebuild() {
    const QScopedValueRollback quiet(filling_, true);
    const auto dimmed = [](const char* name) { return icon(QLatin1String(name), theme().textDimmed); };
    icons_ = {{dimmed("object"), dimmed("body-keys"), dimmed("body-loose"), dimmed("body-joint")},
              dimmed("group"),
              icon(QStringLiteral("eye"), theme().text),
              icon(QStringLiteral("eye-off"), theme().textDimmed),
              icon(QStringLiteral("lock"), theme().text),
              icon(QStringLiteral("lock-open"), theme().border)};
    clear();
    listed_.clear();
    groups_.clear();
    QList<QTreeWidgetItem*> items;
    for (const SceneObject& object : document_.scene().objects) {
        QTreeWidgetItem* item = addObject(object);
        listed_.push_back({object.id, object.group, rowsOf(object), item});
        if (object.group.empty())
            items << item;
        else
            groupItem(object.group, items)->addChild(item);
    }
    addTopLevelItems(items);
    refreshGroups();
    expandAll();
    foldAgain();
    showFound();
    showSelection();
}

QTreeWidgetItem* Outliner::groupItem(const std::string& name, QList<QTreeWidgetItem*>& items) {
    const auto [known, isNew] = groups_.try_emplace(name);
    if (!isNew) return known->second;
    known->second = makeItem({}, kGroup);
    known->second->setData(kName, kGroupRole, QString::fromStdString(name));
    return items.emplace_back(known->second);
}

/// But for what is searched for.
void Outliner::foldAgain() {
    const auto fold = [this](QTreeWidgetItem* item, bool folded) {
        if (const bool open = !words_.isEmpty() || !folded; item->isExpanded() != open)
            item->setExpanded(open);
    };
    for (const auto& [name, item] : groups_)
        fold(item, folded_.contains(name));
    for (const Listed& each : listed_)
        fold(each.item, foldedObjects_.contains(each.id));
}

/// A group is visible as long as anything of it is.
void Outliner::refreshGroups() {
    std::map<std::string, bool> visible;
    for (const Listed& each : listed_)
        if (!each.group.empty()) visible[each.group] |= each.rows.front().visible;
    for (const auto& [name, item] : groups_) {
        item->setText(kName, QString::fromStdString(name));
        item->setIcon(kName, icons_.group);
        item->setToolTip(kName, tr("a group"));
        item->setData(kName, Qt::AccessibleDescriptionRole, tr("a group"));
        showEye(*item, visible[name], visible[name]);
    }
}

bool Outliner::hasSameRows(const Scene& scene) const {
    return std::ranges::equal(scene.objects, listed_, [](const SceneObject& object, const Listed& listed) {
        return object.id == listed.id && object.group == listed.group &&
               object.surfaces.size() + 1 == listed.rows.size();
    });
}

void Outliner::refresh() {
    const auto& objects = document_.scene().objects;
    if (!hasSameRows(document_.scene())) return rebuild();
    const QScopedValueRollback quiet(filling_, true);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::vector<Row> rows = rowsOf(objects[i]);
        QTreeWidgetItem* object = listed_[i].item;
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (rows[row] != listed_[i].rows[row])
                fill(row == 0 ? *object : *object->child(int(row) - 1), rows[row]);
        listed_[i].rows = std::move(rows);
    }
    refreshGroups();
    showFound();
    showSelection();
}

void Outliner::search(const QString& words) {
    words_ = words.trimmed();
    showFound();
    setHint(words_.isEmpty() ? hintOfNothing()
                             : tr("Nothing has \u201c%1\u201d in its name.").arg(words_.left(20)));
}

// A row is shown for its own name, for one above it, and for what is found below it.
void Outliner::showFound() {
    const QScopedValueRollback quiet(filling_, true);
    foldAgain();
    for (int i = 0; i < topLevelItemCount(); ++i)
        showFoundIn(*topLevelItem(i), false);
}

/// `above`: whether a row above it has the words. Whether it is shown.
bool Outliner::showFoundIn(QTreeWidgetItem& row, bool above) {
    const bool whole = above || row.text(kName).contains(words_, Qt::CaseInsensitive);
    bool any = whole;
    for (int child = 0; child < row.childCount(); ++child)
        any = showFoundIn(*row.child(child), whole) || any;
    if (row.isHidden() == any) row.setHidden(!any); // each change lays all rows out anew
    return any;
}

void Outliner::selectFound() {
    SurfaceRefs found;
    for (const Listed& each : listed_)
        for (int child = 0; child < each.item->childCount(); ++child)
            if (const QTreeWidgetItem* item = each.item->child(child); !item->isHidden())
                found.push_back(refOf(item));
    document_.select(found);
}

/// In the order of the list.
std::vector<ObjectId> Outliner::objectsOf(const QTreeWidgetItem* row) const {
    return kindOf(row) == kGroup ? objectsOfGroup(document_.scene(), groupOf(row))
                                 : std::vector{refOf(row).object};
}

void Outliner::renameSelected() {
    const auto active = document_.selection();
    QTreeWidgetItem* item = active ? itemOf(*active) : nullptr;
    const QTreeWidgetItem* object = item ? item->parent() : nullptr;
    if (!item) return;
    // In the list what has the frame; from elsewhere the object, where all of it is selected.
    const auto allSelected = [object] {
        for (int child = 0; child < object->childCount(); ++child)
            if (!object->child(child)->isSelected()) return false;
        return true;
    };
    const bool whole = hasFocus() ? currentItem() == object : object->isSelected() || allSelected();
    QTreeWidgetItem* row = whole ? item->parent() : item;
    const auto chosen = document_.selectedObjects();
    const auto group = groups_.find(document_.scene().find(active->object)->group);
    const bool isGroup = group != groups_.end() && chosen.size() > 1 && chosen == objectsOf(group->second);
    if (isGroup && (!hasFocus() || !currentItem() || kindOf(currentItem()) == kGroup)) row = group->second;
    for (QWidget* around = parentWidget(); around; around = around->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(around)) {
            dock->show();
            dock->raise();
        }
    setFocus(Qt::ShortcutFocusReason);
    scrollToItem(row);
    editItem(row, kName);
}

void Outliner::contextMenuEvent(QContextMenuEvent* event) {
    emit menuAsked(event->globalPos());
}

std::vector<Outliner::Row> Outliner::rowsOf(const SceneObject& object) const {
    std::vector<Row> rows{{object.name, object.visible, object.visible}};
    rows.front().moves = movesOf(document_.scene(), object);
    for (const Surface& each : object.surfaces)
        rows.push_back({each.name, each.visible, object.visible && each.visible, each.locked, each.colour});
    return rows;
}

void Outliner::fill(QTreeWidgetItem& item, const Row& row) {
    item.setText(kName, QString::fromStdString(row.name));
    if (isObject(&item))
        showMoves(item, row.moves);
    else
        item.setIcon(kName, swatchIcon(row.colour));
    showEye(item, row.visible, row.shown);
    if (!isObject(&item)) showLock(item, row.locked);
}

QTreeWidgetItem* Outliner::addObject(const SceneObject& object) {
    const std::vector<Row> rows = rowsOf(object);
    auto* item = makeItem({object.id, 0}, kObject);
    fill(*item, rows.front());
    for (Index i = 0; i < object.surfaces.size(); ++i) {
        auto* child = makeItem({object.id, i}, kSurface);
        item->addChild(child);
        fill(*child, rows[i + 1]);
    }
    return item;
}

/// Null when it is not listed. Where objects stand is asked of the list, not of their numbers.
QTreeWidgetItem* Outliner::itemOf(SurfaceRef ref) const {
    const auto at = std::ranges::find(listed_, ref.object, &Listed::id);
    if (at == listed_.end()) return nullptr;
    return at->item->child(int(ref.surface));
}

void Outliner::showMoves(QTreeWidgetItem& item, Moves moves) {
    const std::array<QString, 4> words{tr("stands still"), tr("moves by its keys"), tr("a loose body"),
                                       tr("a body on joints")};
    item.setIcon(kName, icons_.object[std::size_t(moves)]);
    item.setToolTip(kName, words[std::size_t(moves)]);
    item.setData(kName, Qt::AccessibleDescriptionRole, words[std::size_t(moves)]);
}

void Outliner::showEye(QTreeWidgetItem& item, bool visible, bool shown) {
    item.setIcon(kEye, visible ? icons_.eye : icons_.eyeOff);
    item.setToolTip(kEye,
                    visible ? tr("Hide: it is neither seen nor felt (H)") : tr("Show (Alt+H shows all)"));
    item.setData(kEye, Qt::AccessibleTextRole, visible ? tr("visible") : tr("hidden"));
    item.setData(kName, Qt::ForegroundRole, shown ? QVariant() : QVariant(QBrush(theme().textDimmed)));
}

void Outliner::showLock(QTreeWidgetItem& item, bool locked) {
    item.setIcon(kLock, locked ? icons_.lock : icons_.lockOpen);
    item.setToolTip(kLock, locked ? tr("Unlock: let it be edited again (L)")
                                  : tr("Lock: no edit changes how it feels or which triangles it has (L)"));
    item.setData(kLock, Qt::AccessibleTextRole, locked ? tr("locked") : tr("not locked"));
}

void Outliner::rename(QTreeWidgetItem* item) {
    if (filling_) return;
    const SurfaceRef ref = refOf(item);
    const QString name = item->text(kName).trimmed();
    const bool object = isObject(item);
    const std::string group = groupOf(item);
    // Later: the edit rebuilds the tree, and with it the item that is speaking now.
    auto apply = [this, ref, name, object, group] {
        if (name.isEmpty())
            rebuild(); // takes the typed text back
        else if (!group.empty())
            renameGroup(group, name);
        else if (object)
            document_.renameObject(ref.object, name);
        else
            document_.renameSurface(ref, name);
    };
    QMetaObject::invokeMethod(this, apply, Qt::QueuedConnection);
}

/// It stays folded as it was, and chosen.
void Outliner::renameGroup(const std::string& group, const QString& name) {
    const std::vector<ObjectId> objects = objectsOfGroup(document_.scene(), group);
    if (objects.empty()) return;
    const bool folded = folded_.contains(group);
    if (folded) folded_.insert(freeGroupName(document_.scene(), name.toStdString()));
    document_.renameGroup(group, name);
    rebuild(); // another name may be there already, and a free one is taken
    if (const auto now = groups_.find(document_.scene().find(objects.front())->group); now != groups_.end())
        setCurrentItem(now->second, kName, QItemSelectionModel::NoUpdate);
}

// Later, for the edit rebuilds the tree.
void Outliner::toggle(QTreeWidgetItem* item, int column) {
    const SurfaceRef ref = refOf(item);
    const bool object = isObject(item);
    const std::string group = groupOf(item);
    if (column != kEye && (column != kLock || kindOf(item) != kSurface)) return;
    const auto apply = [this, ref, object, column, group] {
        if (!group.empty()) {
            const bool visible = std::ranges::any_of(document_.scene().objects, [&](const SceneObject& each) {
                return each.group == group && each.visible;
            });
            return document_.setGroupVisible(group, !visible);
        }
        const Surface* surface = document_.surface(ref);
        const SceneObject* of = document_.scene().find(ref.object);
        if (!of || (!object && !surface)) return;
        if (column == kLock)
            document_.setLocked(ref, !surface->locked);
        else if (object)
            document_.setVisible(ref.object, !of->visible);
        else
            document_.setSurfacesVisible(ref, !surface->visible);
    };
    QMetaObject::invokeMethod(this, apply, Qt::QueuedConnection);
}

QWidget* searchable(Outliner& outliner) {
    auto* field = new QLineEdit;
    field->setObjectName(QStringLiteral("outliner-search"));
    field->setPlaceholderText(Outliner::tr("Search the scene"));
    field->setAccessibleName(Outliner::tr("Search in the scene"));
    field->setToolTip(Outliner::tr("Only objects and surfaces with this in their names; Enter selects them"));
    field->setClearButtonEnabled(true);
    QObject::connect(field, &QLineEdit::textChanged, &outliner, &Outliner::search);
    QObject::connect(field, &QLineEdit::returnPressed, &outliner, &Outliner::selectFound);
    auto* escape = new QShortcut(Qt::Key_Escape, field, nullptr, nullptr, Qt::WidgetShortcut);
    QObject::connect(escape, &QShortcut::activated, field, &QLineEdit::clear);
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* top = new QHBoxLayout; // as over the presets
    top->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    top->addWidget(field);
    column->addLayout(top);
    column->addWidget(&outliner);
    both->setFocusProxy(&outliner);
    return both;
}

} // namespace tactum
