// A tree that says, while it is empty, what would be here and how to get it.
#pragma once

#include <QTreeWidget>

namespace tactum {

class HintedTree : public QTreeWidget {
public:
    explicit HintedTree(const QString& hint, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString hint_;
};

} // namespace tactum
