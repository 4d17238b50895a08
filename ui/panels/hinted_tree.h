// A tree that says, while it is empty, what would be here and how to get it.
#pragma once

#include <QTreeWidget>

namespace tactum {

class HintedTree : public QTreeWidget {
public:
    explicit HintedTree(const QString& hint, QWidget* parent = nullptr);

protected:
    /// One column of sentences with an icon, in as many lines as they need.
    void setWrapping();
    /// After such rows were filled in.
    void wrapRows();
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QString hint_;
};

} // namespace tactum
