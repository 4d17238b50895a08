// Small scenes to try a device with: made in code, felt instead of the person's own.
#pragma once

#include "core/port/device_frame.h"
#include "core/scene/scene.h"

namespace tactum {

enum class Trial { Spring, Wall, Friction };

/// What the device allows there. World frame, SI.
struct TrialFigures {
    Vec3 centre = Vec3::Zero(); ///< of the device's workspace
    double radius = 0.05;       ///< of it, m
    double maxForce = 1;        ///< N
    double ceiling = 1000;      ///< N/m
};

/// The spring pulls to the centre wherever the finger goes after it was there once: the inside of a ball that
/// is hardly larger than the proxy. At the edge of the workspace it takes four tenths of the force there is.
/// The wall stands upright to the right of the centre, four fifths as stiff as surfaces may be; the plate
/// lies beneath it and holds by friction.
Scene trialScene(Trial trial, const TrialFigures& figures);

} // namespace tactum
