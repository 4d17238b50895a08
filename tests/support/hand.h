// Things that touch: a proxy alone over one mesh, and a hand that drives whole haptic steps.
#pragma once

#include <memory>
#include <vector>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/proxy/proxy.h"
#include "tests/support/soups.h"

namespace tactum::test {

inline constexpr double kMicrometre = 1e-6;
inline constexpr double kMillisecond = 1e-3;
inline constexpr double kHandSpeed = 0.15; ///< m/s: a fast stroke

inline Material frictionless() {
    Material material;
    material.staticFriction = material.dynamicFriction = material.viscosity = 0;
    return material;
}

/// Material with friction: static and dynamic coefficient, viscosity in N s/m.
inline Material rough(double muStatic, double muDynamic, double viscosity = 0) {
    Material material;
    material.staticFriction = muStatic;
    material.dynamicFriction = muDynamic;
    material.viscosity = viscosity;
    return material;
}

/// The proxy of section 2 over one mesh, without the runtime around it: any radius, any scale.
class ProxyRig {
public:
    ProxyRig(Soup soup, double radius, const Material& material = frictionless())
        : mesh_{soup, SphereTree(*soup)}, materials_{material}, obstacles_{Obstacle{&mesh_, Pose{},
                                                                                    materials_}},
          radius_(radius) {}
    ProxyRig(const ProxyRig&) = delete;
    ProxyRig& operator=(const ProxyRig&) = delete;

    void startAt(const Vec3& p) { restart(state, p); }
    ProxyReport step(const Vec3& finger, double dt = kMillisecond) {
        return moveAndUpdate(state, obstacles_, radius_, finger, dt);
    }
    /// Steps toward a far finger in strides of `stride`, then rests there for `rest` steps.
    void walk(const Vec3& from, const Vec3& to, double stride, int rest = 0) {
        const int steps = std::max(1, int(std::ceil((to - from).norm() / stride)));
        for (int i = 1; i <= steps; ++i)
            step(from + (to - from) * (double(i) / steps));
        for (int i = 0; i < rest; ++i)
            step(to);
    }
    const Vec3& position() const { return state.position; }
    const TriangleSoup& soup() const { return *mesh_.soup; }
    double radius() const { return radius_; }

    ProxyState state;

private:
    CollisionMesh mesh_;
    std::vector<Material> materials_;
    std::vector<Obstacle> obstacles_;
    double radius_;
};

/// A scene of one object with one surface.
inline Scene sceneOf(Soup soup, const Material& material, double radius = 1e-3, const Pose& pose = {}) {
    Scene scene;
    scene.proxyRadius = radius;
    SceneObject object;
    object.name = "object";
    object.geometry = std::move(soup);
    object.pose = pose;
    object.surfaces.resize(1);
    object.surfaces[0].material = material;
    scene.add(std::move(object));
    return scene;
}

inline std::shared_ptr<const World> worldOf(Soup soup, const Material& material, double radius = 1e-3,
                                            const Pose& pose = {}) {
    return compile(sceneOf(std::move(soup), material, radius, pose)).value();
}

/// A finger that goes where it is told, one haptic step at a time.
class Hand {
public:
    explicit Hand(std::shared_ptr<const World> world, double dt = kMillisecond)
        : world_(std::move(world)), dt_(dt) {}

    /// Puts the finger there and makes one step; the velocity is that of the way from the last place.
    const HapticOutput& to(const Vec3& finger) {
        const Vec3 velocity = touched_ ? Vec3((finger - finger_) / dt_) : Vec3::Zero();
        finger_ = finger;
        touched_ = true;
        return output_ = hapticStep(*world_, state, {finger, velocity}, dt_);
    }
    /// Puts the finger there, and nobody knows how it came there.
    const HapticOutput& find(const Vec3& finger) {
        finger_ = finger;
        touched_ = true;
        return output_ = hapticStep(*world_, state, {.finger = finger, .found = true}, dt_);
    }
    /// Goes straight at a speed, calling seen(*this) after each step; ends at the target exactly.
    template <class Seen> void go(const Vec3& target, double speed, Seen&& seen) {
        const Vec3 from = finger_;
        const int steps = std::max(1, int(std::llround((target - from).norm() / (speed * dt_))));
        for (int i = 1; i <= steps; ++i) {
            to(from + (target - from) * (double(i) / steps));
            seen(*this);
        }
    }
    void go(const Vec3& target, double speed) {
        go(target, speed, [](const Hand&) {});
    }

    const Vec3& finger() const { return finger_; }
    const HapticOutput& output() const { return output_; }
    const World& world() const { return *world_; }
    void take(std::shared_ptr<const World> world) { world_ = std::move(world); }

    SimState state;

private:
    std::shared_ptr<const World> world_;
    double dt_;
    Vec3 finger_ = Vec3::Zero();
    HapticOutput output_;
    bool touched_ = false;
};

} // namespace tactum::test
