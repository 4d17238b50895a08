#include "core/geometry/mesh_problems.h"

#include <algorithm>
#include <tuple>

#include "core/geometry/filing.h"
#include "core/geometry/orientation.h"
#include "core/geometry/sliver.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

using Edge = FaceGraph::Edge;

class Search {
public:
    Search(const FaceGraph& graph, const Progress& progress)
        : graph_(graph), soup_(*graph.soup()), progress_(progress),
          weld_(weldMap(soup_.positions, Progress{{}, progress.cancelled})) {}

    Result<std::vector<Problem>> run() {
        if (progress_.isCancelled()) return cancelledError();
        findHoles();
        findEdges(ProblemKind::Flipped, Edge::Flipped);
        const Result<Orientation> orientation = orientationOf(graph_, partOf(progress_, 0.3, 0.6));
        if (!orientation) return cancelledError();
        findInsideOut(*orientation);
        findDuplicates();
        if (progress_.isCancelled()) return cancelledError();
        findSlivers();
        if (progress_.isCancelled()) return cancelledError();
        return std::move(problems_);
    }

private:
    Corners welded(Index t) const {
        const Corners& c = soup_.triangles[t];
        return {weld_[c[0]], weld_[c[1]], weld_[c[2]]};
    }

    template <class F> void eachEdge(Edge kind, F f) const {
        for (Index t = 0; t < graph_.triangles(); ++t)
            for (int side = 0; side < 3; ++side)
                if (graph_.edgeOf(t, side) == kind) f(t, side);
    }

    void findHoles() {
        ProblemGatherer holes(soup_, ProblemKind::Hole);
        UnionFind rims(weld_.size());
        std::vector<char> seen(weld_.size(), 0);
        std::size_t places = 0, joins = 0;
        eachEdge(Edge::Border, [&](Index t, int side) {
            const Corners c = welded(t);
            const Index a = c[std::size_t(side)], b = c[std::size_t(side + 1) % 3];
            for (Index v : {a, b})
                places += !std::exchange(seen[v], 1);
            joins += rims.join(a, b);
            holes.add(t);
        });
        holes.count(places - joins);
        holes.finish(problems_);
    }

    /// Each edge is seen from all its triangles, and counts at the lowest.
    void findEdges(ProblemKind kind, Edge edge) {
        ProblemGatherer found(soup_, kind);
        eachEdge(edge, [&](Index t, int side) {
            bool isFirst = true;
            if (edge == Edge::Flipped)
                isFirst = t < graph_.neighbour(t, side);
            else
                isFirst = t == graph_.firstAround(t, side);
            found.count(isFirst);
            found.add(t);
        });
        found.finish(problems_);
    }

    void findInsideOut(const Orientation& orientation) {
        ProblemGatherer found(soup_, ProblemKind::InsideOut);
        for (Index t : orientation.insideOut)
            found.add(t);
        found.count(orientation.insideOutPatches);
        found.finish(problems_);
    }

    void findDuplicates() {
        struct Face {
            Index second, third, triangle;
            bool sameAs(const Face& f) const { return second == f.second && third == f.third; }
        };
        FiledByVertex<Face> faces(weld_.size());
        const Index n = Index(graph_.triangles());
        for (Index t = 0; t < n; ++t)
            faces.count(std::ranges::min(welded(t)));
        faces.allocate();
        for (Index t = 0; t < n; ++t) {
            Corners c = welded(t);
            std::ranges::sort(c);
            faces.place(c[0], {c[1], c[2], t});
        }
        ProblemGatherer found(soup_, ProblemKind::Duplicate);
        for (Index v = 0; v < faces.vertices(); ++v) {
            std::sort(faces.begin(v), faces.end(v), [](const Face& a, const Face& b) {
                return std::tie(a.second, a.third, a.triangle) < std::tie(b.second, b.third, b.triangle);
            });
            for (Face* face = faces.begin(v); face < faces.end(v); ++face) {
                if (face == faces.begin(v) || !face->sameAs(face[-1])) continue;
                found.count();
                found.add(face->triangle);
            }
        }
        found.finish(problems_);
    }

    void findSlivers() {
        ProblemGatherer found(soup_, ProblemKind::Sliver);
        const SliverRule isSliver(soup_);
        for (Index t = 0; t < graph_.triangles(); ++t) {
            if (kindOf(welded(t)) != Kind::Triangle || !isSliver(t)) continue;
            found.count();
            found.add(t);
        }
        found.finish(problems_);
    }

    const FaceGraph& graph_;
    const TriangleSoup& soup_;
    const Progress& progress_;
    std::vector<Index> weld_;
    std::vector<Problem> problems_;
};

} // namespace

void ProblemGatherer::add(Index triangle) {
    if (problem_.triangles.size() < Problem::kMaxTriangles) problem_.triangles.push_back(triangle);
    for (Index v : soup_.triangles[triangle])
        box_.add(soup_.positions[v]);
}

void ProblemGatherer::finish(std::vector<Problem>& problems) {
    if (problem_.count == 0) return;
    std::ranges::sort(problem_.triangles);
    const auto twice = std::unique(problem_.triangles.begin(), problem_.triangles.end());
    problem_.triangles.erase(twice, problem_.triangles.end());
    problem_.centre = box_.centre();
    problem_.radius = 0.5 * box_.diagonal();
    problems.push_back(std::move(problem_));
}

Result<std::vector<Problem>> problemsOf(const FaceGraph& graph, const Progress& progress) {
    return Search(graph, progress).run();
}

} // namespace tactum
