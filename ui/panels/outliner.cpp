#include "ui/panels/outliner.h"

#include <algorithm>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/scene/order.h"
#include "ui/base/style.h"
#include "ui/widgets/swatch.h"

namespace tactum {

namespace {

constexpr int kName = 0, kEye = 1, kLock = 2;
constexpr int kObjectRole = Qt::UserRole, kSurfaceRole = Qt::UserRole + 1;

SurfaceRef refOf(const QTreeWidgetItem* item) {
    return {item->data(kName, kObjectRole).toUInt(), item->data(kName, kSurfaceRole).toUInt()};
}

bool isObject(const QTreeWidgetItem* item) {
    return !item->parent();
}

QTreeWidgetItem* makeItem(SurfaceRef ref) {
    auto* item = new QTreeWidgetItem;
    item->setData(kName, kObjectRole, ref.object);
    item->setData(kName, kSurfaceRole, ref.surface);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

QString hintOfNothing() {
    return Outliner::tr(
        "The objects of the scene and their surfaces.\n\nOpen a model (Ctrl+O) or drop one on "
        "the window.");
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
    rebuild();
}

void Outliner::follow(const SceneChange& change) {
    using What = SceneChange::What;
    if (change.what == What::Selection)
        showSelection();
    else if (change.what == What::Everything || change.what == What::Objects ||
             change.what == What::Surfaces || change.what == What::Names || change.what == What::Bodies)
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
              icon(QStringLiteral("eye"), theme().text),
              icon(QStringLiteral("eye-off"), theme().textDimmed),
              icon(QStringLiteral("lock"), theme().text),
              icon(QStringLiteral("lock-open"), theme().border)};
    clear();
    listed_.clear();
    QList<QTreeWidgetItem*> items;
    for (const SceneObject& object : document_.scene().objects) {
        items << addObject(object);
        listed_.push_back({object.id, rowsOf(object)});
    }
    addTopLevelItems(items);
    expandAll();
    showFound();
    showSelection();
}

bool Outliner::hasSameRows(const Scene& scene) const {
    return std::ranges::equal(scene.objects, listed_, [](const SceneObject& object, const Listed& listed) {
        return object.id == listed.id && object.surfaces.size() + 1 == listed.rows.size();
    });
}

void Outliner::refresh() {
    const auto& objects = document_.scene().objects;
    if (!hasSameRows(document_.scene())) return rebuild();
    const QScopedValueRollback quiet(filling_, true);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::vector<Row> rows = rowsOf(objects[i]);
        QTreeWidgetItem* object = topLevelItem(int(i));
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (rows[row] != listed_[i].rows[row])
                fill(row == 0 ? *object : *object->child(int(row) - 1), rows[row]);
        listed_[i].rows = std::move(rows);
    }
    showFound();
    showSelection();
}

void Outliner::search(const QString& words) {
    words_ = words.trimmed();
    showFound();
    setHint(words_.isEmpty() ? hintOfNothing()
                             : tr("Nothing has \u201c%1\u201d in its name.").arg(words_.left(20)));
}

// A surface is shown for its own name and for that of its object.
void Outliner::showFound() {
    const auto show = [](QTreeWidgetItem& item, bool shown) {
        if (item.isHidden() == shown) item.setHidden(!shown); // each change lays all rows out anew
    };
    const auto has = [this](const QTreeWidgetItem& item) {
        return item.text(kName).contains(words_, Qt::CaseInsensitive);
    };
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem& object = *topLevelItem(i);
        const bool whole = has(object);
        bool any = whole;
        for (int child = 0; child < object.childCount(); ++child) {
            const bool found = whole || has(*object.child(child));
            show(*object.child(child), found);
            any = any || found;
        }
        show(object, any);
    }
}

void Outliner::selectFound() {
    SurfaceRefs found;
    for (int i = 0; i < topLevelItemCount(); ++i)
        for (int child = 0; child < topLevelItem(i)->childCount(); ++child)
            if (const QTreeWidgetItem* item = topLevelItem(i)->child(child); !item->isHidden())
                found.push_back(refOf(item));
    document_.select(found);
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
    const bool whole = hasFocus() ? currentItem() == object : allSelected();
    QTreeWidgetItem* row = whole ? item->parent() : item;
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

// What a press selects is known after it, and what it takes along before it.
void Outliner::mousePressEvent(QMouseEvent* event) {
    const std::vector<ObjectId> selected = document_.selectedObjects();
    pressedAt_ = event->position().toPoint();
    const QTreeWidgetItem* item = itemAt(pressedAt_);
    const bool grabs = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier && item &&
                       isObject(item) && columnAt(pressedAt_.x()) == kName;
    const ObjectId object = grabs ? refOf(item).object : 0;
    HintedTree::mousePressEvent(event);
    held_.clear();
    if (!grabs) return;
    held_ = std::ranges::find(selected, object) != selected.end() ? selected : std::vector{object};
}

void Outliner::mouseMoveEvent(QMouseEvent* event) {
    if (held_.empty() || !(event->buttons() & Qt::LeftButton)) return HintedTree::mouseMoveEvent(event);
    const QPoint at = event->position().toPoint();
    if (!gap_ && (at - pressedAt_).manhattanLength() < QApplication::startDragDistance()) return;
    gap_ = gapAt(at.y());
    setCursor(Qt::ClosedHandCursor);
    viewport()->update();
}

void Outliner::mouseReleaseEvent(QMouseEvent* event) {
    const auto held = std::exchange(held_, {});
    const auto gap = std::exchange(gap_, std::nullopt);
    HintedTree::mouseReleaseEvent(event);
    unsetCursor();
    viewport()->update();
    if (!held.empty() && gap) bring(held, *gap);
}

/// The nearest to a height of the view.
int Outliner::gapAt(int y) const {
    for (int gap = 0; gap < topLevelItemCount(); ++gap)
        if (y < (topOf(gap) + topOf(gap + 1)) / 2) return gap;
    return topLevelItemCount();
}

/// Below the last object with its surfaces there is one more.
int Outliner::topOf(int gap) const {
    if (gap < topLevelItemCount()) return visualItemRect(topLevelItem(gap)).top();
    const QTreeWidgetItem* last = topLevelItem(topLevelItemCount() - 1);
    if (last->isExpanded() && last->childCount() > 0) last = last->child(last->childCount() - 1);
    return visualItemRect(last).bottom();
}

void Outliner::bring(const std::vector<ObjectId>& objects, int gap) {
    const auto& all = document_.scene().objects;
    const ObjectId before = std::size_t(gap) < all.size() ? all[std::size_t(gap)].id : 0;
    document_.editScene(tr("Another order"), SceneChange::What::Objects,
                        [&](Scene& scene) { reorder(scene, objects, before); });
    document_.selectObjects(objects);
}

void Outliner::paintEvent(QPaintEvent* event) {
    HintedTree::paintEvent(event);
    if (!gap_ || topLevelItemCount() == 0) return;
    QPainter painter(viewport());
    painter.fillRect(QRect(0, topOf(*gap_) - 1, viewport()->width(), 2), theme().accent);
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
    auto* item = makeItem({object.id, 0});
    fill(*item, rows.front());
    for (Index i = 0; i < object.surfaces.size(); ++i) {
        auto* child = makeItem({object.id, i});
        item->addChild(child);
        fill(*child, rows[i + 1]);
    }
    return item;
}

/// Null when it is not listed. Where objects stand is asked of the list, not of their numbers.
QTreeWidgetItem* Outliner::itemOf(SurfaceRef ref) const {
    const auto at = std::ranges::find(listed_, ref.object, &Listed::id);
    if (at == listed_.end()) return nullptr;
    return topLevelItem(int(at - listed_.begin()))->child(int(ref.surface));
}

// In one step, for each is told to all who listen. An object is shown as selected when all its surfaces are.
void Outliner::showSelection() {
    if (choosing_) return;
    const QScopedValueRollback quiet(filling_, true);
    const SurfaceSet selected(document_.selected());
    const auto active = document_.selection();
    QItemSelection rows;
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* object = topLevelItem(i);
        for (int child = 0; child < object->childCount(); ++child) {
            QTreeWidgetItem* item = object->child(child);
            if (!selected.has(refOf(item))) continue;
            const QModelIndex from = indexFromItem(item, kName);
            rows.append(QItemSelectionRange(from, from.siblingAtColumn(kLock)));
        }
    }
    QTreeWidgetItem* current = active ? itemOf(*active) : nullptr;
    setCurrentItem(current, kName, QItemSelectionModel::NoUpdate);
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
}

/// The surface of the current row is the active one; an object stands for all of its surfaces.
void Outliner::selectChosen() {
    if (filling_) return;
    SurfaceRefs chosen;
    SurfaceSet seen;
    const auto add = [&](const QTreeWidgetItem* item) {
        if (seen.add(refOf(item))) chosen.push_back(refOf(item));
    };
    const auto addRow = [&](const QTreeWidgetItem* item) {
        if (!isObject(item)) return add(item);
        for (int i = item->childCount(); i-- > 0;)
            add(item->child(i));
    };
    for (const QTreeWidgetItem* item : selectedItems())
        if (item != currentItem()) addRow(item);
    if (currentItem() && currentItem()->isSelected()) {
        const QTreeWidgetItem* current = currentItem();
        std::erase_if(chosen, [&](SurfaceRef ref) { return !isObject(current) && ref == refOf(current); });
        seen = SurfaceSet(chosen);
        addRow(current);
    }
    const QScopedValueRollback quiet(choosing_, true);
    document_.select(chosen);
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
    // Later: the edit rebuilds the tree, and with it the item that is speaking now.
    auto apply = [this, ref, name, object] {
        if (name.isEmpty())
            rebuild(); // takes the typed text back
        else if (object)
            document_.renameObject(ref.object, name);
        else
            document_.renameSurface(ref, name);
    };
    QMetaObject::invokeMethod(this, apply, Qt::QueuedConnection);
}

// Later, for the edit rebuilds the tree.
void Outliner::toggle(QTreeWidgetItem* item, int column) {
    const SurfaceRef ref = refOf(item);
    const bool object = isObject(item);
    if (column != kEye && (column != kLock || object)) return;
    const auto apply = [this, ref, object, column] {
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
