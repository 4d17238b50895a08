#include "ui/tools/select_tool.h"

#include <algorithm>

#include "core/scene/surface_colours.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

constexpr std::size_t kKeptGraphs = 4;

/// Shift takes one more; of what is selected already it takes it back, as in every file manager.
SelectMode modeFor(Qt::KeyboardModifiers modifiers, const SurfaceRefs& now, SurfaceRef chosen) {
    const SelectMode mode = selectModeOf(modifiers);
    const bool again = std::ranges::find(now, chosen) != now.end() && now.back() == chosen;
    return mode == SelectMode::Add && again ? SelectMode::Subtract : mode;
}

} // namespace

SelectMode selectModeOf(Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ControlModifier) return SelectMode::Subtract;
    return modifiers & Qt::ShiftModifier ? SelectMode::Add : SelectMode::Replace;
}

SelectTool::SelectTool(Document& document, QObject* parent) : QObject(parent), document_(document) {
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
        if (selectModeOf(modifiers) == SelectMode::Replace) takeNothing();
        return;
    }
    if (reach_ == SelectReach::Surface) {
        document_.selectFaces({});
        document_.select(hit->surface, modeFor(modifiers, document_.selected(), hit->surface));
    } else if (reach_ == SelectReach::Material) {
        takeAlike(surfacesLike(document_.scene(), hit->surface), hit->surface, selectModeOf(modifiers));
    } else if (reach_ == SelectReach::Colour) {
        takeAlike(surfacesColouredLike(document_.scene(), hit->surface), hit->surface,
                  selectModeOf(modifiers));
    } else {
        takeRegion(*hit, selectModeOf(modifiers));
    }
}

/// What is chosen last is the active one.
void SelectTool::takeAlike(const std::vector<SurfaceRef>& alike, SurfaceRef active, SelectMode mode) {
    SurfaceRefs chosen = alike;
    std::ranges::rotate(chosen, std::next(std::ranges::find(chosen, active)));
    document_.selectFaces({});
    document_.select(chosen, mode);
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
    return graph.similar(triangle, angle_, reach_ == SelectReach::Similar);
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
    if (const auto active = document_.selection())
        takeAlike(surfacesLike(document_.scene(), *active), *active, SelectMode::Replace);
}

void SelectTool::takeColourOfActive() {
    if (const auto active = document_.selection())
        takeAlike(surfacesColouredLike(document_.scene(), *active), *active, SelectMode::Replace);
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
