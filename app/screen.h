// The screen: only the window and the picture of a replay need one, and with it Qt and VTK, which take longer
// to load than most verbs to run. So there are two programs of one source: `tactum`, which has neither, and
// `tactum-window` beside it, which is the same with a screen.
#pragma once

#include "core/base/result.h"

namespace tactum {

/// In the program with Qt: nothing. In the other: goes on as the program with Qt, as reachScreen() does.
/// Thread: likewise.
Result<void> reachQt(char** argv);
/// In the program with a screen: whether there is a display. In the other: goes on as the program with a
/// screen, with the same arguments; comes back only when that cannot be started. Thread: main, while there is
/// no other and no Qt application.
Result<void> reachScreen(char** argv);

} // namespace tactum
