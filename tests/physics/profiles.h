// Devices and hands of the closed-loop tests, as data. Assumed ranges, not calibrations. SI.
#pragma once

#include <array>

#include "core/port/haptic_device.h"

namespace tactum::test {

/// One axis of a device.
struct PlantProfile {
    const char* name = "";
    double mass = 0;         ///< kg
    double damping = 0;      ///< N s/m
    double friction = 0;     ///< N, dry
    double resolution = 0;   ///< m; 0: none
    double maxForce = 0;     ///< N
    double amplifierLag = 0; ///< s
    double forceStep = 0;    ///< N, of the converter; 0: none
};

inline constexpr double kLag300Hz = 1 / (2 * 3.14159265358979 * 300); ///< s

inline constexpr PlantProfile kTouch{"touch-like", 0.05, 0.1, 0.05, 55e-6, 3.3};
inline constexpr PlantProfile kFalcon{"falcon-like", 0.15, 0.5, 0.3, 60e-6, 8.9};
inline constexpr PlantProfile kLowFriction{"low-friction", 0.1, 0.05, 0.02, 30e-6, 8};
inline constexpr PlantProfile kPremium{"premium-like", 0.075, 0.05, 0.04, 30e-6, 8.5};
inline constexpr PlantProfile kHeavy{"heavy", 0.2, 1, 0.2, 30e-6, 20};
inline constexpr std::array kDevices{kTouch, kFalcon, kLowFriction, kPremium, kHeavy};

inline PlantProfile lagging(PlantProfile device, double lag = kLag300Hz) {
    device.amplifierLag = lag;
    return device;
}

/// The hand on one axis: a mass on the arm's spring and damper, coupled to the device by the grip's. Rigid:
/// the device's mass and the hand's are one. Without mass nobody holds the device.
struct HandProfile {
    const char* name = "";
    double mass = 0;          ///< kg
    double gripStiffness = 0; ///< N/m
    double gripDamping = 0;   ///< N s/m
    double armStiffness = 0;  ///< N/m
    double armDamping = 0;    ///< N s/m
    bool rigid = false;

    /// N s/m: what the device feels at once.
    constexpr double felt() const { return rigid ? armDamping : gripDamping; }
};

inline constexpr HandProfile kNoHand{"none"};
inline constexpr HandProfile kPinch{"pinch", 0.1, 500, 2, 50, 2};
inline constexpr HandProfile kGrasp{"grasp", 0.3, 1000, 4, 150, 5};
inline constexpr HandProfile kFirm{"firm", 1.0, 2000, 8, 400, 15};
inline constexpr HandProfile kRigid{"rigid", 0.5, 0, 0, 200, 5, true};
inline constexpr std::array kHands{kPinch, kGrasp, kFirm, kRigid};

/// A human that loses nothing: the worst partner that is still passive.
constexpr HandProfile lossless(double mass, double stiffness) {
    return {"lossless", mass, 0, 0, stiffness, 0, true};
}

/// How the loop runs.
struct Timing {
    double rate = 1000; ///< Hz
    int delay = 0;      ///< whole ticks from reading to force
    double jitter = 0;  ///< of the period, uniform
    int substeps = 20;  ///< of the plant in each tick

    double period() const { return 1 / rate; }
};

/// A loop: everything but who renders.
struct Bench {
    PlantProfile device;
    HandProfile hand;
    Timing timing;
};

/// The device as its driver describes it, in this hand.
inline DeviceInfo infoOf(const Bench& bench) {
    const auto& [device, hand, timing] = bench;
    DeviceInfo info;
    info.name = device.name;
    info.maxForce = device.maxForce;
    info.workspaceRadius = 0.2;
    info.positionResolution = device.resolution;
    info.rate = timing.rate;
    info.damping = device.damping;
    info.handDamping = hand.felt();
    info.dryFriction = device.friction;
    info.amplifierLag = device.amplifierLag;
    info.delay = timing.delay;
    return info;
}

} // namespace tactum::test
