// Something between the servo and a device: what it does not say otherwise is the device's own.
#pragma once

#include <memory>
#include <utility>

#include "core/port/haptic_device.h"

namespace tactum {

/// Threads are those of the device's members.
class DeviceAround : public HapticDevice {
public:
    explicit DeviceAround(std::unique_ptr<HapticDevice> device) : device_(std::move(device)) {}

    DeviceInfo info() const override { return device_->info(); }
    std::vector<std::string> steps() const override { return device_->steps(); }
    Result<void> prepare(Opening& opening) override { return device_->prepare(opening); }
    Result<void> open() override { return device_->open(); }
    void close() override { device_->close(); }
    std::string trouble() const override { return device_->trouble(); }
    std::string caution() const override { return device_->caution(); }
    void announce(const DeviceCommand& command) noexcept override { device_->announce(command); }
    bool awaitFrame(std::int64_t until) noexcept override { return device_->awaitFrame(until); }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        return device_->exchange(command, dt);
    }
    HandleReading handle() noexcept override { return device_->handle(); }
    void emergencyStop() noexcept override { device_->emergencyStop(); }

protected:
    HapticDevice& device() noexcept { return *device_; }
    const HapticDevice& device() const noexcept { return *device_; }

private:
    std::unique_ptr<HapticDevice> device_;
};

} // namespace tactum
