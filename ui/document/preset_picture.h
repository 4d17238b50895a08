// The picture of a preset: a ball of its colour with the relief of its layers.
#pragma once

#include <QImage>

#include "core/presets/preset.h"

namespace tactum {

/// `side` in device pixels. Thread: any but real time; some milliseconds.
QImage presetPicture(const Preset& preset, int side);

} // namespace tactum
