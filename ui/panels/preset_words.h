// What is said of a preset: at a glance, and value by value with where each comes from.
#pragma once

#include <QString>

namespace tactum {

struct StoredPreset;

/// "0.60 / 0.30 · Metal": static and dynamic friction, or else what it sets first.
QString figuresOf(const StoredPreset& stored);
/// All values of a preset with unit and source, a line each.
QString detailsOf(const StoredPreset& stored);
/// The same under its name.
QString tipOf(const StoredPreset& stored);

} // namespace tactum
