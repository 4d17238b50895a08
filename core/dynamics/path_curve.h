// The curve of a path joint as it is stepped along: places, and how they change with the way, to the last
// digit from one function. For this folder.
#pragma once

#include "core/base/result.h"
#include "core/dynamics/path.h"
#include "core/dynamics/quintic_spline.h"

namespace tactum {

/// Where what rides is, in the frame of the curve: x along it, y up, z aside. Its derivatives by the way make
/// the motion subspace of the joint, S, and S'.
struct PathSpot {
    Pose pose;
    Vec3 way = Vec3::UnitX();     ///< d/ds of the place: of unit length but for 1e-6 or so
    Vec3 turn = Vec3::Zero();     ///< how the axes turn, rad/m
    Vec3 wayRate = Vec3::Zero();  ///< d/ds of `way`: the curvature, 1/m
    Vec3 turnRate = Vec3::Zero(); ///< d/ds of `turn`, rad/m^2
};

class PathCurve {
public:
    /// Errors: fewer than two points (closed: three), two points in one place, turns too sharp for a frame,
    /// an up that lies along the curve. Thread: any but real time.
    static Result<PathCurve> through(const JointPath& path);

    /// Of the whole way, m.
    double length() const noexcept { return curve_.end(); }
    bool isClosed() const noexcept { return closed_; }
    /// `s`: the way from the first point, m. A closed one begins again after its length; beyond an open end
    /// it goes on straight. Thread: real time.
    PathSpot at(double s) const noexcept;
    /// The way to where the curve is nearest to a place; where it crosses itself, to the place turned most
    /// alike. Thread: any but real time.
    double nearest(const Pose& to) const;

private:
    QuinticSpline curve_; ///< of the way: place and up
    bool closed_ = false;
};

} // namespace tactum
