// Which triangles are neighbours, and the regions of a mesh that follow from it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/triangle_set.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// The neighbours of every triangle of a soup: those that share an edge with it, as many as there are.
/// Vertices at the same place count as one, as in mesh_health.h; nothing else is assumed. Segments are
/// neighbours of segments and points at their ends, points of what begins, ends or lies where they do.
///
/// Built once, on a worker: about 0.4 s for a million triangles. Linear memory, whatever the mesh (at most 80
/// bytes a triangle); linear time but for the sorting of each vertex' edges. Every region then takes a few
/// tens of milliseconds at most for a million triangles. Immutable; shares the soup. Thread: any but real
/// time, many at a time.
///
/// Not a half-edge mesh: that holds neither edges of three triangles nor segments, so that regions would end
/// where the soup had to be cut open for it, and costs four times as much.
class FaceGraph {
public:
    /// Fails only when cancelled. At most 2^31 - 1 triangles.
    static Result<FaceGraph> build(std::shared_ptr<const TriangleSoup> soup, const Progress& progress = {});

    const std::shared_ptr<const TriangleSoup>& soup() const { return soup_; }
    std::size_t triangles() const { return normals_.size(); }
    /// Unit length, body frame; zero for segments, points and triangles without an area.
    const Eigen::Vector3f& normal(Index triangle) const { return normals_[triangle]; }

    // Regions. A seed is a number of a triangle, and always in its own region. Angles in radian, good to a
    // millionth; both relations between two triangles are symmetric.

    /// All that can be reached over edges.
    TriangleSet connected(Index seed) const;
    /// The lowest triangle of the connected region.
    Index partOf(Index triangle) const { return ring_[triangle].part; }
    /// All that can be reached over edges that bend by no more than the angle, from 0 to pi. Where two
    /// triangles meet it does not matter whether they agree about front and back. Where more do, only those
    /// count as going on into each other that agree; an edge of more than kMaxAround is a crease. So is
    /// every edge of a triangle without an area: nobody can say how it bends.
    TriangleSet smooth(Index seed, double creaseAngle) const;
    /// All whose normal is within the angle of the seed's, anywhere or reached over others that are.
    TriangleSet similar(Index seed, double angle, bool connected) const;

    /// With the neighbours of all.
    TriangleSet grown(const TriangleSet& set) const;
    /// Without those that have a neighbour outside. A border of the mesh is not outside.
    TriangleSet shrunk(const TriangleSet& set) const;

    /// Where the set ends, for drawing: edges of its triangles at which there is also a triangle outside, or
    /// no other one at all. Each once, as two positions of the soup.
    std::vector<std::array<Index, 2>> outline(const TriangleSet& set) const;

    /// What an edge of a triangle is to the mesh; None for the sides of segments and points.
    enum class Edge : std::uint8_t {
        None,
        Border,  ///< nobody else is there
        Joint,   ///< one neighbour, which agrees about front and back
        Flipped, ///< one neighbour, which does not
        Crowd    ///< more than one neighbour
    };
    Edge edgeOf(Index triangle, int side) const { return ring_[triangle].edge[std::size_t(side)]; }
    /// Across a Joint or a Flipped edge.
    Index neighbour(Index triangle, int side) const { return ring_[triangle].across[std::size_t(side)]; }

    /// The lowest triangle at an edge that is a Crowd.
    Index firstAround(Index triangle, int side) const {
        return usesOf(ring_[triangle].across[std::size_t(side)]).first->triangle;
    }

    /// Calls f(neighbour) for the neighbours over side i (0 to 2: the edge from corner i to the next; of a
    /// segment its ends; of a point 0) of a triangle.
    template <class F> void eachAcross(Index triangle, int side, F f) const {
        const Index other = ring_[triangle].across[std::size_t(side)];
        if (other < kMany)
            f(other);
        else if (other != kNothing)
            for (const Use& use : usesOf(other))
                if (use.triangle != triangle) f(use.triangle);
    }

    static constexpr std::size_t kMaxAround = 16;

private:
    /// What is around a triangle: all that a step of a flood asks for, in one line of the cache.
    struct alignas(32) Ring {
        std::array<Index, 3> across{kNothing, kNothing, kNothing}; ///< neighbour, group of uses, or nothing
        std::array<float, 3> bend{kCrease, kCrease, kCrease};      ///< of the edge to the neighbour, radian
        std::array<Edge, 3> edge{};
        Index part = 0; ///< lowest triangle of all that hang together over edges
    };
    /// A triangle at an edge of more than two.
    struct Use {
        Index triangle;
        std::uint8_t side;
        bool forward; ///< runs along the edge from the lower vertex to the upper one
    };
    struct Uses {
        const Use *first, *last;
        const Use* begin() const { return first; }
        const Use* end() const { return last; }
        std::size_t size() const { return std::size_t(last - first); }
    };
    class Builder;

    FaceGraph() = default;
    Uses usesOf(Index group) const {
        const std::size_t i = group - kMany;
        return {uses_.data() + begin_[i], uses_.data() + begin_[i + 1]};
    }
    template <class Goes> TriangleSet flood(Index seed, Goes goes) const;
    bool goesOn(const Use& a, const Use& b, float chord) const;

    static constexpr Index kMany = Index{1} << 31; ///< and above: a group of uses
    static constexpr Index kNothing = ~Index{0};
    static constexpr float kCrease = 4; ///< radian: more than any angle

    std::shared_ptr<const TriangleSoup> soup_;
    std::vector<Ring> ring_;
    std::vector<Eigen::Vector3f> normals_;
    std::vector<std::size_t> begin_{0}; ///< of each group in uses_, and the end
    std::vector<Use> uses_;
};

} // namespace tactum
