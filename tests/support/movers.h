// Bodies that move by themselves: motions from formulas, and scenes in which they go.
#pragma once

#include "core/motion/motion_build.h"
#include "tests/support/hand.h"

namespace tactum::test {

using SharedMotion = std::shared_ptr<const Motion>;

/// Goes straight with a constant velocity in m/s, for longer than any test.
inline SharedMotion sliding(const Vec3& velocity, double duration = 1000) {
    return std::make_shared<const Motion>(makeMotion(
        {Interpolation::Linear, {0, duration}, {Vec3::Zero(), duration * velocity}, {}, {}}, {}, duration));
}

/// Turns about an axis through the origin of the body, rad/s, without an end.
inline SharedMotion turning(const Vec3& axis, double speed) {
    Track<QuatCoefficients> track;
    const double round = 2 * std::numbers::pi / std::abs(speed);
    for (int i = 0; i <= 4; ++i) {
        track.times.push_back(round * i / 4);
        const double angle = (speed > 0 ? 1 : -1) * std::numbers::pi / 2 * i;
        track.values.push_back(Quat(Eigen::AngleAxisd(angle, axis.normalized())).coeffs());
    }
    return std::make_shared<const Motion>(makeMotion({}, std::move(track), round));
}

/// amplitude (1 - cos) / 2 along a way: starts at rest, goes there and back; `hertz` times a second.
inline SharedMotion swinging(const Vec3& way, double hertz) {
    Track<Vec3> track{Interpolation::CubicSpline, {}, {}, {}, {}};
    constexpr int kKeys = 64;
    const double turn = 2 * std::numbers::pi;
    for (int i = 0; i <= kKeys; ++i) {
        const double phase = turn * i / kKeys;
        track.times.push_back(i / (kKeys * hertz));
        track.values.push_back(0.5 * (1 - std::cos(phase)) * way);
        track.arriving.push_back(0.5 * turn * hertz * std::sin(phase) * way);
        track.leaving.push_back(track.arriving.back());
    }
    return std::make_shared<const Motion>(makeMotion(std::move(track), {}, 1 / hertz));
}

inline SceneObject bodyOf(Soup soup, const Material& material, SharedMotion motion = nullptr,
                          const Pose& pose = {}) {
    SceneObject object;
    object.geometry = std::move(soup);
    object.pose = pose;
    object.motion = std::move(motion);
    object.surfaces.resize(1);
    object.surfaces[0].material = material;
    return object;
}

inline Scene sceneOf(std::initializer_list<SceneObject> bodies, double radius = 1e-3) {
    Scene scene;
    scene.proxyRadius = radius;
    for (const SceneObject& body : bodies)
        scene.add(body);
    return scene;
}

} // namespace tactum::test
