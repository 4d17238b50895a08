#include "core/runtime/trace_point.h"

namespace tactum {

// The part of -force that no plane forbids is what pulls along the surfaces; the rest the normals push.
// Planes that all pass through the proxy, whatever gap they have: they divide a direction, not a place.
TracePoint tracePoint(TracePoint point, const LocalContactModel& model) noexcept {
    point.proxy = model.valid ? model.proxy : point.finger;
    point.revision = model.valid ? model.revision : 0;
    if (!model.valid || model.planes == 0) return point;
    std::array<ConstraintPlane, kMaxModelPlanes> planes = model.plane;
    for (ConstraintPlane& plane : planes)
        plane.offset = 0;
    const NearestPoint along = nearestPoint(-point.force, {planes.data(), std::size_t(model.planes)});
    point.touching = along.active > 0;
    if (!point.touching) return point;
    point.tangentialForce = along.x.norm();
    point.normalForce = (point.force + along.x).norm();
    return point;
}

TracePoint tracePoint(double t, const ServoTelemetry& servo, const ServoOutput& output,
                      const LocalContactModel& model, const TouchedPlace& touched) noexcept {
    return tracePoint({.t = t,
                       .finger = servo.finger,
                       .force = servo.force,
                       .wanted = contactModelForce(model, servo.finger, output.finger.velocity),
                       .energy = servo.energy,
                       .gain = servo.gain,
                       .limited = output.limited,
                       .touched = touched},
                      model);
}

} // namespace tactum
