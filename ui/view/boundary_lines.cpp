#include "ui/view/boundary_lines.h"

#include <algorithm>
#include <array>
#include <optional>

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr Index kNone = ~Index(0), kSeveral = kNone - 1;
constexpr double kLineOpacity = 0.55;
/// Up to so many triangles the edges are found at once: some milliseconds.
constexpr std::size_t kQuickEdges = 40000;

/// The surface of the triangles at each position, or kSeveral.
std::vector<Index> surfacesAt(const TriangleSoup& soup) {
    std::vector<Index> at(soup.positions.size(), kNone);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        for (const Index corner : soup.triangles[i]) {
            Index& known = at[corner];
            known = known == kNone || known == soup.surfaceOf[i] ? soup.surfaceOf[i] : kSeveral;
        }
    return at;
}

} // namespace

std::vector<BoundaryEdge> boundaryEdges(const TriangleSoup& soup) {
    const std::vector<Index> at = surfacesAt(soup);
    std::map<std::array<Index, 2>, std::array<Index, 2>> sides;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(soup.triangles[i][k], soup.triangles[i][(k + 1) % 3]);
            if (low == high || at[low] != kSeveral || at[high] != kSeveral) continue;
            auto& [first, second] =
                sides.try_emplace({low, high}, std::array{soup.surfaceOf[i], kNone}).first->second;
            if (second == kNone && soup.surfaceOf[i] != first) second = soup.surfaceOf[i];
        }
    std::vector<BoundaryEdge> edges;
    for (const auto& [ends, surfaces] : sides)
        if (surfaces[1] != kNone) edges.push_back({ends, surfaces});
    return edges;
}

BoundaryLines::BoundaryLines(vtkRenderer& renderer) {
    mapper_->SetResolveCoincidentTopologyToPolygonOffset(); // of lines as well: before the triangles
    mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -4);
    mapper_->setCoarse(vtkNew<vtkPolyData>()); // a coarser mesh has its surfaces elsewhere
    actor_->SetMapper(mapper_);
    actor_->PickableOff();
    actor_->ForceTranslucentOn();
    actor_->GetProperty()->SetOpacity(kLineOpacity);
    useNoLight(*actor_);
    actor_->VisibilityOff();
    renderer.AddActor(actor_);
}

void BoundaryLines::setTheme(const Theme& theme) {
    const QColor& colour = theme.skyBottom;
    const double shade = theme.dark ? 1 : 0.35; // darker than what it parts
    actor_->GetProperty()->SetColor(shade * colour.redF(), shade * colour.greenF(), shade * colour.blueF());
}

void BoundaryLines::setScene(const Scene& scene) {
    std::map<ObjectId, Object> now;
    for (const SceneObject& object : scene.objects) {
        if (object.surfaces.size() < 2) continue;
        Object& made = now[object.id] = std::move(objects_[object.id]);
        objects_.erase(object.id);
        std::vector<bool> visible;
        for (const Surface& surface : object.surfaces)
            visible.push_back(surface.visible);
        const bool other = made.soup != object.geometry;
        stale_ = stale_ || other || made.visible != visible;
        made.visible = std::move(visible);
        made.soup = object.geometry;
        if (other) find(made);
    }
    stale_ = stale_ || !objects_.empty(); // some are gone
    objects_ = std::move(now);
}

void BoundaryLines::find(Object& object) {
    object.work.reset();
    object.edges.clear();
    if (object.soup->triangles.size() <= kQuickEdges) {
        object.edges = boundaryEdges(*object.soup);
        return;
    }
    object.work = std::make_unique<Aside<std::vector<BoundaryEdge>>>();
    object.work->start([soup = object.soup](const Progress&) { return boundaryEdges(*soup); });
}

bool BoundaryLines::pending() const {
    return std::ranges::any_of(objects_, [](const auto& each) { return each.second.work != nullptr; });
}

bool BoundaryLines::takeFinished() {
    bool any = false;
    for (auto& [id, object] : objects_) {
        auto found = object.work ? object.work->take() : nullptr;
        if (!found) continue;
        object.edges = std::move(*found);
        object.work.reset();
        any = stale_ = true;
    }
    return any;
}

void BoundaryLines::place(const std::function<std::optional<Pose>(ObjectId)>& placeOf) {
    if (shown_) {
        for (auto& [id, object] : objects_) {
            const auto place = placeOf(id);
            stale_ = stale_ || place != object.drawn;
            object.drawn = place;
        }
        if (std::exchange(stale_, false)) draw();
    }
    actor_->SetVisibility(count() > 0);
}

void BoundaryLines::draw() {
    std::vector<float> places;
    std::vector<int> ends;
    for (const auto& [id, object] : objects_)
        for (const BoundaryEdge& edge : object.edges) {
            const bool seen =
                std::ranges::any_of(edge.surfaces, [&](Index i) { return bool(object.visible[i]); });
            if (!seen || !object.drawn) continue;
            for (const Index end : edge.ends) {
                const Vec3 p_W = object.drawn->apply(object.soup->positions[end]);
                ends.push_back(int(places.size() / 3));
                for (const double x : p_W)
                    places.push_back(float(x));
            }
        }
    drawn_ = ends.size() / 2;
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(places));
    vtkNew<vtkPolyData> lines;
    lines->SetPoints(points);
    lines->SetLines(cellArray(ends, 2));
    mapper_->SetInputData(lines);
}

} // namespace tactum
