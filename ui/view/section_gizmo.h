// The plane of a section in the view: its frame drawn over the model, and the handles it is dragged by.
#pragma once

#include <optional>

#include "ui/view/handles.h"
#include "ui/view/section_plane.h"

class QPainter;

namespace tactum {

/// Move: along the normal. TurnX, TurnY: about the axes in the plane.
enum class SectionHandle { Move, TurnX, TurnY };

/// The arrow, or the rim, moves the plane along its normal; the rings turn it. Handles are as large on the
/// screen from any distance. Knows no widget. Thread: ui.
class SectionGizmo : public HandlesOf<SectionHandle, SectionPlane> {
public:
    /// How far the rim is from the origin of the plane, m.
    void setReach(double metres) { reach_ = metres; }
    double reach() const { return reach_; }

    /// Where on the screen a handle can be grabbed; nothing for one that is not there or behind the eye.
    std::optional<QPointF> placeOf(SectionHandle handle, const ViewCamera& camera) const;
    /// The plane where the cursor leads it; `snapped`: from where it was in steps of 5 mm or 15 degrees.
    SectionPlane dragged(QPointF cursor, const ViewCamera& camera, bool snapped) const;
    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const;

private:
    Shapes shapes(const ViewCamera& camera) const override;
    QPolygonF rim(const ViewCamera& camera) const;

    double reach_ = 0.1;
};

} // namespace tactum
