// Device, hand and servo in one loop, tick by tick and deterministic: the product's servo, or a worse one.
#pragma once

#include <deque>
#include <functional>

#include "core/safety/servo_step.h"
#include "tests/physics/plant.h"
#include "tests/support/soups.h"

namespace tactum::test {

/// A reading in, a force out, as at every servo tick; `dt` in s since the last one.
using Control = std::function<Vec3(const DeviceSample&, double dt)>;

class ClosedLoop {
public:
    ClosedLoop(const Bench& bench, Control control, int axes = 1, std::uint64_t seed = 1);

    void tick() { tick(drawPeriod()); }
    /// A tick that comes `dt` seconds after the last one.
    void tick(double dt);
    /// Ticks for a time; seen(*this) after each.
    template <class Seen> void run(double seconds, Seen&& seen) {
        for (const double end = time + seconds; time < end;) {
            tick();
            seen(*this);
        }
    }
    void run(double seconds) {
        run(seconds, [](const ClosedLoop&) {});
    }
    /// The finger where it is, held still: until the forces have come back.
    void warmUp(double seconds = 0.8);

    Plant plant;
    double time = 0;                           ///< s
    Vec3 command = Vec3::Zero();               ///< N, newest
    Vec3 reading = Vec3::Zero();               ///< m, newest
    double watchdog = 0.01;                    ///< s without a tick, after which the device drops its force
    std::function<void(DeviceSample&)> tamper; ///< changes what is read

    const Bench& bench() const { return bench_; }

private:
    double drawPeriod();
    void advance(double dt);
    DeviceSample read() const;
    Vec3 amplified(const Vec3& force) const;

    Bench bench_;
    Control control_;
    Rng random_;
    std::deque<Vec3> onTheWay_;
};

/// Positions as encoders count them.
Vec3 counted(const Vec3& position, double resolution);

} // namespace tactum::test
