// Meshes from formulas in any size, and a finger around them: what is measured without any file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_soup.h"
#include "core/scene/finger_path.h"

namespace tactum::bench {

/// A family of shapes of 0.2 m diagonal about the origin, in any resolution.
enum class Family { Sphere, HeightField };

/// One mesh to measure: a family in a resolution. Sphere: 12 n^2 triangles on a cube that was blown up.
/// HeightField: 2 n^2 triangles, hills of three sizes and a roughness of a tenth of a cell.
struct GeneratedShape {
    Family family = Family::Sphere;
    int n = 1;

    std::size_t triangles() const;
    std::string name() const; ///< "sphere-24k", "height-1.0M"
};

/// Every size that is measured, from 24 thousand to 4 million triangles, in both families.
const std::vector<GeneratedShape>& generatedShapes();

TriangleSoup soupOf(const GeneratedShape& shape);

/// A finger at 0.15 m/s, one row a millisecond: down from 20 mm above, then on a long curve all over the
/// shape, between 0 and 8 mm under its surface. Metre.
std::vector<FingerPoint> fingerOver(Family family);

/// The mesh as a binary PLY file, single precision, as a scanner would write it. False when it cannot be
/// written.
bool writePly(const TriangleSoup& soup, const std::filesystem::path& file);

} // namespace tactum::bench
