// What a hand feels of something that happens to it.
#pragma once

#include "tests/physics/closed_loop.h"

namespace tactum::test {

/// From now on, for some seconds.
struct Event {
    double speed = 0;   ///< m/s, of the device, largest
    double jump = 0;    ///< N, of the command from tick to tick, largest
    double given = 0;   ///< J, to the hand and into motion, largest
    double peak = 0;    ///< N, largest command
    bool finite = true; ///< every command
};

template <class Each> Event watchEvent(ClosedLoop& loop, double seconds, Each&& each) {
    Event event;
    const double before = loop.plant.given();
    Vec3 last = loop.command;
    loop.run(seconds, [&](ClosedLoop& now) {
        event.speed = std::max(event.speed, now.plant.velocity().norm());
        event.jump = std::max(event.jump, (now.command - last).norm());
        event.given = std::max(event.given, now.plant.given() - before);
        event.peak = std::max(event.peak, now.command.norm());
        event.finite = event.finite && now.command.allFinite();
        last = now.command;
        each(now);
    });
    return event;
}
inline Event watchEvent(ClosedLoop& loop, double seconds) {
    return watchEvent(loop, seconds, [](ClosedLoop&) {});
}

} // namespace tactum::test
