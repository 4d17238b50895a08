// The last step of every reader: from a soup as the file has it to an object of the scene.
#include "core/base/text.h"
#include "core/files/readers.h"
#include "core/geometry/mesh_health.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

void appendReport(std::vector<Finding>& findings, const std::string& object, const BuildReport& report,
                  const CollapsedTriangles& collapsed) {
    CountedFindings notes(findings, object);
    notes.add(Severity::Note, report.cutPolygons, "polygon", "with more than three corners",
              "cut into triangles");
    notes.add(Severity::Warning, report.fannedPolygons, "polygon", "too intricate to cut along the outline",
              "cut as a fan, which may cover more than the polygon; cut it in the modelling program");
    notes.add(Severity::Note, report.shortPolygons, "face", "with fewer than three corners",
              "kept as a line or point that can be touched");
    notes.add(Severity::Note, report.emptyPolygons, "face", "without corners", "left out");
    notes.add(Severity::Note, report.filledNormals, "corner", "without a usable normal",
              "given that of the triangle");
    notes.add(Severity::Note, report.filledUvs, "corner", "without a usable texture coordinate",
              "given (0, 0)");
    notes.add(Severity::Note, collapsed.toSegments, "triangle", "whose corners lie on one line",
              "kept as a line that can be touched");
    notes.add(Severity::Note, collapsed.toPoints, "triangle", "whose corners lie at one place",
              "kept as a point that can be touched");
}

} // namespace

void demandBounded(const Source& source, std::size_t meshes, std::uint64_t triangles) {
    if (meshes > kMaxShownMeshes)
        source.fail("shows " + std::to_string(meshes) + " meshes with all its copies, and at most " +
                    std::to_string(kMaxShownMeshes) + " are read; join them, or export fewer copies");
    if (triangles > kMaxShownTriangles)
        source.fail("has more than 67 million triangles with all its copies; split or simplify it");
}

std::string complaintOfPlace(const Vec3& p) {
    if (!p.allFinite()) return " is not a finite number; export it again";
    return p.cwiseAbs().maxCoeff() <= kFarthest
               ? ""
               : " is beyond 1e6 m; move the model to its origin, or scale it";
}

std::string complaintOfCorners(std::size_t corners) {
    if (corners <= kMaxCorners) return {};
    return "a face has more than " + std::to_string(kMaxCorners) +
           " corners; cut it in the modelling program";
}

void addObject(LoadedScene& loaded, std::string name, const BuildReport& report, TriangleSoup soup,
               std::vector<Surface> surfaces, const Progress& progress) {
    if (soup.triangles.empty()) return;
    SceneObject object;
    object.name = printable(name, kLongestName);
    object.surfaces = std::move(surfaces);
    for (Surface& surface : object.surfaces)
        surface.name = printable(surface.name, kLongestName);
    appendReport(loaded.findings, object.name, report,
                 collapseFlatTriangles(soup, Progress{{}, progress.cancelled}));
    const Result<MeshHealth> health = healthOf(soup, progress);
    if (!health) throw ReadFault{health.error()};
    appendHealth(loaded.findings, object.name, *health);
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    loaded.scene.add(std::move(object));
}

Result<LoadedScene> sceneOfMesh(std::string name, TriangleSoup soup, std::vector<Surface> surfaces,
                                const Progress& progress) {
    if (soup.triangles.empty())
        return inputError(printable(name) + ": has no triangles: there is nothing to touch");
    LoadedScene loaded;
    try {
        addObject(loaded, std::move(name), {}, std::move(soup), std::move(surfaces), progress);
    } catch (const ReadFault& fault) {
        return tl::unexpected(fault.error);
    }
    return loaded;
}

} // namespace tactum
