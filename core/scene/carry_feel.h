// The feel of one scene for another: the same model after it was changed, and exported again, elsewhere.
#pragma once

#include <string>
#include <vector>

#include "core/scene/findings.h"

namespace tactum {

/// Without the ".001" that Blender writes behind a name that is there twice.
std::string plainName(const std::string& name);

struct CarriedFeel {
    std::size_t surfaces = 0;     ///< of `onto` that have got a feel from `from`
    std::size_t back = 0;         ///< that have got one from `gone`
    std::size_t surfacesLost = 0; ///< of `from`, without a partner
    std::size_t layersLost = 0;   ///< painted, and left out
    std::size_t bodiesLost = 0;
    std::vector<Finding> findings; ///< what found no partner, on either side, and what could not come along
    std::vector<SceneObject> gone; ///< each with one surface whose feel nobody has got, the newest first
};

/// Gives every surface of `onto` the feel of its partner in `from`: material, shading, layers, sides, whether
/// it is visible and locked. A partner has the same name in an object of the same name, in `gone` if not in
/// `from`: what an earlier call had left over; else the same name anywhere, if all that have it feel the
/// same; else it is the only surface of an object of the same name, or both scenes have one surface alone.
/// plainName() is what counts of a name. What is painted comes along where the mesh has as many vertices and
/// the same triangles, but not to an object of another name at another place; where the shape is not the
/// same, that is said. Shapes and bodies stay those of `onto`, and so do the colours of objects that
/// isColoured(); the others get those of the partners, too. The proxy's radius becomes that of `from`, its
/// cameras come along in place of those of their names, and the finger path where `onto` has
/// none. Thread: any but real time.
CarriedFeel carryFeel(const Scene& from, Scene& onto, const std::vector<SceneObject>* gone = nullptr);

} // namespace tactum
