#include "core/dynamics/air.h"

#include "core/dynamics/convex.h"

namespace tactum {

namespace {

using Box = Eigen::AlignedBox3d;

/// Of what a collider covers, along the axes of its body; nothing of what has no end.
Box boxAround(const Collider& collider) {
    const Convex convex = convexOf(collider.shape);
    Box box;
    if (convex.core == Convex::Core::HalfSpace) return box;
    const Vec3 round = Vec3::Constant(convex.radius);
    const auto add = [&](const Vec3& point) {
        const Vec3 at = collider.pose.apply(point);
        box.extend(Box(at - round, at + round));
    };
    if (convex.core != Convex::Core::Polytope) {
        add({0, convex.half, 0});
        add({0, -convex.half, 0});
    }
    for (const Vec3& point : convex.polytope.points)
        add(point);
    return box;
}

/// How a free body gives way at a point along the axes of its frame, and about them.
void findYield(const RigidBody& body, const Vec3& at, AirBox& box) {
    const Mat3 axes = body.inertiaFrame.toRotationMatrix();
    const Vec3 inverse = (body.inertia.array() > 0).select(body.inertia.cwiseInverse(), 0);
    const Mat3 turns = axes * inverse.asDiagonal() * axes.transpose();
    for (int i = 0; i < 3; ++i) {
        const Vec3 arm = (at - body.centre).cross(Vec3::Unit(i));
        box.yield[i] = 1 / body.mass + arm.dot(turns * arm);
        box.turnYield[i] = turns(i, i);
        box.swerve[i] = (turns * arm).norm();
    }
}

} // namespace

std::vector<AirBox> airBoxesOf(std::span<const RigidBody> bodies, std::span<const Place> places,
                               std::span<const Collider> colliders, double density) {
    std::vector<AirBox> all;
    if (!(density > 0)) return all;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const RigidBody& body = bodies[i];
        if (places[i].link < 0 || body.kinematic || body.mass == 0) continue;
        Box around;
        for (const Collider& collider : colliders)
            if (collider.body == body.id) around.extend(boxAround(collider));
        if (around.isEmpty()) continue;
        const Vec3 side = around.sizes(), fourth = side.array().square().square();
        AirBox box;
        box.place = {places[i].link, places[i].pose * Pose{Quat::Identity(), around.center()}};
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            box.drag[k] = density / 2 * side[l] * side[m];
            box.turnDrag[k] = density / 64 * side[k] * (fourth[l] + fourth[m]);
        }
        findYield(body, around.center(), box);
        all.push_back(box);
    }
    return all;
}

} // namespace tactum
