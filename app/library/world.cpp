#include <tactum/world.h>

#include "app/library/parts.h"
#include "app/library/stepped_world.h"

namespace tactum::library {

struct World::State {
    explicit State(std::shared_ptr<const core::World> first) : stepped(std::move(first)) {}

    SteppedWorld stepped;
};

World::World(const Scene& scene) : state_(std::make_unique<State>(compiled(*Parts::state(scene)))) {}
World::World(World&& other) noexcept = default;
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

Step World::step(const Vec3& finger, double dt) noexcept {
    return state_ ? state_->stepped.step(finger, nullptr, dt) : Step{};
}

Step World::step(const Vec3& finger, const Vec3& velocity, double dt) noexcept {
    return state_ ? state_->stepped.step(finger, &velocity, dt) : Step{};
}

void World::restart(double time) noexcept {
    if (state_) state_->stepped.restart(time);
}

double World::time() const noexcept {
    return state_ ? state_->stepped.time() : 0;
}

void World::update(const Scene& scene) {
    if (!state_) refuse("this World was moved elsewhere; assign another one to it first");
    state_->stepped.offer(compiled(*Parts::state(scene), &state_->stepped.newest()));
}

} // namespace tactum::library
