// The figures of a device, each said once: its name in files and in sentences, its unit and what it can be.
#pragma once

#include "core/port/device_check.h"
#include "core/port/haptic_device.h"

namespace tactum {

struct DeviceFigure {
    const char* key; ///< in profiles and recordings, with its unit
    const char* name;
    const char* unit;
    double DeviceInfo::*value;
    double least, most; ///< what is far beyond every device: a wrong unit, or memory that nobody filled
};

inline constexpr DeviceFigure kDeviceFigures[] = {
    {"rate_Hz", "rate", "Hz", &DeviceInfo::rate, kSlowestRate, kFastestRate},
    {"max_force_N", "largest force", "N", &DeviceInfo::maxForce, 0, 1e4},
    {"continuous_force_N", "continuous force", "N", &DeviceInfo::continuousForce, 0, 1e4},
    {"max_stiffness_N_per_m", "largest stiffness", "N/m", &DeviceInfo::maxStiffness, 0, 1e9},
    {"workspace_radius_m", "workspace radius", "m", &DeviceInfo::workspaceRadius, 0, 1e3},
    {"position_resolution_m", "position resolution", "m", &DeviceInfo::positionResolution, 0, 1},
    {"damping_N_s_per_m", "damping", "N s/m", &DeviceInfo::damping, 0, 1e6},
    {"hand_damping_N_s_per_m", "damping of the hand", "N s/m", &DeviceInfo::handDamping, 0, 1e6},
    {"dry_friction_N", "dry friction", "N", &DeviceInfo::dryFriction, 0, 1e4},
    {"amplifier_lag_s", "amplifier lag", "s", &DeviceInfo::amplifierLag, 0, 1},
    {"delay_ticks", "delay", "ticks", &DeviceInfo::delay, 0, 100},
    {"max_torque_N_m", "largest torque", "N m", &DeviceInfo::maxTorque, 0, 1e3},
    {"max_pinch_N", "largest force of the gripper", "N", &DeviceInfo::maxPinch, 0, 1e4},
    {"trip_speed_m_per_s", "trip speed", "m/s", &DeviceInfo::tripSpeed, 1e-3, 1e3},
};

} // namespace tactum
