#include "tests/physics/closed_loop.h"

#include <algorithm>
#include <cmath>

namespace tactum::test {

Vec3 counted(const Vec3& position, double resolution) {
    if (!(resolution > 0)) return position;
    return position.unaryExpr([=](double x) { return resolution * std::floor(x / resolution + 0.5); });
}

ClosedLoop::ClosedLoop(const Bench& bench, Control control, int axes, std::uint64_t seed)
    : plant(bench.device, bench.hand, axes), bench_(bench), control_(std::move(control)), random_(seed),
      onTheWay_(std::size_t(bench.timing.delay) + 1, Vec3::Zero()) {}

double ClosedLoop::drawPeriod() {
    const double period = bench_.timing.period();
    return bench_.timing.jitter > 0
               ? period * (1 + uniform(random_, -bench_.timing.jitter, bench_.timing.jitter))
               : period;
}

Vec3 ClosedLoop::amplified(const Vec3& force) const {
    const double most = bench_.device.maxForce;
    return counted(force, bench_.device.forceStep).cwiseMin(most).cwiseMax(-most);
}

void ClosedLoop::advance(double dt) {
    const Vec3 held = amplified(onTheWay_.front());
    const double step = bench_.timing.period() / bench_.timing.substeps;
    const int steps = std::max(1, int(std::lround(dt / step)));
    for (int i = 0; i < steps; ++i)
        plant.advance(i * step < watchdog ? held : Vec3::Zero(), dt / steps);
    time += dt;
}

DeviceSample ClosedLoop::read() const {
    DeviceSample sample;
    sample.position = counted(plant.position(), bench_.device.resolution);
    sample.valid = true;
    return sample;
}

void ClosedLoop::tick(double dt) {
    advance(dt);
    // As the servo loop does it: nobody has felt the force of before a stall since.
    if (dt > kStall && onTheWay_.size() > 1) onTheWay_.back().setZero();
    DeviceSample sample = read();
    if (tamper) tamper(sample);
    reading = sample.position;
    command = control_(sample, dt);
    onTheWay_.pop_front();
    onTheWay_.push_back(command);
}

void ClosedLoop::warmUp(double seconds) {
    const DeviceSample still = read();
    for (double t = 0; t < seconds; t += bench_.timing.period())
        control_(still, bench_.timing.period());
}

} // namespace tactum::test
