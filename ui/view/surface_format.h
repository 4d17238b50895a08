// The OpenGL context that every view of the program needs.
#pragma once

namespace tactum {

/// OpenGL 3.2 core with a depth and a stencil buffer as Qt's default. Call it before the QApplication is
/// made: a format set later reaches no context that Qt shares textures with. Thread: main.
void useViewSurfaceFormat();

} // namespace tactum
