// Vertices at exactly the same place made one.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Numbers places in the order in which they first come. Equal means equal in every bit, except that -0 is 0.
/// Thread: any but real time.
class PlaceTable {
public:
    explicit PlaceTable(std::size_t expectedPlaces = 0);

    /// The number of this place, a new one if it is new. `p` must be finite.
    Index numberOf(const Vec3& p);

    const std::vector<Vec3>& places() const { return places_; }
    std::vector<Vec3> takePlaces() { return std::move(places_); }

private:
    struct Slot {
        Index tag;    ///< of the hash; spares most looks at places_
        Index number; ///< kFree while nobody lives here
    };
    void grow();

    std::vector<Slot> slots_; ///< open addressing, a power of two, at most half full
    std::vector<Vec3> places_;
};

/// For each position the number of the first equal one: numbers below positions.size(), first ones keep
/// theirs.
/// When cancelled the rest of the map is 0: ask `progress` before using it.
std::vector<Index> weldMap(const std::vector<Vec3>& positions, const Progress& progress = {});

} // namespace tactum
