// What is done with the list of a surface's texture layers: plain functions on values.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/scene/surface_ref.h"

namespace tactum {

using TextureLayers = std::vector<TextureLayer>;

/// A layer of a surface that is felt alone.
struct SoloLayer {
    SurfaceRef surface;
    int layer = 0;

    bool operator==(const SoloLayer&) const = default;
};

/// A layer to begin with: of a size that a hand can follow, named after its source or its picture as no layer
/// of the list is. `hasUvs`: pictures lie on the mesh's coordinates where there are some.
TextureLayer newLayer(TextureSource source, const TextureLayers& among, bool hasUvs = false,
                      std::shared_ptr<const TextureImage> image = {});
/// "Grooves", or "Grooves 2" where that is taken.
std::string freshLayerName(const TextureLayers& among, const std::string& wanted);

/// The same layer for another target. Metres of height mean nothing as a part of a material's value, and the
/// other way round: the strength then begins anew, with its sign.
TextureLayer withTarget(TextureLayer layer, TextureTarget target);

/// Takes a layer out of the list and puts it in so that it has the number `to`.
void moveLayer(TextureLayers& layers, int from, int to);

/// Where the layer that had this number and these values is now; nothing when it is gone. A layer that was
/// edited keeps its place.
std::optional<int> followed(const TextureLayers& now, std::size_t countBefore, int number,
                            const TextureLayer& before);

/// Every other layer switched off: what is felt of a surface with a layer alone.
TextureLayers alone(TextureLayers layers, int number);

/// Whether the pattern lies on a frame that can be moved about the model.
bool hasFrame(const TexturePattern& pattern);

/// Whether a file is one that a layer can be made of, by its ending.
bool isPicture(const QString& file);

/// "0.20 mm" or "+50 %".
QString strengthText(TextureTarget target, double strength);
/// "Height 0.20 mm".
QString targetText(const TextureLayer& layer);
QString labelOf(const NamedChoice& choice);

} // namespace tactum
