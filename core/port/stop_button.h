// A button of the device that ends all force: between the servo and the device, so that nothing has a say.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/port/haptic_device.h"

namespace tactum {

/// Which button it is, and whether it was pressed: it stays so until somebody says otherwise.
struct StopSwitch {
    std::atomic<std::uint32_t> buttons{0}; ///< bits of DeviceSample::buttons; 0: there is none
    std::atomic<bool> pressed{false};
};

/// The device that it is put around, without force from the tick after the one that read the button. It
/// lies in the servo's own exchange: neither window, scene nor proxy loop can keep it from that.
/// Thread of exchange(): servo, real time.
class StopButton final : public HapticDevice {
public:
    StopButton(std::unique_ptr<HapticDevice> device, std::shared_ptr<StopSwitch> stop)
        : device_(std::move(device)), stop_(std::move(stop)) {}

    DeviceInfo info() const override { return device_->info(); }
    std::vector<std::string> steps() const override { return device_->steps(); }
    Result<void> prepare(Opening& opening) override { return device_->prepare(opening); }
    Result<void> open() override { return device_->open(); }
    void close() override { device_->close(); }
    std::string trouble() const override { return device_->trouble(); }
    std::string caution() const override { return device_->caution(); }
    void announce(const DeviceCommand& command) noexcept override {
        device_->announce(stop_->pressed.load(std::memory_order_relaxed) ? DeviceCommand{} : command);
    }
    bool awaitFrame(std::int64_t until) noexcept override { return device_->awaitFrame(until); }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        const bool off = stop_->pressed.load(std::memory_order_relaxed);
        DeviceSample sample = device_->exchange(off ? DeviceCommand{} : command, dt);
        sample.stopped = (sample.buttons & stop_->buttons.load(std::memory_order_relaxed)) != 0;
        if (sample.stopped) stop_->pressed.store(true, std::memory_order_relaxed);
        sample.stopped = sample.stopped || off;
        return sample;
    }
    void emergencyStop() noexcept override { device_->emergencyStop(); }

private:
    std::unique_ptr<HapticDevice> device_;
    std::shared_ptr<StopSwitch> stop_;
};

} // namespace tactum
