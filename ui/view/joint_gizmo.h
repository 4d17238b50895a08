// The free axis of a joint in the view: drawn over the model with its stops, and dragged by its handles.
#pragma once

#include <optional>

#include "ui/view/handles.h"

class QPainter;

namespace tactum {

/// What of a joint has a place in the world, where it begins.
struct JointMark {
    bool turns = true; ///< else it slides
    Vec3 at = Vec3::Zero();
    Vec3 axis = Vec3::UnitY(); ///< of unit length
    Vec3 body = Vec3::Zero();  ///< the middle of what it holds
    double low = 0, high = 0;  ///< rad or m; endless: no stop
    bool hasLow = false, hasHigh = false;

    bool operator==(const JointMark&) const = default;
};

enum class JointHandle { Place, Tip, Low, High };

/// The line is the axis; its square moves it, its tip turns it, which snaps to the axes of the world within
/// three degrees. The arc, or the bar along the line, goes from stop to stop; its ends move these. Knows no
/// widget. Thread: ui.
class JointGizmo : public HandlesOf<JointHandle, JointMark> {
public:
    const std::optional<JointMark>& mark() const { return shown(); }

    /// Nothing for a handle behind the eye. A stop that there is not stands where one would begin.
    std::optional<QPointF> placeOf(JointHandle handle, const ViewCamera& camera) const;
    /// The joint where the cursor leads it. Stops stay on their sides of 0.
    JointMark dragged(QPointF cursor, const ViewCamera& camera) const;
    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const;

private:
    Shapes shapes(const ViewCamera& camera) const override;
};

} // namespace tactum
