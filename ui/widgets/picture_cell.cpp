#include "ui/widgets/picture_cell.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

#include "ui/base/style.h"
#include "ui/widgets/picture_grid.h"
#include "ui/widgets/text_lines.h"

namespace tactum {

namespace {

constexpr int kGap = kRhythm / 2, kBeside = 2, kLinesOfName = 3, kPicture = PictureGrid::kSide;
constexpr qreal kArrow = 3.5; // half of its length, pixels

bool isHeading(const QModelIndex& index) {
    return index.data(PictureCell::kKeyRole).isValid();
}

QRect wordsIn(const QRect& cell) {
    return cell.adjusted(kBeside, kGap + kPicture, -kBeside, -kGap / 2);
}

/// A size below that of the window: more of a name fits into a line.
QFont nameFont(const QStyleOptionViewItem& option) {
    QFont font = option.font;
    font.setPointSizeF(font.pointSizeF() - 1);
    return font;
}

QStringList nameLines(const QStyleOptionViewItem& option, const QModelIndex& index, int cell) {
    return linesOf(index.data().toString(), nameFont(option), cell - 2 * kBeside, kLinesOfName);
}

/// To the right where something is folded, else down.
QPolygonF arrowAt(QPointF middle, bool folded) {
    QPolygonF shape;
    for (const QPointF corner :
         {QPointF(-kArrow, -kArrow / 2), QPointF(kArrow, -kArrow / 2), QPointF(0, kArrow / 2)})
        shape << middle + (folded ? corner.transposed() : corner);
    return shape;
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
    const bool chosen = option.state & QStyle::State_Selected, under = option.state & QStyle::State_MouseOver;
    if (!chosen && !under) return;
    painter.setPen(chosen && option.widget->hasFocus() ? QPen(theme().accent) : Qt::NoPen);
    painter.setBrush(chosen ? theme().border : theme().field);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5), kGap, kGap);
}

void paintPicture(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    const QRect& cell = option.rect;
    const QRect place(cell.left() + (cell.width() - kPicture) / 2, cell.top() + kGap, kPicture, kPicture);
    QPainterPath rounded;
    rounded.addRoundedRect(place, kGap, kGap);
    painter.setClipPath(rounded);
    painter.drawPixmap(place, index.data(Qt::DecorationRole).value<QPixmap>());
    painter.setClipping(false);
    painter.setPen(theme().text);
    painter.setFont(nameFont(option));
    QRect line = wordsIn(cell);
    line.setHeight(painter.fontMetrics().height());
    for (const QString& words : nameLines(option, index, cell.width())) {
        painter.drawText(line, Qt::AlignHCenter | Qt::AlignVCenter, words.trimmed());
        line.translate(0, line.height());
    }
}

} // namespace

PictureCell::PictureCell(PictureGrid* grid) : QStyledItemDelegate(grid), grid_(*grid) {}

QSize PictureCell::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int cell = grid_.cellWidth();
    if (!isHeading(index)) {
        const auto lines = int(nameLines(option, index, cell).size());
        return {cell, kPicture + 2 * kGap + lines * QFontMetrics(nameFont(option)).height()};
    }
    const int columns = std::max(1, grid_.maximumViewportSize().width() / cell);
    return {columns * cell, option.fontMetrics.height() + kGap};
}

void PictureCell::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    paintGround(*painter, option);
    if (isHeading(index))
        paintHeading(*painter, option, index);
    else
        paintPicture(*painter, option, index);
    painter->restore();
}

void PictureCell::paintHeading(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
    const QRect& row = option.rect;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().textDimmed);
    painter.drawPolygon(arrowAt({row.left() + 1.5 * kRhythm, row.center().y() + 0.5},
                                grid_.isFolded(grid_.item(index.row()))));
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(theme().textDimmed);
    const QRect words = row.adjusted(3 * kRhythm, 0, -kGap, 0);
    painter.drawText(
        words, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(bold).elidedText(index.data(kTitleRole).toString(), Qt::ElideRight, words.width()));
}

QWidget* PictureCell::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
    QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
    editor->setAccessibleName(tr("Name"));
    return editor;
}

void PictureCell::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                       const QModelIndex&) const {
    editor->setGeometry(wordsIn(option.rect));
}

} // namespace tactum
