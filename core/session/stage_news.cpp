// What a stage tells: the newest of its engine, and what happened since.
#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/clock.h"
#include "core/safety/inhibit_words.h"
#include "core/session/stage.h"

namespace tactum {
namespace {

using Kind = StageEvent::Kind;

constexpr auto kTick = std::chrono::milliseconds(1);  ///< while somebody attends
constexpr auto kRest = std::chrono::milliseconds(20); ///< else

} // namespace

void Stage::run() {
    StageState state;
    std::vector<StageEvent> events;
    auto next = std::chrono::steady_clock::now();
    while (true) {
        {
            std::unique_lock lock(mutex_);
            const bool attended = attendance_.count() > 0;
            const auto moment = std::chrono::steady_clock::now();
            next = std::max(next + (attended ? kTick : kRest), moment); // what was missed is not made up for
            wake_.wait_until(lock, next,
                             [this, attended] { return ending_ || (!attended && attendance_.count() > 0); });
            if (ending_) return;
            events.clear();
            tick(state, events);
        }
        const std::lock_guard lock(telling_);
        if (listener_) listener_(state, events);
    }
}

void Stage::tick(StageState& state, std::vector<StageEvent>& events) {
    engine_.poll();
    watchHearts();
    fill(state);
    for (std::size_t hand = 0; hand < state.hands.size(); ++hand) {
        watchContacts(hand, state.hands[hand]);
        watchDevice(hand, state.hands[hand].servo);
    }
    watchDetents(state);
    std::swap(events, events_);
}

void Stage::watchHearts() {
    if (const auto silent = attendance_.takeFromSilent(now()))
        letGo(nameOf(*silent), " is not heard any more");
}

/// Also forgets what is older.
const Stage::Felt* Stage::feltNow(std::uint64_t worldRevision) {
    const auto found =
        std::ranges::find_if(felt_, [&](const Felt& felt) { return felt.world->revision == worldRevision; });
    if (found == felt_.end()) return nullptr;
    felt_.erase(felt_.begin(), found);
    return &felt_.front();
}

void Stage::fill(StageState& state) {
    report(engine_, state.engine);
    const WorldTelemetry& world = state.engine.world;
    const Felt* felt = feltNow(world.worldRevision);
    state.at = monotonicNanoseconds();
    state.revision = felt ? felt->revision : 0;
    state.attending = attendance_.count();
    state.pen = attendance_.pen();
    state.penHolder = nameOf(state.pen);
    state.penAsker = nameOf(attendance_.asker());
    state.hands.resize(engine_.hands());
    for (std::size_t hand = 0; hand < state.hands.size(); ++hand)
        fill(state.hands[hand], engine_.hand(hand), felt ? felt->world.get() : nullptr);
    state.bodies.clear();
    state.detents.clear();
    if (!felt || !felt->world->moving) return;
    if (placesOf_ != felt->world->revision) {
        places_ = std::make_unique<BodyPlaces>(felt->world.get());
        placesOf_ = felt->world->revision;
    }
    const auto places = places_->at(world.bodies);
    state.bodies.assign(places.begin(), places.end());
    const auto detents = places_->detents();
    state.detents.assign(detents.begin(), detents.end());
}

void Stage::fill(StageHand& state, LocalEngine::Hand hand, const World* felt) {
    state.armed = hand.armed();
    state.trouble = hand.trouble();
    state.touch = hand.touch();
    state.servo = hand.servo();
    state.objects.clear();
    const HapticOutput& output = state.touch.output;
    for (int i = 0; felt && i < std::min(output.contacts, kMaxModelPlanes); ++i) {
        const std::uint32_t body = output.contact[std::size_t(i)].body;
        state.objects.push_back(body < felt->bodies.size() ? felt->bodies[body].object : 0);
    }
}

void Stage::watchContacts(std::size_t hand, const StageHand& state) {
    std::vector<ObjectId> now = state.objects;
    std::ranges::sort(now);
    now.erase(std::unique(now.begin(), now.end()), now.end());
    std::vector<ObjectId>& before = sides_[hand].touched;
    if (now == before) return;
    for (const ObjectId object : now)
        if (!std::ranges::binary_search(before, object))
            say({.kind = Kind::Touch, .hand = hand, .object = object});
    for (const ObjectId object : before)
        if (!std::ranges::binary_search(now, object))
            say({.kind = Kind::Leave, .hand = hand, .object = object});
    before = std::move(now);
}

/// Of a scene that is new to it, it says nothing: there nothing has moved yet.
void Stage::watchDetents(const StageState& state) {
    const bool known = detentsOf_ == state.revision && detents_.size() == state.detents.size();
    for (std::size_t i = 0; known && i < detents_.size(); ++i)
        if (detents_[i] != state.detents[i])
            say({.kind = Kind::Detent, .object = state.detents[i].object, .detent = state.detents[i].detent});
    detents_ = state.detents;
    detentsOf_ = state.revision;
}

void Stage::watchDevice(std::size_t hand, const ServoTelemetry& now) {
    Side& side = sides_[hand];
    const std::uint32_t changed = now.buttons ^ std::exchange(side.buttons, now.buttons);
    for (std::uint32_t button = 0; button < 32; ++button)
        if (changed >> button & 1)
            say({.kind = now.buttons >> button & 1 ? Kind::Pressed : Kind::Released,
                 .hand = hand,
                 .button = button});
    if (std::exchange(side.why, now.inhibit) == now.inhibit) return;
    say({.kind = Kind::Force, .hand = hand, .text = inhibitWords(now.inhibit).brief});
}

} // namespace tactum
