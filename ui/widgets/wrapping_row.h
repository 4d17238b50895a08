// A row of widgets that goes on below where it is too long.
#pragma once

#include <vector>

#include <QLayout>

namespace tactum {

/// As wide as all of it where there is room; words stay beside what follows them. Thread: ui.
class WrappingRow : public QLayout {
public:
    explicit WrappingRow(QWidget* parent);
    ~WrappingRow() override;

    /// A gap before what comes next.
    void addGap();
    void addItem(QLayoutItem* item) override;
    int count() const override { return int(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    /// Of items that stand together in one row.
    struct Unit {
        std::vector<QLayoutItem*> items;
        int width = 0;
    };
    std::vector<Unit> units() const;
    std::vector<std::vector<Unit>> rowsIn(int width) const;
    int widthOf(const std::vector<Unit>& row) const;
    static int heightOf(const std::vector<Unit>& row);
    static QSize sizeOf(const QLayoutItem& item);

    std::vector<QLayoutItem*> items_;
};

} // namespace tactum
