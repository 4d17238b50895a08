#include "core/geometry/repair.h"

#include <algorithm>
#include <tuple>

#include "core/geometry/filing.h"
#include "core/geometry/orientation.h"
#include "core/geometry/repair_parts.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

constexpr Index kUnused = ~Index{0};

Repaired repaired(TriangleSoup soup, std::size_t changes, std::string done) {
    return {std::make_shared<const TriangleSoup>(std::move(soup)), changes, std::move(done)};
}

/// The same triangle with the lowest corner first: equal for equal corners and equal front.
Corners turned(const Corners& c) {
    const auto lowest = std::size_t(std::ranges::min_element(c) - c.begin());
    return {c[lowest], c[(lowest + 1) % 3], c[(lowest + 2) % 3]};
}

} // namespace

std::string sentence(std::size_t count, std::string_view one, std::string_view many, std::string_view done) {
    const std::string number = count == 0 ? "no" : std::to_string(count);
    return number + " " + std::string(count == 1 || count == 0 ? one : many) + " " + std::string(done);
}

TriangleSoup withTriangles(const TriangleSoup& soup, const std::vector<char>& kept) {
    TriangleSoup result;
    result.positions = soup.positions;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        if (!kept[t]) continue;
        result.triangles.push_back(soup.triangles[t]);
        result.surfaceOf.push_back(soup.surfaceOf[t]);
        const auto carry = [t](const auto& from, auto& to) {
            if (from.empty()) return;
            const auto first = from.begin() + std::ptrdiff_t(3 * t);
            to.insert(to.end(), first, first + 3);
        };
        carry(soup.cornerNormals, result.cornerNormals);
        carry(soup.cornerUvs, result.cornerUvs);
    }
    return result;
}

void turnOver(TriangleSoup& soup, Index triangle) {
    Corners& c = soup.triangles[triangle];
    std::swap(c[1], c[2]);
    const std::size_t first = 3 * std::size_t(triangle);
    if (!soup.cornerUvs.empty()) std::swap(soup.cornerUvs[first + 1], soup.cornerUvs[first + 2]);
    if (soup.cornerNormals.empty()) return;
    std::swap(soup.cornerNormals[first + 1], soup.cornerNormals[first + 2]);
    const auto& p = soup.positions;
    const Vec3 front = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]);
    for (std::size_t i = first; i < first + 3; ++i)
        if (soup.cornerNormals[i].cast<double>().dot(front) < 0) soup.cornerNormals[i] *= -1;
}

Result<Repaired> weldVertices(const SharedSoup& soup, const Progress& progress) {
    const std::vector<Index> first = weldMap(soup->positions, progress);
    if (progress.isCancelled()) return cancelledError();
    std::vector<Index> number(first.size(), kUnused);
    for (const Corners& c : soup->triangles)
        for (Index v : c)
            number[first[v]] = 0;
    TriangleSoup result = *soup;
    result.positions.clear();
    for (Index v = 0; v < number.size(); ++v) {
        if (number[v] == kUnused) continue;
        number[v] = Index(result.positions.size());
        result.positions.push_back(soup->positions[v]);
    }
    const std::size_t gone = soup->positions.size() - result.positions.size();
    std::string done = sentence(gone, "vertex", "vertices", "merged or removed");
    if (gone == 0) return Repaired{soup, 0, std::move(done)};
    for (Corners& c : result.triangles)
        for (Index& v : c)
            v = number[first[v]];
    return repaired(std::move(result), gone, std::move(done));
}

Result<Repaired> removeDuplicates(const SharedSoup& soup, const Progress& progress) {
    struct Face {
        Index second, third, surface, triangle;
        auto key() const { return std::tie(second, third, surface); }
    };
    const std::vector<Index> weld = weldMap(soup->positions, progress);
    FiledByVertex<Face> faces(weld.size());
    const auto corners = [&](Index t) {
        const Corners& c = soup->triangles[t];
        return turned({weld[c[0]], weld[c[1]], weld[c[2]]});
    };
    const Index n = Index(soup->triangles.size());
    for (Index t = 0; t < n; ++t)
        faces.count(corners(t)[0]);
    faces.allocate();
    for (Index t = 0; t < n; ++t) {
        const Corners c = corners(t);
        faces.place(c[0], {c[1], c[2], soup->surfaceOf[t], t});
    }
    if (progress.isCancelled()) return cancelledError();
    std::vector<char> kept(n, 1);
    std::size_t gone = 0;
    for (Index v = 0; v < faces.vertices(); ++v) {
        std::sort(faces.begin(v), faces.end(v), [](const Face& a, const Face& b) {
            return std::tuple_cat(a.key(), std::tie(a.triangle)) <
                   std::tuple_cat(b.key(), std::tie(b.triangle));
        });
        for (Face* face = faces.begin(v); face < faces.end(v); ++face)
            if (face != faces.begin(v) && face->key() == face[-1].key()) {
                kept[face->triangle] = 0;
                ++gone;
            }
    }
    std::string done = sentence(gone, "repeated triangle", "repeated triangles", "removed");
    if (gone == 0) return Repaired{soup, 0, std::move(done)};
    return repaired(withTriangles(*soup, kept), gone, std::move(done));
}

Result<Repaired> agreeOnFronts(const SharedSoup& soup, const Progress& progress) {
    const Result<FaceGraph> graph = FaceGraph::build(soup, partOf(progress, 0, 0.7));
    if (!graph) return cancelledError();
    const Result<Orientation> orientation = orientationOf(*graph, partOf(progress, 0.7, 1));
    if (!orientation) return cancelledError();
    const TriangleSet& turns = orientation->turned;
    std::string done = sentence(turns.size(), "triangle", "triangles", "turned over");
    if (turns.empty()) return Repaired{soup, 0, std::move(done)};
    TriangleSoup result = *soup;
    for (Index t : turns)
        turnOver(result, t);
    return repaired(std::move(result), turns.size(), std::move(done));
}

Repaired turnOver(const SharedSoup& soup) {
    TriangleSoup result = *soup;
    for (Index t = 0; t < result.triangles.size(); ++t)
        turnOver(result, t);
    return repaired(std::move(result), soup->triangles.size(),
                    sentence(soup->triangles.size(), "triangle", "triangles", "turned over"));
}

Repaired turnOver(const SharedSoup& soup, const TriangleSet& triangles) {
    TriangleSoup result = *soup;
    for (const Index t : triangles)
        turnOver(result, t);
    return repaired(std::move(result), triangles.size(),
                    sentence(triangles.size(), "triangle", "triangles", "turned over"));
}

Repaired scaled(const SharedSoup& soup, double factor) {
    if (factor == 1) return {soup, 0, "nothing scaled"};
    TriangleSoup result = *soup;
    for (Vec3& p : result.positions)
        p *= factor;
    return repaired(std::move(result), soup->triangles.size(), "all lengths scaled");
}

} // namespace tactum
