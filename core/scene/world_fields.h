// The numbers of a moving world that are of no single body.
#pragma once

#include <array>

#include "core/dynamics/mechanics.h"
#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kAirDensity{
    "air-density",
    "Air",
    "kg/m^3",
    0,
    1000,
    0.1,
    0,
    2,
    "Density of what bodies move through, which slows them by the square of "
    "their speed: 1.2 is air, 1000 water, 0 nothing."};

inline constexpr Parameter kForceScale{
    "force-scale",
    "Force scale",
    "x",
    1e-6,
    1e9,
    0.1,
    1,
    6,
    "Newtons on a body for each of the finger's: small for a micro-sensor, large for a windmill."};
inline constexpr Parameter kTimeScale{
    "time-scale",
    "Time scale",
    "x",
    1e-6,
    100,
    0.1,
    1,
    6,
    "Seconds of the moving world for each of the hand's: small for what swings faster than a hand feels."};

struct WorldField {
    const Parameter* parameter;
    double Mechanics::*value;
};
inline constexpr std::array<WorldField, 3> kWorldFields{{{&kAirDensity, &Mechanics::airDensity},
                                                         {&kForceScale, &Mechanics::forceScale},
                                                         {&kTimeScale, &Mechanics::timeScale}}};

} // namespace tactum
