// The pictures of a first touch, one after the other: tests/ui/window/join_pictures.py makes one of them that
// moves.
#pragma once

#include <QDir>
#include <QSize>

#include "tests/ui/window/window_fixture.h"

namespace tactum {

/// Sets a friction, presses into the teapot, strokes it until it slips, and lets go: a file for every other
/// frame of the display, `touch-000.png` and so on.
void takeTouchFrames(const QDir& folder, const QString& sample);

} // namespace tactum
