// A device of each driver on the bench, with what the bench sees of its motors.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum::test {

/// One device, plugged in and closed. Thread: the test's.
class Rig {
public:
    virtual ~Rig() = default;

    virtual HapticDevice& device() = 0;
    /// The driver goes, as it is.
    virtual void destroyDevice() = 0;
    /// All that a person has to do, then open().
    virtual Result<void> open() { return device().open(); }
    /// One exchange, and the device's own time goes on by about a millisecond.
    virtual DeviceSample exchange(const Vec3& force);
    /// N, frame D, what the motors do to the finger; nullopt where the bench cannot see it.
    virtual std::optional<Vec3> pushed() const { return {}; }
    /// Out of its socket, and back; false: there is no cable.
    virtual bool pull() { return false; }
    virtual void plug() {}
    /// Whether it has motors along this axis of D.
    virtual bool pushesAlong(int) const { return true; }
    /// Whether emergencyStop() has a way to the device: no maker's library that the servo calls has.
    virtual bool stops() const { return true; }
};

/// Names of all drivers.
const std::vector<std::string>& rigNames();
std::unique_ptr<Rig> makeRig(const std::string& name);

} // namespace tactum::test
