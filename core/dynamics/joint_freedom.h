// What a joint leaves free, as a chain of links; what it holds, as coordinates. For this folder.
#pragma once

#include <vector>

#include "core/dynamics/mechanism.h"

namespace tactum {

struct LinkStage {
    LinkKind kind = LinkKind::Slide;
    int axis = 0;
    double start = 0;             ///< of Slide and Turn, m or rad
    Quat turn = Quat::Identity(); ///< of Ball
    double sense = 1;             ///< of the joint's coordinate along the link's
    int path = -1;                ///< of Path
    bool carriesPath = false;
};

/// X_parent,child = before * stages * after.
struct JointFreedom {
    Pose before;
    std::vector<LinkStage> stages;
    Pose after;
};

/// Whether a limit is a lock that takes its axes away altogether.
bool takesAxes(const JointLimit& limit);
/// Whether a joint takes away anything, and starts at `start` = X_ab within `near` (m, rad) of its locks.
bool isTreeJoint(const Joint& joint, const Pose& start, double near);
/// Exactly X_ab = start at first.
JointFreedom freedomOf(const Joint& joint, const Pose& start);
/// The same with a hanging on b.
JointFreedom reversed(const JointFreedom& freedom);
/// All six, relative to the world.
JointFreedom freeMotion(const Pose& start);

/// What has to be held of a joint that is no link.
std::vector<Lock> locksOf(const Joint& joint, const Place& a, const Place& b);
/// What a limit or a drive of these axes measures; its places are for the caller to set.
Coordinate coordinate(bool angular, AxisSet axes);

} // namespace tactum
