#include "core/runtime/local_engine.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "core/base/realtime.h"
#include "core/haptics/compile.h"
#include "core/loop/realtime_thread.h"
#include "core/port/device_check.h"
#include "core/runtime/proxy_loop.h"
#include "core/runtime/servo_loop.h"

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

/// Whether a counter goes on rising, as far as somebody looks.
struct Beats {
    static constexpr std::int64_t kPatience = 500'000'000; ///< ns
    std::uint64_t seen = 0;
    std::int64_t since = 0; ///< ns, when it was first seen like that; 0: never
    bool still = false;

    bool stand(std::uint64_t count) {
        const std::int64_t now = monotonicNanoseconds();
        if (count != seen || since == 0) since = now;
        seen = count;
        return still = now - since > kPatience;
    }
};

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

struct PastScene {
    double until = 0; ///< s on the recorder's clock, when the next one came; 0: it is the present one
    RecordedScene recorded;
};

} // namespace

struct LocalEngine::Impl {
    std::unique_ptr<HapticDevice> device;
    DeviceInfo info;
    std::shared_ptr<Channels> channels; ///< fresh at every start
    /// Every World that a loop may still see, oldest first; the last is the one to feel.
    std::vector<std::shared_ptr<const World>> kept;
    std::uint64_t publishedAfter = 0; ///< updates
    DeviceWatchdog watchdog;
    std::deque<PastScene> past; ///< of the last minute, oldest first
    RealtimeThread servoThread, proxyThread;
    std::optional<AwakeProcessors> awake; ///< while a real device is used
    /// By the device's name: who pulls a hot device out and puts it back has a hot device.
    std::map<std::string, LeftHeat> heat;
    LeftHeat motors; ///< of the device; the servo's while it runs
    Workspace workspace;
    bool deadMan = false;
    bool grasped = false;
    double pace = 1;
    bool running = false;
    bool realtime = false;
    std::string priorityNote = "The loops have not been started.";
    ProxyTelemetry proxy;
    ServoTelemetry servo;
    Beats proxyBeats, servoBeats;

    Result<void> startLoops();
    bool endLoops();
    void handOver();
    void release(const World* world);
    void releaseRetired();
    void freshChannels();
    void remember(const World& world);
    void askForButton();
};

// A device that start() will refuse has nothing to record.
void LocalEngine::Impl::freshChannels() {
    const double rate = checkDevice(info) ? info.rate : DeviceInfo{}.rate;
    channels = std::make_shared<Channels>(rate, kUpdatesPerTick * rate);
    channels->workspace.write(workspace);
    motors = heat[info.name];
    askForButton();
    channels->pace.store(pace, std::memory_order_relaxed);
    channels->grasped.store(grasped, std::memory_order_relaxed);
    proxyBeats = servoBeats = {};
    past.clear();
    if (!kept.empty()) remember(*kept.back());
}

void LocalEngine::Impl::askForButton() {
    constexpr int kMax = 31;
    const std::uint32_t all = (std::uint32_t(1) << std::clamp(info.buttons, 0, kMax)) - 1;
    channels->deadMan.store(deadMan ? all : 0, std::memory_order_relaxed);
}

void LocalEngine::Impl::remember(const World& world) {
    const double now = channels->recorder.now();
    if (!past.empty()) past.back().until = now;
    past.push_back({0, {numbersOf(world), world.scene}});
    while (past.size() > 1 &&
           (past.front().until < now - kRecorded - kSlowestPublish || past.size() > kMaxScenes))
        past.pop_front();
}

Result<void> LocalEngine::Impl::startLoops() {
    return servoThread
        .start("tactum-servo", kServoPriority,
               [this] { servoLoop(*channels, *device, info, motors, watchdog); })
        .and_then([this] {
            return proxyThread.start("tactum-proxy", kProxyPriority, [this] {
                proxyLoop(*channels, kUpdatesPerTick * info.rate, kProxyShare / info.rate);
            });
        });
}

/// False: the servo has not come back, and may use device, channels and device watchdog whenever it does.
bool LocalEngine::Impl::endLoops() {
    channels->stop.store(true, std::memory_order_relaxed);
    proxyThread.join();
    if (!servoThread.joinWithin(kExchangePatience)) {
        heat[info.name] = {channels->servoTelemetry.read().heat, monotonicNanoseconds()};
        return false;
    }
    heat[info.name] = motors;
    watchdog.stop();
    device->close();
    return true;
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
    impl_->device = std::move(device);
    impl_->info = impl_->device->info();
    impl_->freshChannels();
}

LocalEngine::~LocalEngine() {
    (void)stop();
}

Result<void> LocalEngine::start() {
    assertNotRealtime();
    if (impl_->running) return {};
    if (Result<void> opened = impl_->device->open(); !opened) return opened;
    impl_->info = impl_->device->info();
    if (Result<void> usable = checkDevice(impl_->info); !usable) {
        impl_->device->close();
        return usable;
    }
    // Before the loops have their memory: of what a fork shares every page is given anew when it is written.
    const Result<void> guarded = impl_->info.real ? impl_->watchdog.start(*impl_->device) : Result<void>();
    impl_->freshChannels();
    impl_->handOver();
    if (Result<void> started = guarded.and_then([this] { return impl_->startLoops(); }); !started) {
        if (!impl_->endLoops()) abandon();
        return started;
    }
    impl_->running = true;
    // After the threads, so that their stacks are among what is locked.
    const int unlocked = lockPresentMemory();
    const Urgency& granted = worse(impl_->servoThread.urgency(), impl_->proxyThread.urgency());
    impl_->realtime = granted.priority > 0 && !unlocked;
    impl_->priorityNote = sentenceOf(granted, unlocked);
    if (impl_->info.real) impl_->awake.emplace();
    return {};
}

Result<void> LocalEngine::stop() {
    assertNotRealtime();
    if (!impl_->running) return {};
    impl_->awake.reset();
    const bool ended = impl_->endLoops();
    if (!ended) abandon();
    impl_->running = false;
    poll();
    // No loop is left to see them; the newest stays for the next start.
    impl_->kept.erase(impl_->kept.begin(),
                      impl_->kept.end() - std::min<std::ptrdiff_t>(1, std::ssize(impl_->kept)));
    return ended ? Result<void>() : machineError(trouble());
}

/// What the servo may still touch stays as it is until the process ends; what the person decided goes along.
/// Its device watchdog has stopped the device already, and stays to do so when the program dies.
void LocalEngine::abandon() {
    impl_->device->emergencyStop();
    impl_->servoThread.abandon();
    auto fresh = std::make_unique<Impl>();
    fresh->device = std::make_unique<AbandonedDevice>(impl_->info);
    fresh->info = impl_->info;
    if (!impl_->kept.empty()) fresh->kept.push_back(impl_->kept.back());
    fresh->heat = impl_->heat;
    fresh->workspace = impl_->workspace;
    fresh->deadMan = impl_->deadMan;
    fresh->grasped = impl_->grasped;
    fresh->pace = impl_->pace;
    fresh->channels = impl_->channels; // with the last minute
    fresh->past = impl_->past;
    static auto& abandoned = *new std::vector<std::unique_ptr<Impl>>; // never destroyed
    abandoned.push_back(std::exchange(impl_, std::move(fresh)));
}

Result<void> LocalEngine::setDevice(std::unique_ptr<HapticDevice> device) {
    (void)stop(); // whom it concerns stops it first
    impl_->device = std::move(device);
    impl_->info = impl_->device->info();
    impl_->grasped = false;
    impl_->freshChannels();
    return start();
}

std::string LocalEngine::trouble() const {
    return impl_->device->trouble();
}

std::string LocalEngine::caution() const {
    return impl_->device->caution();
}

Result<void> LocalEngine::setWorkspace(const Workspace& workspace) {
    assertNotRealtime();
    if (Result<void> possible = checkWorkspace(workspace); !possible) return possible;
    impl_->workspace = workspace;
    impl_->channels->workspace.write(workspace);
    return {};
}

const Workspace& LocalEngine::workspace() const {
    return impl_->workspace;
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

void LocalEngine::fade() {
    impl_->channels->fading.store(true, std::memory_order_relaxed);
    impl_->channels->armed.store(false, std::memory_order_release);
}

void LocalEngine::setArmed(bool armed) {
    impl_->channels->fading.store(false, std::memory_order_relaxed);
    impl_->channels->armed.store(armed, std::memory_order_relaxed);
}
bool LocalEngine::armed() const {
    return impl_->channels->armed.load(std::memory_order_relaxed);
}

void LocalEngine::setDeadMan(bool on) {
    impl_->deadMan = on;
    impl_->askForButton();
}
bool LocalEngine::deadMan() const {
    return impl_->channels->deadMan.load(std::memory_order_relaxed) != 0;
}

void LocalEngine::setOverrideCeiling(bool on) {
    impl_->channels->overrideCeiling.store(on, std::memory_order_relaxed);
}
bool LocalEngine::overridesCeiling() const {
    return impl_->channels->overrideCeiling.load(std::memory_order_relaxed);
}

void LocalEngine::push(const Vec3& force) {
    impl_->channels->outside.write({force, monotonicNanoseconds()});
}

/// A full queue holds the same order already.
void LocalEngine::setGrasped(bool on) {
    impl_->grasped = on;
    impl_->channels->grasped.store(on, std::memory_order_relaxed);
}

void LocalEngine::restartProxy() {
    impl_->channels->commands.push({EngineCommand::Kind::RestartProxy});
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
    impl_->servo = impl_->channels->servoTelemetry.read();
    // What it told last is told for ever by a loop that stands still.
    if (impl_->servoBeats.stand(impl_->servo.ticks)) impl_->servo.rate = 0;
    if (servoStandsStill()) {
        // The device watchdog of a real device has taken it away; from others it is taken when they come
        // back.
        if (impl_->servo.gain > 0) impl_->servo.inhibit = InhibitReason::Stall;
        impl_->servo.gain = 0;
        impl_->servo.force = Vec3::Zero();
    }
    if (impl_->proxyBeats.stand(impl_->proxy.updates)) impl_->proxy.rate = 0;
}

bool LocalEngine::servoStandsStill() const {
    return impl_->running && impl_->servoBeats.still;
}

const ProxyTelemetry& LocalEngine::proxy() const {
    return impl_->proxy;
}
const ServoTelemetry& LocalEngine::servo() const {
    return impl_->servo;
}
bool LocalEngine::popTrace(TracePoint& point) {
    return impl_->channels->trace.pop(point);
}
RecordedRun LocalEngine::recorded() const {
    assertNotRealtime();
    RecordedRun run = impl_->channels->recorder.copy();
    run.device = impl_->info;
    for (const PastScene& past : impl_->past)
        if (!run.sceneOf(past.recorded.numbers.revision)) run.scenes.push_back(past.recorded);
    trim(run);
    return run;
}
const DeviceInfo& LocalEngine::device() const {
    return impl_->info;
}
bool LocalEngine::hasRealtimePriority() const {
    return impl_->realtime;
}
const std::string& LocalEngine::priorityNote() const {
    return impl_->priorityNote;
}

} // namespace tactum
