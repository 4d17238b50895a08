// A simulated hand that gives trouble when the test wants it.
#pragma once

#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <thread>

#include "core/port/haptic_device.h"

namespace tactum {

/// What the test and the device share.
struct Trouble {
    std::atomic<bool> nonsense{false}; ///< the readings are no numbers
    std::atomic<bool> slow{false};     ///< every exchange takes 30 ms
    std::atomic<bool> late{false};     ///< every exchange takes 3 ms
    std::atomic<bool> jitters{false};  ///< 8 of 300 exchanges do
    std::atomic<bool> hangs{false};    ///< no exchange comes back while it is so
    double continuousForce = 0;        ///< N, of DeviceInfo
    double maxStiffness = 0;           ///< N/m, of DeviceInfo
    int buttons = 1;                   ///< of DeviceInfo
};

class TroubledHand final : public HapticDevice {
public:
    TroubledHand(std::unique_ptr<HapticDevice> hand, std::shared_ptr<Trouble> trouble)
        : hand_(std::move(hand)), trouble_(std::move(trouble)) {}

    DeviceInfo info() const override {
        DeviceInfo info = hand_->info();
        info.continuousForce = trouble_->continuousForce;
        info.maxStiffness = trouble_->maxStiffness;
        info.buttons = trouble_->buttons;
        return info;
    }
    Result<void> open() override { return hand_->open(); }
    void close() override { hand_->close(); }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        const bool inBurst = trouble_->jitters && ticks_++ % 300 < 8;
        if (trouble_->late || inBurst) std::this_thread::sleep_for(std::chrono::milliseconds(3));
        if (trouble_->slow) std::this_thread::sleep_for(std::chrono::milliseconds(30));
        while (trouble_->hangs)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        DeviceSample sample = hand_->exchange(command, dt);
        if (trouble_->nonsense) sample.position.setConstant(std::numeric_limits<double>::quiet_NaN());
        return sample;
    }

private:
    std::unique_ptr<HapticDevice> hand_;
    std::shared_ptr<Trouble> trouble_;
    int ticks_ = 0;
};

} // namespace tactum
