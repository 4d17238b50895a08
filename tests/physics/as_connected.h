// Loops as people have them: a shipped profile's figures, its ticks of delay included, in some hand.
#pragma once

#include "tests/physics/profiles.h"

namespace tactum::test {

/// A device, and what its driver says of it.
struct Connected {
    PlantProfile plant;
    int delay = 0;            ///< ticks, from reading to force
    double makersCeiling = 0; ///< N/m
    double continuous = 0;    ///< N
};

/// The figures of resources/devices, with the delay that the way through the maker's scheduler, the device's
/// process and the servo has.
inline constexpr Connected kPremiumConnected{
    {"premium", 0.075, 0.075, 0.04, 30e-6, 8.5, 0.5e-3}, 3, 800, 1.4};
inline constexpr Connected kOmegaConnected{{"omega", 0.2, 0.3, 0.1, 10e-6, 12, 0.3e-3}, 2, 5000, 0};
inline constexpr Connected kTouchConnected{{"touch", 0.05, 0.1, 0.05, 55e-6, 3.3, 0.5e-3}, 3, 400, 0.88};
inline constexpr Connected kFalconConnected{{"falcon", 0.15, 0.5, 0.3, 60e-6, 8, 0.5e-3}, 2, 3000, 0};
inline constexpr std::array kConnected{kPremiumConnected, kOmegaConnected, kTouchConnected, kFalconConnected};

inline Bench benchOf(const Connected& device, const HandProfile& hand) {
    return {device.plant, hand, {.delay = device.delay}};
}

/// As the driver says it, who knows of a light pinch alone.
inline DeviceInfo connectedInfo(const Connected& device) {
    DeviceInfo info = infoOf(benchOf(device, kPinch));
    info.maxStiffness = device.makersCeiling;
    info.continuousForce = device.continuous;
    return info;
}

} // namespace tactum::test
