#include "ui/panels/outliner.h"

#include <QEvent>
#include <QHeaderView>
#include <QScopedValueRollback>

#include "ui/panels/swatch.h"
#include "ui/style.h"

namespace tactum {

namespace {

constexpr int kName = 0, kEye = 1;
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
    setColumnCount(2);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    header()->setSectionResizeMode(kEye, QHeaderView::Fixed);
    header()->resizeSection(kEye, 4 * kRhythm);
    connect(&document_, &Document::changed, this, &Outliner::follow);
    connect(this, &QTreeWidget::currentItemChanged, this, &Outliner::selectCurrent);
    connect(this, &QTreeWidget::itemChanged, this, &Outliner::rename);
    connect(this, &QTreeWidget::itemClicked, this, &Outliner::toggleEye);
    rebuild();
}

void Outliner::follow(const SceneChange& change) {
    using What = SceneChange::What;
    if (change.what == What::Selection)
        showSelection();
    else if (change.what == What::Everything || change.what == What::Objects || change.what == What::Names)
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
    item->setIcon(kEye, object.visible ? icon(QStringLiteral("eye"), theme().text)
                                       : icon(QStringLiteral("eye-off"), theme().textDimmed));
    item->setToolTip(kEye, object.visible ? tr("Hide: it is neither seen nor felt (H)")
                                          : tr("Show (Alt+H shows all)"));
    item->setData(kEye, Qt::AccessibleTextRole, object.visible ? tr("visible") : tr("hidden"));
    if (!object.visible) item->setForeground(kName, theme().textDimmed);
    for (Index i = 0; i < object.surfaces.size(); ++i) {
        auto* child = makeItem(object.surfaces[i].name, {object.id, i});
        child->setIcon(kName, swatch(object.surfaces[i].colour));
        if (!object.visible) child->setForeground(kName, theme().textDimmed);
        item->addChild(child);
    }
    return item;
}

void Outliner::showSelection() {
    const QScopedValueRollback quiet(filling_, true);
    const auto selection = document_.selection();
    if (!selection) return setCurrentItem(nullptr);
    if (currentItem() && refOf(currentItem()) == *selection) return; // an object stands for its first surface
    for (QTreeWidgetItemIterator it(this); *it; ++it)
        if (!isObject(*it) && refOf(*it) == *selection) return setCurrentItem(*it);
}

void Outliner::selectCurrent() {
    if (!filling_ && currentItem()) document_.select(refOf(currentItem()));
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

void Outliner::toggleEye(QTreeWidgetItem* item, int column) {
    if (column != kEye || !isObject(item)) return;
    const ObjectId id = refOf(item).object;
    const bool visible = document_.scene().find(id)->visible;
    QMetaObject::invokeMethod(
        this, [this, id, visible] { document_.setVisible(id, !visible); }, Qt::QueuedConnection);
}

} // namespace tactum
