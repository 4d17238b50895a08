#include "core/geometry/triangle_set.h"

#include <algorithm>
#include <functional>

namespace tactum {

bool isTriangleSet(const TriangleSet& set, std::size_t triangles) {
    return std::ranges::adjacent_find(set, std::greater_equal{}) == set.end() &&
           (set.empty() || set.back() < triangles);
}

TriangleSet trianglesOf(const TriangleSoup& soup, Index surface) {
    TriangleSet result;
    for (std::size_t t = 0; t < soup.surfaceOf.size(); ++t)
        if (soup.surfaceOf[t] == surface) result.push_back(Index(t));
    return result;
}

TriangleSet inverted(const TriangleSoup& soup, const TriangleSet& set, std::optional<Index> surface) {
    TriangleSet result;
    result.reserve(soup.triangles.size() - std::min(set.size(), soup.triangles.size()));
    auto next = set.begin();
    for (Index t = 0; t < soup.triangles.size(); ++t) {
        if (next != set.end() && *next == t)
            ++next;
        else if (!surface || soup.surfaceOf[t] == *surface)
            result.push_back(t);
    }
    return result;
}

} // namespace tactum
