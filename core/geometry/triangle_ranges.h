// Triangles of a soup as runs of neighbouring numbers: the form of a set that is kept and written.
#pragma once

#include "core/geometry/triangle_set.h"

namespace tactum {

/// The numbers from `first` up to, and without, `end`.
struct TriangleRange {
    Index first = 0, end = 0;

    bool operator==(const TriangleRange&) const = default;
};

/// Rising, none empty, none touching the next: one set has one form, so that == compares sets. A surface that
/// was read in one piece is one range, whatever its size. Thread of all here: any but real time.
using TriangleRanges = std::vector<TriangleRange>;

/// Of a soup that has so many triangles.
bool areTriangleRanges(const TriangleRanges& ranges, std::size_t triangles);
/// `set`: ascending, each once.
TriangleRanges rangesOf(const TriangleSet& set);
TriangleSet trianglesOf(const TriangleRanges& ranges);
std::size_t countOf(const TriangleRanges& ranges);

/// The same triangles in `after`, another form of the mesh `before`: repaired, welded, turned over. Where
/// each triangle is where the one of its number was, numbers stay; else a triangle is the nearest one of
/// before within a hundred-thousandth of the diagonal, by their middles. What was not there before, the lid
/// of a hole or a triangle that was cut anew, is not in the set.
TriangleRanges carriedRanges(const TriangleRanges& ranges, const TriangleSoup& before,
                             const TriangleSoup& after);

} // namespace tactum
