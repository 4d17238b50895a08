// Some of the triangles of a soup: what an author selects.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Numbers of triangles of one soup, ascending, each once. Plain and comparable: what undo and files can
/// keep, and what std::set_union and its like work on.
using TriangleSet = std::vector<Index>;

/// Ascending, each once, and all of them triangles of a soup that has so many.
bool isTriangleSet(const TriangleSet& set, std::size_t triangles);

/// All triangles of one surface.
TriangleSet trianglesOf(const TriangleSoup& soup, Index surface);

/// The triangles of a surface, or of the whole soup, that are not in the set.
TriangleSet inverted(const TriangleSoup& soup, const TriangleSet& set, std::optional<Index> surface = {});

/// One bit for each triangle: the form of a set to work with.
class TriangleMarks {
public:
    explicit TriangleMarks(std::size_t triangles) : words_((triangles + 63) / 64, 0) {}
    TriangleMarks(std::size_t triangles, const TriangleSet& set) : TriangleMarks(triangles) {
        for (Index t : set)
            add(t);
    }

    bool has(Index t) const { return words_[t / 64] >> (t % 64) & 1; }
    /// True when it was not there before.
    bool add(Index t) {
        const std::uint64_t bit = std::uint64_t{1} << (t % 64);
        const bool isNew = !(words_[t / 64] & bit);
        words_[t / 64] |= bit;
        return isNew;
    }

    TriangleSet set() const {
        std::size_t count = 0;
        for (std::uint64_t word : words_)
            count += std::size_t(std::popcount(word));
        TriangleSet result;
        result.reserve(count);
        for (std::size_t i = 0; i < words_.size(); ++i)
            for (std::uint64_t word = words_[i]; word; word &= word - 1)
                result.push_back(Index(64 * i + std::size_t(std::countr_zero(word))));
        return result;
    }

private:
    std::vector<std::uint64_t> words_;
};

} // namespace tactum
