// A small picture of a scene that needs no display: what an archive shows of its contents.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace tactum {

/// PNG of width x height pixels: every visible object at the time 0, in its surfaces' colours with plain
/// shading, seen from the front, right and above, in the middle of the picture. The same scene gives the same
/// bytes. Thread: any but real time.
std::string previewOf(const Scene& scene, int width = 640, int height = 480);

} // namespace tactum
