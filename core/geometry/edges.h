// The edges of a soup, each with the triangles at it.
#pragma once

#include <span>
#include <tuple>

#include "core/geometry/filing.h"

namespace tactum {

/// One triangle at an edge between two places.
struct EdgeUse {
    Index high = 0;       ///< the place with the higher number; the lower is what it is filed under
    Index corner = 0;     ///< 3 * triangle + the number of the corner from which it runs to the next one
    bool forward = false; ///< from the lower place to the higher
};

/// The corner after this one in its triangle, and the one before.
inline Index nextCorner(Index corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
inline Index previousCorner(Index corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// Calls see(low, uses) once for each edge of the triangles for which wanted(corners) says yes, in ascending
/// order of its places; `uses` in the order of their corners. `triangles` have numbers of places, smaller
/// than `places`. Linear but for the sorting around each place. Thread: any but real time.
template <class Wanted, class See>
void forEachEdge(std::span<const Corners> triangles, std::size_t places, Wanted&& wanted, See&& see) {
    FiledByVertex<EdgeUse> uses(places);
    const auto forEachSide = [&](auto&& found) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (!wanted(triangles[t])) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3];
                found(std::min(a, b), EdgeUse{std::max(a, b), Index(3 * t + k), a < b});
            }
        }
    };
    forEachSide([&](Index low, const EdgeUse&) { uses.count(low); });
    uses.allocate();
    forEachSide([&](Index low, const EdgeUse& use) { uses.place(low, use); });
    for (Index low = 0; low < places; ++low) {
        EdgeUse *const begin = uses.begin(low), *const end = uses.end(low);
        std::sort(begin, end, [](const EdgeUse& a, const EdgeUse& b) {
            return std::tie(a.high, a.corner) < std::tie(b.high, b.corner);
        });
        for (EdgeUse *first = begin, *last = begin; first != end; first = last) {
            last = std::find_if(first, end, [first](const EdgeUse& u) { return u.high != first->high; });
            see(low, std::span<const EdgeUse>(first, last));
        }
    }
}

} // namespace tactum
