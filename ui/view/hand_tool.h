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

/// Holds the goal and the time in which the hand should be there; the hand goes the way itself. Frame W, SI.
/// Knows no widget and draws nothing. Thread: ui.
/// A press has parts that follow each other: on the way to the place, near it but not touching yet, and down.
/// The hand rests between them, so that it presses as slowly as it means to, however fast it came. A press
/// that was let go before it was down is a tap: it goes on, half as deep, and then lifts off.
/// docs/stability.md#the-simulated-hand has the figures.
class HandTool {
public:
    /// How far beneath the surface a press goes, as a part of the scene's diagonal: 8 mm for a model of 0.2
    /// m, which hand and a surface of the initial stiffness share between them: 1.5 N.
    static constexpr double kPressDepth = 0.04;
    static constexpr double kTapDepth = 0.5; ///< of that, where nobody holds on
    /// How far off the surface a hand is that has lifted off, likewise.
    static constexpr double kHoverHeight = 0.02;
    static constexpr double kShortestApproach = 0.08, kLongestApproach = 0.15; ///< s
    static constexpr double kPressTime = 0.18, kLiftTime = 0.12;               ///< s
    static constexpr double kFollowTime = 0.04;                                ///< s, behind the pointer

    const Vec3& goal() const { return goal_; }
    double time() const { return time_; } ///< s, in which the hand should be at the goal
    Grip grip() const { return grip_; }
    /// Whether a press has not come all the way yet.
    bool gliding() const { return part_ == Part::Way || part_ == Part::Near || part_ == Part::Down; }
    bool moves() const { return part_ != Part::None && part_ != Part::Up; }

    void setGoal(const Vec3& p_W);
    /// Diagonal of the scene: presses, wheel notches and key steps are parts of it.
    void setSceneSize(double metres) { sceneSize_ = metres; }

    /// Takes hold to stroke: comes to the touched point and goes `pressDepth` beyond it, along the view.
    /// `gap`: nothing is felt farther than this before the point, m.
    void beginStroke(QPointF cursor, const Vec3& touched_W, double gap, const ViewCamera& camera,
                     const Bounds& box, const IsFree& isFree);
    /// Takes hold where the goal is.
    void beginMove(Grip grip, QPointF cursor);
    /// Lets go. What has not come down yet still does.
    void end();
    /// Lets go, and nothing more is touched.
    void giveUp();

    /// Whether nobody holds a hand that may be down: lift() is due.
    bool isDone() const { return part_ == Part::Done; }
    void lift(const Vec3& to_W);
    /// Whether it has lifted off and nobody has led it since: from what comes back against it, a key on its
    /// spring, it lifts off once more.
    bool isUp() const { return part_ == Part::Up; }
    /// Where the last stroke is off the surface; empty when the last hold was none or has left the model.
    const std::optional<Vec3>& offSurface() const { return off_; }

    /// The cursor moved with the finger held; `touched_W` is the point of the model under it, if any.
    void moveTo(QPointF cursor, const ViewCamera& camera, const std::optional<Vec3>& touched_W,
                bool alongView);
    /// Moves along the view by notches of the wheel; positive goes away from the eye.
    void push(double notches, const ViewCamera& camera);
    /// Moves by steps of a key: right, up, away.
    void nudge(const Vec3& steps, const ViewCamera& camera);
    /// Goes on; true while there is anything to go on with.
    bool advance(double seconds);

private:
    enum class Part { None, Way, Near, Down, Done, Lift, Up };

    void setPlaces(const Vec3& touched_W, const ViewCamera& camera);
    void begin(Part part, double duration);
    void next();
    void lead(const Vec3& to, double atLeast = kFollowTime);
    void shift(double metres, const ViewCamera& camera);
    void followPlaces();

    Vec3 goal_ = Vec3::Zero();
    double time_ = 0;
    Grip grip_ = Grip::None;
    QPointF cursor_;
    double sceneSize_ = 0.2;
    double pressDepth_ = 0, gap_ = 0;
    Vec3 near_ = Vec3::Zero(), deep_ = Vec3::Zero(), away_ = Vec3::UnitZ();
    std::optional<Vec3> off_;
    Part part_ = Part::None;
    double partTime_ = 0, partDuration_ = 0;
    GlidePath glide_;
};

} // namespace tactum
