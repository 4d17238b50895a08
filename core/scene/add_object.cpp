// The last step of every reader: from a soup as the file has it to an object of the scene.
#include "core/geometry/mesh_health.h"
#include "core/scene/readers.h"
#include "core/scene/text.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

/// Findings about one object, each only if its count is not zero.
class Notes {
public:
    Notes(std::vector<Finding>& findings, const std::string& object) : findings_(findings), object_(object) {}

    void add(Severity severity, std::size_t count, std::string_view noun, const std::string& predicate,
             const std::string& remedy) {
        if (count > 0)
            findings_.push_back({severity, object_, counted(count, noun) + " " + predicate, remedy});
    }

private:
    std::vector<Finding>& findings_;
    const std::string& object_;
};

void appendReport(std::vector<Finding>& findings, const std::string& object, const BuildReport& report,
                  const CollapsedTriangles& collapsed) {
    Notes notes(findings, object);
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

void appendHealth(std::vector<Finding>& findings, const std::string& object, const MeshHealth& health) {
    Notes notes(findings, object);
    const auto note = Severity::Note, warning = Severity::Warning;
    notes.add(note, health.slivers, "triangle", "too thin to see",
              "kept; merge close vertices to remove them");
    notes.add(warning, health.duplicateFaces, "triangle", "that repeats another one",
              "kept; remove doubles in the modelling program");
    notes.add(note, health.nonManifoldEdges, "edge", "with more than two triangles",
              "kept; touch does not mind");
    notes.add(warning, health.flippedEdges, "edge", "whose two triangles face opposite ways",
              "kept; both sides can be touched, but make the normals consistent for shading");
    if (health.boundaryEdges > 0)
        notes.add(note, health.holes, "open rim", "with " + counted(health.boundaryEdges, "edge"),
                  "kept open; the finger can pass through if it is larger than the proxy");
    notes.add(note, health.unreferencedVertices, "vertex", "that no face uses", "ignored");
    if (health.components > 1)
        notes.add(note, health.components, "part", "that share no vertex",
                  "kept; if they should be one, merge close vertices");
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

} // namespace tactum
