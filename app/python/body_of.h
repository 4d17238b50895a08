// Bodies and joints made of words.
#pragma once

#include <string>

#include "app/python/scene_handles.h"

namespace tactum::python {

/// "hinge" or "slider".
AxisKind axisKindNamed(const std::string& kind);
/// The body of an object that stood still.
BodyHandle bodyMadeOf(const ObjectHandle& object);

} // namespace tactum::python
