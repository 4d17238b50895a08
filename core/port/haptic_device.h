// The port to every haptic device, real, simulated or recorded. The servo loop owns it; drivers plug in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/port/handle.h"
#include "core/port/opening.h"

namespace tactum {

/// What a device can do; the guard and the inspector read it.
struct DeviceInfo {
    std::string name;
    double maxForce = 0;           ///< N; no command ever exceeds it
    double continuousForce = 0;    ///< N, that its motors bear for ever; 0: as much as maxForce
    double maxStiffness = 0;       ///< N/m at 1 kHz, the maker's figure; 0: not known
    double workspaceRadius = 0;    ///< m, largest sphere about the origin of D
    double positionResolution = 0; ///< m
    double rate = 1000;            ///< Hz, exchanges a second that the device expects
    double damping = 0;            ///< N s/m, its own, at least
    double handDamping = 2;        ///< N s/m, of the hand that holds it, at least: of a light pinch
    double dryFriction = 0;        ///< N, its own, at least
    double amplifierLag = 0;       ///< s, time constant from command to force
    double delay = 1;              ///< ticks between reading and the force that answers it
    int buttons = 0;               ///< on its handle: the lowest bits of DeviceSample::buttons
    bool real = false;             ///< it pushes a hand: a device watchdog stands by while it is open
    double tripSpeed = 1.5;        ///< m/s; a finger that is faster was let go: the force is taken away
    double maxTorque = 0;          ///< N m, on its handle; 0: it has no motors for that, or it is not known
    double maxPinch = 0;           ///< N, of its gripper, likewise
    bool measuresVelocity = false; ///< false: the servo makes the velocities itself, from the positions
};

/// One reading of the device. Frame D, SI.
struct DeviceSample {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero(); ///< where the device measures it
    std::uint32_t buttons = 0;    ///< a bit for each that is held
    bool valid = false;           ///< false: nothing new was read; after 10 ms of it the force is taken away
    bool jumped = false;  ///< the finger did not go here but was put here, as only a simulated one can be
    bool stopped = false; ///< a button of the device has ended all force: the next command will not go out
    std::int64_t at = 0;  ///< ns of monotonicNanoseconds(), when it was measured; 0: during this exchange
};

/// One command to the device. Frame D, newton; positive force pushes the finger.
struct DeviceCommand {
    Vec3 force = Vec3::Zero();
    HandleCommand handle{};
};

class HapticDevice {
public:
    virtual ~HapticDevice() = default;

    /// Thread: any but real time.
    virtual DeviceInfo info() const = 0;
    /// What prepare() goes through, in order, as the person reads it. Thread: any but real time.
    virtual std::vector<std::string> steps() const { return {}; }
    /// All that takes long or needs a person at hand: drivers, firmware, homing. What is ready already is not
    /// done again. The device stays as it is then, without force, until open() or the end of the object.
    /// Thread: a worker.
    virtual Result<void> prepare(Opening&) { return {}; }
    /// Prepares unattended what prepare() has not. Thread: any but real time. May allocate, wait and fail
    /// with a sentence.
    virtual Result<void> open() = 0;
    /// Zero force first.
    virtual void close() = 0;
    /// Why readings do not come or cannot be used, with what to do; empty while all is well.
    /// Thread: any but real time, also while exchange() runs.
    virtual std::string trouble() const { return {}; }
    /// What of its own safety this device lacks while it is open, with what to do; empty when nothing.
    /// Thread: as trouble().
    virtual std::string caution() const { return {}; }
    /// Sends the command and returns the newest reading. `dt` is the time since the last exchange, in s.
    /// Thread: servo, real time: no allocation, lock or wait but those of the device's own transfer, which
    /// for USB are libusb's (docs/decisions/usb.md).
    virtual DeviceSample exchange(const DeviceCommand& command, double dt) noexcept = 0;
    /// How the handle was turned and gripped at the last exchange. Thread: servo, real time.
    virtual HandleReading handle() noexcept { return {}; }
    /// Waits until there is a reading that exchange() has not returned yet, at most until a moment in ns of
    /// monotonicNanoseconds(). False, at once: it cannot tell, and the loop's own clock decides. Two clocks
    /// that run freely cost a tick of delay. Thread: servo, outside every RealtimeScope.
    virtual bool awaitFrame(std::int64_t) noexcept { return false; }
    /// The command that the next exchange() will send, as soon as it is known: for whoever hands it on to
    /// another loop, which would else get it a tick later. Once for each reading. Thread: servo, real time.
    virtual void announce(const DeviceCommand&) noexcept {}
    /// Brings the device to zero force by the shortest way, because the program is dying or stands still.
    /// Thread: any, also a signal handler and a forked child, also while exchange() runs: only what is
    /// async-signal-safe.
    virtual void emergencyStop() noexcept {}
};

} // namespace tactum
