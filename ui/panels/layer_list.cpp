#include "ui/panels/layer_list.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>

#include "ui/base/style.h"
#include "ui/document/layer_picture.h"

namespace tactum {

namespace {

constexpr int kNameColumn = 0, kEyeColumn = 1, kSolo = 2;
constexpr int kWords = Qt::UserRole, kLayerPicture = Qt::UserRole + 1, kFelt = Qt::UserRole + 2;
constexpr int kRowHeight = LayerList::kThumbnail + kRhythm;

/// Picture, name, and beneath it what the layer changes by how much.
class RowPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return {QStyledItemDelegate::sizeHint(option, index).width(), kRowHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        if (index.column() != kNameColumn) return QStyledItemDelegate::paint(painter, option, index);
        QStyleOptionViewItem bare(option);
        initStyleOption(&bare, index);
        bare.text.clear();
        option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &bare, painter, option.widget);
        const bool isFelt = index.data(kFelt).toBool();
        const QRect picture(option.rect.left() + 4, option.rect.top() + 4, LayerList::kThumbnail,
                            LayerList::kThumbnail);
        painter->save();
        painter->setOpacity(isFelt ? 1 : 0.4);
        painter->drawPixmap(picture, index.data(kLayerPicture).value<QPixmap>());
        painter->setOpacity(1);
        const QRect words = textPlace(option.rect);
        const QRect upper = words.adjusted(0, 3, 0, -words.height() / 2),
                    lower = words.adjusted(0, words.height() / 2, 0, -3);
        const auto line = [&](const QRect& place, const QString& text) {
            painter->drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                              option.fontMetrics.elidedText(text, Qt::ElideRight, place.width()));
        };
        painter->setPen(isFelt ? theme().text : theme().textDimmed);
        line(upper, index.data(Qt::DisplayRole).toString());
        painter->setPen(theme().textDimmed);
        line(lower, index.data(kWords).toString());
        painter->restore();
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() != kNameColumn) return nullptr;
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        editor->setAccessibleName(LayerList::tr("Name of the layer"));
        return editor;
    }
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override {
        const QRect words = textPlace(option.rect);
        editor->setGeometry(words.left() - kRhythm / 2, option.rect.center().y() - 12, words.width(), 24);
    }

private:
    static QRect textPlace(const QRect& row) {
        return row.adjusted(LayerList::kThumbnail + 2 * kRhythm, 0, 0, 0);
    }
};

/// What cannot be shown as a picture: an icon on a square.
QPixmap plainPicture(const QString& name, int side, qreal ratio) {
    QPixmap pixmap(QSize(side, side) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(theme().field);
    QPainter painter(&pixmap);
    painter.drawPixmap(QRect((side - 24) / 2, (side - 24) / 2, 24, 24),
                       icon(name, theme().textDimmed).pixmap(24, 24));
    return pixmap;
}

} // namespace

QPixmap layerThumbnail(const TexturePattern& pattern, int side, qreal ratio) {
    QPixmap pixmap = QPixmap::fromImage(patternPicture(pattern, int(side * ratio)));
    pixmap.setDevicePixelRatio(ratio);
    const bool painted = pattern.source == TextureSource::Painted;
    return pixmap.isNull()
               ? plainPicture(painted ? QStringLiteral("paint") : QStringLiteral("picture"), side, ratio)
               : pixmap;
}

LayerList::LayerList(QWidget* parent) : HintedTree(tr("No layers yet. Add one (+)."), parent) {
    setObjectName(QStringLiteral("layer-list"));
    setAccessibleName(tr("Layers, topmost first"));
    setToolTip(tr("Drag a row to put it above or below others; double click to rename"));
    setItemDelegate(new RowPainter(this));
    setRootIsDecorated(false);
    setIndentation(0);
    setColumnCount(3);
    setSelectionMode(SingleSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed);
    header()->setSectionResizeMode(kNameColumn, QHeaderView::Stretch);
    for (const int column : {kEyeColumn, kSolo}) {
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
        header()->resizeSection(column, 3 * kRhythm + 4);
    }
    connect(this, &QTreeWidget::itemClicked, this, &LayerList::click);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (filling_ || column != kNameColumn) return;
        emit renameAsked(layerOf(indexOfTopLevelItem(item)), item->text(kNameColumn).trimmed());
    });
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!filling_ && item) emit chosen(layerOf(indexOfTopLevelItem(item)));
    });
}

void LayerList::display(const TextureLayers& layers, std::optional<int> current, std::optional<int> solo) {
    const QScopedValueRollback quiet(filling_, true);
    layers_ = layers;
    solo_ = solo;
    while (topLevelItemCount() > int(layers.size()))
        delete takeTopLevelItem(0);
    while (topLevelItemCount() < int(layers.size())) {
        auto* item = new QTreeWidgetItem({QString(), QString(), QString()});
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        insertTopLevelItem(0, item);
    }
    fillIcons();
    QTreeWidgetItem* item = current ? topLevelItem(layerOf(*current)) : nullptr;
    if (item != currentItem()) setCurrentItem(item);
}

void LayerList::fillIcons() {
    const QScopedValueRollback quiet(filling_, true);
    for (int i = 0; i < int(layers_.size()); ++i) {
        const TextureLayer& layer = layers_[std::size_t(i)];
        fill(*topLevelItem(layerOf(i)), layer, solo_ == i, solo_ ? solo_ == i : layer.enabled);
    }
    // Only what is shown is kept.
    std::erase_if(pictures_, [this](const Picture& picture) {
        return std::ranges::none_of(layers_,
                                    [&](const TextureLayer& l) { return l.pattern == picture.pattern; });
    });
}

void LayerList::fill(QTreeWidgetItem& item, const TextureLayer& layer, bool isSolo, bool isFelt) {
    const QString name = QString::fromStdString(layer.name), words = targetText(layer);
    item.setText(kNameColumn, name);
    item.setData(kNameColumn, kWords, words);
    item.setData(kNameColumn, kLayerPicture, pictureOf(layer.pattern));
    item.setData(kNameColumn, kFelt, isFelt);
    item.setData(kNameColumn, Qt::AccessibleTextRole,
                 QStringLiteral("%1, %2, %3").arg(name, words, isFelt ? tr("felt") : tr("not felt")));
    item.setToolTip(kNameColumn, words);
    item.setIcon(kEyeColumn, layer.enabled ? icon(QStringLiteral("eye"), theme().text)
                                           : icon(QStringLiteral("eye-off"), theme().textDimmed));
    item.setToolTip(kEyeColumn, layer.enabled ? tr("Switch the layer off: it is not felt (Space)")
                                              : tr("Switch the layer on (Space)"));
    item.setData(kEyeColumn, Qt::AccessibleTextRole, layer.enabled ? tr("on") : tr("off"));
    item.setIcon(kSolo, icon(QStringLiteral("solo"), isSolo ? theme().accent : theme().border));
    item.setToolTip(kSolo, isSolo ? tr("Feel all layers again (S)") : tr("Feel this layer alone (S)"));
    item.setData(kSolo, Qt::AccessibleTextRole, isSolo ? tr("felt alone") : tr("not alone"));
}

QPixmap LayerList::pictureOf(const TexturePattern& pattern) {
    if (const auto known = std::ranges::find(pictures_, pattern, &Picture::pattern); known != pictures_.end())
        return known->pixmap;
    const QPixmap pixmap = layerThumbnail(pattern, kThumbnail, devicePixelRatioF());
    pictures_.push_back({pattern, pixmap});
    return pixmap;
}

void LayerList::setRows(int rows) {
    setFixedHeight(std::max(1, rows) * kRowHeight + 2 * frameWidth());
}

QPixmap LayerList::thumbnail(int layer) const {
    return topLevelItem(layerOf(layer))->data(kNameColumn, kLayerPicture).value<QPixmap>();
}

void LayerList::editName(int layer) {
    editItem(topLevelItem(layerOf(layer)), kNameColumn);
}

int LayerList::currentLayer() const {
    return currentItem() ? layerOf(indexOfTopLevelItem(currentItem())) : -1;
}

void LayerList::click(QTreeWidgetItem* item, int column) {
    const int layer = layerOf(indexOfTopLevelItem(item));
    if (column == kEyeColumn) emit showAsked(layer);
    if (column == kSolo) emit soloAsked(layer);
}

void LayerList::mousePressEvent(QMouseEvent* event) {
    HintedTree::mousePressEvent(event);
    const QModelIndex index = indexAt(event->position().toPoint());
    const bool grabs = event->button() == Qt::LeftButton && index.isValid() && index.column() == kNameColumn;
    pressedRow_ = grabs ? index.row() : -1;
    pressedAt_ = event->position().toPoint();
}

void LayerList::mouseMoveEvent(QMouseEvent* event) {
    if (pressedRow_ < 0 || !(event->buttons() & Qt::LeftButton)) return HintedTree::mouseMoveEvent(event);
    const QPoint at = event->position().toPoint();
    if (!gap_ && (at - pressedAt_).manhattanLength() < QApplication::startDragDistance()) return;
    gap_ = gapAt(at.y());
    setCursor(Qt::ClosedHandCursor);
    viewport()->update();
}

void LayerList::mouseReleaseEvent(QMouseEvent* event) {
    HintedTree::mouseReleaseEvent(event);
    const int row = std::exchange(pressedRow_, -1);
    const auto gap = std::exchange(gap_, std::nullopt);
    unsetCursor();
    viewport()->update();
    if (row < 0 || !gap) return;
    const int to = *gap > row ? *gap - 1 : *gap; // the row leaves a place of its own
    if (to != row) emit moveAsked(layerOf(row), layerOf(to));
}

int LayerList::gapAt(int y) const {
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (y < visualItemRect(topLevelItem(row)).center().y()) return row;
    return topLevelItemCount();
}

void LayerList::keyPressEvent(QKeyEvent* event) {
    const int layer = currentLayer();
    if (layer < 0) return HintedTree::keyPressEvent(event);
    const bool alt = event->modifiers() == Qt::AltModifier;
    if (alt && event->key() == Qt::Key_Up)
        emit moveAsked(layer, layer + 1);
    else if (alt && event->key() == Qt::Key_Down)
        emit moveAsked(layer, layer - 1);
    else if (event->key() == Qt::Key_Delete && event->modifiers() == Qt::NoModifier)
        emit removeAsked();
    else if (event->key() == Qt::Key_D && event->modifiers() == Qt::ControlModifier)
        emit duplicateAsked();
    else if (event->key() == Qt::Key_Space)
        emit showAsked(layer);
    else if (event->key() == Qt::Key_S && event->modifiers() == Qt::NoModifier)
        emit soloAsked(layer);
    else
        HintedTree::keyPressEvent(event);
}

void LayerList::paintEvent(QPaintEvent* event) {
    HintedTree::paintEvent(event);
    if (!gap_ || topLevelItemCount() == 0) return;
    const bool isLast = *gap_ == topLevelItemCount();
    const QRect row = visualItemRect(topLevelItem(isLast ? *gap_ - 1 : *gap_));
    QPainter painter(viewport());
    painter.fillRect(QRect(0, (isLast ? row.bottom() : row.top()) - 1, viewport()->width(), 2),
                     theme().accent);
}

void LayerList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        pictures_.clear(); // some are in the colours of the theme
        if (topLevelItemCount() == int(layers_.size())) fillIcons();
    }
    HintedTree::changeEvent(event);
}

} // namespace tactum
