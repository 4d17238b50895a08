#include "ui/panels/preset_library.h"

#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/document/preset_store.h"
#include "ui/panels/preset_words.h"
#include "ui/widgets/picture_grid.h"

namespace tactum {

namespace {

constexpr int kDetails = 16 * kRhythm;
constexpr int kFileRole = Qt::UserRole;
const QString kDetailsKey = QStringLiteral("presets/details");

/// The person's own stand together, first of all.
QString groupOf(const StoredPreset& stored) {
    return stored.own ? QStringLiteral("own") : QStringLiteral("shipped/") + asIs(stored.preset.category);
}

QString titleOf(const StoredPreset& stored) {
    return stored.own ? PresetLibrary::tr("Your own") : stored.category();
}

} // namespace

/// The pictures; each can be dragged out.
class PresetGrid : public PictureGrid {
public:
    explicit PresetGrid(PresetStore& store)
        : PictureGrid(QStringLiteral("presets"),
                      PresetLibrary::tr("No preset fits. Clear the search, or save one of your own from a "
                                        "selected surface.")),
          store_(store) {
        setObjectName(QStringLiteral("preset-list"));
        setAccessibleName(PresetLibrary::tr("Presets"));
        setToolTip(PresetLibrary::tr("Drag a preset onto the model, or choose one and press Enter: it "
                                     "is given to the selected surfaces."));
        setDragEnabled(true);
        setDragDropMode(DragOnly);
    }
    QStringList mimeTypes() const override { return {QString::fromLatin1(kPresetMime)}; }
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override {
        const StoredPreset* dragged =
            items.isEmpty() ? nullptr : store_.find(items.front()->data(kFileRole).toString());
        if (!dragged) return nullptr;
        auto* carried = new QMimeData;
        carried->setData(QString::fromLatin1(kPresetMime), dragged->text.toUtf8());
        return carried;
    }
    Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }

private:
    PresetStore& store_;
};

PresetLibrary::PresetLibrary(PresetStore& store, QWidget* parent)
    : QWidget(parent), store_(store), search_(new QLineEdit), grid_(new PresetGrid(store)),
      unfold_(new QToolButton), details_(new QLabel), scroll_(new QScrollArea), buttons_(new QWidget),
      rename_(new QAction(tr("&Rename"), this)), remove_(new QAction(tr("Re&move"), this)) {
    setObjectName(QStringLiteral("dockBody"));
    search_->setObjectName(QStringLiteral("preset-search"));
    search_->setPlaceholderText(tr("Search presets"));
    search_->setAccessibleName(tr("Search presets by name, tag or source"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    makeDetails();
    auto* top = new QHBoxLayout;
    top->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    top->setSpacing(kRhythm / 2);
    top->addWidget(search_);
    top->addWidget(unfold_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(top);
    column->addWidget(grid_, 1);
    column->addWidget(scroll_);
    column->addWidget(buttons_);
    rename_->setShortcut(Qt::Key_F2);
    remove_->setShortcut(Qt::Key_Delete);
    for (QAction* action : {rename_, remove_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        grid_->addAction(action);
    }
    connectAll();
    setFocusProxy(search_);
    fill();
}

void PresetLibrary::makeDetails() {
    unfold_->setObjectName(QStringLiteral("preset-unfold"));
    unfold_->setIcon(icon(QStringLiteral("note")));
    unfold_->setIconSize({16, 16});
    unfold_->setAccessibleName(tr("Values and sources"));
    unfold_->setToolTip(tr("What the chosen preset sets, and where each value comes from"));
    unfold_->setCheckable(true);
    unfold_->setFocusPolicy(Qt::TabFocus);
    details_->setObjectName(QStringLiteral("preset-details"));
    details_->setWordWrap(true);
    details_->setTextFormat(Qt::RichText);
    details_->setOpenExternalLinks(true);
    details_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    details_->setAccessibleName(tr("Values of the preset and their sources"));
    details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    details_->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    scroll_->setWidget(details_);
    scroll_->setWidgetResizable(true);
    scroll_->setFixedHeight(kDetails);
    scroll_->setFocusPolicy(Qt::NoFocus);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    unfold_->setChecked(QSettings().value(kDetailsKey).toBool());
    scroll_->setVisible(unfold_->isChecked());
}

void PresetLibrary::connectAll() {
    connect(rename_, &QAction::triggered, this, &PresetLibrary::editName);
    connect(remove_, &QAction::triggered, this, &PresetLibrary::removeChosen);
    connect(search_, &QLineEdit::textChanged, this, &PresetLibrary::fill);
    connect(search_, &QLineEdit::returnPressed, this, &PresetLibrary::applyAsked);
    connect(unfold_, &QToolButton::clicked, this, [this](bool shown) {
        QSettings().setValue(kDetailsKey, shown);
        scroll_->setVisible(shown);
    });
    connect(grid_, &PictureGrid::pictureActivated, this, &PresetLibrary::applyAsked);
    connect(grid_, &QListWidget::currentItemChanged, this, [this] {
        if (!filling_) showChosen();
    });
    connect(grid_, &QListWidget::itemChanged, this, &PresetLibrary::rename);
    connect(&store_, &PresetStore::changed, this, &PresetLibrary::fill);
}

void PresetLibrary::addActions(QAction* apply, QAction* save, const QList<QAction*>& others) {
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(12, kRhythm / 2, 12, kRhythm);
    row->setSpacing(kRhythm / 2);
    for (QAction* action : {apply, save}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setText(action->iconText());
        button->setProperty("choice", true);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::TabFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button, 1);
    }
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    grid_->addActions({separator, apply, save});
    grid_->addActions(others);
    grid_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

const StoredPreset* PresetLibrary::chosen() const {
    const QListWidgetItem* item = grid_->currentItem();
    return item ? store_.find(item->data(kFileRole).toString()) : nullptr;
}

void PresetLibrary::choose(const QString& file) {
    wanted_ = file;
    if (!store_.find(file)) return; // fill() comes once it has been read
    search_->clear();
    fill();
}

/// Keeps the choice where it still fits the search.
void PresetLibrary::fill() {
    const QString before = chosen() ? chosen()->file : QString();
    const QString wanted = wanted_.isEmpty() ? before : wanted_;
    {
        const QScopedValueRollback quiet(filling_, true);
        const int scrolled = grid_->verticalScrollBar()->value();
        grid_->clear();
        grid_->setAllOpen(!search_->text().trimmed().isEmpty());
        QString group;
        for (const StoredPreset& stored : store_.presets()) {
            if (!matches(stored, search_->text()) && stored.file != wanted_) continue;
            if (const QString key = groupOf(stored); key != group) {
                group = key;
                grid_->beginGroup(key, titleOf(stored));
            }
            QListWidgetItem* item = addPicture(stored);
            if (stored.file == wanted) grid_->setCurrentItem(item);
        }
        const auto found = grid_->pictures();
        if (!chosen() && !search_->text().isEmpty() && !found.isEmpty()) grid_->setCurrentItem(found.front());
        if (wanted_.isEmpty()) grid_->verticalScrollBar()->setValue(scrolled);
    }
    if (store_.find(wanted_)) wanted_.clear();
    showChosen();
}

QListWidgetItem* PresetLibrary::addPicture(const StoredPreset& stored) {
    QListWidgetItem* item = grid_->add(stored.name(), QPixmap::fromImage(stored.picture));
    item->setData(Qt::AccessibleDescriptionRole, figuresOf(stored));
    item->setData(kFileRole, stored.file);
    item->setToolTip(tipOf(stored));
    if (stored.own) item->setFlags(item->flags() | Qt::ItemIsEditable);
    return item;
}

void PresetLibrary::showChosen() {
    const StoredPreset* stored = chosen();
    details_->setText(stored ? detailsOf(*stored)
                             : QStringLiteral("<span style='color:%1'>%2</span>")
                                   .arg(theme().textDimmed.name(), tr("No preset is chosen.")));
    rename_->setEnabled(stored && stored->own);
    remove_->setEnabled(stored && stored->own);
    emit chosenChanged();
}

void PresetLibrary::editName() {
    if (chosen() && chosen()->own) grid_->editItem(grid_->currentItem());
}

// Later: the list is filled anew, and with it goes the row that is speaking now.
void PresetLibrary::rename(QListWidgetItem* item) {
    if (filling_) return;
    const QString file = item->data(kFileRole).toString(), name = item->text();
    const auto apply = [this, file, name] {
        if (const StoredPreset* stored = store_.find(file)) store_.rename(*stored, name);
    };
    QMetaObject::invokeMethod(this, apply, Qt::QueuedConnection);
}

void PresetLibrary::removeChosen() {
    const StoredPreset* stored = chosen();
    if (!stored || !stored->own) return;
    const QString name = stored->name();
    store_.remove(*stored);
    emit removed(name);
}

void PresetLibrary::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    unfold_->setIcon(icon(QStringLiteral("note")));
    showChosen(); // its words have colours, too
}

bool PresetLibrary::eventFilter(QObject* watched, QEvent* event) {
    if (watched != search_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Down && key != Qt::Key_Up) return false;
    grid_->setFocus(Qt::OtherFocusReason);
    if (const auto all = grid_->pictures(); !grid_->currentItem() && !all.isEmpty())
        grid_->setCurrentItem(all.front());
    return true;
}

} // namespace tactum
