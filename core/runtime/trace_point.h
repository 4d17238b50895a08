// One servo tick as the window draws it over time, and as a study logs it.
#pragma once

#include "core/haptics/touched_place.h"
#include "core/runtime/servo_telemetry.h"

namespace tactum {

/// Plain values, world frame, SI.
struct TracePoint {
    double t = 0; ///< s since the start
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< N, what the device was sent
    /// N, what the scene asks for (equation 24), whatever the device bears and whether or not forces are on.
    Vec3 wanted = Vec3::Zero();
    double energy = 0;     ///< J that the surface gave beyond what it took
    bool touching = false; ///< some plane of the local contact model pushes
    // Shares of the force, N: along the felt normals of what is touched, and along its surfaces.
    double normalForce = 0, tangentialForce = 0;
    double gain = 0;            ///< of the force: 0 with the forces off, 1 all of it
    bool limited = false;       ///< the force was shortened to what the motors bear
    std::uint64_t revision = 0; ///< of the World that the local contact model is of; 0: there was none
    TouchedPlace touched{};     ///< by the step that the local contact model is of
};

/// The point with what its contacts say: the proxy, and how the force divides at the planes of the model.
/// Thread: real time; nearestPoint() once.
TracePoint tracePoint(TracePoint point, const LocalContactModel& model) noexcept;

/// The tick that was noted at last. Thread: real time; nearestPoint() a few times.
TracePoint tracePoint(double t, const ServoTelemetry& servo, const ServoOutput& output,
                      const LocalContactModel& model, const TouchedPlace& touched) noexcept;

} // namespace tactum
