// What the repairs of a mesh share. For this folder only.
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/repair.h"

namespace tactum {

/// "1 hole closed", "2 holes closed"; "no hole closed" for none.
std::string sentence(std::size_t count, std::string_view one, std::string_view many, std::string_view done);

/// Copies the triangles that are to be kept, with all they carry; the positions stay.
TriangleSoup withTriangles(const TriangleSoup& soup, const std::vector<char>& kept);

/// Exchanges the last two corners, and turns those corner normals to the new front that look to the back.
void turnOver(TriangleSoup& soup, Index triangle);

} // namespace tactum
