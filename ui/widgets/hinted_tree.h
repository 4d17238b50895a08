// A tree that says, while it shows no row, what would be here and how to get it.
#pragma once

#include <QTreeWidget>

namespace tactum {

/// In the place of rows, words about them.
void paintHint(QWidget& viewport, const QString& hint);

/// Keys of its own actions (Qt::WidgetShortcut) are its own while it has them: what the window does by the
/// same key is not done from here, also while the action is off.
class HintedTree : public QTreeWidget {
public:
    explicit HintedTree(const QString& hint, QWidget* parent = nullptr);

protected:
    /// Whether Del, F2 and Ctrl+D mean nothing of the window's here.
    virtual bool keepsEditKeys() const { return true; }
    /// One column of sentences with an icon, in as many lines as they need.
    void setWrapping();
    /// After such rows were filled in.
    void wrapRows();
    void setHint(const QString& hint);
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QString hint_;
};

} // namespace tactum
