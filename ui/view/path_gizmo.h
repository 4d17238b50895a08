// The curve of a path joint in the view: drawn over the model, and dragged by its points.
#pragma once

#include <vector>

#include "ui/view/handles.h"

class QPainter;

namespace tactum {

/// A path in the world, at the time 0.
struct PathMark {
    std::vector<Vec3> points;
    bool closed = false;
    std::vector<Vec3> curve; ///< what goes through them

    bool operator==(const PathMark&) const = default;
};

/// A dot at each point moves it as the view lies; a ring half way between two makes one more there. Of many
/// all are drawn about the cursor, elsewhere no more than lie apart; all can be grabbed. The number of a
/// handle is that of the point, or of all points and that of the point before. Knows no widget. Thread: ui.
class PathGizmo : public HandlesOf<int, PathMark> {
public:
    const std::optional<PathMark>& mark() const { return shown(); }

    /// Nothing for a handle that is not there or behind the eye.
    std::optional<QPointF> placeOf(int handle, const ViewCamera& camera) const;
    /// The points where the cursor leads them; `snapped`: in steps of 5 mm from where the drag began.
    std::vector<Vec3> dragged(QPointF cursor, const ViewCamera& camera, bool snapped) const;
    /// The handles that are drawn.
    std::vector<int> drawn(const ViewCamera& camera, QPointF cursor) const;
    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const;

private:
    Shapes shapes(const ViewCamera& camera) const override;
    int handles(const PathMark& mark) const;
};

} // namespace tactum
