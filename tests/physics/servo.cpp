#include "tests/physics/servo.h"

#include <algorithm>

#include "core/runtime/proxy_loop.h"
#include "core/safety/model_in_device.h"

namespace tactum::test {

LocalContactModel wall(double stiffness, double damping) {
    LocalContactModel model;
    model.planes = 1;
    model.plane[0] = {Vec3::UnitZ(), 0};
    model.stiffness = stiffness;
    model.damping = damping;
    model.valid = true;
    return model;
}

void Proxy::step(const FingerSample& finger) {
    const bool found = finger.anchoring != anchoring_;
    anchoring_ = state.model.anchoring = finger.anchoring;
    const double dt = std::clamp(time_ - last_, kShortestStep, kLongestStep);
    last_ = time_;
    output = hapticStep(*world, state,
                        {.finger = finger.position,
                         .fingerVelocity = finger.velocity,
                         .found = found,
                         .coupling = coupled ? finger.coupling : Coupling{}},
                        dt);
    onTheWay_.push_back({time_ + latency, state.model});
}

bool Proxy::answer(const FingerSample& finger, double dt, LocalContactModel& model) {
    time_ += dt;
    constexpr double kRounding = 1e-9;
    if (finger.valid && time_ >= due_ - kRounding) {
        due_ = std::max(due_ + 1 / rate, time_);
        step(finger);
    }
    bool fresh = false;
    while (!onTheWay_.empty() && onTheWay_.front().time <= time_ + kRounding) {
        model = onTheWay_.front().model;
        onTheWay_.pop_front();
        fresh = true;
    }
    return fresh;
}

DeviceFrame Servo::frameOf(const DeviceSample& sample, double dt) {
    if (!workspace_) return {};
    around_.forces = state.gate.gain() > 0;
    lookAround(around_, model);
    return workspace_->follow(sample, around_, dt);
}

Vec3 Servo::operator()(const DeviceSample& sample, double dt) {
    const DeviceFrame frame = frameOf(sample, dt);
    output = servoStep(state, settings,
                       {.sample = sample,
                        .frame = frame,
                        .dt = dt,
                        .apart = readings_(sample, dt, 0),
                        .late = dt > 2 * period_,
                        .fresh = fresh_,
                        .border = workspace_ ? workspace_->border() : 0},
                       model);
    around_.pushing = !output.force.isZero(0);
    fresh_ = surroundings_.answer(output.finger, dt, model);
    return output.force;
}

} // namespace tactum::test
