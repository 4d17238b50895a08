#include "core/protocol/remote_engine.h"

#include <chrono>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/remote_engine_impl.h"
#include "core/recording/recording_file.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using Order = v1::OrderRequest;

void write(v1::Vector& to, const Vec3& v) {
    to.set_x(v.x()), to.set_y(v.y()), to.set_z(v.z());
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

/// Nobody knows what it feels.
void silence(HandReport& hand) {
    hand.servo.gain = hand.servo.rate = 0;
    hand.servo.force = hand.touch.output.force = Vec3::Zero();
    hand.servo.inhibit = InhibitReason::NotArmed;
    hand.armed = hand.standsStill = false;
}

} // namespace

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
    if (running()) return impl_->spokenHand().trouble;
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
    return impl_->spokenHand().caution;
}

Result<void> RemoteEngine::setWorkspace(const Workspace& workspace) {
    return setWorkspaceOf(impl_->spoken, workspace);
}
const Workspace& RemoteEngine::workspace() const {
    return impl_->spokenHand().workspace;
}

void RemoteEngine::publish(std::shared_ptr<const World> world) {
    if (world) impl_->session.publish(std::move(world));
}
std::uint64_t RemoteEngine::publishedAfter() const {
    return impl_->shown.publishedAfter;
}

/// Off is a stop, which needs no pen and is for all.
void RemoteEngine::setArmed(bool armed) {
    armed ? setArmedOf(impl_->spoken, true) : setAllArmed(false);
}
void RemoteEngine::fade() {
    impl_->wishArmed(impl_->spoken, false);
    Order order;
    order.mutable_fade();
    impl_->order(std::move(order), impl_->spoken);
}
bool RemoteEngine::armed() const {
    return running() && impl_->spokenHand().armed;
}

void RemoteEngine::setDeadMan(bool on) {
    for (std::size_t hand = 0; hand < hands(); ++hand) {
        impl_->wishes[hand].deadMan.set(on);
        impl_->shown.hands[hand].deadMan = on;
    }
    Order order;
    order.set_dead_man(on);
    impl_->session.order(std::move(order), true);
}
bool RemoteEngine::deadMan() const {
    return impl_->spokenHand().deadMan;
}

void RemoteEngine::setOverrideCeiling(bool on) {
    impl_->wishes[impl_->spoken].overrides.set(on);
    impl_->spokenHand().overridesCeiling = on;
    Order order;
    order.set_override_ceiling(on);
    impl_->order(std::move(order), impl_->spoken);
}
bool RemoteEngine::overridesCeiling() const {
    return impl_->spokenHand().overridesCeiling;
}

void RemoteEngine::push(const Vec3& force) {
    v1::Word word;
    write(*word.mutable_push()->mutable_force(), force);
    word.mutable_push()->set_hand(std::uint32_t(impl_->spoken));
    impl_->session.say(word);
}

void RemoteEngine::setGrasped(bool on) {
    setGraspedOf(impl_->spoken, on);
}
void RemoteEngine::restartProxy() {
    Order order;
    order.mutable_restart();
    impl_->order(std::move(order), impl_->spoken);
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
    if (impl_->spoken >= shown.hands.size()) impl_->spoken = 0; // another server
    const double passed = std::chrono::duration<double>(Clock::now() - impl_->polled).count();
    impl_->polled = Clock::now();
    impl_->pointDue = !known;
    impl_->last.t += known ? 0 : passed;
    shown.running = shown.running && known;
    if (!known) shown.world.rate = 0;
    shown.world.worldRevision = world ? world->revision : 0;
    shown.world.bodies.of = world && world->moving ? world->moving->key() : 0;
    for (std::size_t hand = 0; hand < shown.hands.size(); ++hand) {
        keepKnown(shown.hands[hand].touch.output, world.get());
        impl_->wishes[hand].over(shown.hands[hand]);
        if (!known) silence(shown.hands[hand]);
    }
    impl_->join();
}

const ProxyTelemetry& RemoteEngine::proxy() const {
    return impl_->proxy;
}
const ServoTelemetry& RemoteEngine::servo() const {
    return impl_->spokenHand().servo;
}
bool RemoteEngine::servoStandsStill() const {
    return impl_->spokenHand().standsStill;
}
bool RemoteEngine::popTrace(TracePoint& point) {
    const bool told = impl_->session.popTrace(impl_->spoken, point);
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
    return impl_->spokenHand().device;
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
    if (why)
        for (Wishes& each : impl_->wishes)
            each.armed.forget();
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
