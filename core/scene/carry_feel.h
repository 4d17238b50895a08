// The feel of one scene for another: the same model after it was changed, and exported again, elsewhere.
#pragma once

#include <string>
#include <vector>

#include "core/scene/findings.h"

namespace tactum {

/// Without the ".001" that Blender writes behind a name that is there twice.
std::string plainName(const std::string& name);

struct CarriedFeel {
    std::size_t surfaces = 0;      ///< of `onto` that have got a feel
    std::vector<Finding> findings; ///< what found no partner, on either side, and what could not come along
};

/// Gives every surface of `onto` the feel of its partner in `from`: material, shading, layers, sides, whether
/// it is visible and locked. A partner has the same name in an object of the same name; else the same name
/// anywhere, if all that have it feel the same; else it is the only surface of an object of the same name, or
/// both scenes have one surface alone. plainName() is what counts of a name. What is painted comes along
/// where the mesh has the same vertices and triangles. Shapes, colours and bodies stay those of `onto`; the
/// proxy's radius becomes that of `from`, and so does the finger path where `onto` has none. Thread: any but
/// real time.
CarriedFeel carryFeel(const Scene& from, Scene& onto);

} // namespace tactum
