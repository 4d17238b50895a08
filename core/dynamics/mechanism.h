// Bodies and joints, compiled: a forest of links with one kind of freedom each, and what else acts between
// them. Immutable, shared by all that step through it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/dynamics/air.h"
#include "core/dynamics/convex.h"
#include "core/dynamics/joint.h"
#include "core/dynamics/path_curve.h"
#include "core/dynamics/place.h"
#include "core/dynamics/rigid_body.h"

namespace tactum {

enum class LinkKind : std::uint8_t {
    Slide, ///< along an axis: one coordinate
    Turn,  ///< about an axis: one coordinate
    Ball,  ///< about all three: a quaternion x, y, z, w, and the turn rate in the link's own frame
    Path   ///< along a curve: its coordinate is the way, m
};

/// One freedom, and what moves with it. A joint with several freedoms is a chain of links of which the last
/// one carries the body; a body without any freedom of its own belongs to its parent's link.
struct Link {
    LinkKind kind = LinkKind::Turn;
    int parent = -1; ///< a link that comes before it; -1: the world
    int island = 0;
    int axis = 0;                    ///< of Slide and Turn
    int path = -1;                   ///< of Path: which one
    bool carriesPath = false;        ///< the curve moves with this link, and the parent rides on it
    int q = 0, v = 0;                ///< its first coordinate and its first velocity
    AxisSet driven = 0;              ///< nothing changes its velocity: of Ball each axis, of others bit 0
    Pose base;                       ///< of its joint's frame, in the parent's link
    double mass = 0;                 ///< kg; 0: a link between two freedoms of a joint
    Vec3 centre = Vec3::Zero();      ///< of mass, link frame
    Mat3 moments = Mat3::Zero();     ///< about `centre`, kg m^2, link frame
    double heavy = 0;                ///< kg that gravity acts on
    Vec3 heavyCentre = Vec3::Zero(); ///< where, link frame

    int freedoms() const { return kind == LinkKind::Ball ? 3 : 1; }
};

/// What of the place of frame b relative to frame a is measured (the metrics of KHR_physics_rigid_bodies).
enum class Measure : std::uint8_t {
    Along,    ///< signed distance along axis of a
    Aside,    ///< distance from the line along axis of a
    Distance, ///< of the origins
    Twist,    ///< turn about axis
    Spin,     ///< how fast it turns about axis of the frame halfway from a to b, whose angle is the twist
    Cone,     ///< angle between axis of a and axis of b
    Turned,   ///< angle of the whole turn
    Tilt,     ///< cosine of the angle between axis of a and axis2 of b
    Way,      ///< along a path, whose tangent at b is axis of b; how far only its link knows
    Residue   ///< twice the vector part of the quaternion from a to b, along axis: for three locked axes
};

struct Coordinate {
    Measure measure = Measure::Along;
    int axis = 0, axis2 = 0;
    Place a, b;
    /// Where a single link measures the same thing: that one, and its sense. Turns then count beyond pi.
    int link = -1;
    double sense = 1;
};

struct Limit {
    Coordinate of;
    double min = 0, max = 0;
};
struct Spring {
    Coordinate of;
    JointDrive drive;
    double min = 0, max = 0; ///< of a soft limit: it acts beyond these alone
    bool isLimit = false;
};
struct DryFriction {
    Coordinate of;
    double force = 0;
};
/// A coordinate that is held where it is.
struct Lock {
    Coordinate of;
    double at = 0;
};

/// What of a body touches others.
struct Touchable {
    Place place;
    Convex convex;
    TouchMaterial material;
};

/// Bodies that joints connect without the help of the world: what one does matters to the others at once.
struct Island {
    int firstLink = 0, endLink = 0;
    int v = 0, velocities = 0; ///< of its links
    int firstLoop = 0, endLoop = 0;
};

struct Mechanism {
    std::vector<Link> links; ///< parents first, each island in one piece
    std::vector<Island> islands;
    std::vector<RigidBody> bodies; ///< as they were given
    std::vector<Place> places;     ///< of each body's frame
    std::vector<Lock> loops;       ///< of the joints that close loops, by island
    std::vector<Limit> limits;     ///< hard ones
    std::vector<Spring> springs;   ///< drives and soft limits
    std::vector<DryFriction> frictions;
    std::vector<PathCurve> paths;
    std::vector<AirBox> air; ///< of bodies that it slows
    std::vector<Touchable> touchables;
    std::vector<bool> meets; ///< of each two touchables, whether they may touch
    std::size_t loopJoints = 0;
    int qs = 0, vs = 0;     ///< numbers of coordinates and of velocities
    Eigen::VectorXd q0, v0; ///< at the time 0

    /// Whether two touchables are ever compared. Thread: real time.
    bool mayTouch(int a, int b) const noexcept {
        return meets[std::size_t(a) * touchables.size() + std::size_t(b)];
    }
};

} // namespace tactum
