// A device that gives less than it can, because the person wants no more.
#pragma once

#include <algorithm>

#include "core/port/device_around.h"

namespace tactum {

/// Whoever asks for its figures hears of the lower force: the servo holds every stage to it, plots draw it,
/// recordings have it, and the device's own limit stays behind it.
class OwnLimit final : public DeviceAround {
public:
    /// `force`: N, above 0; what is more than the device can changes nothing.
    OwnLimit(std::unique_ptr<HapticDevice> device, double force)
        : DeviceAround(std::move(device)), force_(force) {}

    DeviceInfo info() const override {
        DeviceInfo info = device().info();
        info.maxForce = std::min(info.maxForce, force_);
        info.continuousForce = std::min(info.continuousForce, force_); // 0 stays as much as maxForce
        return info;
    }

private:
    double force_;
};

} // namespace tactum
