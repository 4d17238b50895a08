#include "tests/physics/plant.h"

#include <cmath>

namespace tactum::test {

Plant::Plant(const PlantProfile& device, const HandProfile& hand, int axes)
    : device_(device), hand_(hand), moves_(axes == 1 ? Axes(0, 0, 1, 0) : Axes(1, 1, 1, 0)),
      mass_(device.mass + (hand.rigid ? hand.mass : 0)) {}

void Plant::place(const Vec3& position, const Vec3& velocity) {
    x = handX = goal = lanes(position);
    v = handV = lanes(velocity);
    force = given_ = Axes::Zero();
}

void Plant::moveHand(const Axes& muscles) {
    const Axes pull = hand_.gripStiffness * (x - handX) + hand_.gripDamping * (v - handV);
    const Axes arm = hand_.armStiffness * (goal - handX) - hand_.armDamping * handV;
    const Axes before = handV;
    handV += (pull + arm + muscles) / hand_.mass * step_.time;
    handX += 0.5 * (before + handV) * step_.time;
}

Plant::Step Plant::stepOf(double dt) const {
    const double half = 0.5 * device_.damping * dt / mass_, mobility = dt / mass_ / (1 + half);
    const double lag = device_.amplifierLag;
    return {.dt = dt,
            .amplifier = lag > 0 ? -std::expm1(-dt / lag) : 1,
            .keeps = (1 - half) / (1 + half),
            .time = dt * moves_,
            .mobility = mobility * moves_,
            .brake = device_.friction * mobility * moves_};
}

// Karnopp's dry friction: what it can stop within the step it stops. The mean of old and new velocity makes
// force times way the exact work.
void Plant::advance(const Vec3& command, double dt) {
    if (dt != step_.dt) step_ = stepOf(dt);
    const Axes commanded = lanes(command), muscles = lanes(voluntary);
    if (device_.amplifierLag > 0)
        force += (commanded - force) * step_.amplifier;
    else
        force = commanded;
    Axes push = force;
    const bool soft = !hand_.rigid && hand_.mass > 0;
    if (hand_.rigid)
        push += hand_.armStiffness * (goal - x) - hand_.armDamping * v + muscles;
    else if (soft)
        push -= hand_.gripStiffness * (x - handX) + hand_.gripDamping * (v - handV);
    else
        push += muscles;
    if (soft) moveHand(muscles);

    const Axes free = v * step_.keeps + push * step_.mobility;
    const Axes next = free - free.min(step_.brake).max(-step_.brake);
    const Axes mean = 0.5 * (v + next);
    const Axes loss = push * mean * step_.time - 0.5 * mass_ * (next * next - v * v);
    given_ += force * mean * step_.time - loss;
    x += mean * step_.time;
    v = next;
}

} // namespace tactum::test
