// Grids of triangles whose vertices lie unevenly and that are halved either way: as meshes of strangers are.
#pragma once

#include "tests/support/soups.h"

namespace tactum::test {

/// `at(x, y)` for whole x from 0 to `along` and y to `across`, moved by up to `uneven` each, 0 to 0.4; those
/// of the rim only with `movesRim`. Even ones are halved by the diagonal from the origin.
template <class Place>
Soup unevenGrid(int along, int across, double uneven, bool movesRim, Rng& rng, Place&& at) {
    std::vector<Vec3> places;
    for (int k = 0; k <= across; ++k)
        for (int i = 0; i <= along; ++i) {
            const bool moves = movesRim || (i > 0 && k > 0 && i < along && k < across);
            const double u = uniform(rng, -uneven, uneven), v = uniform(rng, -uneven, uneven);
            places.push_back(at(i + moves * u, k + moves * v));
        }
    SoupBuilder builder;
    const auto place = [&](int i, int k) { return places[std::size_t(k * (along + 1) + i)]; };
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < across; ++k)
            if (uneven == 0 || rng() % 2)
                builder.triangle(place(i, k), place(i + 1, k), place(i + 1, k + 1))
                    .triangle(place(i, k), place(i + 1, k + 1), place(i, k + 1));
            else
                builder.triangle(place(i, k), place(i + 1, k), place(i, k + 1))
                    .triangle(place(i + 1, k), place(i + 1, k + 1), place(i, k + 1));
    return builder.build();
}

} // namespace tactum::test
