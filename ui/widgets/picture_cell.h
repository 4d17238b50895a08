// How a grid of pictures draws what it has: a picture with its name beneath, or a heading.
#pragma once

#include <QStyledItemDelegate>

namespace tactum {

class PictureGrid;

class PictureCell : public QStyledItemDelegate {
    Q_OBJECT
public:
    static constexpr int kKeyRole = Qt::UserRole + 20, kTitleRole = Qt::UserRole + 21; ///< of headings alone

    explicit PictureCell(PictureGrid* grid);

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

private:
    void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

    PictureGrid& grid_;
};

} // namespace tactum
