#include "core/dynamics/lead.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

constexpr int kSlides = 3; ///< of a body that nothing holds; its ball comes after them

/// The turn from one to the other, along the axes of both, rad.
Vec3 turnBetween(const Quat& from, const Quat& to) {
    const Quat q = from.conjugate() * to;
    const double sine = q.vec().norm();
    if (!(sine > 0)) return Vec3::Zero();
    return (q.w() < 0 ? -2 : 2) * std::atan2(sine, std::abs(q.w())) / sine * q.vec();
}

} // namespace

Leader::Leader(const Mechanism& mechanism)
    : mechanism_(mechanism), before_(mechanism), after_(mechanism),
      momentum_(Coordinates::Zero(mechanism.vs)), change_(momentum_) {}

bool Leader::canLead(std::size_t body) const {
    int link = mechanism_.places[body].link;
    if (link < 0) return false;
    const Link& ball = mechanism_.links[std::size_t(link)];
    if (ball.kind != LinkKind::Ball || ball.driven != kAllAxes) return false;
    for (int i = 0; i < kSlides; ++i) {
        link = mechanism_.links[std::size_t(link)].parent;
        if (link < 0) return false;
        const Link& slide = mechanism_.links[std::size_t(link)];
        if (slide.kind != LinkKind::Slide || slide.driven == 0 || !(slide.base == Pose{})) return false;
    }
    return mechanism_.links[std::size_t(link)].parent < 0;
}

void Leader::lead(std::span<const Led> all, double dt, DynamicState& state) {
    if (all.empty()) return;
    before_.place(state.q, state.v);
    for (const Led& one : all) {
        const Pose goal = linkAt(one);
        const Link* link = &mechanism_.links[std::size_t(mechanism_.places[one.body].link)];
        const Quat now(Eigen::Vector4d(state.q.segment<4>(link->q)));
        state.v.segment<3>(link->v) = turnBetween(now, goal.rotation) / dt;
        for (int i = 0; i < kSlides; ++i) {
            link = &mechanism_.links[std::size_t(link->parent)];
            state.v[link->v] = (goal.translation[link->axis] - state.q[link->q]) / dt;
        }
    }
    keepMomentum(state);
}

// The coordinates of what hangs on a body are relative to it: unchanged they would take all of it along.
void Leader::keepMomentum(DynamicState& state) {
    after_.place(state.q, state.v);
    after_.factor();
    momentum_.setZero();
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        const RigidBody& body = mechanism_.bodies[i];
        const Place& place = mechanism_.places[i];
        if (place.link < 0 || body.kinematic) continue;
        const Place centre{place.link, place.pose * Pose{body.inertiaFrame, body.centre}};
        const FrameVelocity had = before_.velocityOf(centre), has = after_.velocityOf(centre);
        const Pose at = after_.poseOf(centre);
        const Vec3 turning =
            at.rotate(body.inertia.cwiseProduct(at.rotateInverse(had.angular - has.angular)));
        const Link& link = mechanism_.links[std::size_t(place.link)];
        after_.addJacobian(place.link, {body.mass * (had.linear - has.linear), at.translation, turning}, 1,
                           momentum_.data() + mechanism_.islands[std::size_t(link.island)].v);
    }
    for (const Island& island : mechanism_.islands)
        after_.respond(island, momentum_.data() + island.v, change_.data() + island.v);
    state.v += change_;
}

void Leader::put(const Led& one, DynamicState& state) const {
    const Pose goal = linkAt(one);
    const Link* link = &mechanism_.links[std::size_t(mechanism_.places[one.body].link)];
    state.q.segment<4>(link->q) = goal.rotation.coeffs();
    state.v.segment<3>(link->v).setZero();
    for (int i = 0; i < kSlides; ++i) {
        link = &mechanism_.links[std::size_t(link->parent)];
        state.q[link->q] = goal.translation[link->axis];
        state.v[link->v] = 0;
    }
}

} // namespace tactum
