#include "core/scene/light_bodies.h"

#include <algorithm>

#include "core/dynamics/dynamics.h"
#include "core/dynamics/finger_swing.h"
#include "core/dynamics/mechanism_build.h"
#include "core/scene/object_bounds.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

constexpr std::size_t kMost = 1024; // bodies; a scene of more is not pushed at all

/// kg, the least of the six sides' middles.
double leastMass(Dynamics& dynamics, std::size_t body, const SceneObject& object) {
    const Mechanism& mechanism = dynamics.mechanism();
    const DynamicState start = dynamics.startState();
    const Bounds bounds = boundsOf(*object.geometry);
    const Pose offset = mechanism.bodies[body].pose.inverse() * object.pose;
    double least = kUnbounded;
    for (int side = 0; side < 6; ++side) {
        const Vec3 out = (side % 2 ? 1.0 : -1.0) * Vec3::Unit(side / 2);
        const Vec3 middle = bounds.centre() + 0.5 * out.cwiseProduct(bounds.high - bounds.low);
        const Place& place = mechanism.places[body];
        const Place at{place.link, place.pose * Pose{Quat::Identity(), offset.apply(middle)}};
        least = std::min(least, dynamics.effectiveMass(start, at, object.pose.rotate(out)));
    }
    return least;
}

double stiffest(const SceneObject& object) {
    double most = 0;
    for (const Surface& surface : object.surfaces)
        most = std::max(most, surface.material.stiffness);
    return most;
}

} // namespace

void appendLightBodies(std::vector<Finding>& findings, const Scene& scene) {
    const Mechanics& mechanics = scene.mechanics;
    if (mechanics.bodies.empty() || mechanics.bodies.size() > kMost) return;
    auto made = compileMechanism(mechanics.bodies, mechanics.joints);
    if (!made) return; // the World says what is the matter
    Dynamics dynamics(std::make_shared<const Mechanism>(std::move(*made)));
    const double dt = mechanics.timeScale / kUsualProxyRate;
    for (const SceneObject& object : scene.objects) {
        const auto body = std::ranges::find(mechanics.bodies, object.body, &RigidBody::id);
        if (body == mechanics.bodies.end() || !object.geometry || object.geometry->triangles.empty())
            continue;
        const double stiffness = mechanics.forceScale * stiffest(object);
        const double least = leastMass(dynamics, std::size_t(body - mechanics.bodies.begin()), object);
        const double wanted = lightestPushed(stiffness, dt);
        if (!(least < wanted)) continue;
        findings.push_back(
            {Finding::Severity::Warning, object.name,
             "yields to a finger like " + withUnit(least, "kg") + ", and a surface of " +
                 withUnit(stiffest(object), "N/m") + " can push no less than " + withUnit(wanted, "kg") +
                 " with all its force",
             "make the body heavier, its surface softer, or the scene's scale of force smaller"});
    }
}

} // namespace tactum
