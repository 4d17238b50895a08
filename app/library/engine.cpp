#include <tactum/engine.h>

#include <algorithm>
#include <cmath>
#include <map>

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

    void show(const ProxyTelemetry& told, EngineState& state) {
        known_.erase(known_.begin(), known_.lower_bound(told.worldRevision));
        const auto of = known_.find(told.worldRevision);
        for (int i = 0; i < told.output.contacts && of != known_.end(); ++i) {
            const ContactReport& report = told.output.contact[std::size_t(i)];
            if (state.contacts == kMostContacts || report.body >= of->second.size()) break;
            state.contact[state.contacts++] = outward(report, of->second[report.body]);
        }
    }

private:
    std::map<std::uint64_t, std::vector<ObjectId>> known_; ///< by the World's revision
};

} // namespace

struct Engine::State {
    explicit State(const std::string& device)
        : engine(valueOf(
              DeviceRegistry({.hand = hand, .profiles = personsProfiles(), .program = {}}).make(device))) {}

    static State& of(const std::unique_ptr<State>& state) {
        if (!state) refuse("this Engine was moved elsewhere; assign another one to it first");
        return *state;
    }

    std::shared_ptr<HandTarget> hand = std::make_shared<HandTarget>();
    LocalEngine engine;
    std::shared_ptr<const core::World> last;
    ObjectsOfWorlds objects;
};

Engine::Engine(const std::string& device) : state_(std::make_unique<State>(device)) {}
Engine::Engine(Engine&& other) noexcept = default;
Engine& Engine::operator=(Engine&& other) noexcept = default;
Engine::~Engine() = default;

void Engine::open() {
    valueOf(State::of(state_).engine.start());
}

void Engine::close() {
    valueOf(State::of(state_).engine.stop());
}

bool Engine::isOpen() const {
    return State::of(state_).engine.running();
}

std::string Engine::deviceName() const {
    return State::of(state_).engine.device().name;
}

double Engine::maxForce() const {
    return State::of(state_).engine.device().maxForce;
}

std::string Engine::trouble() const {
    return State::of(state_).engine.trouble();
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
    State::of(state_).engine.setArmed(on);
}

bool Engine::armed() const {
    return State::of(state_).engine.armed();
}

void Engine::place(const Workspace& workspace) {
    core::Workspace where = State::of(state_).engine.workspace();
    where.scale = workspace.scale;
    where.offset = inward(workspace.offset);
    valueOf(state_->engine.setWorkspace(where));
}

void Engine::push(const Vec3& force) {
    const core::Vec3 pushed = inward(force);
    if (!pushed.allFinite()) refuse("force: is not finite");
    State::of(state_).engine.push(pushed);
}

void Engine::restartProxy() {
    State::of(state_).engine.restartProxy();
}

void Engine::leadHand(const Vec3& to, double seconds) {
    HandGoal goal;
    goal.position = inward(to);
    goal.held = true;
    goal.time = seconds;
    if (!std::ranges::all_of(goal.position, isCoordinate) || !(seconds >= 0 && seconds <= 3600))
        refuse("leadHand: wants a place within 1e6 m, and from 0 to 3600 s");
    State::of(state_).hand->write(goal);
}

EngineState Engine::state() {
    State& state = State::of(state_);
    state.engine.poll();
    const ProxyTelemetry& proxy = state.engine.proxy();
    const ServoTelemetry& servo = state.engine.servo();
    EngineState told;
    told.finger = outward(servo.finger);
    told.proxy = outward(proxy.output.proxy);
    told.force = outward(servo.force);
    told.gain = servo.gain;
    told.why = inhibitWords(servo.inhibit).brief;
    told.fault = isFault(servo.inhibit);
    told.buttons = servo.buttons;
    told.ticks = servo.ticks;
    told.updates = proxy.updates;
    told.misses = servo.misses;
    told.rate = state.engine.servoStandsStill() ? 0 : servo.rate;
    told.updateMicros = proxy.updateMicros;
    state.objects.show(proxy, told);
    return told;
}

} // namespace tactum::library
