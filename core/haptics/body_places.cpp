#include "core/haptics/body_places.h"

#include <algorithm>
#include <cmath>

namespace tactum {
namespace {

/// What the finger does to the bodies: the opposite of what it feels, as far as the hand gets it.
FingerPushes pushesOf(const HapticOutput& touch, const Coupling& hand, const std::vector<int>& driven,
                      double forceScale) {
    FingerPushes pushes;
    const int count = std::clamp(touch.contacts, 0, int(touch.contact.size()));
    double total = 0;
    Vec3 rest = touch.force;
    for (int i = 0; i < count; ++i) {
        const ContactReport& contact = touch.contact[std::size_t(i)];
        total += contact.normalForce;
        rest -= contact.normalForce * contact.normal;
    }
    const double felt = touch.force.norm(), given = hand.force;
    const double part = forceScale * (felt > given ? given / felt : 1);
    for (int i = 0; i < count; ++i) {
        const ContactReport& contact = touch.contact[std::size_t(i)];
        if (!(contact.normalForce > 0) || contact.body >= driven.size() || driven[contact.body] < 0) continue;
        AppliedForce force;
        force.force_W = -part * (contact.normalForce * contact.normal + contact.normalForce / total * rest);
        force.start_W = contact.point;
        pushes.push({std::uint32_t(driven[contact.body]), force});
    }
    return pushes;
}

} // namespace

BodyPlaces::BodyPlaces(const World* world) {
    if (!world || !world->moving) return;
    const MovingBodies& loops = *world->moving;
    bodies_ = std::make_unique<MovingBodies>(loops.mechanism(), loops.gravity(), loops.scale());
    for (const MovingBodies::Driven& driven : loops.driven())
        bodies_->add(driven);
    places_.resize(loops.driven().size());
    driven_.assign(world->bodies.size(), -1);
    for (const Mover& mover : world->movers)
        driven_[mover.body] = mover.driven;
    for (const Mover& mover : world->movers)
        if (mover.driven >= 0)
            places_[std::size_t(mover.driven)] = {world->bodies[mover.body].object, mover.rest};
    for (const Joint& joint : world->scene->mechanics.joints)
        for (const JointDrive& drive : joint.drives) {
            const auto moved = std::ranges::find(world->scene->objects, joint.b, &SceneObject::body);
            if (!(drive.spacing > 0) || moved == world->scene->objects.end()) continue;
            if (!bodies_->coordinateOf(joint.b)) continue;
            detents_.push_back({joint.b, drive.spacing, drive.position});
            atDetents_.push_back({moved->id, 0});
        }
}

std::span<const PlacedObject> BodyPlaces::at(const BodiesState& state) {
    if (!bodies_) return {};
    BodiesState seen = state;
    bodies_->begin(seen);
    for (std::size_t i = 0; i < places_.size(); ++i)
        places_[i].pose = bodies_->motions()[i].now;
    for (std::size_t i = 0; i < detents_.size(); ++i) {
        const double away = bodies_->coordinateOf(detents_[i].body).value_or(0) - detents_[i].position;
        atDetents_[i].detent = int(std::lround(std::clamp(away / detents_[i].spacing, -1e9, 1e9)));
    }
    return places_;
}

std::optional<BodyReading> BodyPlaces::readingOf(const BodiesState& state, BodyId body,
                                                 const HapticOutput& touch, const Coupling& given) {
    if (!bodies_) return std::nullopt;
    BodiesState seen = state;
    bodies_->begin(seen);
    return bodies_->readingOf(body, pushesOf(touch, given, driven_, bodies_->scale().force));
}

} // namespace tactum
