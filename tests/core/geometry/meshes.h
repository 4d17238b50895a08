// Small meshes with shared vertices, and soups in which everything meets everything.
#pragma once

#include <random>

#include "core/geometry/triangle_soup.h"

namespace tactum::test {

/// The cube from 0 to 1, two triangles a side, fronts outward.
inline TriangleSoup cube(const Vec3& corner = Vec3::Zero()) {
    TriangleSoup soup;
    for (int i = 0; i < 8; ++i)
        soup.positions.push_back(corner + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    soup.surfaceOf.assign(12, 0);
    return soup;
}

/// Every triangle with three vertices of its own, as STL has them.
inline TriangleSoup apart(const TriangleSoup& soup) {
    TriangleSoup result = soup;
    result.positions.clear();
    for (auto& t : result.triangles)
        for (Index& corner : t) {
            result.positions.push_back(soup.positions[corner]);
            corner = Index(result.positions.size() - 1);
        }
    return result;
}

/// Both, with what their corners carry; the surfaces keep their numbers.
inline TriangleSoup joined(TriangleSoup a, const TriangleSoup& b) {
    const Index shift = Index(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    a.surfaceOf.insert(a.surfaceOf.end(), b.surfaceOf.begin(), b.surfaceOf.end());
    a.cornerNormals.insert(a.cornerNormals.end(), b.cornerNormals.begin(), b.cornerNormals.end());
    a.cornerUvs.insert(a.cornerUvs.end(), b.cornerUvs.begin(), b.cornerUvs.end());
    return a;
}

/// A height field of cells x cells squares over the unit square, vertices shared, fronts toward +z.
template <class Height> TriangleSoup grid(Index cells, Height height) {
    TriangleSoup soup;
    for (Index j = 0; j <= cells; ++j)
        for (Index i = 0; i <= cells; ++i) {
            const double x = double(i) / cells, y = double(j) / cells;
            soup.positions.emplace_back(x, y, height(x, y));
        }
    for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i) {
            const Index a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
            soup.triangles.push_back({a, b, d});
            soup.triangles.push_back({a, d, c});
        }
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

/// Triangles, segments and points over few places, so that they share edges by twos, threes and more, lie on
/// each other and have no area.
inline TriangleSoup tangle(std::mt19937& random, Index triangles) {
    TriangleSoup soup;
    for (int i = 0; i < 24; ++i) // every place twice
        soup.positions.emplace_back(i % 3, i / 3 % 2, i / 6 % 2);
    for (Index t = 0; t < triangles; ++t) {
        const auto corner = [&] { return Index(random() % soup.positions.size()); };
        soup.triangles.push_back({corner(), corner(), corner()});
        if (random() % 8 == 0) soup.triangles.back()[2] = soup.triangles.back()[1];
        if (random() % 20 == 0) soup.triangles.back()[0] = soup.triangles.back()[1];
        soup.surfaceOf.push_back(Index(random() % 4));
    }
    return soup;
}

} // namespace tactum::test
