// What an author makes of the objects of a scene: bodies with mass, and joints with one free axis. Functions
// on values; the window puts each into one step of its history. Thread: any but real time.
#pragma once

#include <array>
#include <optional>

#include "core/scene/scene.h"
#include "core/scene/world_fields.h"
#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kBodyMass{
    "body-mass", "Mass", "kg",
    1e-12,       1e9,    1e-3,
    0.1,         15,     "How hard it is to move. At first that of its volume in water."};
inline constexpr Parameter kGravityFactor{"body-gravity",
                                          "Gravity",
                                          "",
                                          -2,
                                          2,
                                          0.1,
                                          1,
                                          2,
                                          "How much of the scene's gravity it feels; 0: it floats."};

struct BodyField {
    const Parameter* parameter;
    double RigidBody::*value;
};
/// The mass is set by setMass(), which keeps the form of the moments.
inline constexpr std::array<BodyField, 2> kBodyFields{
    {{&kBodyMass, &RigidBody::mass}, {&kGravityFactor, &RigidBody::gravityFactor}}};

enum class AxisKind : std::uint8_t { Hinge, Slider, Path };

/// A joint that leaves one axis free, as most are that people make, or the way along a curve. Angles in rad
/// and N m, ways in m and N.
struct AxisJoint {
    AxisKind kind = AxisKind::Hinge;
    BodyId to = kWorldBody;    ///< the body that it is fixed to
    Vec3 at = Vec3::Zero();    ///< m, world frame
    Vec3 axis = Vec3::UnitY(); ///< unit length, world frame; of a path none
    JointPath path;            ///< of a path, at the time 0 in the world frame; `at` is where it is ridden on
    double low = -kUnbounded, high = kUnbounded;
    double stiffness = 0, rest = 0; ///< of its spring
    double damping = 0;
    double friction = 0;
    double speed = 0, strength = 0; ///< of its motor; no strength: it has none
    double spacing = 0, detent = 0; ///< of its detents, and the force that leaves one; either 0: none

    bool operator==(const AxisJoint&) const = default;
};

struct AxisField {
    const Parameter* hinge;
    const Parameter* slider;
    double AxisJoint::*value;
    /// What it is nothing without, such as the strength of a motor without which there is no speed; null:
    /// nothing.
    double AxisJoint::*needs = nullptr;
    double usualOfHinge = 0, usualOfSlider = 0; ///< of what it needs, in that figure's unit

    /// A stop at the end of its range is none.
    bool isStop() const { return value == &AxisJoint::low || value == &AxisJoint::high; }
    const Parameter& of(AxisKind kind) const { return kind == AxisKind::Hinge ? *hinge : *slider; }
    double endless() const { return value == &AxisJoint::low ? -kUnbounded : kUnbounded; }
};
extern const std::array<AxisField, 10> kAxisFields;

/// One figure as an author sets it, brought into its range; a stop at the end of its range is none. What it
/// needs and is 0 gets its usual value: else whichever of the two were set first would be gone.
void setFigure(AxisJoint& joint, const AxisField& field, double value);

/// Makes an object a loose body of the density of water, and of every other object something that bodies can
/// lie on, unless the scene has such already. What its parts that share no vertex enclose is what touches:
/// convex, as hulls. Nothing for an object that moves by its keys or is a body already.
BodyId makeBody(Scene& scene, ObjectId object);
/// What bodies can lie on, of an object that stands still and has no such yet; nothing for one that moves.
void addStillColliders(Scene& scene, ObjectId object);
/// The body of an object goes, with its joints; its objects stay where they are at the time 0.
void makeStill(Scene& scene, BodyId body);

/// What bodies meet of an object that is about to be removed goes, and its body, if nothing else moves with
/// it.
void removeMechanics(Scene& scene, ObjectId object);

/// What moves an object.
enum class Moves : std::uint8_t { Never, ByKeys, Loose, OnJoints };
Moves movesOf(const Scene& scene, const SceneObject& object);

RigidBody* findBody(Scene& scene, BodyId id);
const RigidBody* findBody(const Scene& scene, BodyId id);
/// The moments change in proportion.
void setMass(RigidBody& body, double mass);

/// How many joints hold a body, of any kind: those at whose end it is. The first one of a body in a chain is
/// what it hangs on, others close loops.
std::size_t jointsOf(const Scene& scene, BodyId body);
/// One of them, where it is of this kind.
std::optional<AxisJoint> axisJointOf(const Scene& scene, BodyId body, std::size_t which = 0);
/// In place of one of them, or one more behind them; nothing for a body that there is not, nor of a path that
/// is no curve. What rides on a path stays where it is on the new one.
void setAxisJoint(Scene& scene, BodyId body, const AxisJoint& joint, std::size_t which = 0);
void removeJoint(Scene& scene, BodyId body, std::size_t which);
/// A body without joints.
void setLoose(Scene& scene, BodyId body);

/// Joints as the form of a body suggests them, the likeliest first; at least one. A hinge is the axis of what
/// is round, else that edge of its box that is nearest to what does not move with it, the longer one of two;
/// a slider goes where nothing is in its way, the longer side of two, and a path begins as such a line.
std::vector<AxisJoint> guessedJoints(const Scene& scene, BodyId body, AxisKind kind);
AxisJoint guessedJoint(const Scene& scene, BodyId body, AxisKind kind);

} // namespace tactum
