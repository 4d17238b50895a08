// Which numbers of a layer make a difference.
#pragma once

#include "core/surface/texture_layer.h"

namespace tactum {

/// Whether a number makes a difference for this source and mapping.
bool matters(const PatternField& field, const TexturePattern& pattern);
/// Whether the strength does: a height that is multiplied takes the bare pattern.
bool strengthMatters(const TextureLayer& layer);

} // namespace tactum
