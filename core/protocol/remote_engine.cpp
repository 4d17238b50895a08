#include "core/protocol/remote_engine.h"

#include <chrono>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/remote_session.h"
#include "core/recording/recording_file.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using Order = v1::OrderRequest;

/// What was set, which is told until the server had time to tell it.
template <class T> class Wish {
public:
    void set(const T& value) { value_ = value, until_ = Clock::now() + std::chrono::seconds(1); }
    void forget() { until_ = {}; }
    T over(const T& told) const { return Clock::now() < until_ ? value_ : told; }

private:
    T value_{};
    Clock::time_point until_{};
};

void write(v1::Vector& to, const Vec3& v) {
    to.set_x(v.x()), to.set_y(v.y()), to.set_z(v.z());
}

v1::Workspace written(const Workspace& workspace) {
    v1::Workspace to;
    to.set_scale(workspace.scale);
    for (const auto axis : workspace.axes)
        to.add_axis(axis);
    write(*to.mutable_offset(), workspace.offset);
    to.set_clutch(workspace.clutch);
    to.set_bump(workspace.bump);
    to.set_centring(workspace.centring);
    to.set_reach(std::uint32_t(workspace.reach.mode));
    to.set_shell(workspace.reach.shell);
    return to;
}

/// What a server's contacts name, as far as this World has it.
void keepKnown(HapticOutput& output, const World* world) {
    int kept = 0;
    for (int i = 0; i < output.contacts; ++i) {
        const ContactReport contact = output.contact[std::size_t(i)];
        if (!world || contact.body >= world->bodies.size() ||
            contact.surface >= world->bodies[contact.body].materials.size())
            continue;
        output.contact[std::size_t(kept++)] = contact;
    }
    output.contacts = kept;
}

} // namespace

struct RemoteEngine::Impl {
    Impl(RemoteSettings settings, std::shared_ptr<HandTarget> hand)
        : session(std::move(settings), std::move(hand)) {
        shown.device.name = "Haptic server";
    }

    RemoteSession session;
    EngineReport shown; ///< as poll() found it
    // While nobody tells what is felt, the plots go on without force.
    TracePoint last;
    bool pointDue = false;
    Clock::time_point polled = Clock::now();
    Wish<bool> armed, deadMan, overrides;
    Wish<double> pace;
    Wish<Workspace> workspace;
    Workspace shownWorkspace;
};

RemoteEngine::RemoteEngine(RemoteSettings settings, std::shared_ptr<HandTarget> hand)
    : impl_(std::make_unique<Impl>(std::move(settings), std::move(hand))) {}

RemoteEngine::~RemoteEngine() = default;

Result<void> RemoteEngine::start() {
    impl_->session.begin();
    poll();
    return running() ? Result<void>() : machineError(trouble());
}

Result<void> RemoteEngine::stop() {
    impl_->session.end();
    poll();
    return {};
}

bool RemoteEngine::running() const {
    return impl_->session.open();
}

Result<void> RemoteEngine::setDevice(std::unique_ptr<HapticDevice>) {
    return inputError("the device is the haptic server's: choose it there, with tactum serve --device");
}

std::string RemoteEngine::trouble() const {
    if (running()) return impl_->shown.trouble;
    const std::string fault = impl_->session.fault();
    if (!fault.empty())
        return "The haptic server at " + impl_->session.settings().target + ": " + fault +
               ". It is tried again.";
    if (!impl_->session.settings().certificate.empty())
        return "No haptic server answers at " + impl_->session.settings().target +
               ". It is tried again: see whether tactum serve runs there with a certificate, and whether "
               "certificate.pem and token are those of its folder.";
    return "No haptic server answers at " + impl_->session.settings().target +
           ". It is tried again: see whether tactum serve runs there, and whether it wants a certificate and "
           "a "
           "token (--credentials), which one at 127.0.0.1 does not.";
}
std::string RemoteEngine::caution() const {
    return impl_->shown.caution;
}

Result<void> RemoteEngine::setWorkspace(const Workspace& workspace) {
    if (Result<void> possible = checkWorkspace(workspace); !possible) return possible;
    impl_->workspace.set(workspace);
    impl_->shownWorkspace = workspace;
    Order order;
    *order.mutable_workspace() = written(workspace);
    impl_->session.order(std::move(order), true);
    return {};
}
const Workspace& RemoteEngine::workspace() const {
    return impl_->shownWorkspace;
}

void RemoteEngine::publish(std::shared_ptr<const World> world) {
    if (world) impl_->session.publish(std::move(world));
}
std::uint64_t RemoteEngine::publishedAfter() const {
    return impl_->shown.publishedAfter;
}

void RemoteEngine::setArmed(bool armed) {
    impl_->armed.set(armed);
    Order order;
    if (armed)
        order.set_arm(true);
    else
        order.mutable_stop(); // which needs no pen
    impl_->session.order(std::move(order));
}
void RemoteEngine::fade() {
    impl_->armed.set(false);
    Order order;
    order.mutable_fade();
    impl_->session.order(std::move(order));
}
bool RemoteEngine::armed() const {
    return running() && impl_->armed.over(impl_->shown.armed);
}

void RemoteEngine::setDeadMan(bool on) {
    impl_->deadMan.set(on);
    Order order;
    order.set_dead_man(on);
    impl_->session.order(std::move(order), true);
}
bool RemoteEngine::deadMan() const {
    return impl_->deadMan.over(impl_->shown.deadMan);
}

void RemoteEngine::setOverrideCeiling(bool on) {
    impl_->overrides.set(on);
    Order order;
    order.set_override_ceiling(on);
    impl_->session.order(std::move(order));
}
bool RemoteEngine::overridesCeiling() const {
    return impl_->overrides.over(impl_->shown.overridesCeiling);
}

void RemoteEngine::push(const Vec3& force) {
    v1::Word word;
    write(*word.mutable_push()->mutable_force(), force);
    impl_->session.say(word);
}

void RemoteEngine::setGrasped(bool on) {
    Order order;
    order.set_grasped(on);
    impl_->session.order(std::move(order), true);
}
void RemoteEngine::restartProxy() {
    Order order;
    order.mutable_restart();
    impl_->session.order(std::move(order));
}
void RemoteEngine::setPace(double pace) {
    impl_->pace.set(pace);
    Order order;
    order.set_pace(pace);
    impl_->session.order(std::move(order), true);
}
double RemoteEngine::pace() const {
    return impl_->pace.over(impl_->shown.pace);
}
void RemoteEngine::beginBodies() {
    Order order;
    order.mutable_begin();
    impl_->session.order(std::move(order));
}
void RemoteEngine::stepBodies() {
    Order order;
    order.mutable_step();
    impl_->session.order(std::move(order));
}

/// Where nobody knows what is felt, nothing is shown to be.
void RemoteEngine::poll() {
    std::shared_ptr<const World> world;
    EngineReport& shown = impl_->shown;
    const bool known = impl_->session.read(shown, world);
    const double passed = std::chrono::duration<double>(Clock::now() - impl_->polled).count();
    impl_->polled = Clock::now();
    impl_->pointDue = !known;
    impl_->last.t += known ? 0 : passed;
    if (!known) {
        shown.servo.gain = shown.servo.rate = shown.proxy.rate = 0;
        shown.servo.force = shown.proxy.output.force = Vec3::Zero();
        shown.servo.inhibit = InhibitReason::NotArmed;
        shown.running = shown.armed = shown.standsStill = false;
    }
    shown.proxy.worldRevision = world ? world->revision : 0;
    shown.proxy.bodies.of = world && world->moving ? world->moving->key() : 0;
    keepKnown(shown.proxy.output, world.get());
    impl_->shownWorkspace = impl_->workspace.over(shown.workspace);
}

const ProxyTelemetry& RemoteEngine::proxy() const {
    return impl_->shown.proxy;
}
const ServoTelemetry& RemoteEngine::servo() const {
    return impl_->shown.servo;
}
bool RemoteEngine::servoStandsStill() const {
    return impl_->shown.standsStill;
}
bool RemoteEngine::popTrace(TracePoint& point) {
    const bool told = impl_->session.popTrace(point);
    if (told) impl_->last = {.t = point.t, .finger = point.finger, .proxy = point.proxy};
    if (told || !std::exchange(impl_->pointDue, false)) return told;
    point = impl_->last;
    return true;
}

RecordedRun RemoteEngine::recorded() const {
    std::string bytes;
    if (!impl_->session.record(bytes)) return {};
    auto recording = parseRecording(bytes, "recording of the server");
    return recording ? std::move(recording->run) : RecordedRun{};
}

const DeviceInfo& RemoteEngine::device() const {
    return impl_->shown.device;
}
bool RemoteEngine::hasRealtimePriority() const {
    return impl_->shown.realtime;
}
const std::string& RemoteEngine::priorityNote() const {
    return impl_->shown.priorityNote;
}

// ---- the scene that others see ----

std::string RemoteEngine::place() const {
    return impl_->session.settings().target;
}
std::optional<SharedScene::Arrived> RemoteEngine::arrived() {
    return impl_->session.arrived();
}
std::optional<std::string> RemoteEngine::refused() {
    auto why = impl_->session.refused();
    if (why) impl_->armed.forget();
    return why;
}
std::optional<std::string> RemoteEngine::forceSaid() {
    return impl_->session.forceSaid();
}
bool RemoteEngine::holdsPen() const {
    return impl_->session.standing().pen;
}
std::string RemoteEngine::penHolder() const {
    return impl_->session.standing().holder;
}
void RemoteEngine::askForPen() {
    Order order;
    order.mutable_ask();
    impl_->session.order(std::move(order));
}
std::optional<std::string> RemoteEngine::penAskedBy() {
    return impl_->session.penAskedBy();
}
std::string RemoteEngine::penAsker() const {
    return impl_->session.standing().asker;
}
void RemoteEngine::givePen(const std::string& to) {
    Order order;
    order.mutable_give()->set_to(to);
    impl_->session.order(std::move(order));
}
std::size_t RemoteEngine::attending() const {
    return impl_->session.standing().attending;
}

} // namespace tactum
