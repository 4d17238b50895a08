// A short run without threads: a finger that strokes a rough plate, one servo tick and two haptic steps each
// millisecond, with edits, a swap, a moving body and a fault in it. The same every time.
#pragma once

#include <filesystem>

#include "core/runtime/recorded_run.h"

namespace tactum {

/// `milliseconds` of it.
RecordedRun handMadeRun(int milliseconds);
/// The same over one scene that nobody edits.
RecordedRun handMadeRun(int milliseconds, const Scene& scene);

/// An OBJ file of a flat grid with n x n squares, 0.1 m wide.
void writeGrid(const std::filesystem::path& file, int n);

} // namespace tactum
