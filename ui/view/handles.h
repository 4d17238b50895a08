// What the handles in the view share: what of them lies under the cursor, what a drag means along an axis, in
// a plane or about a ring, and holding one. Pixels are logical. Thread: ui.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <QPointF>
#include <QPolygonF>

#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

namespace tactum {

inline double lengthOf(QPointF p) {
    return std::hypot(p.x(), p.y());
}

/// Where on the screen something can be grabbed: at a dot, along a line, or inside of an area.
struct HandleShape {
    std::optional<QPointF> dot;
    QPolygonF line, area;

    bool operator==(const HandleShape&) const = default;
};

/// Pixels from which a dot is grabbed, and a line.
inline constexpr double kDotNear = 9, kLineNear = 5;

/// Of shapes that lie over each other a dot comes before a line, and that before an area; else the first.
template <class Handle>
std::optional<Handle> handleAt(const std::vector<std::pair<Handle, HandleShape>>& shapes, QPointF cursor);

/// From a point to a line in pieces; far for a line without any.
double distanceTo(const QPolygonF& line, QPointF p);
/// Empty where any of it is behind the eye.
QPolygonF onScreen(const std::vector<Vec3>& points, const ViewCamera& camera);
/// About an axis (0 to 2) of a frame, `along` it from the origin; its last point is its first. Unit: m.
std::vector<Vec3> ring(const Pose& frame, int about, double radius, double along = 0);
/// Of an axis of the world or of a frame.
const QColor& axisColour(const Theme& theme, int axis);

// What a drag from one place of the view to another means. World frame, unit lengths for directions.

/// How far along a line, m.
double draggedAlong(const Vec3& origin, const Vec3& direction, QPointF from, QPointF to,
                    const ViewCamera& camera);
/// The way in a plane, m; in one that is looked at from its edge none.
Vec3 draggedIn(const Vec3& origin, const Vec3& normal, QPointF from, QPointF to, const ViewCamera& camera);
/// The turn of a ring about an axis of a frame by a drag along its tangent where it was taken, rad.
double draggedAbout(const Pose& frame, int about, double radius, QPointF from, QPointF to,
                    const ViewCamera& camera);
/// The turn about the line of sight through a point, rad.
double draggedRound(const Vec3& origin, QPointF from, QPointF to, const ViewCamera& camera);
/// How much farther from a point, as a ratio.
double draggedOut(const Vec3& origin, QPointF from, QPointF to, const ViewCamera& camera);

/// What the view asks of all handles, whatever they do.
class ViewHandles {
public:
    virtual ~ViewHandles() = default;
    virtual bool isUnder(QPointF cursor, const ViewCamera& camera) const = 0;
    /// Takes what lies under the cursor; false: nothing does.
    virtual bool take(QPointF cursor, const ViewCamera& camera) = 0;
    virtual bool shows() const = 0;
    virtual void letGo() = 0;
};

/// The handles of one value, which is drawn over the model and dragged by them. A drag counts from the value
/// when it was taken.
template <class Handle, class Value> class HandlesOf : public ViewHandles {
public:
    using Shapes = std::vector<std::pair<Handle, HandleShape>>;

    /// Nothing: nothing is drawn and nothing can be grabbed.
    void show(const std::optional<Value>& value) { shown_ = value; }
    const std::optional<Value>& shown() const { return shown_; }

    std::optional<Handle> at(QPointF cursor, const ViewCamera& camera) const {
        return shown_ ? handleAt(shapes(camera), cursor) : std::nullopt;
    }
    void grab(Handle handle, QPointF cursor) {
        if (shown_) held_ = Grip{handle, cursor, *shown_};
    }
    bool held() const { return held_.has_value(); }
    /// The value when it was taken; held() must be true.
    const Value& before() const { return held_->value; }

    bool isUnder(QPointF cursor, const ViewCamera& camera) const override {
        return at(cursor, camera).has_value();
    }
    bool take(QPointF cursor, const ViewCamera& camera) override {
        const auto handle = at(cursor, camera);
        if (handle) grab(*handle, cursor);
        return handle.has_value();
    }
    bool shows() const override { return shown_.has_value(); }
    void letGo() override { held_.reset(); }

protected:
    struct Grip {
        Handle handle;
        QPointF from;
        Value value;
    };
    /// Of what is shown; nothing of it for what is behind the eye.
    virtual Shapes shapes(const ViewCamera& camera) const = 0;
    /// The one that is held, else the one under the cursor.
    std::optional<Handle> lit(QPointF cursor, const ViewCamera& camera) const {
        return held_ ? std::optional(held_->handle) : at(cursor, camera);
    }

    std::optional<Value> shown_;
    std::optional<Grip> held_;
};

template <class Handle>
std::optional<Handle> handleAt(const std::vector<std::pair<Handle, HandleShape>>& shapes, QPointF cursor) {
    std::optional<Handle> nearest; // dots of two handles may lie side by side
    double least = kDotNear;
    for (const auto& [handle, shape] : shapes)
        if (const double away = shape.dot ? lengthOf(*shape.dot - cursor) : kDotNear + 1;
            away < least || (!nearest && away <= least)) {
            nearest = handle;
            least = away;
        }
    if (nearest) return nearest;
    for (const auto& [handle, shape] : shapes)
        if (distanceTo(shape.line, cursor) <= kLineNear) return handle;
    for (const auto& [handle, shape] : shapes)
        if (shape.area.containsPoint(cursor, Qt::OddEvenFill)) return handle;
    return std::nullopt;
}

} // namespace tactum
