#include "ui/panels/preset_library.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/document/preset_store.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

namespace {

constexpr int kLibraryPicture = 36; // pixels
constexpr int kDetails = 16 * kRhythm;
constexpr int kFileRole = Qt::UserRole, kFiguresRole = Qt::UserRole + 1;

/// "staticFriction": the key under which a preset says the source of a value.
QString sourceKey(const Parameter& parameter) {
    QString key;
    for (const QString& part : asIs(parameter.key).split(u'-'))
        key += key.isEmpty() ? part : part.left(1).toUpper() + part.mid(1);
    return key;
}

QString valueText(const Parameter& parameter, double value) {
    const DisplayUnit unit = displayUnit(parameter);
    const QString number = numberText(unit.factor * value, unit.decimals);
    return unit.name.isEmpty() ? number : number + u' ' + unit.name;
}

QString sourceText(const PresetSource& source) {
    if (source.words.empty() && source.link.empty()) return PresetLibrary::tr("no source given");
    QString text = asIs(source.words).toHtmlEscaped();
    if (source.typical) text = PresetLibrary::tr("typical; tables disagree. %1").arg(text);
    const QString link = asIs(source.link);
    const bool isAddress =
        link.startsWith(QStringLiteral("https://")) || link.startsWith(QStringLiteral("http://"));
    if (isAddress)
        text +=
            QStringLiteral(" <a href=\"%1\">%2</a>").arg(link.toHtmlEscaped(), PresetLibrary::tr("source"));
    else if (!link.isEmpty())
        text += u' ' + link.toHtmlEscaped();
    return text;
}

QString libraryLine(const QString& label, const QString& value, const PresetSource& source) {
    return QStringLiteral("<p style='margin:0 0 4px 0'>%1 <b>%2</b><br><span style='color:%3'>%4</span></p>")
        .arg(label.toHtmlEscaped(), value.toHtmlEscaped(), theme().textDimmed.name(), sourceText(source));
}

/// "0.60 / 0.30 · Metal": static and dynamic friction, or else what it sets first.
QString figuresOf(const StoredPreset& stored) {
    const Preset& preset = stored.preset;
    QStringList figures;
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        const Parameter* parameter = kMaterialFields[i].parameter;
        if (preset.values[i] && (parameter == &kStaticFriction || parameter == &kDynamicFriction))
            figures << QString::number(*preset.values[i], 'g', 3);
    }
    for (std::size_t i = 0; i < kMaterialFields.size() && figures.isEmpty(); ++i)
        if (preset.values[i]) figures << valueText(*kMaterialFields[i].parameter, *preset.values[i]);
    if (figures.isEmpty() && preset.layers) figures << PresetLibrary::tr("texture");
    QStringList parts{figures.join(QStringLiteral(" / "))};
    if (!preset.category.empty()) parts << stored.category();
    return parts.join(QStringLiteral(" \u00b7 "));
}

} // namespace

QString detailsOf(const StoredPreset& stored) {
    const Preset& preset = stored.preset;
    QString text;
    if (!preset.category.empty())
        text = QStringLiteral("<p style='margin:0 0 4px 0'><b>%1</b></p>")
                   .arg(stored.category().toHtmlEscaped());
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
        const Parameter& parameter = *kMaterialFields[i].parameter;
        if (preset.values[i])
            text += libraryLine(wordsOf(parameter.label), valueText(parameter, *preset.values[i]),
                                sourceOf(preset, sourceKey(parameter).toStdString()));
    }
    if (preset.shading)
        text += libraryLine(PresetLibrary::tr("Force shading"),
                            preset.shading->on ? PresetLibrary::tr("on") : PresetLibrary::tr("off"),
                            sourceOf(preset, kShadingPart));
    if (!preset.layers) return text;
    QStringList names;
    for (const TextureLayer& layer : *preset.layers)
        names << QStringLiteral("%1 (%2, %3)")
                     .arg(asIs(layer.name), wordsOf(kTextureSources[std::size_t(layer.pattern.source)].label),
                          valueText(strengthParameter(layer.target), layer.strength));
    return text + libraryLine(PresetLibrary::tr("Layers"),
                              names.isEmpty() ? PresetLibrary::tr("none") : names.join(QStringLiteral(", ")),
                              sourceOf(preset, kLayersPart));
}

/// Under the name, dimmed, what is known of the preset at a glance.
class PresetRow : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem whole = option;
        initStyleOption(&whole, index);
        const QString name = whole.text;
        whole.text.clear();
        whole.widget->style()->drawControl(QStyle::CE_ItemViewItem, &whole, painter, whole.widget);
        QRect libraryLine = option.rect.adjusted(kLibraryPicture + kRhythm * 3 / 2, 0, -kRhythm / 2, 0);
        libraryLine.setTop(option.rect.center().y() - option.fontMetrics.height());
        libraryLine.setHeight(option.fontMetrics.height());
        const auto draw = [&](const QColor& colour, const QString& text) {
            painter->setPen(colour);
            painter->drawText(libraryLine, Qt::AlignVCenter | Qt::AlignLeft,
                              option.fontMetrics.elidedText(text, Qt::ElideRight, libraryLine.width()));
            libraryLine.translate(0, libraryLine.height());
        };
        draw(theme().text, name);
        draw(theme().textDimmed, index.data(kFiguresRole).toString());
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return {kLibraryPicture, std::max(kLibraryPicture, 2 * option.fontMetrics.height()) + kRhythm / 2};
    }
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override {
        editor->setGeometry(option.rect.adjusted(kLibraryPicture + kRhythm, kRhythm / 2, 0, -kRhythm / 2));
    }
};

/// The rows; each can be dragged out.
class PresetList : public HintedTree {
public:
    explicit PresetList(PresetStore& store)
        : HintedTree(PresetLibrary::tr("No preset fits. Clear the search, or save one of your own from a "
                                       "selected surface.")),
          store_(store) {
        setObjectName(QStringLiteral("preset-list"));
        setAccessibleName(PresetLibrary::tr("Presets"));
        setColumnCount(1);
        setItemDelegate(new PresetRow(this));
        setRootIsDecorated(false);
        setIconSize({kLibraryPicture, kLibraryPicture});
        setDragEnabled(true);
        setDragDropMode(DragOnly);
        setEditTriggers(NoEditTriggers); // a double click applies
        header()->setSectionResizeMode(0, QHeaderView::Stretch);
    }
    QStringList mimeTypes() const override { return {QString::fromLatin1(kPresetMime)}; }
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        const StoredPreset* dragged =
            items.isEmpty() ? nullptr : store_.find(items.front()->data(0, kFileRole).toString());
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
    : QWidget(parent), store_(store), search_(new QLineEdit), list_(new PresetList(store)),
      details_(new QLabel), buttons_(new QWidget), rename_(new QAction(tr("&Rename"), this)),
      remove_(new QAction(tr("Re&move"), this)) {
    setObjectName(QStringLiteral("dockBody"));
    search_->setObjectName(QStringLiteral("preset-search"));
    search_->setPlaceholderText(tr("Search presets"));
    search_->setAccessibleName(tr("Search presets by name, tag or source"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    details_->setObjectName(QStringLiteral("preset-details"));
    details_->setWordWrap(true);
    details_->setTextFormat(Qt::RichText);
    details_->setOpenExternalLinks(true);
    details_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    details_->setAccessibleName(tr("Values of the preset and their sources"));
    details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    details_->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    auto* scroll = new QScrollArea;
    scroll->setWidget(details_);
    scroll->setWidgetResizable(true);
    scroll->setFixedHeight(kDetails);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    top->addWidget(search_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(top);
    column->addWidget(list_, 1);
    column->addWidget(scroll);
    column->addWidget(buttons_);
    rename_->setShortcut(Qt::Key_F2);
    remove_->setShortcut(Qt::Key_Delete);
    for (QAction* action : {rename_, remove_}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        list_->addAction(action);
    }
    connect(rename_, &QAction::triggered, this, &PresetLibrary::editName);
    connect(remove_, &QAction::triggered, this, &PresetLibrary::removeChosen);
    connect(search_, &QLineEdit::textChanged, this, &PresetLibrary::fill);
    connect(search_, &QLineEdit::returnPressed, this, &PresetLibrary::applyAsked);
    connect(list_, &QTreeWidget::itemActivated, this, &PresetLibrary::applyAsked);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        if (!filling_) showChosen();
    });
    connect(list_, &QTreeWidget::itemChanged, this, &PresetLibrary::rename);
    connect(&store_, &PresetStore::changed, this, &PresetLibrary::fill);
    setFocusProxy(search_);
    fill();
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
    list_->addActions({separator, apply, save});
    list_->addActions(others);
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

const StoredPreset* PresetLibrary::chosen() const {
    const QTreeWidgetItem* item = list_->currentItem();
    return item ? store_.find(item->data(0, kFileRole).toString()) : nullptr;
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
        list_->clear();
        for (const StoredPreset& stored : store_.presets()) {
            if (!matches(stored, search_->text()) && stored.file != wanted_) continue;
            auto* item = new QTreeWidgetItem(list_, {stored.name()});
            const QPixmap picture = QPixmap::fromImage(stored.picture);
            QIcon shown(picture);
            shown.addPixmap(picture, QIcon::Selected); // else it is tinted there
            item->setIcon(0, shown);
            item->setData(0, kFiguresRole, figuresOf(stored));
            item->setData(0, Qt::AccessibleDescriptionRole, figuresOf(stored));
            item->setData(0, kFileRole, stored.file);
            item->setToolTip(0, detailsOf(stored));
            if (stored.own) item->setFlags(item->flags() | Qt::ItemIsEditable);
            if (stored.file == wanted) list_->setCurrentItem(item);
        }
        if (!list_->currentItem() && !search_->text().isEmpty() && list_->topLevelItemCount() > 0)
            list_->setCurrentItem(list_->topLevelItem(0));
    }
    if (store_.find(wanted_)) wanted_.clear();
    showChosen();
}

void PresetLibrary::showChosen() {
    const StoredPreset* stored = chosen();
    details_->setText(stored ? detailsOf(*stored)
                             : QStringLiteral("<span style='color:%1'>%2</span>")
                                   .arg(theme().textDimmed.name(),
                                        tr("Drag a preset onto the model, or choose one and press Enter: it "
                                           "is given to the selected surfaces.")));
    rename_->setEnabled(stored && stored->own);
    remove_->setEnabled(stored && stored->own);
    emit chosenChanged();
}

void PresetLibrary::editName() {
    if (chosen() && chosen()->own) list_->editItem(list_->currentItem(), 0);
}

// Later: the list is filled anew, and with it goes the row that is speaking now.
void PresetLibrary::rename(QTreeWidgetItem* item) {
    if (filling_) return;
    const QString file = item->data(0, kFileRole).toString(), name = item->text(0);
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

bool PresetLibrary::eventFilter(QObject* watched, QEvent* event) {
    if (watched != search_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Down && key != Qt::Key_Up) return false;
    list_->setFocus(Qt::OtherFocusReason);
    if (!list_->currentItem() && list_->topLevelItemCount() > 0)
        list_->setCurrentItem(list_->topLevelItem(0));
    return true;
}

} // namespace tactum
