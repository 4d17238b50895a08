// Two fingers and a box between them, which stands on a floor: what a pinch lifts.
#pragma once

#include <array>
#include <memory>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "tests/support/hand.h"

namespace tactum::test {

inline constexpr double kGravity = 9.81;   ///< m/s^2, along -y
inline constexpr double kBoxHalf = 0.02;   ///< m
inline constexpr double kFingertip = 5e-3; ///< m, radius of the proxies

/// A cube with its middle in the origin, corners shared, counter-clockwise from outside.
inline Soup cube(double half) {
    SoupBuilder builder;
    for (const int axis : {0, 1, 2})
        for (const double side : {-half, half}) {
            Vec3 out = Vec3::Zero(), across = Vec3::Zero(), up = Vec3::Zero();
            out[axis] = side;
            across[(axis + 1) % 3] = half;
            up[(axis + 2) % 3] = side;
            builder.quad(out - across - up, out + across - up, out + across + up, out - across + up);
        }
    return builder.build();
}

/// A box of `mass` that stands on a floor, with its middle in the origin, and feels like `feel`.
inline Scene boxOnFloor(double mass, const Material& feel) {
    Scene scene = sceneOf(cube(kBoxHalf), feel, kFingertip);
    RigidBody body;
    body.id = 1;
    body.mass = mass;
    body.inertia = Vec3::Constant(mass * 4 * kBoxHalf * kBoxHalf / 6);
    scene.objects[0].body = 1;
    scene.mechanics.bodies = {body};
    scene.mechanics.gravity = {0, -kGravity, 0};
    ColliderShape box, floor;
    box.size = Vec3::Constant(2 * kBoxHalf);
    floor.kind = ShapeKind::Plane;
    floor.size = {kUnbounded, 0, kUnbounded};
    scene.mechanics.colliders = {{1, Pose{}, box, {}, {}},
                                 {kWorldBody, {Quat::Identity(), Vec3(0, -kBoxHalf, 0)}, floor, {}, {}}};
    return scene;
}

/// As a loop has it that answers so late: the bodies' side of each spring is damped.
inline constexpr Coupling kAnswersLate{.delay = 1.5e-3};

/// Two fingers left and right of the box, told where to be one step at a time.
class TwoHands {
public:
    explicit TwoHands(std::shared_ptr<const World> world, double dt = kMillisecond)
        : world_(std::move(world)), dt_(dt) {}

    /// Both fingers, each `depth` deep in its side (negative: before it) at the height `y`; one step.
    void to(double depth, double y) {
        to({fingerAt(-1, depth, y), fingerAt(1, depth, y)}, {kAnswersLate, kAnswersLate});
    }
    void to(const std::array<Vec3, 2>& fingers, const std::array<Coupling, 2>& couplings) {
        for (std::size_t i = 0; i < 2; ++i) {
            HandStep& hand = steps_[i];
            const Vec3 velocity = touched_ ? Vec3((fingers[i] - hand.input.finger) / dt_) : Vec3::Zero();
            hand.input = {.finger = fingers[i], .fingerVelocity = velocity, .coupling = couplings[i]};
        }
        touched_ = true;
        hapticStep(*world_, shared, steps_, dt_);
    }
    /// From where they are in so many steps, evenly; seen() after each.
    template <class Seen> void go(double depth, double y, int steps, Seen&& seen) {
        const double fromDepth = depth_, fromY = y_;
        for (int i = 1; i <= steps; ++i) {
            const double part = double(i) / steps;
            to(fromDepth + part * (depth - fromDepth), fromY + part * (y - fromY));
            seen();
        }
        depth_ = depth, y_ = y;
    }
    void go(double depth, double y, int steps) {
        go(depth, y, steps, [] {});
    }

    const HapticOutput& output(std::size_t hand) const { return steps_[hand].output; }
    /// N on both fingers together.
    Vec3 forces() const { return steps_[0].output.force + steps_[1].output.force; }
    /// Where the box's middle is, m, and how fast, m/s: of a box that began in the origin.
    Vec3 box() const { return {shared.bodies.q[0], shared.bodies.q[1], shared.bodies.q[2]}; }
    Vec3 boxVelocity() const { return {shared.bodies.v[0], shared.bodies.v[1], shared.bodies.v[2]}; }
    const World& world() const { return *world_; }
    void take(std::shared_ptr<const World> world) { world_ = std::move(world); }

    WorldState shared;
    std::array<HandState, 2> hands;

private:
    static Vec3 fingerAt(int side, double depth, double y) {
        return {side * (kBoxHalf + kFingertip - depth), y, 0};
    }

    std::shared_ptr<const World> world_;
    double dt_;
    std::array<HandStep, 2> steps_{HandStep{hands[0], {}}, HandStep{hands[1], {}}};
    double depth_ = -1e-3, y_ = 0;
    bool touched_ = false;
};

} // namespace tactum::test
