// One servo tick: a reading and the newest local contact model in, a force out that the device may be given.
// A plain function, the same in the servo loop, in the closed-loop simulator and in replay.
#pragma once

#include "core/haptics/coupling.h"
#include "core/port/device_frame.h"
#include "core/port/force_limiter.h"
#include "core/port/haptic_device.h"
#include "core/safety/added_damping.h"
#include "core/safety/border_spring.h"
#include "core/safety/contact_transition.h"
#include "core/safety/force_gate.h"
#include "core/safety/motor_heat.h"
#include "core/safety/outside_force.h"
#include "core/safety/passivity.h"
#include "core/safety/sample_check.h"
#include "core/safety/stiffness_schedule.h"

namespace tactum {

/// Where the finger is. World frame, SI.
struct FingerSample {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    std::uint64_t tick = 0; ///< of the servo
    bool valid = false;
    std::uint32_t anchoring = 0; ///< another number than before: the proxy has to begin at the finger
    Coupling coupling{};         ///< with what it pushes
};

/// What the person and the machine decide about the loop.
struct ServoSettings {
    bool armed = false;           ///< forces on
    bool fading = false;          ///< forces off, gently (kFadeAway)
    std::uint32_t deadMan = 0;    ///< buttons of which one must be held, and was let go before; 0: none
    bool overrideCeiling = false; ///< the person knows better than safeStiffness(); from the next contact on
    bool grasped = false;         ///< the person says that the whole hand holds the device; likewise
    double period = 0;            ///< s, measured, where it is worse than the nominal one; else 0
};

struct ServoInput {
    DeviceSample sample;
    DeviceFrame frame{};           ///< where the device is in the scene
    double dt = 1e-3;              ///< s since the last tick
    double apart = 1e-3;           ///< s between the last two readings; 0: there is no new one (ReadingClock)
    bool late = false;             ///< the tick came more than one period late
    bool fresh = false;            ///< the model is another one than at the last tick
    bool unguarded = false;        ///< nobody would stop the device if the program died
    bool clutched = false;         ///< the device moves and the finger stays: `frame` sees to that
    Vec3 outside_D = Vec3::Zero(); ///< N, that somebody else wants added to the force: see OutsideForce
    double border = 0;             ///< m about the device's centre, where rate control begins; 0: nowhere
};

/// What one tick leaves to the next, beside what each stage remembers itself. Frame D, SI.
struct Previous {
    Vec3 finger_D = Vec3::Zero();
    Vec3 anchor_D = Vec3::Zero();  ///< of the rendered model
    Vec3 added_D = Vec3::Zero();   ///< N, of the added damping
    Vec3 outside_D = Vec3::Zero(); ///< N, of the outside force that was added, before the gain
    double gain = 0;               ///< of the gate
    double load = 0;               ///< N, of the spring before the gain
    bool touching = false;
};

/// All that the servo remembers from tick to tick: its stages in their order. Copied whole by the recorder.
struct ServoState {
    explicit ServoState(const DeviceInfo& device) noexcept;

    SampleCheck check;
    StiffnessSchedule schedule;
    ContactTransition transition;
    ForceGate gate;
    Passivity passivity;
    AddedDamping damper;
    BorderSpring border;
    MotorHeat heat;
    ForceLimiter limiter;

    Previous previous;
    std::uint64_t ticks = 0;
    double unread = 0;       ///< s since the newest reading that was believed came
    double modelAge = 1e9;   ///< s since the newest model came
    std::uint32_t letGo = 0; ///< buttons that were seen let go since the device came
};

struct ServoOutput {
    Vec3 force = Vec3::Zero(); ///< N, frame D: finite, and never above the device's limit
    FingerSample finger;       ///< for the proxy loop
    DeviceFrame frame;         ///< of the input
    double border = 0;         ///< of the input
    bool limited = false;      ///< the force was shortened to what the motors bear
};

/// Nine stages, in the order of trust: what is last cannot be overruled. All of it happens in the hand's
/// measure, frame D, so that no scale of the workspace changes what a hand or a device can bear; `model_W`
/// and the finger that comes out are the world's. The border of rate control gets what room the rest leaves.
/// docs/stability.md has each stage's reason, bound and test. Deterministic. Thread: real time; bounded:
/// nearestPoint() a dozen times.
ServoOutput servoStep(ServoState& state, const ServoSettings& settings, const ServoInput& input,
                      const LocalContactModel& model_W) noexcept;

} // namespace tactum
