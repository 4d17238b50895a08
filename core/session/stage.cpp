#include "core/session/stage.h"

#include <algorithm>
#include <chrono>

#include "core/base/clock.h"
#include "core/haptics/compile.h"
#include "core/safety/inhibit_words.h"
#include "core/session/secret.h"

namespace tactum {
namespace {

using Kind = StageEvent::Kind;

constexpr auto kTick = std::chrono::milliseconds(1);  ///< while somebody attends
constexpr auto kRest = std::chrono::milliseconds(20); ///< else
/// Of a whole scene, so that no client uses up the machine.
constexpr std::size_t kMostTriangles = 100'000'000, kMostObjects = 10'000;

Result<void> checkSize(const Scene& scene) {
    if (scene.objects.size() > kMostObjects)
        return inputError("the scene would have more than " + std::to_string(kMostObjects) +
                          " objects: join some of them into one mesh");
    if (triangleCount(scene) > kMostTriangles)
        return inputError("the scene would have more than " + std::to_string(kMostTriangles) +
                          " triangles: simplify its meshes");
    return {};
}

std::vector<ObjectId> addedTo(const Scene& before, const Scene& after) {
    std::vector<ObjectId> added;
    for (const SceneObject& object : after.objects)
        if (!before.find(object.id)) added.push_back(object.id);
    return added;
}

} // namespace

Stage::Stage(std::unique_ptr<HapticDevice> device, std::shared_ptr<HandTarget> hand, Scene scene)
    : engine_(std::move(device)), hand_(std::move(hand)),
      scene_(std::make_shared<const Scene>(std::move(scene))) {}

Stage::~Stage() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

double Stage::now() const {
    return 1e-9 * double(monotonicNanoseconds());
}

Result<void> Stage::start() {
    auto world = compile(*scene_);
    if (!world) return tl::unexpected(world.error());
    if (auto started = engine_.start(); !started) return started;
    device_ = engine_.device();
    take(*scene_, std::move(*world));
    thread_ = std::thread([this] { run(); });
    return {};
}

void Stage::listen(Listener listener) {
    const std::lock_guard lock(telling_);
    listener_ = std::move(listener);
}

Result<Stage::Welcome> Stage::join(std::string_view name, bool wantsPen) {
    auto key = makeSecret();
    if (!key) return tl::unexpected(key.error());
    const std::lock_guard lock(mutex_);
    const auto id = attendance_.join(name, *key, wantsPen, now());
    if (!id) return tl::unexpected(id.error());
    say({.kind = Kind::Attends, .text = nameOf(*id) + " attends"});
    const bool pen = attendance_.pen() == *id;
    if (pen) say({.kind = Kind::Pen, .text = nameOf(*id)});
    wake_.notify_all();
    return Welcome{*id, std::move(*key), pen};
}

void Stage::leave(ClientId id) {
    const std::lock_guard lock(mutex_);
    if (!attendance_.find(id)) return;
    const std::string name = nameOf(id);
    const bool hadPen = attendance_.pen() == id;
    attendance_.leave(id);
    if (hadPen) letGo(name, " has left");
    say({.kind = Kind::Attends, .text = name + " has left"});
}

void Stage::heard(ClientId id) {
    const std::lock_guard lock(mutex_);
    attendance_.heard(id, now());
}

ClientId Stage::whoHas(std::string_view key) const {
    const std::lock_guard lock(mutex_);
    return attendance_.whoHas(key);
}

bool Stage::hasPen(ClientId id) const {
    const std::lock_guard lock(mutex_);
    return id != 0 && attendance_.pen() == id;
}

std::string Stage::penHolder() const {
    const std::lock_guard lock(mutex_);
    return nameOf(attendance_.pen());
}

std::string Stage::nameOf(ClientId id) const {
    const Client* client = attendance_.find(id);
    return client ? client->name : std::string();
}

/// What it had is free, and no force goes on that nobody answers for.
void Stage::letGo(const std::string& name, const std::string& what) {
    say({.kind = Kind::Pen});
    if (!engine_.armed()) return;
    engine_.fade();
    say({.kind = Kind::Force, .text = name + what + ": the force fades", .client = name});
}

void Stage::say(StageEvent event) {
    constexpr std::size_t kMost = 4096;
    event.at = monotonicNanoseconds();
    if (events_.size() < kMost) events_.push_back(std::move(event));
}

// The change is made of the newest scene, beside everything else; when another one was quicker it is made
// once more, of that scene, with the shapes that are ready by then.
Result<StageChange> Stage::change(ClientId who, std::uint64_t base, const Edit& edit,
                                  const Progress& progress) {
    std::shared_ptr<const World> ready;
    while (true) {
        Scenery before;
        {
            const std::lock_guard lock(mutex_);
            if (auto may = attendance_.takePen(who); !may) return tl::unexpected(may.error());
            if (base != 0 && base != revision_)
                return inputError("the scene is of revision " + std::to_string(revision_) + " now, not of " +
                                  std::to_string(base) + ": look at it again");
            before = {scene_, world_, revision_};
        }
        Scene scene = *before.scene;
        if (auto made = edit(scene).and_then([&] { return checkSize(scene); }); !made)
            return tl::unexpected(made.error());
        auto world = compile(scene, ready ? ready.get() : before.world.get(), progress);
        if (!world) return tl::unexpected(world.error());
        const std::lock_guard lock(mutex_);
        if (revision_ != before.revision) {
            ready = std::move(*world);
            continue;
        }
        StageChange done{.added = addedTo(*before.scene, scene)};
        take(std::move(scene), std::move(*world));
        done.revision = revision_;
        done.feltAfter = engine_.publishedAfter();
        return done;
    }
}

void Stage::take(Scene scene, std::shared_ptr<const World> world) {
    constexpr std::size_t kMost = 256; // of Worlds on their way; a loop that stands still takes none
    scene_ = std::make_shared<const Scene>(std::move(scene));
    world_ = std::move(world);
    ++revision_;
    felt_.push_back({revision_, world_});
    if (felt_.size() > kMost) felt_.pop_front();
    engine_.publish(world_);
    say({.kind = Kind::Scene, .revision = revision_});
}

Stage::Scenery Stage::scenery() const {
    const std::lock_guard lock(mutex_);
    return {scene_, world_, revision_};
}

void Stage::stop(ClientId who) {
    const std::lock_guard lock(mutex_);
    engine_.setArmed(false);
    const std::string name = nameOf(who);
    say({.kind = Kind::Force,
         .text = (name.empty() ? "the server" : name) + " has stopped all force",
         .client = name});
}

Result<void> Stage::arm(ClientId who, bool on) {
    return order(who, [&](Engine& engine) {
        engine.setArmed(on);
        say({.kind = Kind::Force,
             .text = nameOf(who) + (on ? " has switched the force on" : " has switched the force off"),
             .client = nameOf(who)});
    });
}

Result<void> Stage::askForPen(ClientId who) {
    const std::lock_guard lock(mutex_);
    const ClientId holder = attendance_.pen();
    if (auto taken = attendance_.takePen(who); taken) {
        if (holder != who) say({.kind = Kind::Pen, .text = nameOf(who)});
        return {};
    }
    if (!attendance_.find(who)) return inputError("who does not attend cannot ask for the pen: attend first");
    attendance_.ask(who);
    say({.kind = Kind::PenAsked, .text = nameOf(who), .only = holder});
    return {};
}

Result<void> Stage::passPen(ClientId who, std::string_view name) {
    const std::lock_guard lock(mutex_);
    if (auto passed = attendance_.passPen(who, name); !passed) return passed;
    say({.kind = Kind::Pen, .text = nameOf(attendance_.pen())});
    return {};
}

Result<void> Stage::order(ClientId who, const std::function<void(Engine&)>& order) {
    const std::lock_guard lock(mutex_);
    if (auto may = attendance_.takePen(who); !may) return may;
    order(engine_);
    return {};
}

void Stage::push(ClientId who, const Vec3& force) {
    const std::lock_guard lock(mutex_);
    if (who != 0 && attendance_.pen() == who) engine_.push(force);
}

Result<void> Stage::leadHand(ClientId who, HandGoal goal) {
    if (!hand_) return inputError("only the simulated hand can be led");
    return order(who, [&](Engine&) {
        if (goal.teleport && (jump_.who != who || jump_.theirs != goal.sequence))
            jump_ = {who, goal.sequence, jump_.ours + 1};
        goal.sequence = jump_.ours;
        hand_->write(goal);
    });
}

RecordedRun Stage::recorded() const {
    const std::lock_guard lock(mutex_);
    return engine_.recorded();
}

bool Stage::armed() const {
    const std::lock_guard lock(mutex_);
    return engine_.armed();
}

std::size_t Stage::attending() const {
    const std::lock_guard lock(mutex_);
    return attendance_.count();
}

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
    watchContacts(state);
    watchDevice(state);
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
    const ProxyTelemetry& proxy = state.engine.proxy;
    const Felt* felt = feltNow(proxy.worldRevision);
    state.at = monotonicNanoseconds();
    state.revision = felt ? felt->revision : 0;
    state.attending = attendance_.count();
    state.pen = attendance_.pen();
    state.penHolder = nameOf(state.pen);
    state.penAsker = nameOf(attendance_.asker());
    state.objects.clear();
    state.bodies.clear();
    state.detents.clear();
    if (!felt) return;
    for (int i = 0; i < std::min(proxy.output.contacts, kMaxModelPlanes); ++i) {
        const std::uint32_t body = proxy.output.contact[std::size_t(i)].body;
        state.objects.push_back(body < felt->world->bodies.size() ? felt->world->bodies[body].object : 0);
    }
    if (!felt->world->moving) return;
    if (placesOf_ != felt->world->revision) {
        places_ = std::make_unique<BodyPlaces>(felt->world.get());
        placesOf_ = felt->world->revision;
    }
    const auto places = places_->at(proxy.bodies);
    state.bodies.assign(places.begin(), places.end());
    const auto detents = places_->detents();
    state.detents.assign(detents.begin(), detents.end());
}

void Stage::watchContacts(const StageState& state) {
    std::vector<ObjectId> now = state.objects;
    std::ranges::sort(now);
    now.erase(std::unique(now.begin(), now.end()), now.end());
    if (now == touched_) return;
    for (const ObjectId object : now)
        if (!std::ranges::binary_search(touched_, object)) say({.kind = Kind::Touch, .object = object});
    for (const ObjectId object : touched_)
        if (!std::ranges::binary_search(now, object)) say({.kind = Kind::Leave, .object = object});
    touched_ = std::move(now);
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

void Stage::watchDevice(const StageState& state) {
    const std::uint32_t changed = state.engine.servo.buttons ^ buttons_;
    for (std::uint32_t button = 0; button < 32; ++button)
        if (changed >> button & 1)
            say({.kind = state.engine.servo.buttons >> button & 1 ? Kind::Pressed : Kind::Released,
                 .button = button});
    buttons_ = state.engine.servo.buttons;
    if (state.engine.servo.inhibit == why_) return;
    why_ = state.engine.servo.inhibit;
    say({.kind = Kind::Force, .text = inhibitWords(why_).brief});
}

} // namespace tactum
