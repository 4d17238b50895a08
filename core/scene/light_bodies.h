// Bodies that are too light for a finger to push with all its force.
#pragma once

#include "core/scene/findings.h"

namespace tactum {

/// At the rate that a device of 1 kHz asks for.
inline constexpr double kUsualProxyRate = 2000; // Hz

/// A finding for each object whose body yields so easily, in the middle of one of the six sides of its box,
/// that a finger at kUsualProxyRate could not be followed. Thread: any but real time.
void appendLightBodies(std::vector<Finding>& findings, const Scene& scene);

} // namespace tactum
