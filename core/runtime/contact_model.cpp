#include "core/runtime/contact_model.h"

#include <algorithm>

namespace tactum {

namespace {

double depthOn(const LocalContactModel& model, const NearestPoint& nearest, int which) noexcept {
    double depth = 0;
    for (int i = 0; i < model.planes; ++i)
        depth += depthShare(nearest.lambda[std::size_t(i)], model.plane[std::size_t(i)].normal,
                            model.plane[std::size_t(which)].normal);
    return depth;
}

} // namespace

Anchor anchorOf(const LocalContactModel& model, const Vec3& finger_W) noexcept {
    if (!model.valid || model.planes == 0) return {finger_W, false};
    const NearestPoint nearest =
        nearestPoint(finger_W - model.proxy, {model.plane.data(), std::size_t(model.planes)});
    if (nearest.active == 0) return {finger_W, false};
    const double excess = nearest.x.norm();
    double slide = excess;
    for (int i = 0; i < model.planes; ++i) {
        if (!(nearest.lambda[i] > 0)) continue;
        // A viscous contact moves with the proxy loop, which knows the time: here it stands still.
        const FrictionLimit cone{model.friction[i].coefficient, 0};
        slide = model.friction[i].lag > 0
                    ? 0
                    : std::min(slide, allowedSlide(cone, excess, depthOn(model, nearest, i), 0, 0));
    }
    return {model.proxy + (excess > 0 ? Vec3(nearest.x * (slide / excess)) : Vec3::Zero()), true};
}

// Damping only against the finger's way in: a surface that pulled the finger inward would be felt as sticky.
Vec3 springForce(const LocalContactModel& model, const Vec3& anchor_W, const Vec3& finger_W,
                 const Vec3& velocity_W) noexcept {
    const Vec3 stretch = anchor_W - finger_W;
    const double length = stretch.norm();
    if (!(length > 0)) return Vec3::Zero();
    const double inward = std::max(0.0, (model.velocity - velocity_W).dot(stretch) / length);
    return model.stiffness * stretch + (model.damping * inward / length) * stretch;
}

LocalContactModel inDevice(const LocalContactModel& model_W, const DeviceFrame& frame) noexcept {
    LocalContactModel model = model_W;
    model.proxy = frame.pointInDevice(model_W.proxy);
    model.velocity = frame.wayInDevice(model_W.velocity);
    model.stiffness *= frame.scale;
    model.damping *= frame.scale;
    for (int i = 0; i < model.planes; ++i) {
        ConstraintPlane& plane = model.plane[std::size_t(i)];
        plane = {frame.turnedBack(plane.normal), plane.offset / frame.scale};
    }
    return model;
}

Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W,
                       const Vec3& velocity_W) noexcept {
    const Anchor anchor = anchorOf(model, finger_W);
    return anchor.touching ? springForce(model, anchor.position, finger_W, velocity_W) : Vec3::Zero();
}

} // namespace tactum
