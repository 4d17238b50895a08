// How wide the panels beside the view are, through every size of the window.
#pragma once

#include <map>

#include <QMainWindow>
#include <QVariantList>

#include "ui/controllers/docks.h"

namespace tactum {

/// A window that becomes small takes width from its panels, and Qt gives what it wins again to the view
/// alone. So each side gets back, when the window grows, what it had at first or what a person's hand gave
/// it. Thread: ui.
class DockWidths : public QObject {
    Q_OBJECT
public:
    /// Made when all docks are there.
    explicit DockWidths(QMainWindow& window);

    /// Pixels of the left and the right side, for the settings.
    QVariantList widths() const;
    void restore(const QVariantList& widths);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void note(QDockWidget& dock);
    void settle();
    QDockWidget* shownIn(Qt::DockWidgetArea side) const;

    QMainWindow& window_;
    std::map<Qt::DockWidgetArea, int> wanted_{{Qt::LeftDockWidgetArea, kLeftDocks},
                                              {Qt::RightDockWidgetArea, kRightDocks}}; ///< pixels
    int settled_ = 0; ///< pixels, the width of the window to which its panels were laid out
};

} // namespace tactum
