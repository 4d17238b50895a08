// A finger that goes everywhere in a scene, for files that nobody trusts.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace tactum::test {

/// Strokes of 50 haptic steps to, through and along what is there. What was wrong, in words; empty where
/// every proxy and force was finite and the limiter let no more through than a device has. Takes a scene that
/// does not compile for sound: that is an answer too.
std::string faultOfTouch(const Scene& scene, int strokes = 20);

} // namespace tactum::test
