// A button of the device that ends all force: between the servo and the device, so that nothing has a say.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/port/device_around.h"

namespace tactum {

/// Which button it is, and whether it was pressed: it stays so until somebody says otherwise.
struct StopSwitch {
    std::atomic<std::uint32_t> buttons{0}; ///< bits of DeviceSample::buttons; 0: there is none
    std::atomic<bool> pressed{false};
};

/// The device that it is put around, without force from the tick after the one that read the button. It
/// lies in the servo's own exchange: neither window, scene nor proxy loop can keep it from that.
/// Thread of exchange(): servo, real time.
class StopButton final : public DeviceAround {
public:
    StopButton(std::unique_ptr<HapticDevice> device, std::shared_ptr<StopSwitch> stop)
        : DeviceAround(std::move(device)), stop_(std::move(stop)) {}

    void announce(const DeviceCommand& command) noexcept override {
        device().announce(stop_->pressed.load(std::memory_order_relaxed) ? DeviceCommand{} : command);
    }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        const bool off = stop_->pressed.load(std::memory_order_relaxed);
        DeviceSample sample = device().exchange(off ? DeviceCommand{} : command, dt);
        sample.stopped = (sample.buttons & stop_->buttons.load(std::memory_order_relaxed)) != 0;
        if (sample.stopped) stop_->pressed.store(true, std::memory_order_relaxed);
        sample.stopped = sample.stopped || off;
        return sample;
    }

private:
    std::shared_ptr<StopSwitch> stop_;
};

} // namespace tactum
