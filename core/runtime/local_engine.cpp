#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "core/base/realtime.h"
#include "core/haptics/compile.h"
#include "core/loop/realtime_thread.h"
#include "core/port/device_check.h"
#include "core/runtime/local_engine_impl.h"
#include "core/runtime/proxy_loop.h"

namespace tactum {
namespace {

constexpr int kProxyPriority = kServoPriority - 10;
/// Of a servo tick, what an update may take before something is left out.
constexpr double kProxyShare = 0.8;

/// The one that was granted less.
const Urgency& worse(const Urgency& servo, const Urgency& proxy) {
    return proxy.priority - proxy.asked < servo.priority - servo.asked ? proxy : servo;
}

/// Past scenes are remembered for a minute, but of no more edits than this.
constexpr std::size_t kMaxScenes = 8192;
constexpr double kSlowestPublish = 2; ///< s, from publish() to the first step in the World, and some more

constexpr double kExchangePatience = 1; ///< s, for an exchange to come back when the loops shall end

/// In the place of one that never came back.
class AbandonedDevice final : public HapticDevice {
public:
    explicit AbandonedDevice(DeviceInfo info) : info_(std::move(info)) {}

    DeviceInfo info() const override { return info_; }
    Result<void> open() override { return machineError(trouble()); }
    void close() override {}
    std::string trouble() const override {
        return info_.name + " did not come back from its last exchange: unplug it, and start the program " +
               "again before it is used.";
    }
    DeviceSample exchange(const DeviceCommand&, double) noexcept override { return {}; }

private:
    DeviceInfo info_;
};

} // namespace

// A device that start() will refuse has nothing to record.
void LocalEngine::Impl::freshChannels() {
    std::vector<double> rates;
    for (const auto& side : sides)
        rates.push_back(checkDevice(side->info) ? side->info.rate : DeviceInfo{}.rate);
    channels = std::make_shared<Channels>(rates, kUpdatesPerTick * *std::ranges::max_element(rates));
    for (std::size_t i = 0; i < sides.size(); ++i) {
        Side& side = *sides[i];
        channels->hand(i).workspace.write(side.workspace);
        channels->hand(i).grasped.store(side.grasped, std::memory_order_relaxed);
        if (side.motors.at == 0) side.motors = heat[side.info.name];
        side.beats = {};
        askForButton(i);
    }
    channels->pace.store(pace, std::memory_order_relaxed);
    proxyBeats = {};
    past.clear();
    if (!kept.empty()) remember(*kept.back());
}

void LocalEngine::Impl::askForButton(std::size_t hand) {
    constexpr int kMax = 31;
    const Side& side = *sides[hand];
    const std::uint32_t all = (std::uint32_t(1) << std::clamp(side.info.buttons, 0, kMax)) - 1;
    channels->hand(hand).deadMan.store(side.deadMan ? all : 0, std::memory_order_relaxed);
}

void LocalEngine::Impl::remember(const World& world) {
    const double now = channels->recorder.now();
    if (!past.empty()) past.back().until = now;
    past.push_back({0, {numbersOf(world), world.scene}});
    while (past.size() > 1 &&
           (past.front().until < now - kRecorded - kSlowestPublish || past.size() > kMaxScenes))
        past.pop_front();
}

/// Hz, of the servos.
double LocalEngine::Impl::fastest() const {
    double rate = 0;
    for (const auto& side : sides)
        rate = std::max(rate, side->info.rate);
    return rate;
}

bool LocalEngine::Impl::hasRealDevice() const {
    return std::ranges::any_of(sides, [](const auto& side) { return side->info.real; });
}

/// All of them, or none.
Result<void> LocalEngine::Impl::openDevices() {
    const auto closeFirst = [this](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            sides[i]->device->close();
    };
    for (std::size_t i = 0; i < sides.size(); ++i) {
        Side& side = *sides[i];
        if (Result<void> opened = side.device->open(); !opened) {
            closeFirst(i);
            return opened;
        }
        side.info = side.device->info();
        if (Result<void> usable = checkDevice(side.info); !usable) {
            closeFirst(i + 1);
            return usable;
        }
    }
    return {};
}

Result<void> LocalEngine::Impl::startWatchdogs() {
    for (const auto& side : sides)
        if (side->info.real)
            if (Result<void> guarded = side->watchdog.start(*side->device); !guarded) return guarded;
    return {};
}

Result<void> LocalEngine::Impl::startLoops() {
    for (std::size_t i = 0; i < sides.size(); ++i) {
        Side& side = *sides[i];
        const auto loop = [&side, &hand = channels->hand(i)] {
            servoLoop(hand, *side.device, side.info, side.motors, side.watchdog);
        };
        if (Result<void> started = side.thread.start("tactum-servo", kServoPriority, loop); !started)
            return started;
    }
    return proxyThread.start("tactum-proxy", kProxyPriority, [this] {
        proxyLoop(*channels, kUpdatesPerTick * fastest(), kProxyShare / fastest());
    });
}

Urgency LocalEngine::Impl::leastUrgency() const {
    Urgency least = proxyThread.urgency();
    for (const auto& side : sides)
        least = worse(side->thread.urgency(), least);
    return least;
}

/// False: a servo has not come back, and may use device, channels and device watchdog whenever it does.
bool LocalEngine::Impl::endLoops() {
    for (std::size_t i = 0; i < sides.size(); ++i)
        channels->hand(i).stop.store(true, std::memory_order_relaxed);
    proxyThread.join();
    bool ended = true;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        Side& side = *sides[i];
        side.stuck = !side.thread.joinWithin(kExchangePatience);
        if (side.stuck) {
            ended = false;
            continue;
        }
        side.watchdog.stop();
        side.device->close();
    }
    keepHeat();
    return ended;
}

/// Of devices of one name the hottest is remembered: nobody knows which of them will come again.
void LocalEngine::Impl::keepHeat() {
    for (const auto& side : sides)
        heat.erase(side->info.name);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& side = *sides[i];
        const LeftHeat left =
            side.stuck ? LeftHeat{channels->hand(i).servoTelemetry.read().heat, monotonicNanoseconds()}
                       : side.motors;
        LeftHeat& hottest = heat[side.info.name];
        if (left.heat >= hottest.heat) hottest = left;
    }
}

/// Makes the newest World the next that the proxy loop takes. One that it never took is released at once.
void LocalEngine::Impl::handOver() {
    if (kept.empty()) return;
    publishedAfter = channels->proxyTelemetry.read().updates;
    if (const World* skipped = channels->worldIn.exchange(kept.back().get(), std::memory_order_acq_rel))
        release(skipped);
}

/// Drops one reference; the same World may have been published twice.
void LocalEngine::Impl::release(const World* world) {
    const auto found = std::find_if(kept.begin(), kept.end(),
                                    [world](const auto& candidate) { return candidate.get() == world; });
    if (found != kept.end()) kept.erase(found);
}

void LocalEngine::Impl::releaseRetired() {
    const World* retired = nullptr;
    while (channels->worldOut.pop(retired))
        release(retired);
}

LocalEngine::LocalEngine(std::unique_ptr<HapticDevice> device) : impl_(std::make_unique<Impl>()) {
    impl_->sides.push_back(std::make_unique<Impl::Side>(std::move(device)));
    impl_->freshChannels();
}

LocalEngine::~LocalEngine() {
    (void)stop();
}

Result<void> LocalEngine::start() {
    assertNotRealtime();
    if (impl_->running) return {};
    if (Result<void> usable = impl_->openDevices(); !usable) return usable;
    // Before the loops have their memory: of what a fork shares every page is given anew when it is written.
    const Result<void> guarded = impl_->startWatchdogs();
    impl_->freshChannels();
    for (std::size_t i = 0; i < impl_->channels->hands(); ++i)
        impl_->channels->hand(i).recorder.touch();
    impl_->handOver();
    if (Result<void> started = guarded.and_then([this] { return impl_->startLoops(); }); !started) {
        if (!impl_->endLoops()) abandon();
        return started;
    }
    impl_->running = true;
    // After the threads, so that their stacks are among what is locked.
    const int unlocked = lockPresentMemory();
    const Urgency granted = impl_->leastUrgency();
    impl_->realtime = granted.priority > 0 && !unlocked;
    impl_->priorityNote = sentenceOf(granted, unlocked);
    if (impl_->hasRealDevice()) impl_->awake.emplace();
    return {};
}

Result<void> LocalEngine::stop() {
    assertNotRealtime();
    if (!impl_->running) return {};
    impl_->awake.reset();
    const bool ended = impl_->endLoops();
    std::string stuck;
    if (!ended) {
        abandon();
        for (const auto& side : impl_->sides)
            if (side->stuck) stuck = side->device->trouble();
    }
    impl_->running = false;
    poll();
    // No loop is left to see them; the newest stays for the next start.
    impl_->kept.erase(impl_->kept.begin(),
                      impl_->kept.end() - std::min<std::ptrdiff_t>(1, std::ssize(impl_->kept)));
    return ended ? Result<void>() : machineError(stuck);
}

/// What the stuck servos may still touch stays as it is until the process ends; what the person decided goes
/// along, and so do the hands that came back. The device watchdog of a stuck one has stopped the device
/// already, and stays to do so when the program dies.
void LocalEngine::abandon() {
    auto fresh = std::make_unique<Impl>();
    for (auto& side : impl_->sides) {
        if (!side->stuck) {
            fresh->sides.push_back(std::move(side));
            continue;
        }
        side->device->emergencyStop();
        side->thread.abandon();
        auto empty = std::make_unique<Impl::Side>(std::make_unique<AbandonedDevice>(side->info));
        empty->stuck = true;
        empty->workspace = side->workspace;
        empty->deadMan = side->deadMan;
        empty->grasped = side->grasped;
        fresh->sides.push_back(std::move(empty));
    }
    if (!impl_->kept.empty()) fresh->kept.push_back(impl_->kept.back());
    fresh->heat = impl_->heat;
    fresh->pace = impl_->pace;
    fresh->spoken = impl_->spoken;
    fresh->channels = impl_->channels; // with the last minute
    fresh->past = impl_->past;
    static auto& abandoned = *new std::vector<std::unique_ptr<Impl>>; // never destroyed
    abandoned.push_back(std::exchange(impl_, std::move(fresh)));
}

Result<void> LocalEngine::setDevice(std::unique_ptr<HapticDevice> device) {
    return exchangeDevice(impl_->spoken, std::move(device));
}

Result<void> LocalEngine::exchangeDevice(std::size_t hand, std::unique_ptr<HapticDevice> device) {
    (void)stop(); // whom it concerns stops it first
    impl_->sides[hand]->take(std::move(device));
    impl_->freshChannels();
    return start();
}

Result<void> LocalEngine::addDevice(std::unique_ptr<HapticDevice> device) {
    if (impl_->sides.size() >= std::size_t(kMaxHands))
        return inputError("The engine: it has " + std::to_string(kMaxHands) +
                          " hands already, as many as there can be; remove a device first.");
    const bool ran = impl_->running;
    (void)stop();
    impl_->sides.push_back(std::make_unique<Impl::Side>(std::move(device)));
    impl_->freshChannels();
    return ran ? start() : Result<void>();
}

Result<void> LocalEngine::removeDevice(std::size_t hand) {
    if (impl_->sides.size() == 1)
        return inputError("The engine: its last device cannot be removed; exchange it for another one.");
    const bool ran = impl_->running;
    (void)stop();
    impl_->sides.erase(impl_->sides.begin() + std::ptrdiff_t(hand));
    if (impl_->spoken == hand)
        impl_->spoken = 0;
    else if (impl_->spoken > hand)
        --impl_->spoken;
    impl_->freshChannels();
    return ran ? start() : Result<void>();
}

void LocalEngine::setAllArmed(bool armed) {
    for (std::size_t i = 0; i < hands(); ++i)
        hand(i).setArmed(armed);
}

bool LocalEngine::anyArmed() const {
    for (std::size_t i = 0; i < hands(); ++i)
        if (Hand(*impl_, i).armed()) return true;
    return false;
}

std::size_t LocalEngine::hands() const {
    return impl_->sides.size();
}

LocalEngine::Hand LocalEngine::hand(std::size_t i) {
    return {*impl_, i};
}

bool LocalEngine::running() const {
    return impl_->running;
}

void LocalEngine::publish(std::shared_ptr<const World> world) {
    assertNotRealtime();
    if (!world) return;
    impl_->releaseRetired();
    impl_->kept.push_back(std::move(world));
    impl_->remember(*impl_->kept.back());
    impl_->handOver();
}

std::uint64_t LocalEngine::publishedAfter() const {
    return impl_->publishedAfter;
}

void LocalEngine::setPace(double pace) {
    impl_->pace = std::clamp(pace, 0.0, 1.0);
    impl_->channels->pace.store(impl_->pace, std::memory_order_relaxed);
}

double LocalEngine::pace() const {
    return impl_->pace;
}

void LocalEngine::beginBodies() {
    impl_->channels->commands.push({EngineCommand::Kind::BeginBodies});
}

void LocalEngine::stepBodies() {
    impl_->channels->commands.push({EngineCommand::Kind::StepBodies});
}

void LocalEngine::poll() {
    assertNotRealtime();
    impl_->releaseRetired();
    impl_->proxy = impl_->channels->proxyTelemetry.read();
    for (std::size_t i = 0; i < impl_->sides.size(); ++i)
        impl_->pollHand(i);
    impl_->tellSpoken();
    if (impl_->proxyBeats.stand(impl_->proxy.updates)) impl_->proxy.rate = 0;
}

void LocalEngine::Impl::pollHand(std::size_t hand) {
    Side& side = *sides[hand];
    side.touch = hand == 0 ? proxy : channels->hand(hand).touchTelemetry.read();
    side.servo = channels->hand(hand).servoTelemetry.read();
    // What it told last is told for ever by a loop that stands still.
    if (side.beats.stand(side.servo.ticks)) side.servo.rate = 0;
    if (!running || !side.beats.still) return;
    // The device watchdog of a real device has taken it away; from others it is taken when they come back.
    if (side.servo.gain > 0) side.servo.inhibit = InhibitReason::Stall;
    side.servo.gain = 0;
    side.servo.force = Vec3::Zero();
}

/// What all hands share is told with any of them.
void LocalEngine::Impl::tellSpoken() {
    static_cast<TouchTelemetry&>(proxy) = sides[spoken]->touch;
}

const ProxyTelemetry& LocalEngine::proxy() const {
    return impl_->proxy;
}
RecordedRun LocalEngine::recorded() const {
    assertNotRealtime();
    RecordedRun run = impl_->channels->recorder.copy();
    for (std::size_t i = 1; i < impl_->channels->hands(); ++i)
        run.others.push_back(impl_->channels->hand(i).recorder.copy());
    for (std::size_t i = 0; i < run.hands(); ++i)
        run.hand(i).device = impl_->sides[i]->info;
    for (const auto& past : impl_->past)
        if (!run.sceneOf(past.recorded.numbers.revision)) run.scenes.push_back(past.recorded);
    trim(run);
    return run;
}
bool LocalEngine::hasRealtimePriority() const {
    return impl_->realtime;
}
const std::string& LocalEngine::priorityNote() const {
    return impl_->priorityNote;
}

} // namespace tactum
