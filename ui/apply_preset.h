// A preset given to surfaces of the document.
#pragma once

#include "core/presets/preset.h"
#include "ui/document.h"

namespace tactum {

/// One step of the history, whatever the preset sets and however many surfaces there are. Locked surfaces
/// stay as they are. False where nothing was changed. Thread: ui.
bool applyPreset(Document& document, const SurfaceRefs& refs, const Preset& preset);

} // namespace tactum
