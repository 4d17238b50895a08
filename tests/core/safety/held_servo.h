// A servo whose finger is where the test puts it.
#pragma once

#include <algorithm>
#include <utility>

#include "core/safety/servo_step.h"

namespace tactum::test {

inline constexpr double kTick = 1e-3; // s

/// The half-space below z = 0, with a proxy that is on it.
inline LocalContactModel wall(double stiffness, double friction = 0) {
    LocalContactModel model;
    model.planes = 1;
    model.plane[0] = {Vec3::UnitZ(), 0};
    model.friction[0].coefficient = friction;
    model.stiffness = stiffness;
    model.valid = true;
    return model;
}

/// A servo whose finger stays where the test puts it.
struct Held {
    explicit Held(const DeviceInfo& device = info()) : state(device) {
        settings.armed = settings.overrideCeiling = true;
    }
    static DeviceInfo info() {
        DeviceInfo info;
        info.maxForce = 20;
        return info;
    }
    Vec3 tick(const Vec3& finger, double dt = kTick) {
        DeviceSample sample;
        sample.position = finger;
        sample.valid = true;
        sample.buttons = buttons;
        model.anchoring = state.gate.anchoring();
        if (repeats) unread_ += dt;
        output = servoStep(state, settings,
                           {.sample = sample,
                            .frame = frame,
                            .dt = dt,
                            .apart = repeats ? 0 : dt + std::exchange(unread_, 0),
                            .fresh = fresh,
                            .clutched = clutched,
                            .outside_D = outside,
                            .border = border},
                           model);
        return output.force;
    }
    void rest(const Vec3& finger, int ticks = 1000) {
        for (int i = 0; i < ticks; ++i)
            tick(finger);
    }
    /// As slowly as a hand does.
    void go(double from, double to) {
        for (int i = 0; i <= 200; ++i)
            tick({0, 0, from + (to - from) * i / 200});
    }

    ServoState state;
    ServoSettings settings;
    LocalContactModel model;
    std::uint32_t buttons = 0;
    DeviceFrame frame;
    bool clutched = false;
    Vec3 outside = Vec3::Zero(); ///< N, that others add
    double border = 0;           ///< m, of rate control
    bool repeats = false;        ///< the device says nothing new: the reading is that of the tick before
    bool fresh = true;           ///< the model is a newer one at every tick
    ServoOutput output;

private:
    double unread_ = 0; ///< s
};

/// Largest change from tick to tick until nothing changes any more.
inline double largestChange(Held& held, const Vec3& finger, const Vec3& before) {
    double largest = 0;
    Vec3 last = before;
    for (int i = 0; i < 6000; ++i) {
        const Vec3 force = held.tick(finger);
        largest = std::max(largest, (force - last).norm());
        last = force;
    }
    return largest;
}

} // namespace tactum::test
