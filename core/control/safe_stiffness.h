// How stiff a surface may be rendered before device, hand and sampling begin to buzz.
#pragma once

#include "core/control/haptic_device.h"

namespace tactum {

/// What the ceiling depends on. SI.
struct LoopFigures {
    double period = 1e-3;     ///< s, of the servo: nominal, or what was measured where that is worse
    double delay = 0;         ///< s, from reading to command
    double amplifierLag = 0;  ///< s
    double damping = 0;       ///< N s/m, of device and hand together
    double dryFriction = 0;   ///< N
    double resolution = 0;    ///< m, of the encoders; 0: none
    double makersCeiling = 0; ///< N/m; 0: not known
};

/// Of a device as it describes itself. Thread: any, real time too.
LoopFigures loopFigures(const DeviceInfo& device) noexcept;

enum class CeilingReason : std::uint8_t { Damping, Resolution, Maker };

struct StiffnessCeiling {
    double value = 0; ///< N/m
    CeilingReason reason = CeilingReason::Damping;
};

/// K_safe = 0.7 min[(b + b_hand) / (T/2 + delay + lag), 2 f_c / Delta] (Colgate and Schenkel's passivity of a
/// sampled wall; Diolaiti's for quantised positions), and never more than the maker allows. Seven tenths,
/// because at eight no simulated device and hand oscillated. The second bound holds only where there is both
/// dry friction and resolution. Thread: any, real time too.
StiffnessCeiling safeStiffness(const LoopFigures& loop) noexcept;

} // namespace tactum
