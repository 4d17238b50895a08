// Cutting the model open in the view: the commands, the row over the view, the handles.
#pragma once

#include <optional>

#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/view/section_plane.h"

class QLabel;

namespace tactum {

class NumberBox;
class ToolStrip;

/// A section is shown, never felt and never saved; another scene begins whole. Thread: ui.
class SectionController : public QObject {
    Q_OBJECT
public:
    explicit SectionController(const Workbench& bench);

    /// As another scene begins.
    void makeWhole() { cut(false); }

private:
    void fillStrip();
    void cut(bool on);
    /// Through the middle of the scene, across an axis of the world, 0 to 2.
    void cutAcross(int axis);
    void turnOver();
    void moveTo(double place);
    void set(const SectionPlane& plane);
    void show();
    void useUnit();

    Workbench bench_;
    ToolStrip* strip_;
    NumberBox* place_; ///< in the unit of lengths that the person prefers
    QLabel* unit_;
    double factor_ = 1;
    std::optional<SectionPlane> beforeDrag_; ///< to come back to while one goes on
};

} // namespace tactum
