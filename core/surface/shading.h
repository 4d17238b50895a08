// Whether a surface feels smooth although it is made of facets (section 3): plain values.
#pragma once

#include <cstdint>

#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kCreaseAngle{
    "crease-angle",
    "Crease angle",
    "rad",
    0,
    3.141592653589793,
    0.08726646259971647,
    0.8726646259971648,
    3,
    "Edges that bend by more than this stay sharp when normals are computed (section 3)."};

/// Where the normals of a shaded surface come from.
enum class NormalSource : std::uint8_t {
    File,    ///< those of the file; computed where it has none
    Computed ///< the mean of the facets around a corner, up to the crease angle
};

/// Of one surface. Which way round the normals are makes no difference: they are turned to the proxy's side.
struct Shading {
    bool on = false;
    NormalSource normals = NormalSource::File;
    double creaseAngle = kCreaseAngle.initial; ///< rad

    bool operator==(const Shading&) const = default;
};

} // namespace tactum
