// One servo tick as the window draws it over time.
#pragma once

#include "core/haptics/contact_model.h"

namespace tactum {

/// Plain values, world frame, SI.
struct TracePoint {
    double t = 0; ///< s since the start
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< N, what the device was sent
    double energy = 0;         ///< J that the surface gave beyond what it took
    bool touching = false;     ///< some plane of the local contact model pushes
    // Shares of the force, N: along the felt normals of what is touched, and along its surfaces.
    double normalForce = 0, tangentialForce = 0;
};

/// The point with what its contacts say: the proxy, and how the force divides at the planes of the model.
/// Thread: real time; nearestPoint() once.
TracePoint tracePoint(TracePoint point, const LocalContactModel& model) noexcept;

} // namespace tactum
