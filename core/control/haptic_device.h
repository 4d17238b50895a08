// The port to every haptic device, real, simulated or recorded. The servo loop owns it; drivers plug in.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace tactum {

/// What a device can do; the force limiter and the inspector read it.
struct DeviceInfo {
    std::string name;
    double maxForce = 0;           ///< N; no command ever exceeds it
    double maxStiffness = 0;       ///< N/m at 1 kHz, the maker's figure
    double workspaceRadius = 0;    ///< m, largest sphere about the origin of D
    double positionResolution = 0; ///< m
    double rate = 1000;            ///< Hz, exchanges a second that the device expects
};

/// One reading of the device. Frame D, SI.
struct DeviceSample {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    std::uint32_t buttons = 0;
    bool valid = false; ///< false: nothing new was read; the servo then commands zero force
};

/// One command to the device. Frame D, newton; positive force pushes the finger.
struct DeviceCommand {
    Vec3 force = Vec3::Zero();
};

class HapticDevice {
public:
    virtual ~HapticDevice() = default;

    /// Thread: any but real time.
    virtual DeviceInfo info() const = 0;
    /// Thread: any but real time. May allocate, wait and fail with a sentence.
    virtual Result<void> open() = 0;
    virtual void close() = 0;
    /// Sends the command and returns the newest reading. `dt` is the time since the last exchange, in s.
    /// Thread: servo, real time: no allocation, lock or wait but the device's own transfer.
    virtual DeviceSample exchange(const DeviceCommand& command, double dt) noexcept = 0;
};

} // namespace tactum
