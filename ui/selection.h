// What a person has selected: surfaces, and triangles of one object.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/surface_ref.h"

namespace tactum {

/// One or more surfaces of a scene, each once.
struct SurfaceRefs : std::vector<SurfaceRef> {
    SurfaceRefs() = default;
    SurfaceRefs(std::nullopt_t) {}
    SurfaceRefs(std::optional<SurfaceRef> perhaps) {
        if (perhaps) push_back(*perhaps);
    }
    SurfaceRefs(std::initializer_list<SurfaceRef> several) : std::vector<SurfaceRef>(several) {}
    SurfaceRefs(SurfaceRef one) : std::vector<SurfaceRef>{one} {}
    SurfaceRefs(std::vector<SurfaceRef> several) : std::vector<SurfaceRef>(std::move(several)) {}
};

/// Triangles of one object, in rising order.
struct FaceSelection {
    ObjectId object = 0;
    std::vector<Index> faces;

    bool empty() const { return faces.empty(); }
    bool operator==(const FaceSelection&) const = default;
};

/// How what is chosen joins what is selected already.
enum class SelectMode { Replace, Add, Subtract };

/// `chosen` joined to `now`. Triangles of another object replace those that are selected, and cannot be taken
/// from them.
FaceSelection joined(const FaceSelection& now, const FaceSelection& chosen, SelectMode mode);
/// The last of `chosen` becomes the last of the result: the active one.
SurfaceRefs joined(const SurfaceRefs& now, const SurfaceRefs& chosen, SelectMode mode);

} // namespace tactum
