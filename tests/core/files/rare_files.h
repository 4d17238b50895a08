// Small files of the formats that Assimp reads.
#pragma once

#include <string>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// One object with one material.
std::string as3ds(const TriangleSoup& soup, const std::string& object, const std::string& material);
/// A unit square and a triangle, with two materials, under a node that scales and mirrors. `unit`: an
/// element.
std::string asDae(const std::string& unit);
/// A unit square in the text form of FBX.
std::string asFbx(double centimetres);

} // namespace tactum
