#include "tests/physics/plant.h"

#include <cmath>

namespace tactum::test {

PlantAxis::PlantAxis(const PlantProfile& device, const HandProfile& hand)
    : device_(device), hand_(hand), mass_(device.mass + (hand.rigid ? hand.mass : 0)) {}

void PlantAxis::place(double position, double velocity) {
    x = handX = goal = position;
    v = handV = velocity;
    force = given = lost = 0;
}

void PlantAxis::moveHand(double voluntary, double dt) {
    const double pull = hand_.gripStiffness * (x - handX) + hand_.gripDamping * (v - handV);
    const double arm = hand_.armStiffness * (goal - handX) - hand_.armDamping * handV;
    const double before = handV;
    handV += (pull + arm + voluntary) / hand_.mass * dt;
    handX += 0.5 * (before + handV) * dt;
}

PlantAxis::Step PlantAxis::stepOf(double dt) const {
    const double half = 0.5 * device_.damping * dt / mass_, mobility = dt / mass_ / (1 + half);
    const double lag = device_.amplifierLag;
    return {.dt = dt,
            .amplifier = lag > 0 ? -std::expm1(-dt / lag) : 1,
            .keeps = (1 - half) / (1 + half),
            .mobility = mobility,
            .brake = device_.friction * mobility};
}

// Karnopp's dry friction: what it can stop within the step it stops. The mean of old and new velocity makes
// force times way the exact work.
void PlantAxis::advance(double command, double voluntary, double dt) {
    if (dt != step_.dt) step_ = stepOf(dt);
    force = device_.amplifierLag > 0 ? force + (command - force) * step_.amplifier : command;
    double push = force;
    if (hand_.rigid)
        push += hand_.armStiffness * (goal - x) - hand_.armDamping * v + voluntary;
    else if (hand_.mass > 0)
        push -= hand_.gripStiffness * (x - handX) + hand_.gripDamping * (v - handV);
    else
        push += voluntary;
    if (!hand_.rigid && hand_.mass > 0) moveHand(voluntary, dt);

    const double free = v * step_.keeps + push * step_.mobility;
    const double next = std::abs(free) <= step_.brake ? 0 : free - std::copysign(step_.brake, free);
    const double mean = 0.5 * (v + next);
    const double loss = push * mean * dt - 0.5 * mass_ * (next * next - v * v);
    given += force * mean * dt - loss;
    lost += loss;
    x += mean * dt;
    v = next;
}

Plant::Plant(const PlantProfile& device, const HandProfile& hand, int axes) : first_(3 - axes) {
    axis.fill(PlantAxis(device, hand));
}

void Plant::place(const Vec3& position, const Vec3& velocity) {
    for (int i = 0; i < 3; ++i)
        axis[std::size_t(i)].place(position[i], velocity[i]);
}

void Plant::advance(const Vec3& command, double dt) {
    for (int i = first_; i < 3; ++i)
        axis[std::size_t(i)].advance(command[i], voluntary[i], dt);
}

void Plant::setGoal(const Vec3& goal) {
    for (int i = 0; i < 3; ++i)
        axis[std::size_t(i)].goal = goal[i];
}

} // namespace tactum::test
