// Measuring in the view: places on bodies, the distance and the angle between them, and how that is drawn.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QRegion>
#include <QString>

#include "core/scene/scene.h"
#include "ui/base/theme.h"
#include "ui/view/section_plane.h"
#include "ui/view/view_camera.h"

class QFont;
class QPainter;

namespace tactum {

/// A place on a body, which goes with it: what is measured is what is seen now, also while bodies move.
struct MeasurePoint {
    ObjectId object = 0;
    Vec3 p_B = Vec3::Zero();                ///< body frame, m
    std::shared_ptr<const TriangleSoup> of; ///< of that time: of another shape it would be another place

    bool operator==(const MeasurePoint&) const = default;
};

/// What two or three points say.
struct MeasuredNumbers {
    Vec3 way = Vec3::Zero();     ///< from the first to the second point, m
    std::optional<double> angle; ///< at the second between the other two, rad, 0 to pi; nothing of two points
};

/// Nothing of fewer than two points. World frame, metre.
std::optional<MeasuredNumbers> numbersOf(std::span<const Vec3> points_W);

/// "103.92 mm", in the unit that the person prefers. Thread: ui.
QString measuredText(double metres);
/// The numbers in lines, for the clipboard: a name, a number and a unit in each. Thread: ui.
QString measuredLines(const MeasuredNumbers& numbers);

/// The place on a triangle that is meant by a click on it at `hit_W`: the corner, else the point of the edge,
/// that is drawn near the cursor and not cut away, else the hit itself. World frame.
Vec3 snappedTo(const TriangleSoup& soup, Index triangle, const Pose& X_WB, const Vec3& hit_W, QPointF cursor,
               const ViewCamera& camera, const std::optional<SectionPlane>& section);

/// Where the numbers of a measure are written, in logical pixels: beside its lines, but inside of the view
/// and not under `covered`, where there is room.
std::vector<QRectF> measureBoxes(std::span<const Vec3> points_W, const ViewCamera& camera, const QFont& font,
                                 const QRegion& covered);

/// Points, lines and numbers, in logical pixels; `next`: the place under the cursor that a click would add.
/// `covered`: of the view, by what lies over it.
void drawMeasure(QPainter& painter, std::span<const Vec3> points_W, const std::optional<Vec3>& next_W,
                 const ViewCamera& camera, const Theme& theme, const QRegion& covered = {});

} // namespace tactum
