#include "core/proxy/proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/inplace_vector.h"
#include "core/proxy/carry.h"
#include "core/proxy/felt_planes.h"
#include "core/proxy/passed_bodies.h"
#include "core/surface/friction.h"

namespace tactum {

void restart(ProxyState& state, const Vec3& finger_W) noexcept {
    state.position = state.finger = finger_W;
    state.contactCount = state.passedCount = state.feltCount = 0;
    state.speed = 0;
    state.slidingOn = kNoBody;
    for (SweepMemory& memory : state.memories)
        memory.mesh = nullptr;
}

namespace {

// A touch is kept while its gap is within this many skins; what is farther away is found by the sweep.
constexpr double kKeep = 2;
// A contact that pushes is not given up while it is within this part of the radius.
constexpr double kHover = 0.1;
// The proxy goes around an edge by at most this cosine at once.
constexpr double kSteepest = 0.5;
// Up to this curvature times depth Newton's step is trusted; beyond it the proxy is about to roll off, and is
// only led to roll faster.
constexpr double kMostBent = 0.7;
constexpr double kRollFaster = 2;
// Motion and change of the constraint planes below these parts of the radius count as rest.
constexpr double kRest = 1e-9;
// Under a finger that moves, the rounds on a felt surface end with a motion below this part of the radius.
constexpr double kSettled = 1e-4;
// A stride on a felt surface that need not turn back may be so much longer next time.
constexpr double kStrideGrowth = 1.2;
// A finger that holds still for so many steps feels the proxy come to rest, each step with half the stride.
constexpr int kSettling = 8;
// The speed that textures are filtered for falls by this factor a step at most: bumps slow the proxy down for
// a moment, which shall not let finer ones through.
constexpr double kSpeedDecay = 0.9;
constexpr double kSamePlane = 1e-12;

// One step: the state it works on and what stays the same during it.
class Step {
public:
    Step(ProxyState& state, std::span<const Obstacle> obstacles, std::span<const BodyMotion> movers,
         double radius, const Vec3& finger, double dt, const Vec3& start, int mostRounds)
        : state_(state), obstacles_(obstacles), movers_(movers), radius_(radius), finger_(finger), dt_(dt),
          timeLeft_(dt), fingerVelocity_((finger - state.finger) / dt), start_(start),
          mostRounds_(mostRounds) {}

    ProxyReport run() noexcept {
        ProxyReport report;
        countStillSteps();
        refreshContacts();
        report.boundHit = true;
        for (rounds_ = 1; rounds_ <= mostRounds_; ++rounds_) {
            if (!round()) {
                report.boundHit = false;
                break;
            }
            if (rounds_ > mostRounds_ / 2) noteNearest();
        }
        if (report.boundHit) returnToNearest();
        report.rounds = std::min(rounds_, mostRounds_);
        report.squeezed = squeezed_;
        finish();
        return report;
    }

private:
    using Planes = InplaceVector<ConstraintPlane, kMaxPlanes>;

    std::span<Contact> contacts() { return {state_.contacts.data(), std::size_t(state_.contactCount)}; }

    // Rounds that go to and fro until they are used up must not leave a plain proxy farther away than it was.
    void noteNearest() noexcept {
        const double distance = (finger_ - state_.position).norm();
        if (distance >= nearestDistance_) return;
        nearestDistance_ = distance;
        nearest_ = state_.position;
    }
    void returnToNearest() noexcept {
        if (felt_ || nearestDistance_ >= (finger_ - state_.position).norm()) return;
        state_.position = nearest_;
        refreshContacts();
    }

    // The constraint planes of all contacts, seen from the proxy.
    Planes planes() noexcept {
        Planes planes;
        for (const Contact& contact : contacts())
            planes.push({contact.normal, -contact.gap});
        return planes;
    }

    // Update (2.2), friction (4), move (2.1). False when the proxy has come to rest for this step.
    bool round() noexcept {
        if (comesOut()) return true;
        const Vec3 wish = unconstrainedByFriction();
        const double excess = wish.norm();
        if (excess <= kRest * radius_) return false;
        const double slide = frictionAllows(wish, excess);
        if (slide <= 0 && !felt_) return false; // what is felt lets the proxy down onto it even when it holds
        // Friction that lets go entirely is none; the last rounds take no risks.
        const bool free = slide == excess && rounds_ < mostRounds_ - 2;
        const Vec3 motion = felt_  ? alongFelt(wish, slide / excess, free)
                            : free ? alongCurvature(wish, excess)
                                   : Vec3(wish * (slide / excess));
        if (felt_ && motion.norm() <= kRest * radius_) return false;
        const bool takesTime = slide < excess && isViscous();
        // A curved step is a guess: where it led onto a flat face it went too far, and the next round says
        // so.
        const bool guessed = felt_ ? motion.norm() > settled() : free && motion != wish;
        std::uint32_t body = kNoBody;
        const SweepHit hit = sweep(motion, body);
        const double part = std::min(hit.t, 1.0);
        state_.position += part * motion;
        if (part * motion.norm() > kRest * radius_) forgetInactive();
        const bool planesTurned = refreshContacts();
        if (body != kNoBody) {
            timeLeft_ *= 1 - part;
            if (!meet(body, hit.triangle)) return false;
            foresee(body, hit, 0);
            return true;
        }
        if (planesTurned && hit.soonCount > 0) {
            const int had = pushing_;
            const bool alone = state_.contactCount == 0;
            if (alone) meet(soonBody_, hit.soon[0]);
            if (had > 1) foresee(soonBody_, hit, alone ? 1 : 0);
        }
        // Whatever is met from here on in this step has no time left to be slid on against viscosity.
        if (takesTime) timeLeft_ = 0;
        if (felt_) return guessed || state_.contactCount == 0;
        return planesTurned || guessed;
    }

    // A proxy that was squeezed leaves the surfaces as soon as there is room, by the shortest way: friction
    // holds it where it is, not inside of what it touches.
    bool comesOut() noexcept {
        const auto isInside = [this](const Contact& c) { return c.gap < -kKeep * kSkin * radius_; };
        if (std::ranges::none_of(contacts(), isInside)) return false;
        const NearestPoint out = nearestPoint(Vec3::Zero(), planes().all());
        if (!out.feasible) return false;
        std::uint32_t body = kNoBody;
        const SweepHit hit = sweep(out.x, body);
        state_.position += std::min(hit.t, 1.0) * out.x;
        nearestDistance_ = std::numeric_limits<double>::infinity(); // where it was is no place to return to
        refreshContacts();
        return body == kNoBody || meet(body, hit.triangle);
    }

    // The update stage: where the proxy would go if nothing but the planes held it, relative to it.
    Vec3 unconstrainedByFriction() noexcept {
        felt_ = isFelt(obstacles_, contacts());
        const NearestPoint nearest = felt_ ? updateFelt(state_, feltContacts()) : updatePlain();
        squeezed_ |= !nearest.feasible;
        pushing_ = nearest.active;
        return nearest.x;
    }

    // On facets that feel as they are.
    NearestPoint updatePlain() noexcept {
        Planes held = planes();
        const NearestPoint nearest = nearestReachable(finger_ - state_.position, held.all());
        for (int i = 0; i < state_.contactCount; ++i) {
            Contact& contact = state_.contacts[i];
            contact.lambda = nearest.lambda[i];
            if (contact.lambda > 0) contact.material = obstacles_[contact.body].material(contact.triangle);
        }
        state_.feltCount = 0;
        return nearest;
    }

    // Features that pass by too fast for the servo are left out. A finger at rest feels all of them, however
    // far the proxy just went: what is felt must not change while the proxy settles.
    FeltContacts feltContacts() noexcept {
        const double way = std::min(state_.speed, fingerVelocity_.norm()) * dt_;
        return {obstacles_, movers_, contacts(), radius_, finger_, kStepsToAFeature * way};
    }

    // Down onto the surfaces, and along them as far as the felt normal, which changes on the way, still leads
    // on. Between where the drop and where the wish end no plane is crossed.
    Vec3 alongFelt(const Vec3& wish, double part, bool free) noexcept {
        const Vec3 drop = seat();
        Vec3 slide = part * (wish - drop);
        if (slide.norm() <= kRest * radius_) return drop;
        const double reach = feltReach(state_, feltContacts(), drop, slide, free);
        if (reach <= 1 || isAllowed(drop + reach * slide)) slide *= reach;
        if (slide.dot(lastSlide_) < 0) state_.stride = 0.5 * lastSlide_.norm();
        const double most = free ? std::min(state_.stride, settlingStride()) : state_.stride;
        if (const double length = slide.norm(); length > most) slide *= most / length;
        state_.stride *= kStrideGrowth;
        lastSlide_ = slide;
        return drop + slide;
    }

    double settled() const noexcept { return (state_.stillFor > 0 ? kRest : kSettled) * radius_; }

    // Where the proxy, which went ahead on tangents, is pressed down to: no friction and no felt normal has a
    // say in it.
    Vec3 seat() noexcept {
        Vec3 push = Vec3::Zero();
        for (const Contact& contact : contacts())
            push -= contact.lambda * contact.normal;
        Planes held = planes();
        return nearestReachable(push, held.all()).x;
    }

    // Normals can be such that a felt surface nowhere holds the finger: it shall not move under a hand that
    // does not.
    double settlingStride() const noexcept {
        return state_.stillFor < kSettling ? std::numeric_limits<double>::infinity()
                                           : std::ldexp(radius_, kSettling - state_.stillFor);
    }

    void countStillSteps() noexcept {
        const bool still = finger_ == state_.finger && movers_.empty();
        if (!still) state_.stride = std::numeric_limits<double>::infinity();
        state_.stillFor = still ? std::min(state_.stillFor + 1, 1 << 10) : 0;
    }

    // The same on curved constraints. Around an edge or a vertex the C-obstacle is a cylinder or a sphere,
    // and going to the foot on its tangent plane again and again only halves the error.
    Vec3 alongCurvature(const Vec3& flat, double excess) noexcept {
        std::array<const Contact*, 2> held{};
        int pushing = 0;
        for (const Contact& contact : contacts()) {
            if (contact.lambda <= 0) continue;
            if (pushing == 2) return flat;
            held[std::size_t(pushing++)] = &contact;
        }
        if (pushing == 0) return flat;
        if (pushing == 1 && !(held[0]->lambda * held[0]->bend * bentPart(*held[0], flat / excess) > 0))
            return flat;
        const Vec3 bent = pushing == 1 ? aroundAlone(*held[0], flat) : alongBoth(*held[0], *held[1], flat);
        return isAllowed(bent) ? bent : flat;
    }

    bool isAllowed(const Vec3& motion) noexcept {
        return std::ranges::all_of(contacts(), [&](const Contact& contact) {
            return contact.normal.dot(motion) >= -std::max(contact.gap, 0.0) - kRest * radius_;
        });
    }

    // How much of a direction the C-obstacle bends in.
    static double bentPart(const Contact& contact, const Vec3& way) noexcept {
        const double along = contact.edge.dot(way), out = contact.normal.dot(way);
        return std::max(0.0, 1 - along * along - out * out);
    }

    // On one edge or vertex alone the answer is known: on the ray from there to the finger. In the tangent
    // plane the proxy goes to just above it, and drops onto it in the next round. A finger beyond the edge
    // has no such answer: the proxy rolls off.
    Vec3 aroundAlone(const Contact& contact, const Vec3& flat) noexcept {
        const Vec3 foot = contact.point + contact.edge * contact.edge.dot(finger_ - contact.point);
        const Vec3 out = finger_ - foot;
        const double rise = contact.normal.dot(out);
        if (!(rise > kSteepest * out.norm())) return flat;
        return foot + out * (radius_ / rise) - state_.position;
    }

    // On several constraints one direction is left to go, and the curvature of all in it, the Hessian of the
    // Lagrangian (4), 1 - sum lambda_i Hess(distance_i), tells how far: Newton's method. The way down onto
    // the planes is not to be stretched with it: it would lead below them.
    static Vec3 alongBoth(const Contact& a, const Contact& b, const Vec3& flat) noexcept {
        const Vec3 axis = a.normal.cross(b.normal);
        const double length2 = axis.squaredNorm();
        if (!(length2 > 0)) return flat;
        const Vec3 way = axis / std::sqrt(length2);
        const double bend = a.lambda * a.bend * bentPart(a, way) + b.lambda * b.bend * bentPart(b, way);
        const double farther = bend < kMostBent ? bend / (1 - bend) : kRollFaster - 1;
        return flat + farther * way.dot(flat) * way;
    }

    // Sections 4.1 and 4.2: any plane in static contact holds; of the sliding ones the lowest bound wins.
    double frictionAllows(const Vec3& wish, double excess) noexcept {
        if (isHeld(excess)) return 0;
        const double speed = fingerVelocity_.dot(wish) / excess;
        double slide = excess;
        for (Contact& contact : contacts()) {
            if (contact.lambda <= 0) continue;
            contact.slipping = true;
            state_.slidingOn = contact.body;
            const FrictionLimit limit = frictionLimit(contact.material, true);
            slide = std::min(slide, allowedSlide(limit, excess, depthOn(contact), speed, timeLeft_));
        }
        return slide;
    }

    // Normal force on a contact divided by the stiffness, with what planes that lean less than a right angle
    // from it carry of the load: two halves of a flat floor rub as one.
    double depthOn(const Contact& contact) noexcept {
        double depth = 0;
        for (const Contact& other : contacts())
            depth += std::max(0.0, other.lambda) * std::max(0.0, other.normal.dot(contact.normal));
        return depth;
    }

    bool isHeld(double excess) noexcept {
        bool held = false;
        for (Contact& contact : contacts()) {
            const FrictionLimit limit = frictionLimit(contact.material, contact.slipping);
            if (contact.lambda > 0 && excess <= limit.coefficient * depthOn(contact)) held = true;
        }
        return held;
    }

    bool isViscous() noexcept {
        return std::ranges::any_of(contacts(), [&](const Contact& contact) {
            return contact.lambda > 0 && contact.material.viscosity > 0;
        });
    }

    // The move stage. Primitives with a plane are left out: a C-obstacle is convex, so the half-space above
    // its plane is free of it.
    SweepHit sweep(const Vec3& motion, std::uint32_t& body) noexcept {
        SweepHit first;
        for (std::uint32_t i = 0; i < obstacles_.size(); ++i) {
            const Obstacle& obstacle = obstacles_[i];
            if (hasPassed(state_, i)) continue;
            std::array<Index, kMaxPlanes> touched;
            std::size_t count = 0;
            for (const Contact& contact : contacts())
                if (contact.body == i) touched[count++] = contact.triangle;
            const SpherePath path{poseNow(obstacle, movers_).applyInverse(state_.position),
                                  poseNow(obstacle, movers_).rotateInverse(motion), radius_ * (1 - kSkin),
                                  obstacle.sides};
            // Of many bodies most are far away, and memories are few.
            if (obstacles_.size() > state_.memories.size() &&
                obstacle.mesh->tree.isBeyond(path.from, path.radius + path.motion.norm()))
                continue;
            SweepMemory& memory = state_.memories[i % state_.memories.size()];
            const SweepHit hit = sweepFrom(memory, *obstacle.mesh, path, {touched.data(), count});
            if (hit.t < first.t) {
                first = hit;
                body = i;
            } else if (hit.soonCount > 0 && body == kNoBody) {
                first.soon = hit.soon;
                first.soonCount = hit.soonCount;
                soonBody_ = i;
            }
        }
        return first;
    }

    // Adds the primitive that ended a move. Without room for its plane the step ends here, outside.
    bool meet(std::uint32_t body, Index triangle) noexcept {
        if (state_.contactCount == kMaxPlanes) return false;
        Contact contact;
        contact.body = body;
        contact.triangle = triangle;
        contact.slipping = state_.slidingOn == body;
        locate(contact);
        state_.contacts[state_.contactCount++] = contact;
        return true;
    }

    // Faces that the proxy is about to touch hold it in the next round already, instead of costing one each.
    // The half-space above any plane is free of its primitive; but an edge's plane would stop a slide toward
    // a flat neighbour.
    void foresee(std::uint32_t body, const SweepHit& hit, int begin) noexcept {
        for (int i = begin; i < hit.soonCount; ++i) {
            if (!meet(body, hit.soon[std::size_t(i)])) return;
            const Contact& contact = state_.contacts[state_.contactCount - 1];
            if (contact.bend > 0 || contact.gap > kHover * radius_) --state_.contactCount;
        }
    }

    void locate(Contact& contact) noexcept {
        tactum::locate(contact, obstacles_, movers_, radius_, state_.position);
    }

    // Recomputes every plane, drops what is no longer touched; says whether any plane turned or went.
    bool refreshContacts() noexcept {
        bool changed = false;
        int kept = 0;
        for (Contact contact : contacts()) {
            const Vec3 before = contact.normal;
            const bool wasBent = contact.bend > 0;
            locate(contact);
            const bool turned = (contact.normal - before).squaredNorm() > kSamePlane * kSamePlane;
            // What still pushed and is only just left is come back to: rolling, or a move that was cut short.
            const double keep = contact.lambda > 0 && (wasBent || !turned) ? kHover : kKeep * kSkin;
            changed = changed || turned;
            if (contact.gap <= keep * radius_)
                state_.contacts[kept++] = contact;
            else
                changed = true;
        }
        state_.contactCount = kept;
        return changed;
    }

    // After a real move, planes that did not push are found again by the sweep if they matter.
    void forgetInactive() noexcept {
        const auto kept = std::ranges::remove_if(contacts(), [](const Contact& c) { return c.lambda <= 0; });
        state_.contactCount -= int(kept.size());
    }

    // A contact sticks again when its motion has died out within a step.
    void finish() noexcept {
        const bool still = (state_.position - start_).norm() <= kRest * radius_;
        for (Contact& contact : contacts())
            if (still) contact.slipping = false;
        if (still || state_.contactCount == 0) state_.slidingOn = kNoBody;
        state_.finger = finger_;
        state_.speed = std::max((state_.position - start_).norm() / dt_, kSpeedDecay * state_.speed);
    }

    ProxyState& state_;
    std::span<const Obstacle> obstacles_;
    std::span<const BodyMotion> movers_;
    double radius_;
    Vec3 finger_;
    double dt_;
    double timeLeft_;
    Vec3 fingerVelocity_;
    Vec3 start_;                    ///< where the proxy was, or where what it rides on took it
    Vec3 lastSlide_ = Vec3::Zero(); ///< the last one on a felt surface
    int mostRounds_;
    int rounds_ = 0;
    bool squeezed_ = false;
    Vec3 nearest_ = start_; ///< the nearest place of the last rounds, or the first
    double nearestDistance_ = (finger_ - start_).norm();
    bool felt_ = false;          ///< some contact of this round is shaded or textured
    int pushing_ = 0;            ///< how many planes hold the proxy in this round
    std::uint32_t soonBody_ = 0; ///< of the triangle that the last sweep ended near
};

} // namespace

ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt, std::span<const BodyMotion> movers,
                          int mostRounds) noexcept {
    const CarryReport carried = carry(state, obstacles, movers, radius);
    ProxyReport report =
        Step(state, obstacles, movers, radius, finger_W, dt, carried.start, mostRounds).run();
    report.squeezed |= carried.squeezed;
    report.passed = carried.passed;
    return report;
}

} // namespace tactum
