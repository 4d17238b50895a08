#include "app/python/live_world.h"

#include <algorithm>

#include "app/python/failure.h"

namespace tactum::python {

namespace {

constexpr double kFirstStep = 1e-3; // as replay() begins

bool isFarBefore(const FingerPoint& a, const FingerPoint& b) {
    return b.t - a.t > 1;
}

} // namespace

LiveWorld::LiveWorld(std::shared_ptr<const World> world, bool records) : world_(std::move(world)) {
    if (records) record_.emplace();
}

LiveWorld::Turn::Turn(LiveWorld& of) : lock_(of.turn_, std::try_to_lock) {
    if (!lock_)
        throw Failure("this World is being stepped by another thread; make one of the same scene for each");
}

HapticOutput LiveWorld::step(const FingerMove& move) {
    ProxyRow row;
    row.dt = move.dt;
    row.finger = tripleOf(move.finger);
    const Vec3 moved = before_ ? Vec3((move.finger - *before_) / move.dt) : Vec3(Vec3::Zero());
    row.velocity = tripleOf(move.velocity.value_or(moved));
    if (record_) record_->begin(row, *state_, *world_);
    const HapticOutput output = stepFrom(row, *world_, *state_);
    if (record_) {
        note(row, output);
        record_->end(row);
    }
    before_ = move.finger;
    felt_ = output;
    time_ += move.dt;
    return output;
}

Result<TouchTrace> LiveWorld::follow(const std::vector<FingerPoint>& path, const Progress& progress) {
    constexpr std::size_t kLook = 512; // steps between two looks
    ProgressMeter meter(progress, path.size(), kLook);
    if (before_ && path.front().t <= time_)
        return inputError("path: begins before the World's time; let it begin later, or restart()");
    if (record_ && std::ranges::adjacent_find(path, isFarBefore) != path.end())
        return inputError("path: has points more than 1 s apart, which no recording holds; fill the gap");
    if (!before_) {
        time_ = path.front().t - kFirstStep;
        state_->time = time_;
    }
    TouchTrace rows;
    rows.reserve(path.size());
    for (const FingerPoint& point : path) {
        if (!meter.goesOn(rows.size())) return cancelledError();
        const HapticOutput output = step({point.position, before_ ? point.t - time_ : kFirstStep, {}});
        time_ = point.t; // without the rounding of the sum
        rows.push_back({.t = point.t,
                        .finger = point.position,
                        .proxy = output.proxy,
                        .force = output.force,
                        .contacts = output.contacts});
    }
    return rows;
}

void LiveWorld::enter(std::shared_ptr<const World> world) {
    world_ = std::move(world);
    readings_.reset();
}

std::vector<PlacedObject> LiveWorld::places() const {
    std::vector<PlacedObject> all;
    if (!before_) return all;
    for (const Mover& mover : world_->movers)
        if (mover.driven >= 0)
            all.push_back(
                {world_->bodies[mover.body].object, world_->drivenMotions()[std::size_t(mover.driven)].now});
    return all;
}

BodyReading LiveWorld::readingOf(BodyId body) {
    if (!readings_) readings_.emplace(world_.get());
    if (const auto reading = readings_->readingOf(state_->bodies, body, felt_)) return *reading;
    throw Failure("body " + std::to_string(body) + " is moved by no force in this World");
}

void LiveWorld::restart() {
    *state_ = {};
    felt_ = {};
    before_.reset();
    time_ = 0;
    if (record_) record_.emplace();
}

Recording LiveWorld::recording(const std::string& reason) const {
    if (!record_) throw Failure("this World does not record; make it with record=True");
    return record_->recording(reason);
}

} // namespace tactum::python
