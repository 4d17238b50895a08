#include "core/haptics/haptic_step.h"

#include <algorithm>
#include <utility>

#include "core/proxy/place.h"

namespace tactum {

namespace {

/// The shapeRevision of bodies that were put back: all contacts are void, the proxy stays where it can.
constexpr std::uint64_t kBeginAnew = kNoShape - 1;

Vec3 velocityOf(const World& world, const StepMotions& movers, const Contact& contact, double dt) {
    const int mover = world.obstacles[contact.body].mover;
    return mover < 0 ? Vec3::Zero() : Vec3(movers.of(mover).wayOf(contact.point) / dt);
}

// Stiffness, damping and velocity of several contacts: the mean, weighted by how hard each pushes. Without a
// push the last values stay, for a proxy that is still on its way.
void mixMaterials(const World& world, const StepMotions& movers, HandState& state, double dt) {
    const ProxyState& proxy = state.proxy;
    double total = 0, stiffness = 0, damping = 0;
    Vec3 velocity = Vec3::Zero();
    for (int i = 0; i < proxy.contactCount; ++i) {
        const Contact& contact = proxy.contacts[i];
        total += contact.lambda;
        stiffness += contact.lambda * contact.material.stiffness;
        damping += contact.lambda * contact.material.damping;
        velocity += contact.lambda * velocityOf(world, movers, contact, dt);
    }
    if (!(total > 0)) return;
    state.model.stiffness = stiffness / total;
    state.model.damping = damping / total;
    state.model.velocity = velocity / total;
}

void addPlane(LocalContactModel& model, const Contact& contact, const Vec3& normal) {
    if (model.planes == kMaxModelPlanes) return;
    model.plane[model.planes] = {normal, -contact.gap * normal.dot(contact.normal)};
    FrictionLimit& friction = model.friction[model.planes++];
    friction = frictionLimit(contact.material, contact.slipping);
    friction.lag = frictionLimit(contact.material, true).lag; // the servo sees first when it begins to slip
}

// Of shaded and textured surfaces the servo gets the planes that are felt.
void describeSurroundings(const World& world, const StepMotions& movers, HandState& state, double dt) {
    LocalContactModel& model = state.model;
    const ProxyState& proxy = state.proxy;
    model.proxy = proxy.position;
    model.valid = true;
    model.revision = world.revision;
    model.restarts = state.restarts;
    model.planes = 0;
    mixMaterials(world, movers, state, dt);
    for (int i = 0; i < proxy.contactCount; ++i) {
        const Contact& contact = proxy.contacts[i];
        if (proxy.feltCount == 0 && contact.lambda > 0) addPlane(model, contact, contact.normal);
        for (int j = 0; j < proxy.feltCount; ++j) {
            const FeltPlane& felt = proxy.felt[j];
            if (felt.body == contact.body && felt.triangle == contact.triangle)
                addPlane(model, contact, felt.normal);
        }
    }
}

HapticOutput reportOf(const World& world, const HandState& state) {
    HapticOutput output;
    output.proxy = state.proxy.position;
    for (int i = 0; i < state.proxy.contactCount && output.contacts < kMaxModelPlanes; ++i) {
        const Contact& contact = state.proxy.contacts[i];
        if (contact.lambda <= 0) continue;
        ContactReport& report = output.contact[output.contacts++];
        report.point = contact.point;
        report.normal = contact.normal;
        report.normalForce = state.model.stiffness * contact.lambda;
        report.body = contact.body;
        report.surface = world.obstacles[contact.body].surfaceOf(contact.triangle);
        report.slipping = contact.slipping;
        report.frictionless = !hasFriction(contact.material);
        report.staticFriction = contact.material.staticFriction;
        report.dynamicFriction = contact.material.dynamicFriction;
    }
    return output;
}

// At first, and when nobody knows which way the finger went, the proxy begins at the finger. After a change
// of shape it stays where it is. Where there is something now, it goes to the nearest clear place; so it does
// where it would be inside of what it was outside of, for no way of the finger leads there.
void startAnew(const World& world, double time, HandState& state, const HapticInput& input) {
    const bool first = state.shapeRevision == kNoShape;
    const bool atFinger = first || input.restart || input.found;
    const Vec3 wanted = atFinger ? input.finger : state.proxy.position;
    FormerPlace former{state.shapeRevision};
    if (input.found && !first) former.at_W = state.proxy.position;
    const StepMotions movers(world.movers, time, time, world.drivenMotions());
    const Vec3 place =
        clearPlace(world.obstacles, movers, world.proxyRadius, wanted, former, &world.near).value_or(wanted);
    restart(state.proxy, place);
    state.proxy.finger = input.finger;
    if (atFinger || place != wanted) ++state.restarts;
    state.shapeRevision = world.shapeRevision;
}

using Hands = InplaceVector<HandStep*, std::size_t(kMaxHands)>;

void beginBodies(const World& world, WorldState& shared, const Hands& hands) noexcept {
    // A replay that begins here knows the states alone.
    const auto isNew = [&](const HandStep* hand) { return hand->state.model.revision != world.revision; };
    if (std::ranges::any_of(hands.all(), isNew)) world.moving->forget();
    if (!world.moving->begin(shared.bodies)) return;
    for (HandStep* hand : hands.all())
        hand->state.press.force = hand->state.press.velocity = Vec3::Zero();
}

// What the fingers did in the last step acts on the bodies until this one.
void moveBodies(const World& world, WorldState& shared, const Hands& hands, double dt, double time) noexcept {
    const auto drivenOf = [&](std::uint32_t obstacle) {
        const int mover = world.obstacles[obstacle].mover;
        return mover < 0 ? -1 : world.movers[std::size_t(mover)].driven;
    };
    for (const HandStep* hand : hands.all()) {
        const HandState& state = hand->state;
        world.moving->press(
            pushesOf(state.proxy, state.press, state.model.stiffness, {world.moving->scale().force, time}),
            drivenOf);
    }
    world.moving->step(shared.bodies, dt);
}

int roundsAt(Fidelity fidelity) {
    return fidelity == Fidelity::PlaneOnly ? kFewRounds : kMaxRounds;
}

bool canBe(const HapticInput& input) noexcept {
    return input.finger.allFinite() && input.fingerVelocity.allFinite();
}

/// Of a hand that has no part in the step.
HapticOutput leftOut(const World& world, const HandState& state) {
    // Contacts of another shape may name bodies and triangles that this world does not have.
    if (state.shapeRevision == world.shapeRevision) return reportOf(world, state);
    HapticOutput output;
    output.proxy = state.proxy.position;
    return output;
}

void touch(const World& world, const StepMotions& movers, HandStep& hand, double dt, int rounds) noexcept {
    HandState& state = hand.state;
    const HapticInput& input = hand.input;
    const ProxyReport report =
        moveAndUpdate(state.proxy, world.obstaclesAt(input.fidelity), world.proxyRadius, input.finger, dt,
                      movers, rounds, &world.near);
    describeSurroundings(world, movers, state, dt);
    hand.output = reportOf(world, state);
    hand.output.report = report;
    hand.output.force = springForce(state.model, hand.output.proxy, input.finger, input.fingerVelocity);
    state.press = {hand.output.force, input.fingerVelocity, input.coupling};
}

} // namespace

void hapticStep(const World& world, WorldState& shared, std::span<HandStep> all, double dt,
                const BodiesTime& bodies) noexcept {
    Hands hands;
    for (HandStep& hand : all)
        if (canBe(hand.input))
            hands.push(&hand);
        else
            hand.output = leftOut(world, hand.state);
    if (hands.size() == 0) return;
    if (bodies.begin) {
        shared.time = 0, shared.bodies.of = 0;
        for (HandStep& hand : all)
            hand.state.shapeRevision = kBeginAnew;
    }
    if (world.moving) beginBodies(world, shared, hands);
    for (HandStep* hand : hands.all())
        if (hand->input.restart || hand->input.found || hand->state.shapeRevision != world.shapeRevision)
            startAnew(world, shared.time, hand->state, hand->input);
    const double time = bodies.pace * (world.moving ? world.moving->scale().time : 1), way = time * dt;
    const double before = std::exchange(shared.time, shared.time + way);
    if (world.moving) moveBodies(world, shared, hands, way, time);
    const StepMotions movers(world.movers, before, shared.time, world.drivenMotions());
    for (HandStep* hand : hands.all())
        touch(world, movers, *hand, dt, roundsAt(hand->input.fidelity));
}

HapticOutput hapticStep(const World& world, SimState& state, const HapticInput& input, double dt,
                        const BodiesTime& bodies) noexcept {
    HandStep hand{state, input};
    hapticStep(world, state, {&hand, 1}, dt, bodies);
    return hand.output;
}

// With few rounds: a long fall is not made twice in one period.
void rehearse(const World& world, const HandState& state, double time, const HapticInput& next, double dt,
              HandState& copy) noexcept {
    if (state.shapeRevision != world.shapeRevision || !canBe(next)) return;
    copy = state;
    HandStep hand{copy, next};
    touch(world, StepMotions(world.movers, time, time, world.drivenMotions()), hand, dt, kFewRounds);
}

} // namespace tactum
