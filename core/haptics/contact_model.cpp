#include "core/haptics/contact_model.h"

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

/// Of a way that only viscosity holds back, what is gone after a time: b x' = k (s - x), implicit. Steady it
/// drags with b v, and whatever the lag, it never goes beyond where the finger is now: what slid only after
/// the proxy had been told would go on towards where the finger was, and give energy.
double gone(double lag, double since) noexcept {
    return lag > 0 ? since / (since + lag) : 1;
}

} // namespace

Anchor anchorOf(const LocalContactModel& model, const Vec3& finger_W, double since) noexcept {
    if (!model.valid || model.planes == 0) return {finger_W, false};
    const NearestPoint nearest =
        nearestPoint(finger_W - model.proxy, {model.plane.data(), std::size_t(model.planes)});
    if (nearest.active == 0) return {finger_W, false};
    const double excess = nearest.x.norm();
    double slide = excess;
    for (int i = 0; i < model.planes; ++i) {
        if (!(nearest.lambda[i] > 0)) continue;
        const FrictionLimit cone{model.friction[i].coefficient, 0};
        slide = std::min(slide, allowedSlide(cone, excess, depthOn(model, nearest, i), 0, 0) *
                                    gone(model.friction[i].lag, since));
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

// Without the bound a surface that pushes next to nothing would count with all that is gone elsewhere.
double rise(const Vec3& now, const Vec3& before) noexcept {
    const double length = now.norm();
    return length > 0 ? length - std::max(-length, now.dot(before) / length) : 0;
}

Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W,
                       const Vec3& velocity_W) noexcept {
    const Anchor anchor = anchorOf(model, finger_W);
    return anchor.touching ? springForce(model, anchor.position, finger_W, velocity_W) : Vec3::Zero();
}

} // namespace tactum
