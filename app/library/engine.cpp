#include <tactum/engine.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "app/library/parts.h"
#include "core/geometry/soup_builder.h"
#include "core/runtime/local_engine.h"
#include "core/safety/inhibit_words.h"
#include "device/registry.h"

namespace tactum::library {

std::vector<Device> devices() {
    std::vector<Device> all;
    for (DeviceListing& one :
         DeviceRegistry({.hand = {}, .profiles = personsProfiles(), .program = {}}).list())
        all.push_back({std::move(one.id), std::move(one.name), one.usable, std::move(one.sentence)});
    return all;
}

namespace {

/// Which objects the contacts of a World's steps are on, as long as the steps may still be told.
class ObjectsOfWorlds {
public:
    void add(const core::World& world) {
        constexpr std::size_t kMost = 64; // the loops are never so many Worlds behind
        if (known_.size() == kMost) known_.erase(known_.begin());
        auto& objects = known_[world.revision];
        for (const WorldBody& body : world.bodies)
            objects.push_back(body.object);
    }

    void show(const HapticOutput& output, std::uint64_t world, EngineState& state) {
        known_.erase(known_.begin(), known_.lower_bound(world));
        const auto of = known_.find(world);
        for (int i = 0; i < output.contacts && of != known_.end(); ++i) {
            const ContactReport& report = output.contact[std::size_t(i)];
            if (state.contacts == kMostContacts || report.body >= of->second.size()) break;
            state.contact[state.contacts++] = outward(report, of->second[report.body]);
        }
    }

private:
    std::map<std::uint64_t, std::vector<ObjectId>> known_; ///< by the World's revision
};

/// With who leads it, where it is a simulated one.
struct MadeDevice {
    explicit MadeDevice(const std::string& id)
        : device(valueOf(
              DeviceRegistry({.hand = lead, .profiles = personsProfiles(), .program = {}}).make(id))) {}

    std::shared_ptr<HandTarget> lead = std::make_shared<HandTarget>();
    std::unique_ptr<HapticDevice> device;
};

} // namespace

struct Engine::State {
    explicit State(MadeDevice first) : leads{first.lead}, engine(std::move(first.device)) {}

    static State& of(const std::unique_ptr<State>& state) {
        if (!state) refuse("this Engine was moved elsewhere; assign another one to it first");
        return *state;
    }
    static Hand first(const std::unique_ptr<State>& state) { return {of(state), 0}; }

    std::vector<std::shared_ptr<HandTarget>> leads; ///< of each hand
    LocalEngine engine;
    std::shared_ptr<const core::World> last;
    ObjectsOfWorlds objects;
};

Engine::Engine(const std::string& device) : state_(std::make_unique<State>(MadeDevice(device))) {}
Engine::Engine(Engine&& other) noexcept = default;
Engine& Engine::operator=(Engine&& other) noexcept = default;
Engine::~Engine() = default;

void Engine::addHand(const std::string& device) {
    State& state = State::of(state_);
    MadeDevice made(device);
    const auto added = state.engine.addDevice(std::move(made.device));
    // Also where it does not start: the hand is there then.
    if (state.engine.hands() > state.leads.size()) state.leads.push_back(made.lead);
    valueOf(added);
}

std::size_t Engine::hands() const {
    return State::of(state_).leads.size();
}

Hand Engine::hand(std::size_t i) {
    if (i >= hands()) refuse("there is no hand " + std::to_string(i) + ": they are numbered from 0");
    return {*state_, i};
}

void Engine::open() {
    valueOf(State::of(state_).engine.start());
}

void Engine::close() {
    valueOf(State::of(state_).engine.stop());
}

bool Engine::isOpen() const {
    return State::of(state_).engine.running();
}

std::string Engine::priority() const {
    return State::of(state_).engine.priorityNote();
}

void Engine::publish(const Scene& scene) {
    State& state = State::of(state_);
    state.last = compiled(*Parts::state(scene), state.last.get());
    state.objects.add(*state.last);
    state.engine.publish(state.last);
}

void Engine::arm(bool on) {
    State::of(state_).engine.setAllArmed(on);
}

std::string Engine::deviceName() const {
    return State::first(state_).deviceName();
}

double Engine::maxForce() const {
    return State::first(state_).maxForce();
}

std::string Engine::trouble() const {
    return State::first(state_).trouble();
}

bool Engine::armed() const {
    return State::first(state_).armed();
}

void Engine::place(const Workspace& workspace) {
    State::first(state_).place(workspace);
}

void Engine::push(const Vec3& force) {
    State::first(state_).push(force);
}

void Engine::restartProxy() {
    State::first(state_).restartProxy();
}

void Engine::leadHand(const Vec3& to, double seconds) {
    State::first(state_).lead(to, seconds);
}

EngineState Engine::state() {
    return State::first(state_).state();
}

std::string Hand::deviceName() const {
    return engine_->engine.hand(index_).device().name;
}

double Hand::maxForce() const {
    return engine_->engine.hand(index_).device().maxForce;
}

std::string Hand::trouble() const {
    return engine_->engine.hand(index_).trouble();
}

void Hand::arm(bool on) {
    engine_->engine.hand(index_).setArmed(on);
}

bool Hand::armed() const {
    return engine_->engine.hand(index_).armed();
}

void Hand::place(const Workspace& workspace) {
    core::Workspace where = engine_->engine.hand(index_).workspace();
    where.scale = workspace.scale;
    where.offset = inward(workspace.offset);
    valueOf(engine_->engine.hand(index_).setWorkspace(where));
}

void Hand::push(const Vec3& force) {
    const core::Vec3 pushed = inward(force);
    if (!pushed.allFinite()) refuse("force: is not finite");
    engine_->engine.hand(index_).push(pushed);
}

void Hand::restartProxy() {
    engine_->engine.hand(index_).restartProxy();
}

void Hand::lead(const Vec3& to, double seconds) {
    HandGoal goal;
    goal.position = inward(to);
    goal.held = true;
    goal.time = seconds;
    if (!std::ranges::all_of(goal.position, isCoordinate) || !(seconds >= 0 && seconds <= 3600))
        refuse("leadHand: wants a place within 1e6 m, and from 0 to 3600 s");
    engine_->leads[index_]->write(goal);
}

EngineState Hand::state() {
    LocalEngine& engine = engine_->engine;
    engine.poll();
    const LocalEngine::Hand hand = engine.hand(index_);
    const ProxyTelemetry& proxy = engine.proxy();
    const ServoTelemetry& servo = hand.servo();
    const HapticOutput& output = hand.touch().output;
    EngineState told;
    told.finger = outward(servo.finger);
    told.proxy = outward(output.proxy);
    told.force = outward(servo.force);
    told.gain = servo.gain;
    told.why = inhibitWords(servo.inhibit).brief;
    told.fault = isFault(servo.inhibit);
    told.buttons = servo.buttons;
    told.ticks = servo.ticks;
    told.updates = proxy.updates;
    told.misses = servo.misses;
    told.rate = hand.servoStandsStill() ? 0 : servo.rate;
    told.updateMicros = proxy.updateMicros;
    engine_->objects.show(output, proxy.worldRevision, told);
    return told;
}

} // namespace tactum::library
