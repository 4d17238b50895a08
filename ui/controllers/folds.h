// Docks that share tabs, folded to those tabs, so that the view has their room.
#pragma once

#include <map>

#include <QObject>
#include <QStringList>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace tactum {

/// Every row of tabs below or left of the view has a button that folds it; a click on a folded tab unfolds
/// it. Thread: ui.
class Folds : public QObject {
    Q_OBJECT
public:
    explicit Folds(QMainWindow& window);

    bool isFolded(const QDockWidget& dock) const;
    /// All docks that share tabs with this one; they come back as high as they were.
    void setFolded(QDockWidget& dock, bool folded);
    /// Seen, whatever hid it.
    void bringForward(QDockWidget& dock);

    /// Names of the folded docks.
    QStringList names() const;
    void restore(const QStringList& names);

signals:
    void changed();
    /// By button or tab.
    void decided();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fold(QDockWidget& dock, bool folded);
    QList<QDockWidget*> together(QDockWidget& dock) const;
    QDockWidget& frontOf(QDockWidget& dock) const;
    void adopt(QTabBar& bar);
    void decide(QDockWidget* dock, bool folded);
    void showButton(QTabBar& bar);
    void showButtons();

    QMainWindow& window_;
    std::map<Qt::DockWidgetArea, int> heights_; ///< of an unfolded row, pixels
};

} // namespace tactum
