#include "core/haptics/moving_bodies.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/dynamics/finger_swing.h"
#include "core/surface/friction.h"

namespace tactum {

namespace {

/// A step as the loops take it, to see in it what a joint does, s.
constexpr double kLook = 5e-4;

/// FNV-1a over words.
class Key {
public:
    void add(std::uint64_t word) noexcept { value_ = std::rotl((value_ ^ word) * 0x100000001b3u, 29); }
    void add(double number) noexcept { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const Eigen::VectorXd& numbers) noexcept {
        for (const double number : numbers)
            add(number);
    }
    void add(const Pose& pose) noexcept {
        for (int i = 0; i < 4; ++i)
            add(pose.rotation.coeffs()[i]);
        for (int i = 0; i < 3; ++i)
            add(pose.translation[i]);
    }
    std::uint64_t value() const noexcept { return value_ | 1; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// The way means another place where the curve is another one.
void addCurve(const PathCurve& path, Key& key) {
    constexpr int kLooks = 64;
    key.add(path.length());
    for (int i = 0; i <= kLooks; ++i)
        key.add(path.at(path.length() * i / kLooks).pose);
}

/// Of masses, springs and materials nothing: they may change under the hand.
std::uint64_t keyOf(const Mechanism& mechanism) {
    Key key;
    for (const Link& link : mechanism.links) {
        key.add(std::uint64_t(link.kind));
        key.add(std::uint64_t(std::int64_t(link.parent)));
        key.add(std::uint64_t(link.axis));
        key.add(link.base);
        if (link.kind != LinkKind::Path) continue;
        key.add(std::uint64_t(link.carriesPath));
        addCurve(mechanism.paths[std::size_t(link.path)], key);
    }
    key.add(mechanism.q0);
    key.add(mechanism.v0);
    return key.value();
}

/// Of the force on the finger, that the hand gets.
double partGiven(const FingerPress& press, double stiffness) noexcept {
    const Coupling& hand = press.coupling;
    const double softer = stiffness > hand.stiffness ? hand.stiffness / stiffness : 1;
    const double given = softer * press.force.norm();
    return given > hand.force ? softer * hand.force / given : softer;
}

} // namespace

FingerPushes pushesOf(const ProxyState& proxy, const FingerPress& press, double stiffness,
                      const HandScale& scale) noexcept {
    FingerPushes pushes;
    if (!(scale.time > 0)) return pushes;
    double total = 0;
    Vec3 rest = press.force;
    for (int i = 0; i < proxy.contactCount; ++i) {
        const Contact& contact = proxy.contacts[std::size_t(i)];
        if (!(contact.lambda > 0)) continue;
        total += contact.lambda;
        rest -= stiffness * contact.lambda * contact.normal;
    }
    if (!(total > 0)) return pushes;
    const double part = scale.force * partGiven(press, stiffness);
    for (int i = 0; i < proxy.contactCount; ++i) {
        const Contact& contact = proxy.contacts[std::size_t(i)];
        if (!(contact.lambda > 0)) continue;
        const double share = contact.lambda / total;
        AppliedForce force;
        force.force_W = -part * (stiffness * contact.lambda * contact.normal + share * rest);
        force.stiffness = part * stiffness;
        force.damping = force.stiffness * scale.time * press.coupling.delay;
        force.velocity_W = press.velocity / scale.time;
        force.start_W = contact.point;
        force.into_W = -contact.normal;
        force.sticks = hasFriction(contact.material) && !contact.slipping;
        pushes.push({contact.body, force});
    }
    return pushes;
}

MovingBodies::MovingBodies(std::shared_ptr<const Mechanism> mechanism, const Vec3& gravity,
                           const HandScale& scale)
    : mechanism_(std::move(mechanism)), gravity_(gravity), scale_(scale), key_(keyOf(*mechanism_)),
      dynamics_(mechanism_), now_(dynamics_.startState()), poses_(mechanism_->bodies.size()) {}

int MovingBodies::add(const Driven& driven) {
    driven_.push_back(driven);
    motions_.push_back({});
    return int(driven_.size()) - 1;
}

void MovingBodies::read(const BodiesState& state) noexcept {
    std::copy_n(state.q.begin(), state.qs, now_.q.data());
    std::copy_n(state.v.begin(), state.vs, now_.v.data());
}

bool MovingBodies::begin(BodiesState& state) noexcept {
    const bool known = state.of == key_ && state.qs == mechanism_->qs && state.vs == mechanism_->vs;
    if (!known) {
        state.of = key_;
        state.qs = mechanism_->qs, state.vs = mechanism_->vs;
        std::copy_n(mechanism_->q0.data(), state.qs, state.q.begin());
        std::copy_n(mechanism_->v0.data(), state.vs, state.v.begin());
    }
    read(state);
    dynamics_.posesOf(now_, poses_);
    for (std::size_t i = 0; i < driven_.size(); ++i)
        motions_[i].before = motions_[i].now = poses_[driven_[i].body] * driven_[i].offset;
    forces_.clear();
    return !known;
}

/// Which of the mechanism it is; nothing for what stands still.
std::optional<std::size_t> MovingBodies::indexOf(BodyId body) const {
    const auto found = std::ranges::find(mechanism_->bodies, body, &RigidBody::id);
    const std::size_t index = std::size_t(found - mechanism_->bodies.begin());
    if (found == mechanism_->bodies.end() || mechanism_->places[index].link < 0) return std::nullopt;
    return index;
}

std::optional<double> MovingBodies::coordinateOf(BodyId body) const {
    const auto index = indexOf(body);
    if (!index) return std::nullopt;
    const Link& link = mechanism_->links[std::size_t(mechanism_->places[*index].link)];
    return link.kind == LinkKind::Ball ? std::nullopt : std::optional(now_.q[link.q]);
}

std::optional<BodyReading> MovingBodies::readingOf(BodyId body, const FingerPushes& pushes) {
    const auto index = indexOf(body);
    if (!index) return std::nullopt;
    const int place = mechanism_->places[*index].link;
    std::vector<BodyState> all(mechanism_->bodies.size());
    dynamics_.describe(now_, gravity_, all);
    BodyReading reading{.kinetic = all[*index].kinetic, .potential = all[*index].potential};
    const Link& link = mechanism_->links[std::size_t(place)];
    if (link.kind == LinkKind::Ball) return reading;
    reading.turns = link.kind == LinkKind::Turn;
    reading.slides = !reading.turns;
    reading.value = now_.q[link.q], reading.rate = now_.v[link.v];
    press(pushes, [](std::uint32_t driven) { return int(driven); });
    reading.force = dynamics_.jointForce(now_, gravity_, forces_.all(), kLook, place);
    forces_.clear();
    return reading;
}

// The point of the body's material that is touched now.
void MovingBodies::addForce(AppliedForce force, int driven) noexcept {
    const std::size_t body = driven_[std::size_t(driven)].body;
    const Place& place = mechanism_->places[body];
    const Vec3 point = poses_[body].applyInverse(force.start_W);
    force.at = {place.link, place.pose * Pose{Quat::Identity(), point}};
    forces_.push(force);
}

// The finger's spring and the body make an oscillator: its parts are short enough to follow it, and where
// none is, it is softer. Where several hold one body the dynamics cut the parts once more.
int MovingBodies::partsFor(double dt) noexcept {
    double fastest = 0;
    for (AppliedForce& force : forces_.all()) {
        const double mass = dynamics_.effectiveMass(now_, force.at, force.into_W);
        const double swing = dt * std::sqrt(force.stiffness / mass);
        const double most = kFastestSwing * kSwingParts;
        force.damping = std::min(force.damping, most * mass / dt);
        fastest = std::max({fastest, swing, dt * force.damping / mass});
        if (!(swing > most)) continue;
        const double part = most * most / (swing * swing);
        force.force_W *= part;
        force.stiffness *= part;
    }
    return int(std::clamp(std::ceil(fastest / kSwing), 1.0, double(kSwingParts)));
}

void MovingBodies::step(BodiesState& state, double dt) noexcept {
    dt = std::min(dt, kMostBodyTime);
    const int parts = partsFor(dt);
    for (int i = 0; i < parts; ++i)
        dynamics_.step(now_, gravity_, forces_.all(), dt / parts);
    std::copy_n(now_.q.data(), state.qs, state.q.begin());
    std::copy_n(now_.v.data(), state.vs, state.v.begin());
    dynamics_.posesOf(now_, poses_);
    for (std::size_t i = 0; i < driven_.size(); ++i)
        motions_[i].now = poses_[driven_[i].body] * driven_[i].offset;
    forces_.clear();
}

} // namespace tactum
