#include "ui/panels/outliner.h"

#include <algorithm>

#include <QEvent>
#include <QHeaderView>
#include <QScopedValueRollback>

#include "ui/panels/swatch.h"
#include "ui/style.h"

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

QTreeWidgetItem* makeItem(const std::string& name, SurfaceRef ref) {
    auto* item = new QTreeWidgetItem({QString::fromStdString(name), QString()});
    item->setData(kName, kObjectRole, ref.object);
    item->setData(kName, kSurfaceRole, ref.surface);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

} // namespace

Outliner::Outliner(Document& document, QWidget* parent)
    : HintedTree(tr("The objects of the scene and their surfaces.\n\nOpen a model (Ctrl+O) or drop one on "
                    "the window."),
                 parent),
      document_(document) {
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
             change.what == What::Surfaces || change.what == What::Names)
        rebuild();
}

void Outliner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) rebuild();
    HintedTree::changeEvent(event);
}

void Outliner::rebuild() {
    const QScopedValueRollback quiet(filling_, true);
    clear();
    for (const SceneObject& object : document_.scene().objects)
        addTopLevelItem(addObject(object));
    expandAll();
    showSelection();
}

QTreeWidgetItem* Outliner::addObject(const SceneObject& object) {
    auto* item = makeItem(object.name, {object.id, 0});
    item->setIcon(kName, icon(QStringLiteral("object"), theme().textDimmed));
    showEye(*item, object.visible, object.visible);
    for (Index i = 0; i < object.surfaces.size(); ++i) {
        const Surface& surface = object.surfaces[i];
        auto* child = makeItem(surface.name, {object.id, i});
        child->setIcon(kName, swatch(surface.colour));
        showEye(*child, surface.visible, object.visible && surface.visible);
        showLock(*child, surface.locked);
        item->addChild(child);
    }
    return item;
}

// An object is shown as selected when all its surfaces are.
void Outliner::showSelection() {
    if (choosing_) return;
    const QScopedValueRollback quiet(filling_, true);
    const SurfaceRefs& selected = document_.selected();
    const auto active = document_.selection();
    clearSelection();
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        if (isObject(*it)) continue;
        const SurfaceRef ref = refOf(*it);
        if (active == ref) setCurrentItem(*it, kName, QItemSelectionModel::Current);
        if (std::ranges::find(selected, ref) != selected.end()) (*it)->setSelected(true);
    }
    if (!active) setCurrentItem(nullptr);
}

/// The surface of the current row is the active one; an object stands for all of its surfaces.
void Outliner::selectChosen() {
    if (filling_) return;
    SurfaceRefs chosen;
    const auto add = [&](const QTreeWidgetItem* item) {
        if (std::ranges::find(chosen, refOf(item)) == chosen.end()) chosen.push_back(refOf(item));
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
        addRow(current);
    }
    const QScopedValueRollback quiet(choosing_, true);
    document_.select(chosen);
}

void Outliner::showEye(QTreeWidgetItem& item, bool visible, bool shown) {
    item.setIcon(kEye, visible ? icon(QStringLiteral("eye"), theme().text)
                               : icon(QStringLiteral("eye-off"), theme().textDimmed));
    item.setToolTip(kEye,
                    visible ? tr("Hide: it is neither seen nor felt (H)") : tr("Show (Alt+H shows all)"));
    item.setData(kEye, Qt::AccessibleTextRole, visible ? tr("visible") : tr("hidden"));
    if (!shown) item.setForeground(kName, theme().textDimmed);
}

void Outliner::showLock(QTreeWidgetItem& item, bool locked) {
    item.setIcon(kLock, locked ? icon(QStringLiteral("lock"), theme().text)
                               : icon(QStringLiteral("lock-open"), theme().border));
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
            rebuild();
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

} // namespace tactum
