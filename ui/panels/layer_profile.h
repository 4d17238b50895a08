// What the layers of a surface are along a stroke of the proxy over it.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/haptics/world.h"
#include "core/scene/surface_ref.h"
#include "ui/document/layer_edits.h"
#include "ui/panels/last_stroke.h"

namespace tactum {

/// One value for each place, places as far apart as the next; m of height, else the factor of the material's
/// value. Not a number where the stroke was not on the surface.
struct LayerProfile {
    TextureTarget target = TextureTarget::Height;
    double length = 0; ///< m, from the first place to the last
    std::vector<double> values;

    bool any() const; ///< whether some of it was on the surface
    double wayOf(std::size_t i) const { return length * double(i) / double(values.size() - 1); }
};

/// Where on the surface the proxy was is the point that is nearest to it. `world`: for where its bodies are.
/// Thread: any but real time. Empty when cancelled or when the surface is not in the World.
LayerProfile profileAlong(const std::vector<StrokePoint>& stroke, const World& world, SurfaceRef surface,
                          const TextureLayers& layers, TextureTarget target, const Progress& progress = {});

} // namespace tactum
