#include "ui/select_tool.h"

#include <algorithm>

#include "core/geometry/box_select.h"
#include "ui/document.h"
#include "ui/view/scene_view.h"

namespace tactum {

namespace {

constexpr std::size_t kKeptGraphs = 4;

SelectMode modeOf(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return SelectMode::Subtract;
    return modifiers & Qt::ShiftModifier ? SelectMode::Add : SelectMode::Replace;
}

/// Shift takes one more; of what is selected already it takes it back, as in every file manager.
SelectMode modeFor(Qt::KeyboardModifiers modifiers, const SurfaceRefs& now, SurfaceRef chosen) {
    const SelectMode mode = modeOf(modifiers);
    const bool again = std::ranges::find(now, chosen) != now.end() && now.back() == chosen;
    return mode == SelectMode::Add && again ? SelectMode::Subtract : mode;
}

ScreenBox onScreen(const QRectF& box, const QSizeF& size) {
    return {2 * box.left() / size.width() - 1, 1 - 2 * box.bottom() / size.height(),
            2 * box.right() / size.width() - 1, 1 - 2 * box.top() / size.height()};
}

Eigen::Matrix4d matrixOf(const Pose& pose) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = pose.translation;
    return matrix;
}

} // namespace

SelectTool::SelectTool(Document& document, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
    connect(&job_, &BackgroundJob::progressed, this, &SelectTool::progressed);
    connect(&job_, &BackgroundJob::finished, this, &SelectTool::finished);
}

void SelectTool::withGraphOf(ObjectId id, Use use) {
    const SceneObject* object = document_.scene().find(id);
    if (!object) return;
    for (const auto& graph : graphs_)
        if (haveSameShape(*graph->soup(), *object->geometry)) return use(*graph);
    job_.start([this, use, soup = object->geometry](const Progress& progress) -> BackgroundJob::Delivery {
        auto built = FaceGraph::build(soup, progress);
        if (!built) return [] {}; // cancelled
        return [this, use, graph = std::make_shared<const FaceGraph>(std::move(*built))] {
            if (graphs_.size() == kKeptGraphs) graphs_.erase(graphs_.begin());
            graphs_.push_back(graph);
            use(*graph);
        };
    });
}

void SelectTool::take(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers) {
    if (!hit) {
        if (modeOf(modifiers) == SelectMode::Replace) takeNothing();
        return;
    }
    if (reach_ == SelectReach::Surface) {
        document_.selectFaces({});
        document_.select(hit->surface, modeFor(modifiers, document_.selected(), hit->surface));
    } else if (reach_ == SelectReach::Material) {
        document_.selectFaces({});
        auto like = surfacesLike(document_.scene(), hit->surface);
        std::ranges::rotate(like, std::next(std::ranges::find(like, hit->surface))); // the active one: last
        document_.select(like, modeOf(modifiers));
    } else {
        takeRegion(*hit, modeOf(modifiers));
    }
}

void SelectTool::takeRegion(const PickHit& hit, SelectMode mode) {
    document_.select(hit.surface);
    const ObjectId object = hit.surface.object;
    const auto use = [this, hit, mode, object](const FaceGraph& graph) {
        document_.selectFaces({object, regionAt(graph, hit.triangle)}, mode);
    };
    if (reach_ == SelectReach::Triangle)
        document_.selectFaces({object, {hit.triangle}}, mode);
    else
        withGraphOf(object, use);
}

TriangleSet SelectTool::regionAt(const FaceGraph& graph, Index triangle) const {
    if (reach_ == SelectReach::Connected) return graph.connected(triangle);
    if (reach_ == SelectReach::Smooth) return graph.smooth(triangle, angle_);
    return graph.similar(triangle, angle_, true);
}

void SelectTool::takeBox(const QRectF& box, Qt::KeyboardModifiers modifiers) {
    const SelectMode mode = modeOf(modifiers);
    if (reach_ == SelectReach::Surface || reach_ == SelectReach::Material) return takeSurfacesIn(box, mode);
    const auto active = document_.selection();
    if (active) document_.selectFaces({active->object, trianglesOf(active->object, box)}, mode);
}

void SelectTool::takeSurfacesIn(const QRectF& box, SelectMode mode) {
    SurfaceRefs chosen;
    for (const SceneObject& object : document_.scene().objects) {
        if (!object.visible) continue;
        std::vector<char> met(object.surfaces.size());
        for (const Index face : trianglesOf(object.id, box))
            met[object.geometry->surfaceOf[face]] = true;
        for (Index i = 0; i < met.size(); ++i)
            if (met[i]) chosen.push_back({object.id, i});
    }
    document_.selectFaces({});
    document_.select(chosen, mode);
}

/// Those that can be seen from in front, of surfaces that are visible.
TriangleSet SelectTool::trianglesOf(ObjectId id, const QRectF& box) const {
    const SceneObject& object = *document_.scene().find(id);
    const ViewCamera& camera = view_.camera();
    TriangleSet set = trianglesInBox(*object.geometry, camera.clipFromWorld() * matrixOf(object.pose),
                                     onScreen(box, camera.size));
    std::erase_if(set,
                  [&](Index face) { return !object.surfaces[object.geometry->surfaceOf[face]].visible; });
    return set;
}

void SelectTool::takeAll() {
    SurfaceRefs all;
    for (const SceneObject& object : document_.scene().objects)
        for (Index i = 0; i < object.surfaces.size(); ++i)
            if (object.visible && object.surfaces[i].visible) all.push_back({object.id, i});
    document_.selectFaces({});
    document_.select(all);
}

void SelectTool::takeNothing() {
    document_.selectFaces({});
    document_.select(std::nullopt);
}

void SelectTool::takeLikeActive() {
    const auto active = document_.selection();
    if (!active) return;
    auto like = surfacesLike(document_.scene(), *active);
    std::ranges::rotate(like, std::next(std::ranges::find(like, *active)));
    document_.select(like);
}

void SelectTool::grow() {
    const FaceSelection now = document_.selectedFaces();
    if (now.empty()) return;
    withGraphOf(now.object, [this, now](const FaceGraph& graph) {
        document_.selectFaces({now.object, graph.grown(now.faces)});
    });
}

void SelectTool::shrink() {
    const FaceSelection now = document_.selectedFaces();
    if (now.empty()) return;
    withGraphOf(now.object, [this, now](const FaceGraph& graph) {
        document_.selectFaces({now.object, graph.shrunk(now.faces)});
    });
}

void SelectTool::invert() {
    const FaceSelection& faces = document_.selectedFaces();
    if (!faces.empty()) {
        const auto& soup = *document_.scene().find(faces.object)->geometry;
        return document_.selectFaces({faces.object, inverted(soup, faces.faces)});
    }
    SurfaceRefs others;
    const SurfaceSet selected(document_.selected());
    for (const SceneObject& object : document_.scene().objects)
        for (Index i = 0; i < object.surfaces.size(); ++i)
            if (!selected.has({object.id, i})) others.push_back({object.id, i});
    document_.select(others);
}

} // namespace tactum
