// Which surface is touched, and what a person calls it.
#pragma once

#include <optional>

#include <QString>

#include "core/haptics/haptic_step.h"
#include "core/haptics/world.h"
#include "core/scene/surface_ref.h"

namespace tactum {

/// The one that pushes most; nothing where nothing is touched. `world`: in which it was felt.
std::optional<SurfaceRef> touchedSurface(const HapticOutput& touch, const World& world);

/// "lid"; with its object where the scene has several: "kettle: lid". Empty for a reference to nothing.
QString nameOfSurface(const Scene& scene, SurfaceRef ref);

/// "lid: 800 N/m, friction 0.60 / 0.40": the name, and what is felt first, static friction before dynamic.
/// Empty for a reference to nothing.
QString feelText(const Scene& scene, SurfaceRef ref);

} // namespace tactum
