// A simulated hand that is guarded by a process of its own, as a real device is.
#pragma once

#include <utility>

#include "device/simulated_hand.h"

namespace tactum::test {

class GuardedHand : public HapticDevice {
public:
    explicit GuardedHand(std::shared_ptr<HandTarget> target) : hand_(std::move(target)) {}
    DeviceInfo info() const override {
        DeviceInfo info = hand_.info();
        info.real = true;
        return info;
    }
    Result<void> open() override { return hand_.open(); }
    void close() override { hand_.close(); }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        return hand_.exchange(command, dt);
    }

private:
    SimulatedHand hand_;
};

} // namespace tactum::test
