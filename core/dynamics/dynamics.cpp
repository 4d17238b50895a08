#include "core/dynamics/dynamics.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

/// A limit that is met ends a part of the step; after so many the rest is one part.
constexpr int kMostEvents = 4;
/// How much the slopes in the middle of a step may differ, as a part of what they differ from the first.
constexpr double kRough = 0.04;
/// By no more than this, m/s or rad/s and as a part of the speed, they never matter.
constexpr double kSmooth = 1e-9;
/// Springs and dampers that are held are found anew where it is more than this.
constexpr double kVeryRough = 0.25;
/// Loops that are farther open, m or rad, are closed before the next step.
constexpr double kOpen = 1e-6;
/// What is rough is gone in at most so many parts.
constexpr int kFinest = 8;

/// Whether a part of a step is too long for what happens in it, as a whip's crack is. Both slopes in its
/// middle are of one time, the second found with the help of the first: |k3 - k2| / |k2 - k1| grows with how
/// fast slopes change there (E. Hairer, S. Norsett and G. Wanner, Solving Ordinary Differential Equations I,
/// II.4). `rough`: how much of it is.
bool isRough(const std::array<Coordinates, 4>& slopes, const Coordinates& v, double dt,
             double rough) noexcept {
    const double first = (slopes[1] - slopes[0]).squaredNorm();
    const double second = (slopes[2] - slopes[1]).squaredNorm();
    return second > rough * rough * first && dt * dt * second > kSmooth * kSmooth * (1 + v.squaredNorm());
}

/// Beyond what numbers hold: it stands still where it was, and goes on from there.
void standStill(DynamicState& state, const DynamicState& before) noexcept {
    state = before;
    state.v.setZero();
}

} // namespace

Vec3 AppliedForce::forceAt(const Vec3& now_W, const Vec3& rate_W) const noexcept {
    if (!(stiffness > 0)) return force_W;
    const Vec3 less = stiffness * (now_W - start_W) + damping * (rate_W - velocity_W);
    const double before = force_W.dot(into_W), press = before - into_W.dot(less);
    if (!(press > 0 && before > 0)) return Vec3::Zero();
    if (sticks) return force_W - less;
    return press / before * force_W;
}

Dynamics::Dynamics(std::shared_ptr<const Mechanism> mechanism)
    : mechanism_(std::move(mechanism)), articulation_(*mechanism_), loops_(*mechanism_), rows_(*mechanism_) {
    const Mechanism& m = *mechanism_;
    along_ = free_ = springs_ = Coordinates::Zero(m.vs);
    q_ = Coordinates::Zero(m.qs);
    for (std::size_t i = 0; i < 4; ++i) {
        a_[i] = v_[i] = Coordinates::Zero(m.vs);
        qRate_[i] = Coordinates::Zero(m.qs);
    }
    before_ = looked_ = startState(); // its memory, before the first step
    springInertia_.assign(m.springs.size(), 1);
    weighs_ = std::ranges::any_of(m.springs, [](const Spring& spring) { return spring.drive.acceleration; });
}

DynamicState Dynamics::startState() const {
    return {mechanism_->q0, mechanism_->v0, 0};
}

Dynamics::Stretch Dynamics::stretchOf(const Spring& spring, const Coordinates& q,
                                      const Coordinates& v) const noexcept {
    const Coordinate& of = spring.of;
    Stretch now;
    if (of.link >= 0) {
        const Link& link = mechanism_->links[std::size_t(of.link)];
        now.value = of.sense * q[link.q];
        now.rate = of.sense * v[link.v];
    } else {
        const Measured measured = measure(of, articulation_.poseOf(of.a), articulation_.poseOf(of.b));
        now.value = measured.value;
        now.along = measured.along;
        now.rate = articulation_.powerOf(of.a, of.b, now.along);
    }
    now.rest = spring.drive.restAt(now.value);
    if (spring.isLimit) {
        now.acts = now.value < spring.min || now.value > spring.max;
        now.rest = now.value < spring.min ? spring.min : spring.max;
    }
    return now;
}

double Dynamics::forceOf(std::size_t spring, const Stretch& now) const noexcept {
    const JointDrive& drive = mechanism_->springs[spring].drive;
    return springInertia_[spring] *
           std::clamp(drive.stiffness * (now.rest - now.value) + drive.damping * (drive.velocity - now.rate),
                      -drive.maxForce, drive.maxForce);
}

void Dynamics::addSprings(const Coordinates& q, const Coordinates& v) noexcept {
    springs_ = along_;
    for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) {
        const Spring& spring = mechanism_->springs[i];
        if (rows_.springIsRow(i)) continue;
        const Stretch now = stretchOf(spring, q, v);
        if (!now.acts) continue;
        const double force = forceOf(i, now);
        if (spring.of.link >= 0)
            springs_[mechanism_->links[std::size_t(spring.of.link)].v] += spring.of.sense * force;
        else
            articulation_.addForce(spring.of.a, spring.of.b, now.along, force);
    }
}

void Dynamics::addForce(const AppliedForce& force) noexcept {
    const Vec3 point = articulation_.poseOf(force.at).translation;
    const Vec3 rate = articulation_.velocityOf(force.at).linear;
    articulation_.addForce(force.at.link, force.forceAt(point, rate), point);
}

void Dynamics::addAir(double dt) noexcept {
    for (const AirBox& box : mechanism_->air) {
        const Pose at = articulation_.poseOf(box.place);
        const FrameVelocity moves = articulation_.velocityOf(box.place);
        const Vec3 force = box.force(at.rotateInverse(moves.linear), dt);
        const Vec3 torque = box.torque(at.rotateInverse(moves.angular), dt);
        articulation_.addForce(Place{}, box.place, {at.rotate(force), at.translation, at.rotate(torque)}, 1);
    }
}

void Dynamics::evaluate(const Coordinates& q, const Coordinates& v, const Surroundings& around,
                        Coordinates& acceleration) noexcept {
    articulation_.place(q, v);
    articulation_.addGravity(around.gravity);
    for (const AppliedForce& force : around.forces)
        addForce(force);
    addAir(around.dt);
    addSprings(q, v);
    rows_.addHeld(articulation_);
    articulation_.accelerate(springs_, acceleration);
    if (loops_.empty()) return;
    loops_.factor(articulation_);
    loops_.correct(articulation_, acceleration);
}

void Dynamics::ratesOf(const Coordinates& q, const Coordinates& v, Coordinates& rate) const noexcept {
    for (const Link& link : mechanism_->links) {
        if (link.kind != LinkKind::Ball) {
            rate[link.q] = v[link.v];
            continue;
        }
        // q' = q w / 2, w in the frame of the link.
        const Vec3 x = q.segment<3>(link.q), w = v.segment<3>(link.v);
        rate.segment<3>(link.q) = 0.5 * (q[link.q + 3] * w + x.cross(w));
        rate[link.q + 3] = -0.5 * x.dot(w);
    }
}

void Dynamics::normalise(Coordinates& q) const noexcept {
    for (const Link& link : mechanism_->links)
        if (link.kind == LinkKind::Ball) q.segment<4>(link.q).normalize();
}

// The first of the four slopes of v is known: it was needed for what is not smooth. Where the slopes change
// too much the way is gone in up to `finest` parts; not at all where `whole`, which gives false then.
bool Dynamics::rungeKutta(DynamicState& state, const Surroundings& around, double dt, int finest,
                          bool whole) noexcept {
    double part = dt;
    // What closes a loop damps its gap by 2 c: that alone makes c h of the ratio, and is as smooth as it
    // seems.
    const auto rough = [&] { return kRough + (loops_.empty() ? 0 : kClosing * part); };
    const auto slope = [&](std::size_t i, double h) {
        q_ = state.q + h * qRate_[i - 1];
        v_[i] = state.v + h * a_[i - 1];
        ratesOf(q_, v_[i], qRate_[i]);
        evaluate(q_, v_[i], around, a_[i]);
    };
    const auto goHalfWay = [&] {
        slope(1, 0.5 * part);
        slope(2, 0.5 * part);
    };
    for (int left = 1, all = 1; left > 0;) {
        v_[0] = state.v;
        ratesOf(state.q, state.v, qRate_[0]);
        for (goHalfWay(); all < finest && isRough(a_, state.v, part, rough()); goHalfWay()) {
            if (whole && left == all && isRough(a_, state.v, part, kVeryRough)) return false;
            part *= 0.5;
            left *= 2, all *= 2;
        }
        slope(3, part);
        state.q += part / 6 * (qRate_[0] + 2 * qRate_[1] + 2 * qRate_[2] + qRate_[3]);
        state.v += part / 6 * (a_[0] + 2 * a_[1] + 2 * a_[2] + a_[3]);
        if (!state.q.allFinite() || !state.v.allFinite()) {
            ++stoodStill_;
            standStill(state, before_);
            return true;
        }
        normalise(state.q);
        if (--left > 0) evaluate(state.q, state.v, around, a_[0]);
    }
    return true;
}

void Dynamics::weighSprings(const DynamicState& state) noexcept {
    if (!weighs_) return;
    articulation_.place(state.q, state.v);
    articulation_.factor();
    for (std::size_t i = 0; i < springInertia_.size(); ++i)
        if (mechanism_->springs[i].drive.acceleration)
            springInertia_[i] = rows_.inertiaOf(articulation_, mechanism_->springs[i].of);
}

// What a step that was too rough for its order has opened would take 1 / c to come back, and be farther
// open by then.
void Dynamics::closeLoops(DynamicState& state) noexcept {
    loops_.projectAll(state.v);
    loops_.closing(free_);
    ratesOf(state.q, free_, qRate_[0]);
    state.q += qRate_[0];
    normalise(state.q);
}

void Dynamics::findHeldForces(DynamicState& state, const Surroundings& around, bool early) noexcept {
    along_.setZero();
    rows_.letGo();
    weighSprings(state);
    evaluate(state.q, state.v, around, a_[0]);
    if (!loops_.empty() && loops_.largestGap() > kOpen) {
        closeLoops(state);
        evaluate(state.q, state.v, around, a_[0]);
    }
    rows_.gather(articulation_, loops_, state.q, around.dt, early);
    if (rows_.empty()) return;
    if (rows_.stopApproaches(state.v)) {
        evaluate(state.q, state.v, around, a_[0]);
        rows_.gather(articulation_, loops_, state.q, around.dt, early);
    }
    rows_.solve(state.v, around.dt, along_, a_[0]);
}

void Dynamics::takeBack(DynamicState& state, double dt) noexcept {
    if (!rows_.correction(dt, free_)) return;
    ratesOf(state.q, free_, qRate_[0]);
    state.q += qRate_[0];
    normalise(state.q);
}

// Up to where bodies meet or a limit is reached; the blow is the next part's. After so many of them what is
// met in the rest counts as met before. What dampers and springs among the rows do is found anew for each
// part of what is rough: held for longer than the motion stays the same, it drives what it should calm.
void Dynamics::advance(DynamicState& state, Surroundings around, int finest) noexcept {
    for (int event = 0; around.dt > 0; ++event) {
        const bool last = event == kMostEvents;
        findHeldForces(state, around, last);
        const bool whole = finest > 1 && rows_.holdSprings();
        before_ = state;
        double part = last ? 1 : rows_.firstTouch(around.dt);
        if (!rungeKutta(state, around, part * around.dt, finest, whole)) {
            around.dt *= 0.5;
            advance(state, around, finest / 2);
            advance(state, around, finest / 2);
            return;
        }
        if (!mechanism_->limits.empty() && !last) {
            articulation_.place(state.q, state.v);
            const double crossing = rows_.firstCrossing(articulation_, state.q, part * around.dt);
            if (crossing < 1) {
                part *= crossing;
                state = before_;
                rungeKutta(state, around, part * around.dt, finest, false);
            }
        }
        takeBack(state, part * around.dt);
        if (part == 1) return;
        around.dt *= 1 - part;
    }
}

void Dynamics::step(DynamicState& state, const Vec3& gravity, std::span<const AppliedForce> forces,
                    double dt) noexcept {
    const int parts = std::max(1, int(std::ceil(dt / kLongestPart - 1e-9)));
    rows_.chooseSprings(dt / parts);
    for (int i = 0; i < parts; ++i)
        advance(state, {gravity, forces, dt / parts}, kFinest);
    state.time += dt;
}

void Dynamics::accelerations(const DynamicState& state, const Vec3& gravity,
                             std::span<const AppliedForce> forces, Coordinates& acceleration) noexcept {
    along_.setZero();
    rows_.letGo();
    rows_.chooseSprings(0);
    evaluate(state.q, state.v, {gravity, forces, 0}, acceleration);
}

double Dynamics::effectiveMass(const DynamicState& state, const Place& at, const Vec3& along_W) noexcept {
    if (at.link < 0) return kUnbounded;
    articulation_.place(state.q, state.v);
    articulation_.factor();
    if (!loops_.empty()) loops_.factor(articulation_);
    const Island& island = mechanism_->islands[std::size_t(mechanism_->links[std::size_t(at.link)].island)];
    const Wrench push{along_W, articulation_.poseOf(at).translation, Vec3::Zero()};
    along_.setZero();
    articulation_.addJacobian(at.link, push, 1, along_.data() + island.v);
    articulation_.respond(island, along_.data() + island.v, free_.data() + island.v);
    if (!loops_.empty()) loops_.project(island, free_.data() + island.v);
    const double yield =
        along_.segment(island.v, island.velocities).dot(free_.segment(island.v, island.velocities));
    return yield > 0 ? 1 / yield : kUnbounded;
}

void Dynamics::posesOf(const DynamicState& state, std::span<Pose> bodies) noexcept {
    articulation_.place(state.q, state.v);
    for (std::size_t i = 0; i < mechanism_->places.size() && i < bodies.size(); ++i)
        bodies[i] = articulation_.poseOf(mechanism_->places[i]);
}

void Dynamics::describe(const DynamicState& state, const Vec3& gravity,
                        std::span<BodyState> bodies) noexcept {
    articulation_.place(state.q, state.v);
    for (std::size_t i = 0; i < mechanism_->bodies.size() && i < bodies.size(); ++i) {
        const RigidBody& body = mechanism_->bodies[i];
        const Place& place = mechanism_->places[i];
        const Place centre{place.link, place.pose * Pose{body.inertiaFrame, body.centre}};
        const Pose principal = articulation_.poseOf(centre);
        const FrameVelocity velocity = articulation_.velocityOf(centre);
        BodyState& now = bodies[i];
        now.pose = articulation_.poseOf(place);
        now.centre = principal.translation;
        now.velocity = velocity.linear;
        now.angularVelocity = velocity.angular;
        const Vec3 turning = principal.rotation.conjugate() * velocity.angular;
        now.kinetic = 0.5 * body.mass * velocity.linear.squaredNorm() +
                      0.5 * turning.dot(body.inertia.cwiseProduct(turning));
        now.potential = -body.mass * body.gravityFactor * gravity.dot(now.centre);
    }
}

double Dynamics::springEnergy(const DynamicState& state) noexcept {
    articulation_.place(state.q, state.v);
    double sum = 0;
    for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) {
        const Stretch now = stretchOf(mechanism_->springs[i], state.q, state.v);
        const JointDrive& drive = mechanism_->springs[i].drive;
        const double off = now.value - now.rest;
        const double held = drive.spacing > 0 ? drive.energyAt(now.value) : 0.5 * off * off;
        if (now.acts) sum += springInertia_[i] * drive.stiffness * held;
    }
    return sum;
}

double Dynamics::jointForce(const DynamicState& state, const Vec3& gravity,
                            std::span<const AppliedForce> forces, double dt, int link) noexcept {
    looked_ = state;
    rows_.forget();
    rows_.chooseSprings(dt);
    findHeldForces(looked_, {gravity, forces, dt}, true);
    double sum = rows_.forceAlong(link, dt);
    articulation_.place(state.q, state.v);
    for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) {
        const Spring& spring = mechanism_->springs[i];
        if (spring.of.link != link || rows_.springIsRow(i)) continue;
        if (const Stretch now = stretchOf(spring, state.q, state.v); now.acts)
            sum += spring.of.sense * forceOf(i, now);
    }
    rows_.forget();
    return sum;
}

double Dynamics::loopGap(const DynamicState& state) noexcept {
    articulation_.place(state.q, state.v);
    articulation_.factor();
    loops_.factor(articulation_);
    return loops_.largestGap();
}

} // namespace tactum
