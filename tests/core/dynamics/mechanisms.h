// Bodies and joints for tests.
#pragma once

#include <memory>

#include "core/dynamics/dynamics.h"
#include "core/dynamics/mechanics.h"
#include "core/dynamics/mechanism_build.h"

namespace tactum::test {

inline const Vec3 kDown{0, -9.81, 0};

inline RigidBody bodyAt(BodyId id, const Vec3& centre, double mass = 1, const Vec3& inertia = Vec3::Ones()) {
    RigidBody body;
    body.id = id;
    body.name = "body " + std::to_string(id);
    body.pose.translation = centre;
    body.mass = mass;
    body.inertia = inertia;
    return body;
}

inline JointLimit lock(bool angular, AxisSet axes) {
    return {angular, axes, 0, 0};
}

/// A joint between the frames of two bodies that meet at a place of the world, where its axes are those of
/// `axes`; what it locks is for the caller to say.
inline Joint jointAt(const std::vector<RigidBody>& bodies, BodyId a, BodyId b, const Vec3& at,
                     const Quat& axes, std::vector<JointLimit> limits) {
    const auto poseOf = [&](BodyId id) {
        for (const RigidBody& body : bodies)
            if (body.id == id) return body.pose;
        return Pose{};
    };
    Joint joint;
    joint.name = "joint";
    joint.a = a;
    joint.b = b;
    joint.frameA = poseOf(a).inverse() * Pose{axes, at};
    joint.frameB = poseOf(b).inverse() * Pose{axes, at};
    joint.limits = std::move(limits);
    return joint;
}

/// About the axis that x is turned to.
inline Joint hingeAt(const std::vector<RigidBody>& bodies, BodyId a, BodyId b, const Vec3& at,
                     const Vec3& axis = Vec3::UnitZ()) {
    return jointAt(bodies, a, b, at, turnOnto(Vec3::UnitX(), axis), {lock(false, kAllAxes), lock(true, 6)});
}
/// Along the axis that x is turned to.
inline Joint sliderAt(const std::vector<RigidBody>& bodies, BodyId a, BodyId b, const Vec3& at,
                      const Vec3& axis) {
    return jointAt(bodies, a, b, at, turnOnto(Vec3::UnitX(), axis), {lock(false, 6), lock(true, kAllAxes)});
}
inline Joint ballAt(const std::vector<RigidBody>& bodies, BodyId a, BodyId b, const Vec3& at) {
    return jointAt(bodies, a, b, at, Quat::Identity(), {lock(false, kAllAxes)});
}

/// Bodies and joints with their state, as a test steps through them.
class Running {
public:
    Running(const std::vector<RigidBody>& bodies, const std::vector<Joint>& joints)
        : dynamics_(std::make_shared<const Mechanism>(compileMechanism(bodies, joints).value())),
          state_(dynamics_.startState()), now_(bodies.size()) {}

    explicit Running(const Mechanics& scene)
        : dynamics_(std::make_shared<const Mechanism>(
              compileMechanism(scene.bodies, scene.joints, scene.colliders, scene.airDensity).value())),
          state_(dynamics_.startState()), now_(scene.bodies.size()) {}

    void run(double seconds, double dt, const Vec3& gravity = kDown,
             std::span<const AppliedForce> forces = {}) {
        const auto steps = std::llround(seconds / dt);
        for (long long i = 0; i < steps; ++i)
            dynamics_.step(state_, gravity, forces, dt);
    }
    const std::vector<BodyState>& bodies(const Vec3& gravity = kDown) {
        dynamics_.describe(state_, gravity, now_);
        return now_;
    }
    double energy(const Vec3& gravity = kDown) {
        double sum = 0;
        for (const BodyState& body : bodies(gravity))
            sum += body.kinetic + body.potential;
        return sum;
    }
    const Mechanism& mechanism() const { return dynamics_.mechanism(); }
    Dynamics& dynamics() { return dynamics_; }
    DynamicState& state() { return state_; }

private:
    Dynamics dynamics_;
    DynamicState state_;
    std::vector<BodyState> now_;
};

/// A chain of hinges with alternating axes that hangs off to one side.
struct Chain {
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;
};
inline Chain chainOf(int links, double length = 0.1, double mass = 0.1) {
    Chain chain;
    const Vec3 thin(mass * length * length / 100, mass * length * length / 12, mass * length * length / 12);
    for (int i = 0; i < links; ++i)
        chain.bodies.push_back(bodyAt(BodyId(i + 1), Vec3((i + 0.5) * length, 0, 0), mass, thin));
    for (int i = 0; i < links; ++i)
        chain.joints.push_back(hingeAt(chain.bodies, BodyId(i), BodyId(i + 1), Vec3(i * length, 0, 0),
                                       i % 2 == 0 ? Vec3::UnitZ() : Vec3::UnitY()));
    return chain;
}

} // namespace tactum::test
