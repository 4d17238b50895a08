#include "core/haptics/body_places.h"

namespace tactum {

BodyPlaces::BodyPlaces(const World* world) {
    if (!world || !world->moving) return;
    const MovingBodies& loops = *world->moving;
    bodies_ = std::make_unique<MovingBodies>(loops.mechanism(), loops.gravity());
    for (const MovingBodies::Driven& driven : loops.driven())
        bodies_->add(driven);
    places_.resize(loops.driven().size());
    for (const Mover& mover : world->movers)
        if (mover.driven >= 0)
            places_[std::size_t(mover.driven)] = {world->bodies[mover.body].object, mover.rest};
}

std::span<const PlacedObject> BodyPlaces::at(const BodiesState& state) {
    if (!bodies_) return {};
    BodiesState seen = state;
    bodies_->begin(seen);
    for (std::size_t i = 0; i < places_.size(); ++i)
        places_[i].pose = bodies_->motions()[i].now;
    return places_;
}

std::optional<BodyReading> BodyPlaces::readingOf(const BodiesState& state, BodyId body) {
    if (!bodies_) return std::nullopt;
    BodiesState seen = state;
    bodies_->begin(seen);
    return bodies_->readingOf(body);
}

} // namespace tactum
