#include "core/geometry/triangle_ranges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/weld.h"

namespace tactum {

namespace {

constexpr double kNear = 1e-5; // of the diagonal: repairs move vertices by less than half of it

Vec3 middleOf(const TriangleSoup& soup, Index triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return (soup.positions[a] + soup.positions[b] + soup.positions[c]) / 3;
}

bool areInTheirPlaces(const TriangleSoup& before, const TriangleSoup& after, double near) {
    if (before.triangles.size() != after.triangles.size()) return false;
    for (Index t = 0; t < before.triangles.size(); ++t)
        if ((middleOf(before, t) - middleOf(after, t)).norm() > near) return false;
    return true;
}

/// The triangles of a mesh by the cells of a grid that their middles lie in.
class Middles {
public:
    Middles(const TriangleSoup& soup, double near)
        : soup_(soup), near_(near), cells_(soup.triangles.size()), next_(soup.triangles.size()) {
        for (Index t = 0; t < soup.triangles.size(); ++t) {
            const Index cell = cells_.numberOf(cellOf(middleOf(soup, t)));
            if (cell == first_.size()) first_.push_back(kNone);
            next_[t] = std::exchange(first_[cell], t);
        }
    }

    static constexpr Index kNone = ~Index{0};

    /// The triangle whose middle is nearest; kNone: there is none near. Of several in one place the one that
    /// looks to the same side.
    Index nearest(const Vec3& middle, const Vec3& normal) {
        Index best = kNone;
        double least = near_;
        for (int i = 0; i < 27; ++i) {
            const Index cell = cells_.numberOf(cellOf(middle) +
                                               Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)); // may be a new one
            for (Index t = cell < first_.size() ? first_[cell] : kNone; t != kNone; t = next_[t]) {
                const double away = (middleOf(soup_, t) - middle).norm();
                if (away > least || (away == least && best != kNone && normalOf(soup_, t).dot(normal) < 0))
                    continue;
                best = t, least = away;
            }
        }
        return best;
    }

    static Vec3 normalOf(const TriangleSoup& soup, Index triangle) {
        const auto& [a, b, c] = soup.triangles[triangle];
        return (soup.positions[b] - soup.positions[a]).cross(soup.positions[c] - soup.positions[a]);
    }

private:
    Vec3 cellOf(const Vec3& p) const {
        return {std::floor(p.x() / near_), std::floor(p.y() / near_), std::floor(p.z() / near_)};
    }

    const TriangleSoup& soup_;
    double near_;
    PlaceTable cells_;
    std::vector<Index> first_; ///< of each cell
    std::vector<Index> next_;  ///< in the same cell
};

} // namespace

bool areTriangleRanges(const TriangleRanges& ranges, std::size_t triangles) {
    const bool rising = std::ranges::all_of(ranges, [](auto each) { return each.first < each.end; });
    const auto touch = [](TriangleRange a, TriangleRange b) { return a.end >= b.first; };
    return rising && std::ranges::adjacent_find(ranges, touch) == ranges.end() &&
           (ranges.empty() || ranges.back().end <= triangles);
}

TriangleRanges rangesOf(const TriangleSet& set) {
    TriangleRanges ranges;
    for (const Index t : set)
        if (!ranges.empty() && ranges.back().end == t)
            ++ranges.back().end;
        else
            ranges.push_back({t, t + 1});
    return ranges;
}

TriangleSet trianglesOf(const TriangleRanges& ranges) {
    TriangleSet set;
    set.reserve(countOf(ranges));
    for (const auto& [first, end] : ranges)
        for (Index t = first; t < end; ++t)
            set.push_back(t);
    return set;
}

std::size_t countOf(const TriangleRanges& ranges) {
    std::size_t count = 0;
    for (const auto& [first, end] : ranges)
        count += end - first;
    return count;
}

TriangleRanges carriedRanges(const TriangleRanges& ranges, const TriangleSoup& before,
                             const TriangleSoup& after) {
    const double near = kNear * boundsOf(before).diagonal();
    if (areInTheirPlaces(before, after, near)) return ranges;
    if (!(near > 0)) return {};
    Middles middles(before, near);
    const TriangleMarks marks(before.triangles.size(), trianglesOf(ranges));
    TriangleSet carried;
    for (Index t = 0; t < after.triangles.size(); ++t) {
        const Index was = middles.nearest(middleOf(after, t), Middles::normalOf(after, t));
        if (was != Middles::kNone && marks.has(was)) carried.push_back(t);
    }
    return rangesOf(carried);
}

} // namespace tactum
