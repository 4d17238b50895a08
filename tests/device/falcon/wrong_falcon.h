// What the tests of the self-test share: a device whose maker got something wrong, and a person who leads the
// emulated grip.
#pragma once

#include <array>
#include <memory>

#include "core/port/device_around.h"
#include "core/self_test/trial_bench.h"
#include "tests/device/falcon/emulated_falcon.h"

namespace tactum::test {

/// Of the emulated grip, when nobody holds it.
inline constexpr FalconBody::Hand kFreeGrip{.mass = 0.15, .stiffness = 0, .damping = 1.2};

struct Wrong {
    Vec3 scale{1, 1, 1}; ///< of the readings
    Vec3 motor{1, 1, 1};
    std::size_t late = 0; ///< ticks, of the commands
};

class WrongDevice final : public DeviceAround {
public:
    WrongDevice(std::unique_ptr<HapticDevice> device, const Wrong& wrong)
        : DeviceAround(std::move(device)), wrong_(wrong) {}

    void announce(const DeviceCommand&) noexcept override {} // or it would come before it is late
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        onTheWay_[tick_ % onTheWay_.size()] = command.force;
        const Vec3 force = onTheWay_[(tick_ + onTheWay_.size() - wrong_.late) % onTheWay_.size()];
        ++tick_;
        DeviceSample sample = device().exchange({force.cwiseProduct(wrong_.motor)}, dt);
        sample.position = sample.position.cwiseProduct(wrong_.scale);
        return sample;
    }

private:
    Wrong wrong_;
    std::array<Vec3, 32> onTheWay_{};
    std::size_t tick_ = 0;
};

/// As a person would, but for the mass and the buttons.
inline void doAsAsked(EmulatedFalcon& falcon, TrialAsk what) {
    const bool led =
        what == TrialAsk::Zero || what == TrialAsk::Right || what == TrialAsk::Up || what == TrialAsk::Toward;
    falcon.setHand(led ? FalconBody::Hand{} : kFreeGrip);
    falcon.putGrip(what == TrialAsk::Right    ? Vec3(kRulerWay, 0, 0)
                   : what == TrialAsk::Up     ? Vec3(0, kRulerWay, 0)
                   : what == TrialAsk::Toward ? Vec3(0, 0, kRulerWay)
                                              : Vec3(0, 0, 0));
}

} // namespace tactum::test
