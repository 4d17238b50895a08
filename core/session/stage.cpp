#include "core/session/stage.h"

#include <algorithm>

#include "core/base/clock.h"
#include "core/haptics/compile.h"
#include "core/session/secret.h"

namespace tactum {
namespace {

using Kind = StageEvent::Kind;

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
    : engine_(std::move(device)), sides_{Side(std::move(hand))},
      scene_(std::make_shared<const Scene>(std::move(scene))) {}

Result<void> Stage::addHand(std::unique_ptr<HapticDevice> device, std::shared_ptr<HandTarget> hand) {
    return engine_.addDevice(std::move(device)).map([&] { sides_.emplace_back(std::move(hand)); });
}

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
    for (std::size_t hand = 0; hand < engine_.hands(); ++hand)
        devices_.push_back(engine_.hand(hand).device());
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
    if (!engine_.anyArmed()) return;
    for (std::size_t hand = 0; hand < engine_.hands(); ++hand)
        engine_.hand(hand).fade();
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
    engine_.setAllArmed(false);
    const std::string name = nameOf(who);
    say({.kind = Kind::Force,
         .text = (name.empty() ? "the server" : name) + " has stopped all force",
         .client = name});
}

Result<void> Stage::arm(ClientId who, bool on, OfHand of) {
    return order(who, of,
                 [&](LocalEngine::Hand hand) {
                     hand.setArmed(on);
                     return Result<void>();
                 })
        .map([&] {
            const std::lock_guard lock(mutex_);
            say({.kind = Kind::Force,
                 .hand = of.value_or(0),
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

Result<void> Stage::order(ClientId who, OfHand of,
                          const std::function<Result<void>(LocalEngine::Hand)>& order) {
    Result<void> done;
    const auto all = [&](Engine&) {
        if (of && *of >= engine_.hands())
            done = inputError("there is no hand " + std::to_string(*of) + ": they are numbered from 0");
        else if (of)
            done = order(engine_.hand(*of));
        for (std::size_t hand = 0; !of && done && hand < engine_.hands(); ++hand)
            done = order(engine_.hand(hand));
    };
    return this->order(who, all).and_then([&] { return done; });
}

void Stage::push(ClientId who, std::size_t hand, const Vec3& force) {
    const std::lock_guard lock(mutex_);
    if (who != 0 && attendance_.pen() == who && hand < engine_.hands()) engine_.hand(hand).push(force);
}

Result<void> Stage::leadHand(ClientId who, std::size_t hand, HandGoal goal) {
    if (hand >= sides_.size() || !sides_[hand].lead) return inputError("only a simulated hand can be led");
    return order(who, [&](Engine&) {
        Side::Jump& jump = sides_[hand].jump;
        if (goal.teleport && (jump.who != who || jump.theirs != goal.sequence))
            jump = {who, goal.sequence, jump.ours + 1};
        goal.sequence = jump.ours;
        sides_[hand].lead->write(goal);
    });
}

RecordedRun Stage::recorded() const {
    const std::lock_guard lock(mutex_);
    return engine_.recorded();
}

bool Stage::armed() const {
    const std::lock_guard lock(mutex_);
    return engine_.anyArmed();
}

std::size_t Stage::attending() const {
    const std::lock_guard lock(mutex_);
    return attendance_.count();
}

} // namespace tactum
