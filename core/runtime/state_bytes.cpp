#include "core/runtime/state_bytes.h"

#include <algorithm>

#include "core/base/byte_archive.h"

namespace tactum {

// What each part consists of. A member that is missing here makes replays differ, which the tests notice.

void fields(auto& visit, MaybeConst<ConstraintPlane> auto& plane) {
    visit(plane.normal, plane.offset);
}
void fields(auto& visit, MaybeConst<FrictionLimit> auto& limit) {
    visit(limit.coefficient, limit.lag);
}
void fields(auto& visit, MaybeConst<LocalContactModel> auto& model) {
    visit.counted(model.plane, model.planes);
    visit(model.proxy, model.friction, model.stiffness, model.damping, model.velocity, model.valid,
          model.revision, model.restarts, model.anchoring);
}
void fields(auto& visit, MaybeConst<Material> auto& material) {
    for (const MaterialField& field : kMaterialFields)
        visit(material.*field.value);
}
void fields(auto& visit, MaybeConst<Contact> auto& contact) {
    visit(contact.body, contact.triangle, contact.slipping, contact.point, contact.normal, contact.gap,
          contact.bend, contact.edge, contact.lambda, contact.material);
}
void fields(auto& visit, MaybeConst<FeltPlane> auto& felt) {
    visit(felt.normal, felt.body, felt.triangle);
}
void fields(auto& visit, MaybeConst<PassedBody> auto& passed) {
    visit(passed.body, passed.at_B);
}
void fields(auto& visit, MaybeConst<StraddledBody> auto& straddled) {
    visit(straddled.body, straddled.from_B);
}
void fields(auto& visit, MaybeConst<ProxyState> auto& proxy) {
    visit(proxy.position, proxy.finger);
    visit.counted(proxy.contacts, proxy.contactCount);
    visit.counted(proxy.felt, proxy.feltCount);
    visit(proxy.speed);
    visit.unbounded(proxy.stride);
    visit(proxy.stillFor, proxy.slidingOn);
    visit.counted(proxy.passed, proxy.passedCount);
    visit.counted(proxy.straddled, proxy.straddledCount);
}
void fields(auto& visit, MaybeConst<BodiesState> auto& bodies) {
    visit.counted(bodies.q, bodies.qs);
    visit.counted(bodies.v, bodies.vs);
}
void fields(auto& visit, MaybeConst<FingerPress> auto& press) {
    visit(press.force, press.velocity);
    visit.unbounded(press.coupling.stiffness);
    visit.unbounded(press.coupling.force);
    visit(press.coupling.delay);
}
// In the order of before there were several hands: recordings stay what they are.
void fields(auto& visit, MaybeConst<SimState> auto& state) {
    visit(state.proxy, state.model, state.shapeRevision, state.time, state.restarts, state.bodies.of,
          state.press, state.bodies);
}
void fields(auto& visit, MaybeConst<HandState> auto& state) {
    visit(state.proxy, state.model, state.shapeRevision, state.restarts, state.press);
}
void fields(auto& visit, MaybeConst<LoopFigures> auto& loop) {
    visit(loop.period, loop.delay, loop.amplifierLag, loop.damping, loop.dryFriction, loop.resolution,
          loop.makersCeiling, loop.handsCeiling, loop.surfaceDamping);
}
void fields(auto& visit, MaybeConst<ForceLimiter> auto& limiter) {
    visit(limiter.maxForce, limiter.clamped, limiter.notFinite);
}
void fields(auto& visit, MaybeConst<StiffnessCeiling> auto& ceiling) {
    visit(ceiling.value, ceiling.reason, ceiling.damping);
}
void fields(auto& visit, MaybeConst<DeviceSample> auto& sample) {
    // Not when it was measured: that is for the loop, which hands on how long after the one before.
    visit(sample.position, sample.velocity, sample.buttons, sample.valid, sample.jumped, sample.stopped);
}
void fields(auto& visit, MaybeConst<RenderedSpring> auto& spring) {
    visit(spring.force, spring.stiffness, spring.stretch, spring.limit, spring.velocity);
}
void fields(auto& visit, MaybeConst<Previous> auto& previous) {
    visit(previous.finger_D, previous.anchor_D, previous.added_D, previous.outside_D, previous.gain,
          previous.load, previous.touching);
}
void fields(auto& visit, MaybeConst<ServoState> auto& state) {
    visit(state.check, state.schedule, state.transition, state.gate, state.passivity, state.damper,
          state.border, state.heat, state.limiter, state.previous, state.ticks, state.unread, state.modelAge,
          state.letGo);
}

namespace {

// Another size: a member came or went. List it in fields(), there or above, and then its new size here. Built
// for one processor Eigen may align its vectors wider, and the sizes are others.
#if EIGEN_MAX_STATIC_ALIGN_BYTES == 16
static_assert(sizeof(ForceGate) == 48 && sizeof(ContactTransition) == 416 && sizeof(Passivity) == 704);
static_assert(sizeof(OscillationDetector) == 192 && sizeof(MotorHeat) == 24 && sizeof(SampleCheck) == 672);
static_assert(sizeof(LoopFigures) == 72 && sizeof(DeviceSample) == 64 && sizeof(ServoState) == 2720);
static_assert(sizeof(LocalContactModel) == 288 && sizeof(Contact) == 152 && sizeof(BorderSpring) == 272);
static_assert(sizeof(ProxyState) == 7488 + sizeof(ProxyState::memories));
static_assert(sizeof(BodiesState) == 16 * kMaxCoordinates + 16 && sizeof(FingerPress) == 72);
static_assert(sizeof(HandState) == 384 + sizeof(ProxyState));
static_assert(sizeof(WorldState) == 8 + sizeof(BodiesState));
#endif

template <class State, std::size_t Room> void writeState(const State& state, StateBytes<Room>& to) noexcept {
    ByteWriter writer(to.bytes);
    writer(state);
    to.size = writer.fits() ? writer.size() : 0;
}

template <class State>
bool readState(std::span<const std::byte> bytes, State& state, NotFinite rule) noexcept {
    ByteReader reader(bytes, rule);
    reader(state);
    return reader.complete();
}

// What a proxy remembers only makes it faster.
void forgetSeen(ProxyState& proxy) noexcept {
    proxy.memories = {};
    proxy.seenFrom = kNowhere;
}

bool exists(const World& world, std::uint32_t body, Index triangle) noexcept {
    return body < world.obstacles.size() && triangle < world.obstacles[body].mesh->soup->triangles.size();
}

} // namespace

void write(const SimState& state, SimStateBytes& to) noexcept {
    writeState(state, to);
}
void write(const HandState& state, SimStateBytes& to) noexcept {
    writeState(state, to);
}
void write(const ServoState& state, ServoStateBytes& to) noexcept {
    writeState(state, to);
}
bool read(std::span<const std::byte> bytes, SimState& state) noexcept {
    forgetSeen(state.proxy);
    return readState(bytes, state, NotFinite::Refused);
}
bool read(std::span<const std::byte> bytes, HandState& state) noexcept {
    forgetSeen(state.proxy);
    return readState(bytes, state, NotFinite::Refused);
}
bool read(std::span<const std::byte> bytes, ServoState& state) noexcept {
    return readState(bytes, state, NotFinite::Allowed);
}

bool belongsTo(const HandState& state, const World& world) noexcept {
    const ProxyState& proxy = state.proxy;
    return std::all_of(proxy.contacts.begin(), proxy.contacts.begin() + proxy.contactCount,
                       [&](const Contact& c) { return exists(world, c.body, c.triangle); }) &&
           std::all_of(proxy.felt.begin(), proxy.felt.begin() + proxy.feltCount,
                       [&](const FeltPlane& f) { return exists(world, f.body, f.triangle); }) &&
           std::all_of(proxy.passed.begin(), proxy.passed.begin() + proxy.passedCount,
                       [&](const PassedBody& p) { return p.body < world.obstacles.size(); }) &&
           std::all_of(proxy.straddled.begin(), proxy.straddled.begin() + proxy.straddledCount,
                       [&](const StraddledBody& s) { return s.body < world.obstacles.size(); });
}

} // namespace tactum
