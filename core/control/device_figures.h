// The figures of a device with the names under which files keep them: profiles and recordings.
#pragma once

#include "core/control/haptic_device.h"

namespace tactum {

struct DeviceFigure {
    const char* key; ///< with its unit
    double DeviceInfo::*value;
};

inline constexpr DeviceFigure kDeviceFigures[] = {{"max_force_N", &DeviceInfo::maxForce},
                                                  {"continuous_force_N", &DeviceInfo::continuousForce},
                                                  {"max_stiffness_N_per_m", &DeviceInfo::maxStiffness},
                                                  {"workspace_radius_m", &DeviceInfo::workspaceRadius},
                                                  {"position_resolution_m", &DeviceInfo::positionResolution},
                                                  {"rate_Hz", &DeviceInfo::rate},
                                                  {"damping_N_s_per_m", &DeviceInfo::damping},
                                                  {"hand_damping_N_s_per_m", &DeviceInfo::handDamping},
                                                  {"dry_friction_N", &DeviceInfo::dryFriction},
                                                  {"amplifier_lag_s", &DeviceInfo::amplifierLag},
                                                  {"delay_ticks", &DeviceInfo::delay},
                                                  {"trip_speed_m_per_s", &DeviceInfo::tripSpeed}};

} // namespace tactum
