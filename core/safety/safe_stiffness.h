// How stiff a surface may be rendered before device, hand and sampling begin to buzz.
#pragma once

#include "core/port/haptic_device.h"

namespace tactum {

/// What the ceiling depends on. SI.
struct LoopFigures {
    double period = 1e-3;      ///< s, of the servo: nominal, or what was measured where that is worse
    double delay = 0;          ///< s, from reading to command
    double amplifierLag = 0;   ///< s
    double damping = 0;        ///< N s/m, of device and hand together
    double dryFriction = 0;    ///< N
    double resolution = 0;     ///< m, of the encoders; 0: none
    double makersCeiling = 0;  ///< N/m; 0: not known
    double handsCeiling = 0;   ///< N/m, what this hand bears whatever it damps; 0: not known
    double surfaceDamping = 0; ///< N s/m, of the surface that is rendered
};

/// Of a device as it describes itself. Thread: any, real time too.
LoopFigures loopFigures(const DeviceInfo& device) noexcept;

/// s, from a position to the force that answers it: half a period that the force is held, and what comes on
/// the way. Thread: any, real time too.
inline double lateness(const LoopFigures& loop) noexcept {
    return 0.5 * loop.period + loop.delay + loop.amplifierLag;
}

enum class CeilingReason : std::uint8_t { Damping, SurfaceDamping, Resolution, Hand, Maker };
inline constexpr std::size_t kCeilingReasons = std::size_t(CeilingReason::Maker) + 1;

struct StiffnessCeiling {
    double value = 0; ///< N/m
    CeilingReason reason = CeilingReason::Damping;
    double damping = 0; ///< N s/m: the ceiling of the surface's own damping
};

/// K_safe = min[(1.05 (b + b_hand) - B) / (T/2 + delay + lag), 0.7 2 f_c / Delta] (Colgate and Schenkel's
/// passivity of a sampled wall with damping B; Diolaiti's for quantised positions), and never more than the
/// maker allows. Not less than the bound, because a passivity controller stands behind it and hands take up
/// more than is counted on here. A sampled damping takes at the sampling frequency what it gives below, so B
/// is rendered up to 0.35 (b + b_hand): two thirds of the stiffness are left then. The second bound holds
/// only where there is both dry friction and resolution. Nothing is stiff in a loop whose figures give no
/// bound. Thread: any, real time too.
StiffnessCeiling safeStiffness(const LoopFigures& loop) noexcept;

} // namespace tactum
