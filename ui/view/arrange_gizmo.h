// The handles that move, turn and scale objects in the view.
#pragma once

#include <optional>

#include <QString>

#include "core/scene/arrange.h"
#include "ui/view/handles.h"

class QPainter;

namespace tactum {

/// In planes, along axes, about axes, about the line of sight, all around the pivot.
enum class ArrangeHandle {
    Move,
    MoveX,
    MoveY,
    MoveZ,
    MoveYZ,
    MoveZX,
    MoveXY,
    TurnX,
    TurnY,
    TurnZ,
    Turn,
    Scale
};

/// Arrows move along an axis, squares in a plane, the dot in that of the camera; rings turn about an axis,
/// the outer one about the line of sight; the square on it scales. As large on the screen from any distance.
/// What is shown is X_W of the pivot and the axes. Knows no widget. Thread: ui.
class ArrangeGizmo : public HandlesOf<ArrangeHandle, Pose> {
public:
    /// Where on the screen a handle can be grabbed; nothing for one behind the eye.
    std::optional<QPointF> placeOf(ArrangeHandle handle, const ViewCamera& camera) const;

    /// As grab(), without a button: turns then follow the pointer around the pivot.
    void grabFree(ArrangeHandle handle, QPointF cursor);
    bool takenFree() const { return held() && free_; }
    /// The same drag, from where it began, along or about another axis of the frame.
    void keepTo(int axis);
    bool take(QPointF cursor, const ViewCamera& camera) override;
    /// The pointer went on; `fine`: it counts for a tenth.
    void lead(QPointF step, bool fine);
    /// A key of a number, which counts instead of the pointer: mm along the first axis that it may move
    /// along, degrees or a factor. Minus turns the sign round, without digits the pointer counts again.
    /// False: no such key.
    bool type(int key);
    /// What the drag comes to so far; `snapped`: in even steps, smaller ones where it is fine.
    Arrangement dragged(const ViewCamera& camera, bool snapped, bool fine) const;

    /// `now`: what was made of the drag so far, to be told beside the handles.
    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor,
              const std::optional<Arrangement>& now) const;

private:
    Shapes shapes(const ViewCamera& camera) const override;
    Vec3 draggedMove(const ViewCamera& camera) const;
    double draggedTurn(const ViewCamera& camera) const;
    Vec3 turnAxis(const ViewCamera& camera) const;
    Arrangement typed(const ViewCamera& camera) const;
    /// What is typed, once it is a number that the handle can take.
    std::optional<double> number() const;
    bool mayMove(int axis) const;
    QString words(const Arrangement& now, const ViewCamera& camera) const;

    bool free_ = false;
    QString typed_; ///< a number, or what is there of it
    QPointF led_;   ///< where the pointer would be without fine ways
};

} // namespace tactum
