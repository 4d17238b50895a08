#include "core/health/mesh_probe.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/collision/nearest.h"
#include "core/geometry/filing.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

Problem finished(ProblemGatherer gatherer, ProblemKind kind) {
    std::vector<Problem> found;
    gatherer.finish(found);
    if (!found.empty()) return std::move(found.front());
    Problem none;
    none.kind = kind;
    return none;
}

/// What hangs together over edges.
struct Part {
    std::vector<Index> triangles;
    Bounds box;
    double volume = 0;     ///< six times it
    double widest = 0;     ///< m: diagonal of the widest opening
    bool feltFront = true; ///< every triangle, from there
    bool feltBack = true;
};

class ReachSearch {
public:
    ReachSearch(const FaceGraph& graph, const std::vector<Sides>& sides, double diameter,
                const Progress& progress)
        : graph_(graph), soup_(*graph.soup()), sides_(sides), diameter_(diameter), progress_(progress) {}

    Result<Problem> run() {
        gatherParts();
        findOpenings();
        std::vector<const Part*> shells;
        for (const Part& part : parts_)
            if (isShell(part)) shells.push_back(&part);
        const auto size = [](const Part* part) { return -part->box.diagonal(); };
        std::ranges::stable_sort(shells, {}, size);
        shells.resize(std::min<std::size_t>(shells.size(), 64));
        hidden_.assign(parts_.size(), 0);
        for (std::size_t i = 0; i < shells.size() && !progress_.isCancelled(); ++i) {
            hideWhatIsIn(*shells[i]);
            if (progress_.report) progress_.report(double(i + 1) / double(shells.size()));
        }
        if (progress_.isCancelled()) return cancelledError();
        ProblemGatherer found(soup_, ProblemKind::Unreachable);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            found.count(std::size_t(hidden_[i]));
            if (hidden_[i])
                for (Index t : parts_[i].triangles)
                    found.add(t);
        }
        return finished(std::move(found), ProblemKind::Unreachable);
    }

private:
    const Vec3& corner(Index t, std::size_t i) const { return soup_.positions[soup_.triangles[t][i]]; }

    void gatherParts() {
        numberOf_.resize(graph_.triangles());
        for (Index t = 0; t < graph_.triangles(); ++t) {
            const Index lowest = graph_.partOf(t);
            if (lowest == t) {
                numberOf_[t] = Index(parts_.size());
                parts_.emplace_back();
            }
            numberOf_[t] = numberOf_[lowest];
            add(parts_[numberOf_[t]], t);
        }
    }

    void add(Part& part, Index t) {
        part.triangles.push_back(t);
        for (std::size_t i = 0; i < 3; ++i)
            part.box.add(corner(t, i));
        const Vec3& origin = corner(part.triangles.front(), 0);
        part.volume += (corner(t, 0) - origin).dot((corner(t, 1) - origin).cross(corner(t, 2) - origin));
        const Sides sides = sides_.empty() ? Sides::Both : sides_[soup_.surfaceOf[t]];
        part.feltFront &= sides != Sides::Back;
        part.feltBack &= sides != Sides::Front;
    }

    void findOpenings() {
        const std::vector<Index> weld = weldMap(soup_.positions);
        UnionFind rims(weld.size());
        const auto eachBorder = [&](auto f) {
            for (Index t = 0; t < graph_.triangles(); ++t)
                for (int side = 0; side < 3; ++side)
                    if (graph_.edgeOf(t, side) == FaceGraph::Edge::Border)
                        f(t, weld[soup_.triangles[t][std::size_t(side)]],
                          weld[soup_.triangles[t][std::size_t(side + 1) % 3]]);
        };
        eachBorder([&](Index, Index a, Index b) { rims.join(a, b); });
        std::map<Index, Bounds> boxes;
        eachBorder([&](Index, Index a, Index b) {
            Bounds& box = boxes[rims.rootOf(a)];
            box.add(soup_.positions[a]);
            box.add(soup_.positions[b]);
        });
        eachBorder([&](Index t, Index a, Index) {
            double& widest = parts_[numberOf_[t]].widest;
            widest = std::max(widest, boxes[rims.rootOf(a)].diagonal());
        });
    }

    bool isShell(const Part& part) const {
        const bool lets = part.volume > 0 ? !part.feltFront : !part.feltBack;
        return parts_.size() > 1 && part.triangles.size() >= 4 && part.volume != 0 && !lets &&
               part.widest < diameter_;
    }

    static bool holds(const Bounds& outer, const Bounds& inner) {
        return (outer.low.array() < inner.low.array()).all() &&
               (outer.high.array() > inner.high.array()).all();
    }

    void hideWhatIsIn(const Part& shell) {
        std::optional<CollisionMesh> mesh; // only when it is asked for
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (hidden_[i] || &parts_[i] == &shell || !holds(shell.box, parts_[i].box)) continue;
            if (!mesh) mesh = meshOf(shell);
            hidden_[i] = isInside(*mesh, shell.volume > 0, parts_[i]);
        }
    }

    CollisionMesh meshOf(const Part& part) const {
        auto soup = std::make_shared<TriangleSoup>();
        for (Index t : part.triangles) {
            const Index first = Index(soup->positions.size());
            for (std::size_t i = 0; i < 3; ++i)
                soup->positions.push_back(corner(t, i));
            soup->triangles.push_back({first, first + 1, first + 2});
        }
        soup->surfaceOf.assign(soup->triangles.size(), 0);
        CollisionMesh mesh;
        mesh.tree = SphereTree(*soup);
        mesh.soup = std::move(soup);
        return mesh;
    }

    bool isInside(const CollisionMesh& shell, bool frontOutside, const Part& part) const {
        const std::size_t samples = std::min<std::size_t>(part.triangles.size(), 32);
        for (std::size_t i = 0; i < samples; ++i) {
            const Index t = part.triangles[i * part.triangles.size() / samples];
            const double front = nearestOn(shell, corner(t, i % 3)).front;
            if (frontOutside ? front >= 0 : front <= 0) return false;
        }
        return true;
    }

    const FaceGraph& graph_;
    const TriangleSoup& soup_;
    const std::vector<Sides>& sides_;
    double diameter_;
    const Progress& progress_;
    std::vector<Part> parts_;
    std::vector<Index> numberOf_; ///< of the part of each triangle
    std::vector<char> hidden_;
};

} // namespace

Result<Problem> unreachableParts(const FaceGraph& graph, const std::vector<Sides>& sides, double proxyRadius,
                                 const Progress& progress) {
    return ReachSearch(graph, sides, 2 * proxyRadius, progress).run();
}

} // namespace tactum
