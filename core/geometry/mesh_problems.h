// What is unusual about a mesh, and where.
#pragma once

#include "core/geometry/face_graph.h"

namespace tactum {

enum class ProblemKind : std::uint8_t {
    Hole,       ///< connected borders
    Flipped,    ///< edges whose two triangles disagree about front and back
    InsideOut,  ///< closed parts whose front looks inward, and that no other part encloses
    Duplicate,  ///< triangles with the same corners as an earlier one
    Sliver,     ///< triangles whose area is below 1e-12 of the squared diagonal of the box
    Unreachable ///< parts that the proxy cannot come to (core/health/mesh_probe.h)
};

/// All of one kind in one mesh. Body frame, metre.
struct Problem {
    static constexpr std::size_t kMaxTriangles = 10'000;

    ProblemKind kind = ProblemKind::Hole;
    std::size_t count = 0;      ///< in the unit of the kind: as MeshHealth counts
    TriangleSet triangles;      ///< those concerned, at most kMaxTriangles of them
    Vec3 centre = Vec3::Zero(); ///< of a sphere around all of it
    double radius = 0;

    bool operator==(const Problem&) const = default;
};

/// Gathers the triangles of one problem, and where they are.
class ProblemGatherer {
public:
    ProblemGatherer(const TriangleSoup& soup, ProblemKind kind) : soup_(soup) { problem_.kind = kind; }
    void add(Index triangle);
    void count(std::size_t more = 1) { problem_.count += more; }
    /// Appends the problem if it counted anything.
    void finish(std::vector<Problem>& problems);

private:
    const TriangleSoup& soup_;
    Problem problem_;
    Bounds box_;
};

/// Those that the mesh shows by itself, in the order of the kinds; the counts are those of healthOf().
/// About 0.5 s for a million triangles. Fails only when cancelled. Thread: any but real time.
Result<std::vector<Problem>> problemsOf(const FaceGraph& graph, const Progress& progress = {});

} // namespace tactum
