#include "core/dynamics/articulation.h"

#include <algorithm>

namespace tactum {

namespace {

Quat ballOf(const Coordinates& q, int first) noexcept {
    return Quat(Eigen::Vector4d(q.segment<4>(first))).normalized();
}

/// Turns a frame about one of its own axes: the product of quaternions without what is 0.
void turnAboutOwn(int axis, double angle, Quat& frame) noexcept {
    const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
    double* q = frame.coeffs().data();
    double &along = q[axis], &next = q[axis == 2 ? 0 : axis + 1], &last = q[axis == 0 ? 2 : axis - 1];
    const double w = q[3], x = along, y = next, z = last;
    q[3] = w * c - x * s;
    along = w * s + x * c;
    next = y * c + z * s;
    last = z * c - y * s;
}

/// A force and a torque about the origin on what moves, W: number by number what Eigen computes, bit for bit.
template <typename Six> double workOf(const IslandWrench& on, const Six& motion) noexcept {
    return (on.torque.x() * motion[0] + (on.torque.z() * motion[2] + on.force.y() * motion[4])) +
           (on.torque.y() * motion[1] + (on.force.x() * motion[3] + on.force.z() * motion[5]));
}

void addAt(const Vec3& arm, const Vec3& force, Vec6& all) noexcept {
    putHalves(angular(all) + arm.cross(force), linear(all) + force, all);
}

/// The inertia of a link alone, about the origin of its island, and the force that its motion takes. `centre`
/// is seen from that origin. By blocks: a third of the products of six numbers would be with 0.
void addBody(double mass, const Vec3& centre, const Mat3& moments, LinkNow& now) noexcept {
    const Vec3 w = angular(now.velocity), v = linear(now.velocity), arm = mass * centre;
    const Mat3 about =
        moments + mass * (centre.squaredNorm() * Mat3::Identity() - centre * centre.transpose());
    setInertia(mass, arm, about, now.inertia);
    const Vec3 turning = about.col(0) * w.x() + about.col(1) * w.y() + about.col(2) * w.z();
    const Vec3 twirl(turning.x() - arm.z() * v.y() + arm.y() * v.z(),
                     turning.y() + arm.z() * v.x() - arm.x() * v.z(),
                     turning.z() - arm.y() * v.x() + arm.x() * v.y());
    const Vec3 push(arm.z() * w.y() - arm.y() * w.z() + mass * v.x(),
                    arm.x() * w.z() - arm.z() * w.x() + mass * v.y(),
                    arm.y() * w.x() - arm.x() * w.y() + mass * v.z());
    putHalves(w.cross(twirl) + v.cross(push), w.cross(push), now.bias); // v x* f (2.32)
}

// Without loops: g++ leaves those of a triangle.
void addSymmetric(const Mat6& part, Mat6& all) noexcept {
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
        all(j, j) += part(j, j);
#pragma GCC unroll 6
        for (int i = 0; i < j; ++i) {
            const double both = 0.5 * (part(i, j) + part(j, i));
            all(i, j) += both;
            all(j, i) += both;
        }
    }
}

/// Of a link with one freedom what that does not take. (Without a matrix in between.)
void passOn(const LinkNow& now, Mat6& all) noexcept {
    const Vec6 push = now.push.col(0), held = now.yield(0, 0) * push;
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
        all(j, j) += now.inertia(j, j) - held[j] * push[j];
#pragma GCC unroll 6
        for (int i = 0; i < j; ++i) {
            const double both =
                0.5 * ((now.inertia(i, j) - held[i] * push[j]) + (now.inertia(j, i) - held[j] * push[i]));
            all(i, j) += both;
            all(j, i) += both;
        }
    }
}

/// The inverse for the axes that are not driven, and nothing for the others.
Mat3 inverseBut(const Mat3& all, AxisSet driven) noexcept {
    Mat3 kept = all;
    for (int i = 0; i < 3; ++i)
        if (driven >> i & 1) {
            kept.row(i).setZero();
            kept.col(i).setZero();
            kept(i, i) = 1;
        }
    Mat3 inverse = kept.inverse();
    if (!inverse.allFinite()) return Mat3::Zero(); // nothing there has any inertia
    for (int i = 0; i < 3; ++i)
        if (driven >> i & 1) inverse(i, i) = 0;
    return inverse;
}

} // namespace

Articulation::Articulation(const Mechanism& mechanism)
    : mechanism_(mechanism), now_(mechanism.links.size()), origins_(mechanism.islands.size(), Vec3::Zero()),
      spots_(mechanism.paths.size()), impulses_(mechanism.links.size()), rests_(mechanism.links.size()) {
    for (LinkNow& now : now_) {
        now.way.setZero();
        now.push.setZero();
    }
}

void Articulation::placeLink(std::size_t i, const Coordinates& q) noexcept {
    const Link& link = mechanism_.links[i];
    Pose& pose = now_[i].pose;
    pose = link.parent < 0 ? link.base : now_[std::size_t(link.parent)].pose * link.base;
    if (link.kind == LinkKind::Slide)
        pose.translation = pose.apply(q[link.q] * Vec3::Unit(link.axis));
    else if (link.kind == LinkKind::Turn)
        turnAboutOwn(link.axis, q[link.q], pose.rotation);
    else if (link.kind == LinkKind::Path)
        pose = pose * alongPath(link, q[link.q]);
    else
        pose.rotation = pose.rotation * ballOf(q, link.q);
}

Pose Articulation::alongPath(const Link& link, double way) noexcept {
    PathSpot& spot = spots_[std::size_t(link.path)];
    spot = mechanism_.paths[std::size_t(link.path)].at(way);
    return link.carriesPath ? spot.pose.inverse() : spot.pose;
}

// S in the frame of the curve is (w, c' + c x w), and S' = (w', c'' + c' x w + c x w'); about the origin,
// along the axes of the world. Where the curve moves with this link both are the opposite of how the rider
// moves.
void Articulation::moveAlongPath(std::size_t i, double rate) noexcept {
    const Link& link = mechanism_.links[i];
    LinkNow& now = now_[i];
    const PathSpot& spot = spots_[std::size_t(link.path)];
    const Pose base = link.parent < 0 ? link.base : now_[std::size_t(link.parent)].pose * link.base;
    const Quat& turned = link.carriesPath ? now.pose.rotation : base.rotation;
    const double sense = link.carriesPath ? -1 : 1;
    const Mat3 axes = sense * turned.toRotationMatrix();
    const Vec3 rider = link.carriesPath ? base.translation : now.pose.translation;
    const Vec3 at = rider - origins_[std::size_t(link.island)];
    const Vec3 turn = axes * spot.turn, way = axes * spot.way, turnRate = axes * spot.turnRate;
    now.way.col(0) = spatial(turn, way + at.cross(turn));
    const Vec3 wayRate = axes * spot.wayRate + sense * way.cross(turn) + at.cross(turnRate);
    now.pathDrift = rate * rate * spatial(turnRate, wayRate);
}

/// What the link's freedoms move, and how they do.
FrameVelocity Articulation::moveFreedoms(std::size_t i, const Vec3& at, const Mat3& axes,
                                         const Coordinates& v) noexcept {
    const Link& link = mechanism_.links[i];
    LinkNow& now = now_[i];
    if (link.kind == LinkKind::Ball) {
        for (int k = 0; k < 3; ++k)
            now.way.col(k) = turnAbout(axes.col(k), at);
        const Vec6 own = now.way * v.segment<3>(link.v);
        return {angular(own), linear(own)};
    }
    if (link.kind == LinkKind::Path) {
        moveAlongPath(i, v[link.v]);
    } else {
        const Vec3 axis = axes.col(link.axis);
        const bool slides = link.kind == LinkKind::Slide;
        putHalves(slides ? Vec3(Vec3::Zero()) : axis, slides ? axis : Vec3(at.cross(axis)), now.way.col(0));
    }
    return {v[link.v] * now.way.col(0).head<3>(), v[link.v] * now.way.col(0).tail<3>()};
}

void Articulation::moveLink(std::size_t i, const Coordinates& v) noexcept {
    const Link& link = mechanism_.links[i];
    LinkNow& now = now_[i];
    const Vec3& origin = origins_[std::size_t(link.island)];
    const Mat3 axes = now.pose.rotation.toRotationMatrix();
    const FrameVelocity own = moveFreedoms(i, now.pose.translation - origin, axes, v);
    now.force.setZero();
    if (link.parent >= 0) {
        const Vec6& before = now_[std::size_t(link.parent)].velocity;
        const Vec3 turn = angular(before), way = linear(before);
        putHalves(turn + own.angular, way + own.linear, now.velocity);
        // How its own motion m changes as it goes with its parent: v x m (2.31).
        putHalves(turn.cross(own.angular), turn.cross(own.linear) + way.cross(own.angular), now.drift);
    } else {
        putHalves(own.angular, own.linear, now.velocity);
        now.drift.setZero();
    }
    if (link.kind == LinkKind::Path) now.drift += now.pathDrift;
    if (link.mass > 0) {
        const Mat3 moments = axes * link.moments * axes.transpose();
        addBody(link.mass, now.pose.apply(link.centre) - origin, moments, now);
    } else {
        now.inertia.setZero();
        now.bias.setZero();
    }
}

void Articulation::place(const Coordinates& q, const Coordinates& v) noexcept {
    for (std::size_t i = 0; i < now_.size(); ++i)
        placeLink(i, q);
    // The last link of a free body's four is at its centre; of others any of them will do.
    for (std::size_t i = 0; i < origins_.size(); ++i) {
        const Island& island = mechanism_.islands[i];
        origins_[i] = now_[std::size_t(island.firstLink)].pose.translation;
        for (int link = island.firstLink; link < island.endLink; ++link)
            if (mechanism_.links[std::size_t(link)].mass > 0) {
                origins_[i] = now_[std::size_t(link)].pose.translation;
                break;
            }
    }
    for (std::size_t i = 0; i < now_.size(); ++i)
        moveLink(i, v);
}

void Articulation::addGravity(const Vec3& gravity) noexcept {
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const Link& link = mechanism_.links[i];
        if (link.heavy == 0) continue;
        const Vec3 arm = now_[i].pose.apply(link.heavyCentre) - origins_[std::size_t(link.island)];
        addAt(arm, link.heavy * gravity, now_[i].force);
    }
}

void Articulation::addForce(int link, const Vec3& force_W, const Vec3& point_W) noexcept {
    if (link >= 0) addAt(point_W - originOf(link), force_W, now_[std::size_t(link)].force);
}

inline IslandWrench Articulation::atOrigin(int link, const Wrench& wrench, double size) const noexcept {
    const Vec3 torque = (wrench.point - originOf(link)).cross(wrench.force) + wrench.torque;
    return {size * torque, size * wrench.force};
}

void Articulation::addForce(const Place& a, const Place& b, const Wrench& wrench, double size) noexcept {
    const auto add = [&](int link, double times) {
        if (link < 0) return;
        Vec6& all = now_[std::size_t(link)].force;
        const IslandWrench on = atOrigin(link, wrench, times);
        putHalves(angular(all) + on.torque, linear(all) + on.force, all);
    };
    add(b.link, size);
    add(a.link, -size);
}

// What rounding leaves of an inertia that is not symmetric would grow by 1 / (2 - sqrt 3) with each rod of a
// chain, as the covariance of a Kalman filter does: 36 on balls would fly apart.
void Articulation::factorLink(std::size_t i) noexcept {
    const Link& link = mechanism_.links[i];
    LinkNow& now = now_[i];
    LinkNow* const parent = link.parent < 0 ? nullptr : &now_[std::size_t(link.parent)];
    if (link.kind == LinkKind::Ball) {
        now.push.noalias() = now.inertia * now.way;
        now.yield = inverseBut(now.way.transpose() * now.push, link.driven);
        if (parent) addSymmetric(now.inertia - now.push * now.yield * now.push.transpose(), parent->inertia);
    } else {
        now.push.col(0).noalias() = now.inertia * now.way.col(0);
        const double inertia = now.way.col(0).dot(now.push.col(0));
        now.yield(0, 0) = link.driven || !(inertia > 0) ? 0 : 1 / inertia;
        if (parent) passOn(now, parent->inertia);
    }
}

void Articulation::factor() noexcept {
    for (std::size_t i = now_.size(); i-- > 0;)
        factorLink(i);
}

/// The force that holds a link up, as far as its own freedoms do not give way, goes on to its parent.
void Articulation::passForce(std::size_t i, const Coordinates& along) noexcept {
    const Link& link = mechanism_.links[i];
    LinkNow& now = now_[i];
    const Vec6& held = now.acceleration;
    Vec6* const parent = link.parent < 0 ? nullptr : &now_[std::size_t(link.parent)].acceleration;
    // A^a c + p^a, with A^a = A - U D^-1 U^T.
    if (link.kind == LinkKind::Ball) {
        now.rest = along.segment<3>(link.v) - now.way.transpose() * held;
        if (!parent) return;
        const Vec3 taken = now.yield * (now.rest - now.push.transpose() * now.drift);
        *parent += held + (now.inertia * now.drift + now.push * taken);
    } else {
        now.rest[0] = along[link.v] - now.way.col(0).dot(held);
        if (!parent) return;
        const double taken = now.yield(0, 0) * (now.rest[0] - now.push.col(0).dot(now.drift));
        *parent += held + (now.inertia * now.drift + now.push.col(0) * taken);
    }
}

// Both ways to the root in one: what each waits for is ready while the other waits.
void Articulation::accelerate(const Coordinates& along, Coordinates& acceleration) noexcept {
    for (LinkNow& now : now_)
        now.acceleration = now.bias - now.force; // the force that holds it up, for now
    for (std::size_t i = now_.size(); i-- > 0;) {
        factorLink(i);
        passForce(i, along);
    }
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const Link& link = mechanism_.links[i];
        LinkNow& now = now_[i];
        now.acceleration = now.drift;
        if (link.parent >= 0) now.acceleration += now_[std::size_t(link.parent)].acceleration;
        if (link.kind == LinkKind::Ball) {
            const Vec3 own = now.yield * (now.rest - now.push.transpose() * now.acceleration);
            acceleration.segment<3>(link.v) = own;
            now.acceleration += now.way * own;
        } else {
            const double own = now.yield(0, 0) * (now.rest[0] - now.push.col(0).dot(now.acceleration));
            acceleration[link.v] = own;
            now.acceleration += now.way.col(0) * own;
        }
    }
}

void Articulation::respond(const Island& island, const double* impulse, double* change) noexcept {
    for (int i = island.firstLink; i < island.endLink; ++i)
        impulses_[std::size_t(i)].setZero();
    for (int i = island.endLink; i-- > island.firstLink;) {
        const Link& link = mechanism_.links[std::size_t(i)];
        const LinkNow& now = now_[std::size_t(i)];
        const Vec6& held = impulses_[std::size_t(i)];
        Vec3& rest = rests_[std::size_t(i)];
        const double* own = impulse + (link.v - island.v);
        Vec6* const parent = link.parent < 0 ? nullptr : &impulses_[std::size_t(link.parent)];
        if (link.kind == LinkKind::Ball) {
            rest = Vec3(own[0], own[1], own[2]) - now.way.transpose() * held;
            if (parent) *parent += held + now.push * (now.yield * rest);
        } else {
            rest[0] = own[0] - now.way.col(0).dot(held);
            if (parent) *parent += held + now.push.col(0) * (now.yield(0, 0) * rest[0]);
        }
    }
    for (int i = island.firstLink; i < island.endLink; ++i) {
        const Link& link = mechanism_.links[std::size_t(i)];
        const LinkNow& now = now_[std::size_t(i)];
        Vec6& moved = impulses_[std::size_t(i)];
        moved.setZero();
        if (link.parent >= 0) moved = impulses_[std::size_t(link.parent)];
        const Vec3& rest = rests_[std::size_t(i)];
        double* own = change + (link.v - island.v);
        if (link.kind == LinkKind::Ball) {
            const Vec3 by = now.yield * (rest - now.push.transpose() * moved);
            Eigen::Map<Vec3>{own} = by;
            moved += now.way * by;
        } else {
            own[0] = now.yield(0, 0) * (rest[0] - now.push.col(0).dot(moved));
            moved += now.way.col(0) * own[0];
        }
    }
}

void Articulation::addJacobian(int link, const Wrench& wrench, double size, double* along) const noexcept {
    if (link < 0) return;
    const IslandWrench w = atOrigin(link, wrench, size);
    const int first = mechanism_.islands[std::size_t(mechanism_.links[std::size_t(link)].island)].v;
    for (int i = link; i >= 0; i = mechanism_.links[std::size_t(i)].parent) {
        const Link& on = mechanism_.links[std::size_t(i)];
        for (int k = 0; k < on.freedoms(); ++k)
            along[on.v - first + k] += workOf(w, now_[std::size_t(i)].way.col(k));
    }
}

Pose Articulation::poseOf(const Place& frame) const noexcept {
    return frame.link < 0 ? frame.pose : now_[std::size_t(frame.link)].pose * frame.pose;
}

FrameVelocity Articulation::velocityOf(const Place& frame) const noexcept {
    if (frame.link < 0) return {};
    const LinkNow& now = now_[std::size_t(frame.link)];
    const Vec3 at = now.pose.apply(frame.pose.translation) - originOf(frame.link);
    return {angular(now.velocity), velocityAt(now.velocity, at)};
}

double Articulation::powerOf(const Place& a, const Place& b, const Wrench& wrench) const noexcept {
    const auto on = [&](int link) {
        return link < 0 ? 0 : workOf(atOrigin(link, wrench), now_[std::size_t(link)].velocity);
    };
    return on(b.link) - on(a.link);
}

double Articulation::accelerationAlong(const Place& a, const Place& b, const Wrench& wrench) const noexcept {
    const auto on = [&](int link) {
        return link < 0 ? 0 : workOf(atOrigin(link, wrench), now_[std::size_t(link)].acceleration);
    };
    return on(b.link) - on(a.link);
}

double Articulation::driftAlong(const Place& a, const Place& b, const Wrench& wrench) const noexcept {
    const auto on = [&](int link) {
        Vec6 drift = Vec6::Zero();
        for (int i = link; i >= 0; i = mechanism_.links[std::size_t(i)].parent)
            drift += now_[std::size_t(i)].drift;
        return link < 0 ? 0 : workOf(atOrigin(link, wrench), drift);
    };
    return on(b.link) - on(a.link);
}

void startVelocities(Mechanism& mechanism) {
    Coordinates& v = mechanism.v0;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        // What nothing can move has the velocity that it is given.
        const RigidBody& body = mechanism.bodies[i];
        int link = mechanism.places[i].link;
        if (link < 0 || !(mechanism.links[std::size_t(link)].driven)) continue;
        const Link& ball = mechanism.links[std::size_t(link)];
        if (ball.kind != LinkKind::Ball || ball.parent < 0) continue;
        const Quat axes = body.pose.rotation * body.inertiaFrame;
        for (int k = 0; k < 3; ++k)
            if (ball.driven >> k & 1) v[ball.v + k] = (axes.conjugate() * body.angularVelocity)[k];
        for (int up = ball.parent; up >= 0; up = mechanism.links[std::size_t(up)].parent) {
            const Link& slide = mechanism.links[std::size_t(up)];
            if (slide.kind == LinkKind::Slide && slide.driven) v[slide.v] = body.velocity[slide.axis];
        }
    }
    Articulation articulation(mechanism);
    articulation.place(mechanism.q0, v);
    articulation.factor();
    Coordinates momentum = Coordinates::Zero(mechanism.vs);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const RigidBody& body = mechanism.bodies[i];
        const Place& place = mechanism.places[i];
        if (place.link < 0) continue;
        const Vec3 centre = body.pose.apply(body.centre);
        const Place at{place.link, {place.pose.rotation, place.pose.apply(body.centre)}};
        const FrameVelocity has = articulation.velocityOf(at);
        const Mat3 axes = (body.pose.rotation * body.inertiaFrame).toRotationMatrix();
        const Vec3 turning =
            axes * body.inertia.asDiagonal() * axes.transpose() * (body.angularVelocity - has.angular);
        const Link& link = mechanism.links[std::size_t(place.link)];
        articulation.addJacobian(place.link, {body.mass * (body.velocity - has.linear), centre, turning}, 1,
                                 momentum.data() + mechanism.islands[std::size_t(link.island)].v);
    }
    Coordinates change = Coordinates::Zero(mechanism.vs);
    for (const Island& island : mechanism.islands)
        articulation.respond(island, momentum.data() + island.v, change.data() + island.v);
    v += change;
}

} // namespace tactum
