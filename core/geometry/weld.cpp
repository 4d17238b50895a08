#include "core/geometry/weld.h"

#include <bit>

namespace tactum {
namespace {

constexpr Index kFree = ~Index{0};

std::uint64_t hashOf(const Vec3& p) {
    std::uint64_t h = 0;
    for (double c : {p.x(), p.y(), p.z()}) {
        h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
        h ^= h >> 32;
    }
    return h;
}

std::size_t slotsFor(std::size_t places) {
    return std::bit_ceil(std::max<std::size_t>(16, 2 * places));
}

} // namespace

PlaceTable::PlaceTable(std::size_t expectedPlaces) : slots_(slotsFor(expectedPlaces), Slot{0, kFree}) {
    places_.reserve(expectedPlaces);
}

Index PlaceTable::numberOf(const Vec3& p) {
    const Vec3 place = p + Vec3::Zero(); // turns -0 into 0
    const std::uint64_t hash = hashOf(place);
    const Index tag = Index(hash >> 32);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
        Slot& slot = slots_[i];
        if (slot.number == kFree) {
            const Index number = Index(places_.size());
            slot = {tag, number};
            places_.push_back(place);
            if (2 * places_.size() > slots_.size()) grow();
            return number;
        }
        if (slot.tag == tag && places_[slot.number] == place) return slot.number;
    }
}

void PlaceTable::grow() {
    slots_.assign(2 * slots_.size(), Slot{0, kFree});
    const std::size_t mask = slots_.size() - 1;
    for (Index number = 0; number < places_.size(); ++number) {
        const std::uint64_t hash = hashOf(places_[number]);
        std::size_t i = hash & mask;
        while (slots_[i].number != kFree)
            i = (i + 1) & mask;
        slots_[i] = {Index(hash >> 32), number};
    }
}

std::vector<Index> weldMap(const std::vector<Vec3>& positions, const Progress& progress) {
    PlaceTable table(positions.size());
    std::vector<Index> firstOf; // of each place
    firstOf.reserve(positions.size());
    std::vector<Index> map(positions.size());
    ProgressMeter meter(progress, positions.size());
    for (Index i = 0; i < positions.size() && meter.goesOn(i); ++i) {
        const Index place = table.numberOf(positions[i]);
        if (place == firstOf.size()) firstOf.push_back(i);
        map[i] = firstOf[place];
    }
    return map;
}

} // namespace tactum
