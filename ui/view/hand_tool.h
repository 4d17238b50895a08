// The mouse as a hand: how presses, drags, wheel and keys lead the finger's goal.
#pragma once

#include <optional>

#include "ui/view/glide_path.h"
#include "ui/view/view_camera.h"

namespace tactum {

/// How the finger is held.
enum class Grip {
    None,
    Stroke, ///< the goal stays a little beneath the surface under the cursor
    Drag,   ///< the goal moves in the camera's plane while the button is down
    Follow  ///< the same without a button
};

/// Holds the goal. Frame W, metre. Knows no widget and draws nothing. Thread: ui.
class HandTool {
public:
    /// How far beneath the surface a press goes, as a part of the scene's diagonal: 8 mm for a model of 0.2
    /// m, which a surface of the initial stiffness answers with 6 N.
    static constexpr double kPressDepth = 0.04;

    const Vec3& goal() const { return goal_; }
    Grip grip() const { return grip_; }
    bool gliding() const { return gliding_; }

    void setGoal(const Vec3& p_W);
    /// Diagonal of the scene: presses, wheel notches and key steps are parts of it.
    void setSceneSize(double metres) { sceneSize_ = metres; }

    /// Takes hold to stroke: glides to the touched point and `pressDepth` beyond it, along the view.
    void beginStroke(QPointF cursor, const Vec3& touched_W, const ViewCamera& camera, const Bounds& box,
                     const IsFree& isFree);
    /// Takes hold where the goal is.
    void beginMove(Grip grip, QPointF cursor);
    void end();

    /// The cursor moved with the finger held; `touched_W` is the point of the model under it, if any.
    void moveTo(QPointF cursor, const ViewCamera& camera, const std::optional<Vec3>& touched_W,
                bool alongView);
    /// Moves along the view by notches of the wheel; positive goes away from the eye.
    void push(double notches, const ViewCamera& camera);
    /// Moves by steps of a key: right, up, away.
    void nudge(const Vec3& steps, const ViewCamera& camera);
    /// Continues a glide; true while the goal moves.
    bool advance(double seconds);

private:
    double pressDepth() const { return pressDepth_ * sceneSize_; }
    void setTarget(const Vec3& target);
    void shift(double metres, const ViewCamera& camera);

    Vec3 goal_ = Vec3::Zero();
    Grip grip_ = Grip::None;
    QPointF cursor_;
    double sceneSize_ = 0.2;
    double pressDepth_ = 0;
    bool gliding_ = false;
    GlidePath glide_;
    double glideTime_ = 0, glideDuration_ = 0;
};

} // namespace tactum
