#include "core/geometry/surfaces.h"

#include <algorithm>

namespace tactum {

TriangleSoup withSurface(const TriangleSoup& soup, const TriangleSet& set, Index surface) {
    TriangleSoup result = soup;
    for (Index t : set)
        result.surfaceOf[t] = surface;
    return result;
}

MergedSurfaces mergeSurfaces(Index count, std::span<const Index> surfaces) {
    MergedSurfaces result;
    result.newNumber.resize(count);
    std::vector<char> goes(count, 0);
    const Index lowest = surfaces.empty() ? 0 : *std::ranges::min_element(surfaces);
    for (Index s : surfaces)
        goes[s] = s != lowest;
    for (Index s = 0; s < count; ++s)
        if (!goes[s]) result.newNumber[s] = result.count++;
    if (lowest < count) result.merged = result.newNumber[lowest];
    for (Index s = 0; s < count; ++s)
        if (goes[s]) result.newNumber[s] = result.merged;
    return result;
}

TriangleSoup renumbered(const TriangleSoup& soup, std::span<const Index> newNumber) {
    TriangleSoup result = soup;
    for (Index& surface : result.surfaceOf)
        surface = newNumber[surface];
    return result;
}

double areaOf(const TriangleSoup& soup, std::span<const Index> triangles) {
    double twice = 0;
    for (const Index t : triangles) {
        const auto& c = soup.triangles[t];
        const Vec3& a = soup.positions[c[0]];
        twice += (soup.positions[c[1]] - a).cross(soup.positions[c[2]] - a).norm();
    }
    return twice / 2;
}

} // namespace tactum
