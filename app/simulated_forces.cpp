#include "app/simulated_forces.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace tactum {

namespace {

constexpr double kBesideColliders = 1e3; ///< m: a body without colliders comes after all others
constexpr double kBeside = 1e-3;         ///< m: so near to a body is on it
/// A push that begins or ends so near to the end of a step, as a part of it, does so there.
constexpr double kAtTheEnd = 1e-6;

} // namespace

std::vector<std::string> tableNames(const std::vector<RigidBody>& bodies) {
    std::set<std::string> taken;
    for (const RigidBody& body : bodies)
        taken.insert(body.name);
    std::set<std::string> given;
    std::vector<std::string> names;
    for (const RigidBody& body : bodies) {
        std::string name = body.name;
        for (int i = 2; given.contains(name) || (name != body.name && taken.contains(name)); ++i)
            name = body.name + " " + std::to_string(i);
        given.insert(name);
        names.push_back(name);
    }
    return names;
}

double Pushes::untilChange(double time, double dt) const {
    double until = dt;
    for (const PushOption& push : given_)
        for (const double change : {push.from - time, push.to - time})
            if (change > kAtTheEnd * dt && change < (1 - kAtTheEnd) * dt) until = std::min(until, change);
    return until;
}

const std::vector<AppliedForce>& Pushes::at(double time, double dt, Dynamics& dynamics,
                                            const DynamicState& state) {
    acting_.clear();
    for (std::size_t i = 0; i < given_.size(); ++i) {
        const double middle = time + 0.5 * dt;
        if (middle < given_[i].from || middle >= given_[i].to) continue;
        if (!places_[i].found) places_[i] = find(given_[i], dynamics, state);
        if (places_[i].found) acting_.push_back({places_[i].place, given_[i].force});
    }
    return acting_;
}

std::size_t Pushes::missed() const {
    return std::size_t(
        std::ranges::count_if(places_, [](const Found& one) { return one.looked && !one.found; }));
}

std::vector<std::string> Pushes::strays() const {
    std::vector<std::string> lines;
    for (const Found& one : places_) {
        if (!one.found || one.distance <= kBeside) continue;
        std::string line = "--push: no body is at its point; the nearest, " + inQuotes(one.body) + ", ";
        appendNumber(line, one.distance);
        lines.push_back(line + " m away, is pushed as if it reached there");
    }
    return lines;
}

/// The body whose collider, or else whose centre, is nearest to the point.
Pushes::Found Pushes::find(const PushOption& push, Dynamics& dynamics, const DynamicState& state) const {
    std::vector<BodyState> bodies(mechanism_.bodies.size());
    dynamics.describe(state, Vec3::Zero(), bodies);
    Found found;
    found.looked = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Place& place = mechanism_.places[i];
        if (place.link < 0) continue;
        double distance = (bodies[i].centre - push.point).norm() + kBesideColliders;
        for (const Collider& collider : mechanics_.colliders)
            if (collider.body == mechanism_.bodies[i].id)
                distance =
                    std::min(distance, distanceTo(collider.shape,
                                                  (bodies[i].pose * collider.pose).applyInverse(push.point)));
        if (distance >= nearest) continue;
        nearest = distance;
        found.found = true;
        found.body = names_[i];
        found.distance = distance < kBesideColliders ? distance : (bodies[i].centre - push.point).norm();
        found.place = {place.link,
                       place.pose * Pose{Quat::Identity(), bodies[i].pose.applyInverse(push.point)}};
    }
    return found;
}

KeyedBodies::KeyedBodies(const Scene& scene, const Mechanism& mechanism) : leader_(mechanism) {
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const RigidBody& body = mechanism.bodies[i];
        const auto object = std::ranges::find_if(
            scene.objects, [&](const SceneObject& one) { return one.body == body.id && bool(one.motion); });
        if (!body.kinematic || object == scene.objects.end() || !leader_.canLead(i)) continue;
        all_.push_back({i, object->motion, object->pose, object->pose.inverse() * body.pose});
    }
}

void KeyedBodies::start(DynamicState& state) {
    constexpr double kSoon = 1e-6; // s
    lead(0, kSoon, state);
}

void KeyedBodies::lead(double time, double dt, DynamicState& state) {
    led_.clear();
    for (const Keyed& one : all_) {
        const Leader::Led led{one.body, one.at(time + dt)};
        if (one.motion->jumpsBetween(time, time + dt))
            leader_.put(led, state);
        else
            led_.push_back(led);
    }
    leader_.lead(led_, dt, state);
}

} // namespace tactum
