#include "core/health/examine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/health/mesh_probe.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

Repair repairOf(ProblemKind kind) {
    switch (kind) {
    case ProblemKind::Hole:
        return Repair::FillHoles;
    case ProblemKind::Flipped:
    case ProblemKind::InsideOut:
        return Repair::AgreeOnFronts;
    case ProblemKind::Duplicate:
        return Repair::RemoveDuplicates;
    case ProblemKind::Sliver:
        return Repair::RepairSlivers;
    case ProblemKind::Unreachable:
        break;
    }
    return Repair::None;
}

/// The finding about one kind of problem, in the very words of validate() where that speaks of it.
Finding findingOf(const Problem& problem, const MeshHealth& health, const std::string& object) {
    std::vector<Finding> found;
    MeshHealth only;
    CountedFindings notes(found, object);
    switch (problem.kind) {
    case ProblemKind::Hole:
        only.holes = health.holes;
        only.boundaryEdges = health.boundaryEdges;
        break;
    case ProblemKind::Flipped:
        only.flippedEdges = health.flippedEdges;
        break;
    case ProblemKind::Duplicate:
        only.duplicateFaces = health.duplicateFaces;
        break;
    case ProblemKind::Sliver:
        only.slivers = health.slivers;
        break;
    case ProblemKind::InsideOut:
        notes.add(Severity::Warning, problem.count, "closed part", "whose front looks inward",
                  "turn it over; a surface that is felt from its front alone cannot be felt from outside");
        break;
    case ProblemKind::Unreachable:
        notes.add(Severity::Note, problem.count, "part", "inside another one that the proxy cannot enter",
                  "kept; remove it if nobody is to feel it, or open what is around it");
        break;
    }
    appendHealth(found, object, only);
    return found.front();
}

/// A rim whose triangles disagree is none that can be followed: where that keeps all holes open, they agree
/// first.
Result<Repaired> closeHoles(const std::shared_ptr<const TriangleSoup>& soup, const Progress& progress) {
    auto closed = fillHoles(soup, {}, partOf(progress, 0, 0.4));
    if (!closed || closed->changes > 0) return closed;
    const auto agreed = agreeOnFronts(soup, partOf(progress, 0.4, 0.6));
    if (!agreed || agreed->changes == 0) return agreed ? closed : agreed;
    auto second = fillHoles(agreed->soup, {}, partOf(progress, 0.6, 1));
    if (!second || second->changes > 0) {
        if (second) second->done += ", " + agreed->done;
        return second;
    }
    return closed;
}

class Examination {
public:
    Examination(const Scene& scene, const std::vector<KnownMesh>& known, const Progress& progress)
        : scene_(scene), known_(known), progress_(progress) {}

    Result<Examined> run() {
        for (Finding& finding : validate(scene_))
            result_.findings.push_back({std::move(finding), 0, {}, Repair::None, 1});
        guessScale();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            const SceneObject& object = scene_.objects[i];
            if (!object.geometry || object.geometry->triangles.empty()) continue;
            const double n = double(scene_.objects.size());
            const KnownMesh* mesh = know(object, partOf(progress_, double(i) / n, double(i + 1) / n));
            if (!mesh) return cancelledError();
            for (const Problem& problem : mesh->problems)
                place(object, problem, findingOf(problem, mesh->health, object.name));
        }
        return std::move(result_);
    }

private:
    void guessScale() {
        const auto guess = guessUnit(boundsOf(scene_).diagonal());
        if (!guess) return;
        for (PlacedFinding& found : result_.findings)
            if (found.finding.object.empty() && found.finding.sentence.ends_with("looks like another unit")) {
                found.repair = Repair::Scale;
                found.factor = guess->factor;
            }
    }

    const KnownMesh* know(const SceneObject& object, const Progress& progress) {
        std::vector<Sides> sides;
        for (const Surface& surface : object.surfaces)
            sides.push_back(surface.sides);
        const auto isIt = [&](const KnownMesh& mesh) {
            return mesh.soup == object.geometry && mesh.proxyRadius == scene_.proxyRadius &&
                   mesh.sides == sides;
        };
        const auto here = std::ranges::find_if(result_.meshes, isIt);
        if (here != result_.meshes.end()) return &*here;
        const auto there = std::ranges::find_if(known_, isIt);
        if (there != known_.end()) return &result_.meshes.emplace_back(*there);
        KnownMesh mesh{object.geometry, scene_.proxyRadius, std::move(sides), {}, {}};
        if (!look(mesh, progress)) return nullptr;
        return &result_.meshes.emplace_back(std::move(mesh));
    }

    static bool look(KnownMesh& mesh, const Progress& progress) {
        const auto graph = FaceGraph::build(mesh.soup, partOf(progress, 0, 0.1));
        if (!graph) return false;
        const auto health = healthOf(*mesh.soup, partOf(progress, 0.1, 0.2));
        auto problems = problemsOf(*graph, partOf(progress, 0.2, 0.3));
        if (!health || !problems) return false;
        const auto inside = unreachableParts(*graph, mesh.sides, mesh.proxyRadius, partOf(progress, 0.3, 1));
        if (!inside) return false;
        mesh.health = *health;
        mesh.problems = std::move(*problems);
        if (inside->count > 0) mesh.problems.push_back(*inside);
        return true;
    }

    /// To the finding that says it already, or as a new one.
    void place(const SceneObject& object, const Problem& problem, Finding finding) {
        auto found = std::ranges::find_if(result_.findings, [&](const PlacedFinding& other) {
            return !other.problem && other.finding == finding;
        });
        if (found == result_.findings.end())
            found = result_.findings.insert(found, {std::move(finding), 0, {}, Repair::None, 1});
        found->object = object.id;
        found->problem = problem;
        found->repair = repairOf(problem.kind);
    }

    const Scene& scene_;
    const std::vector<KnownMesh>& known_;
    const Progress& progress_;
    Examined result_;
};

} // namespace

Result<Examined> examine(const Scene& scene, const std::vector<KnownMesh>& known, const Progress& progress) {
    return Examination(scene, known, progress).run();
}

Result<Repaired> repair(const std::shared_ptr<const TriangleSoup>& soup, Repair repair,
                        const Progress& progress) {
    switch (repair) {
    case Repair::FillHoles:
        return closeHoles(soup, progress);
    case Repair::AgreeOnFronts:
        return agreeOnFronts(soup, progress);
    case Repair::RemoveDuplicates:
        return removeDuplicates(soup, progress);
    case Repair::RepairSlivers:
        return repairSlivers(soup, progress);
    case Repair::Scale:
    case Repair::None:
        break;
    }
    return Repaired{soup, 0, "nothing to do"};
}

std::optional<UnitGuess> guessUnit(double diagonal) {
    constexpr double kSmallest = 0.005, kLargest = 2; // m, as validate() has them
    static constexpr std::array<UnitGuess, 5> kGuesses{{{0.001, "millimetres"},
                                                        {0.01, "centimetres"},
                                                        {0.0254, "inches"},
                                                        {1000, "metres taken for millimetres"},
                                                        {39.37007874015748, "metres taken for inches"}}};
    if (!(diagonal > 0) || (diagonal >= kSmallest && diagonal <= kLargest)) return std::nullopt;
    const auto farOff = [&](const UnitGuess& guess) {
        return std::abs(std::log(guess.factor * diagonal / kHandDiagonal));
    };
    const UnitGuess& best = *std::ranges::min_element(kGuesses, {}, farOff);
    const double size = best.factor * diagonal;
    if (size < kSmallest || size > kLargest) return std::nullopt;
    return best;
}

} // namespace tactum
