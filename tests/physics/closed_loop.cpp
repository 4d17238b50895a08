#include "tests/physics/closed_loop.h"

#include <algorithm>
#include <cmath>

namespace tactum::test {

Vec3 counted(const Vec3& position, double resolution) {
    if (!(resolution > 0)) return position;
    return position.unaryExpr([=](double x) { return resolution * std::floor(x / resolution + 0.5); });
}

ClosedLoop::ClosedLoop(const DeviceProfile& device, const HandProfile& hand, const Timing& timing,
                       Control control, int axes, std::uint64_t seed)
    : plant(device, hand, axes), device_(device), timing_(timing), control_(std::move(control)),
      random_(seed), onTheWay_(std::size_t(timing.delay) + 1, Vec3::Zero()) {}

double ClosedLoop::drawPeriod() {
    const double period = timing_.period();
    return timing_.jitter > 0 ? period * (1 + uniform(random_, -timing_.jitter, timing_.jitter)) : period;
}

Vec3 ClosedLoop::amplified(const Vec3& force) const {
    const double most = device_.maxForce;
    return counted(force, device_.forceStep).cwiseMin(most).cwiseMax(-most);
}

void ClosedLoop::advance(double dt) {
    const Vec3 held = amplified(onTheWay_.front());
    const double step = timing_.period() / timing_.substeps;
    const int steps = std::max(1, int(std::lround(dt / step)));
    for (int i = 0; i < steps; ++i)
        plant.advance(i * step < watchdog ? held : Vec3::Zero(), dt / steps);
    time += dt;
}

DeviceSample ClosedLoop::read() const {
    DeviceSample sample;
    sample.position = counted(plant.position(), device_.resolution);
    sample.valid = true;
    return sample;
}

void ClosedLoop::tick(double dt) {
    advance(dt);
    DeviceSample sample = read();
    if (tamper) tamper(sample);
    reading = sample.position;
    command = control_(sample, dt);
    onTheWay_.pop_front();
    onTheWay_.push_back(command);
}

void ClosedLoop::warmUp(double seconds) {
    const DeviceSample still = read();
    for (double t = 0; t < seconds; t += timing_.period())
        control_(still, timing_.period());
}

} // namespace tactum::test
