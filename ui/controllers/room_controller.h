// The room of the view: which panels stand around it, folded or not.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QStringList>

#include "ui/controllers/workbench.h"

namespace tactum {

class DockWidths;
class Folds;

/// Thread: ui.
class RoomController : public QObject {
    Q_OBJECT
public:
    /// Made when all docks are there.
    RoomController(const Workbench& bench, Folds& folds);

    /// As it was left, and back into the settings: size, docks, folds.
    void restore();
    void save() const;
    /// Once a frame.
    void frame();
    void hidePanels(bool hidden);
    /// The start page has the window to itself; the panels come with what is opened first.
    void clearForStart();
    void leaveStart();
    bool hidesPanels() const { return !shownPanels_.isEmpty(); }

private:
    void connectFold(const char* command, const char* dock);

    /// Who says whether the plots are folded: nothing was felt yet, the hand is still there, they came by
    /// themselves, the person.
    enum class Plots { Empty, Due, Shown, AsDecided };

    Workbench bench_;
    Folds& folds_;
    DockWidths& widths_;
    Plots plots_ = Plots::Empty;
    bool clearedForStart_ = false;
    bool grabbed_ = false;     ///< the finger in the view
    QByteArray shownPanels_;   ///< the layout to come back to while all panels are hidden
    QStringList foldedPanels_; ///< the same of what is folded
};

} // namespace tactum
