// The product's servo as a control of the closed loop, with the proxy that answers it.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "core/haptics/haptic_step.h"
#include "core/port/reading_clock.h"
#include "core/port/workspace.h"
#include "core/safety/servo_step.h"
#include "tests/physics/closed_loop.h"

namespace tactum::test {

/// The half-space below z = 0, felt by a proxy of no size.
LocalContactModel wall(double stiffness, double damping = 0);

/// Whoever answers the finger with local contact models.
class Surroundings {
public:
    virtual ~Surroundings() = default;
    /// Called at every servo tick, after it. Returns whether `model` is a new one.
    virtual bool answer(const FingerSample& finger, double dt, LocalContactModel& model) = 0;
};

/// A model that the test writes: answers at once.
class GivenModel final : public Surroundings {
public:
    explicit GivenModel(const LocalContactModel& theModel) : model(theModel) {}
    bool answer(const FingerSample& finger, double, LocalContactModel& answer) override {
        if (silent) return false;
        answer = model;
        answer.anchoring = finger.anchoring;
        return true;
    }

    LocalContactModel model;
    bool silent = false;
};

/// The product's haptic step at a rate of its own, its answers `latency` late, as the proxy loop runs it.
class Proxy final : public Surroundings {
public:
    Proxy(std::shared_ptr<const World> theWorld, double theRate, double theLatency = 0)
        : world(std::move(theWorld)), rate(theRate), latency(theLatency) {}
    bool answer(const FingerSample& finger, double dt, LocalContactModel& model) override;

    std::shared_ptr<const World> world;
    double rate;         ///< Hz
    double latency;      ///< s
    bool coupled = true; ///< false: bodies get what the model says, whatever the hand gets of it
    SimState state;
    HapticOutput output; ///< of the newest step

private:
    void step(const FingerSample& finger);

    double time_ = 0, due_ = 0, last_ = 0;
    std::uint32_t anchoring_ = 0;
    struct Answer {
        double time;
        LocalContactModel model;
    };
    std::deque<Answer> onTheWay_;
};

/// The product's servoStep() with what the servo loop does around it.
class Servo {
public:
    Servo(const DeviceInfo& info, Surroundings& surroundings)
        : state(info), info_(info), surroundings_(surroundings), period_(1 / info.rate) {
        settings.armed = true;
    }

    Vec3 operator()(const DeviceSample& sample, double dt);
    /// This servo as the control of a loop that it outlives.
    Control control() {
        return [this](const DeviceSample& sample, double dt) { return (*this)(sample, dt); };
    }

    /// Lays the device's workspace into the scene, and moves it along.
    void lay(const Workspace& workspace) {
        workspace_.emplace(info_);
        workspace_->decide(workspace);
    }

    ServoState state;
    ServoSettings settings;
    ServoOutput output;
    LocalContactModel model; ///< newest answer

private:
    DeviceFrame frameOf(const DeviceSample& sample, double dt);

    DeviceInfo info_;
    std::optional<WorkspaceTracker> workspace_; ///< none: the device's frame is the world's
    AroundHand around_;
    Surroundings& surroundings_;
    double period_;
    bool fresh_ = false;
    ReadingClock readings_;
};

} // namespace tactum::test
