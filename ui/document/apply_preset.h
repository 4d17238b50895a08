// A preset given to surfaces of the document.
#pragma once

#include "core/presets/preset.h"
#include "ui/document/document.h"
#include "ui/document/preset_store.h"

namespace tactum {

/// One step of the history, whatever the preset sets and however many surfaces there are, named as it is
/// in the `library`. Locked surfaces stay as they are. False where nothing was changed. Thread: ui.
bool applyPreset(Document& document, const SurfaceRefs& refs, const Preset& preset,
                 const std::vector<StoredPreset>& library = {});

} // namespace tactum
