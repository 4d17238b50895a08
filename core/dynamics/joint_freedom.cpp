#include "core/dynamics/joint_freedom.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tactum {

namespace {

int countOf(AxisSet axes) {
    return std::popcount(unsigned(axes));
}

bool has(AxisSet axes, int axis) {
    return (axes >> axis & 1) != 0;
}

int firstOf(AxisSet axes) {
    return std::countr_zero(unsigned(axes));
}

struct Locked {
    AxisSet linear = 0, angular = 0;
    Vec3 along = Vec3::Zero();      ///< where the linear ones are locked, m
    Quat turned = Quat::Identity(); ///< and the angular ones
};

Locked lockedOf(const Joint& joint) {
    Locked locked;
    for (const JointLimit& limit : joint.limits) {
        if (!takesAxes(limit)) continue;
        AxisSet& axes = limit.angular ? locked.angular : locked.linear;
        axes = AxisSet(axes | limit.axes);
        if (limit.min == 0) continue;
        const int axis = firstOf(limit.axes);
        if (limit.angular)
            locked.turned = locked.turned * Quat(Eigen::AngleAxisd(limit.min, Vec3::Unit(axis)));
        else
            locked.along[axis] = limit.min;
    }
    return locked;
}

/// The turn about an axis that comes nearest to a rotation.
double twist(const Quat& q, int axis) {
    return 2 * std::atan2(q.vec()[axis] * (q.w() < 0 ? -1 : 1), std::abs(q.w()));
}

Quat turnAround(int axis, double angle) {
    return Quat(Eigen::AngleAxisd(angle, Vec3::Unit(axis)));
}

/// The turns that the locked axes leave, beginning at `start`; gives what is left of it.
Quat addTurns(AxisSet locked, const Quat& start, std::vector<LinkStage>& stages) {
    if (locked == kAllAxes) return start;
    if (locked == 0) {
        stages.push_back({LinkKind::Ball, 0, 0, start, 1});
        return Quat::Identity();
    }
    const auto turn = [&](int axis, double angle) {
        stages.push_back({LinkKind::Turn, axis, angle, Quat::Identity(), 1});
    };
    if (countOf(locked) == 2) {
        const int axis = firstOf(AxisSet(~locked & kAllAxes));
        const double angle = twist(start, axis);
        turn(axis, angle);
        return turnAround(axis, -angle) * start;
    }
    // A universal joint: one axis stands on a, the other on b, at a right angle.
    const int k = firstOf(locked), i = (k + 1) % 3, j = (k + 2) % 3;
    const Mat3 m = start.toRotationMatrix();
    const double first = std::atan2(m(k, j), m(j, j));
    const Quat rest = turnAround(i, -first) * start;
    const double second = twist(rest, j);
    turn(i, first);
    turn(j, second);
    return turnAround(j, -second) * rest;
}

} // namespace

bool takesAxes(const JointLimit& limit) {
    return limit.isLock() && (limit.min == 0 || countOf(limit.axes) == 1);
}

bool isTreeJoint(const Joint& joint, const Pose& start, double near) {
    const Locked locked = lockedOf(joint);
    if (locked.linear == 0 && locked.angular == 0) return false;
    for (int i = 0; i < 3; ++i)
        if (has(locked.linear, i) && std::abs(start.translation[i] - locked.along[i]) > near) return false;
    std::vector<LinkStage> stages;
    const Quat rest = addTurns(locked.angular, start.rotation * locked.turned.conjugate(), stages);
    return 2 * rest.vec().norm() <= near;
}

JointFreedom freedomOf(const Joint& joint, const Pose& start) {
    const Locked locked = lockedOf(joint);
    JointFreedom freedom;
    for (int i = 0; i < 3; ++i) {
        if (has(locked.linear, i))
            freedom.before.translation[i] = start.translation[i];
        else
            freedom.stages.push_back({LinkKind::Slide, i, start.translation[i], Quat::Identity(), 1});
    }
    freedom.after.rotation = addTurns(locked.angular, start.rotation, freedom.stages);
    return freedom;
}

JointFreedom reversed(const JointFreedom& freedom) {
    JointFreedom other{freedom.after.inverse(), freedom.stages, freedom.before.inverse()};
    std::ranges::reverse(other.stages);
    for (LinkStage& stage : other.stages) {
        stage.carriesPath = stage.kind == LinkKind::Path;
        if (stage.carriesPath) continue; // its way is the same one
        stage.start = -stage.start;
        stage.turn = stage.turn.conjugate();
        stage.sense = -stage.sense;
    }
    return other;
}

JointFreedom freeMotion(const Pose& start) {
    return freedomOf(Joint{}, start);
}

std::vector<Lock> locksOf(const Joint& joint, const Place& a, const Place& b) {
    const Locked locked = lockedOf(joint);
    std::vector<Lock> locks;
    for (int i = 0; i < 3; ++i)
        if (has(locked.linear, i)) locks.push_back({{Measure::Along, i, 0, a, b}, locked.along[i]});
    Place turned = b; // as b would be without the turn at which it is locked
    turned.pose.rotation = b.pose.rotation * locked.turned.conjugate();
    const auto hold = [&](Measure measure, int axis, int axis2) {
        locks.push_back({{measure, axis, axis2, a, turned}, 0});
    };
    const int count = countOf(locked.angular);
    if (count == 3)
        for (int i = 0; i < 3; ++i)
            hold(Measure::Residue, i, 0);
    if (count == 2) {
        const int free = firstOf(AxisSet(~locked.angular & kAllAxes));
        hold(Measure::Tilt, (free + 1) % 3, free);
        hold(Measure::Tilt, (free + 2) % 3, free);
    }
    if (count == 1) {
        const int k = firstOf(locked.angular);
        hold(Measure::Tilt, (k + 1) % 3, (k + 2) % 3);
    }
    return locks;
}

Coordinate coordinate(bool angular, AxisSet axes) {
    const int count = countOf(axes);
    const int axis = count == 2 ? firstOf(AxisSet(~axes & kAllAxes)) : firstOf(axes);
    Coordinate of;
    of.axis = of.axis2 = axis;
    if (angular)
        of.measure = count == 1 ? Measure::Twist : count == 2 ? Measure::Cone : Measure::Turned;
    else
        of.measure = count == 1 ? Measure::Along : count == 2 ? Measure::Aside : Measure::Distance;
    return of;
}

} // namespace tactum
