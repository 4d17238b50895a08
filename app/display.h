// Whether there is a display that the window, or the picture of a replay, can be drawn on.
#pragma once

#include "core/base/result.h"

namespace tactum {

/// Says why not, and what to do. Qt would end the program where it cannot connect or finds no OpenGL, so a
/// child process tries it first. Thread: main, while there is no other and no Qt application.
Result<void> checkDisplay();

} // namespace tactum
