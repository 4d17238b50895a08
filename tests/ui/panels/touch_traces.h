// Traces of touch whose every value is known.
#pragma once

#include <cmath>
#include <vector>

#include "core/runtime/channels.h"

namespace tactum::testing {

/// A finger that is pressed into the plane y = 0 and pulled along x: after t seconds with a normal force of
/// 2 N and a tangential one of t N, at a lag of 1 mm, coefficients 0.8 and 0.5.
inline TracePoint pulledAt(double t) {
    TracePoint point;
    point.t = t;
    point.finger = {0, -1e-3, 0};
    point.force = {t, 2, 0};
    point.energy = -1e-3 * t;
    point.touching = true;
    point.normalForce = 2;
    point.tangentialForce = t;
    return point;
}

inline std::vector<TracePoint> pulled(double from, double to, double step = 1e-3) {
    std::vector<TracePoint> points;
    for (int i = 0; from + i * step < to - 1e-9; ++i)
        points.push_back(pulledAt(from + i * step));
    return points;
}

inline HapticOutput pulledTouch() {
    HapticOutput touch;
    touch.contacts = 1;
    touch.contact[0].normal = Vec3::UnitY();
    touch.contact[0].normalForce = 2;
    touch.contact[0].staticFriction = 0.8;
    touch.contact[0].dynamicFriction = 0.5;
    return touch;
}

} // namespace tactum::testing
