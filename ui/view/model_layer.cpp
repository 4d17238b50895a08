#include "ui/view/model_layer.h"

#include <chrono>
#include <cmath>

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/base/screen_colour.h"
#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

/// Up to here normals are made at once: less than a tenth of a second.
constexpr std::size_t kQuickTriangles = 40000;
/// Up to here a body is one of the crowd: the processor moves its vertices, and drawing it by itself would
/// cost more than its triangles.
constexpr std::size_t kSmallBody = 2000;
/// From here on there is a coarser mesh of about so many triangles for what moves: a picture of more takes a
/// processor longer than a fifteenth of a second.
constexpr std::size_t kCoarsenFrom = 100000, kCoarseTriangles = 40000;
/// Of the colours of a map: what they shine by themselves, and what of the light they take.
constexpr double kMapGlow = 0.4, kMapLight = 0.62;

vtkSmartPointer<vtkPolyData> polyData(vtkPoints* points, vtkDataArray* normals,
                                      const DisplaySurface& surface) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    if (normals) data->GetPointData()->SetNormals(normals);
    data->SetPolys(cellArray(surface.triangles, 3));
    if (!surface.segments.empty()) data->SetLines(cellArray(surface.segments, 2));
    if (!surface.points.empty()) data->SetVerts(cellArray(surface.points, 1));
    return data;
}

vtkSmartPointer<vtkPolyData> polyData(const CrowdPart& part) {
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(part.positions));
    return polyData(points, vectorArray(part.normals), part.cells);
}

void setMatrix(vtkMatrix4x4& matrix, const Pose& pose) {
    const Mat3 rotation = pose.rotation.toRotationMatrix();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix.SetElement(row, column, rotation(row, column));
        matrix.SetElement(row, 3, pose.translation[row]);
    }
}

Bounds boxOf(const TriangleSoup& soup) {
    Bounds box;
    for (const auto& triangle : soup.triangles)
        for (const Index corner : triangle)
            box.add(soup.positions[corner]);
    return box;
}

/// How glossy a surface looks: as slippery as it is. Glass on glass at 0.1 is nearly glaze, rubber at 1 is
/// chalk.
float glossOf(const Material& material) {
    return float(std::exp(-2.5 * std::max(0.0, material.staticFriction)));
}

} // namespace

void ModelLayer::setScene(const Scene& scene) {
    std::map<ObjectId, std::unique_ptr<Model>> models;
    for (const SceneObject& object : scene.objects) {
        auto& old = models_[object.id];
        const bool keep = old && haveSameShape(*old->soup, *object.geometry);
        if (old && !keep) drop(*old);
        auto& model = models[object.id] = keep ? std::move(old) : build(object);
        models_.erase(object.id);
        if (model->soup != object.geometry || model->parts.size() != object.surfaces.size())
            regroup(*model, object);
        model->visible = object.visible;
        model->rest = object.pose;
        model->motion = object.motion;
        if (object.body == kWorldBody) model->put.reset();
    }
    for (auto& [id, model] : models_)
        drop(*model);
    models_ = std::move(models);
    gather();
    for (const SceneObject& object : scene.objects)
        update(*models_[object.id], object);
    showCrowd();
}

bool ModelLayer::setLooks(const Scene& scene) {
    bool any = false;
    for (const SceneObject& object : scene.objects) {
        const auto known = models_.find(object.id);
        if (known == models_.end() || known->second->parts.size() != object.surfaces.size()) continue;
        const auto looksLike = [](const auto& part, const Surface& surface) {
            return part->colour == surface.colour && part->gloss == glossOf(surface.material);
        };
        if (std::ranges::equal(known->second->parts, object.surfaces, looksLike)) continue;
        update(*known->second, object);
        any = true;
    }
    return any;
}

/// The crowd anew, where other parts are in it than before.
void ModelLayer::gather() {
    if (!std::exchange(crowdStale_, false)) return;
    std::vector<CrowdPart*> parts;
    for (auto& [id, model] : models_)
        for (auto& part : model->parts)
            if (model->small) parts.push_back(&part->crowd);
    crowd_.setParts(std::move(parts));
    for (auto& [id, model] : models_) {
        place(*model);
        for (auto& part : model->parts)
            if (model->small) crowd_.paint(part->crowd);
    }
    hidingStale_ = true;
}

void ModelLayer::showCrowd() {
    if (std::exchange(hidingStale_, false)) crowd_.showVisible();
}

std::unique_ptr<ModelLayer::Model> ModelLayer::build(const SceneObject& object) {
    auto model = std::make_unique<Model>();
    model->soup = object.geometry;
    model->small = object.geometry->triangles.size() <= kSmallBody;
    model->box = boxOf(*object.geometry);
    resize(*model, object.surfaces.size());
    if (object.geometry->triangles.size() <= kQuickTriangles) {
        show(*model, smoothMesh(*object.geometry));
    } else {
        show(*model, flatMesh(*object.geometry));
        model->made = std::async(std::launch::async, [soup = model->soup, stop = &model->cancelled] {
            Made made{smoothMesh(*soup, Progress{{}, stop}), {}};
            if (soup->triangles.size() >= kCoarsenFrom && !*stop)
                made.coarse = coarseMesh(made.mesh, kCoarseTriangles);
            return made;
        });
    }
    return model;
}

void ModelLayer::resize(Model& model, std::size_t surfaces) {
    while (model.parts.size() > surfaces) {
        drop(*model.parts.back());
        model.parts.pop_back();
    }
    while (model.parts.size() < surfaces) {
        Part& part = *model.parts.emplace_back(std::make_unique<Part>());
        if (!model.small) giveActor(model, part);
    }
}

void ModelLayer::giveActor(const Model& model, Part& part) {
    part.mapper = vtkSmartPointer<ModelMapper>::New();
    part.actor = vtkSmartPointer<vtkActor>::New();
    part.actor->SetMapper(part.mapper);
    part.actor->SetUserMatrix(model.matrix);
    part.actor->GetProperty()->SetPointSize(3);
    showWireframe(*part.actor, wireframe_);
    part.relief = {};
    useStudioLight(*part.actor);
    renderer_.AddActor(part.actor);
}

/// Triangles are of other surfaces now: the vertices stay.
void ModelLayer::regroup(Model& model, const SceneObject& object) {
    dresses_.erase(object.id); // they are of its surfaces
    model.soup = object.geometry;
    if (model.small) {
        resize(model, object.surfaces.size());
        return show(model, smoothMesh(*object.geometry));
    }
    vtkPolyData& shown = *model.parts.front()->own;
    const vtkSmartPointer<vtkPoints> points = shown.GetPoints();
    const vtkSmartPointer<vtkDataArray> normals = shown.GetPointData()->GetNormals();
    resize(model, object.surfaces.size());
    show(model, points, normals);
}

void ModelLayer::show(Model& model, DisplayMesh mesh) {
    if (model.small) {
        const auto surfaces = bySurface(mesh.corners, model.soup->surfaceOf, model.parts.size());
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            model.parts[i]->crowd = crowdPartOf(mesh, surfaces[i]);
            model.parts[i]->cornered = nullptr;
        }
        crowdStale_ = true;
        return;
    }
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(mesh.positions));
    model.corners = std::move(mesh.corners);
    show(model, points, mesh.normals.empty() ? nullptr : vectorArray(mesh.normals).Get());
}

void ModelLayer::show(Model& model, vtkPoints* points, vtkDataArray* normals) {
    const std::size_t count = model.parts.size();
    const auto surfaces = bySurface(model.corners, model.soup->surfaceOf, count);
    const auto coarse = bySurface(model.coarse.corners, model.coarse.surfaceOf(model.soup->surfaceOf), count);
    for (std::size_t i = 0; i < count; ++i) {
        Part& part = *model.parts[i];
        part.own = polyData(points, normals, surfaces[i]);
        part.coarse = model.coarse.corners.empty() ? nullptr : polyData(points, normals, coarse[i]);
        part.smooth = normals != nullptr;
        part.cornered = nullptr;
        part.mapper->SetInputData(part.own);
        part.actor->GetProperty()->SetInterpolation(normals ? VTK_GOURAUD : VTK_FLAT);
    }
}

void ModelLayer::update(Model& model, const SceneObject& object) {
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        model.parts[i]->colour = object.surfaces[i].colour;
        model.parts[i]->gloss = glossOf(object.surfaces[i].material);
        model.parts[i]->visible = object.visible && object.surfaces[i].visible;
    }
    dress(object.id, model);
    place(model);
}

Pose ModelLayer::poseOf(const Model& model) const {
    if (model.put) return *model.put;
    return model.motion ? model.rest * model.motion->at(time_) : model.rest;
}

void ModelLayer::place(Model& model) {
    const Pose now = poseOf(model);
    setMatrix(*model.matrix, now);
    if (!model.small) return;
    for (auto& part : model.parts)
        crowd_.place(part->crowd, now);
}

bool ModelLayer::moveTo(double time) {
    if (time == time_) return false;
    time_ = time;
    bool any = false;
    for (auto& [id, model] : models_) {
        if (!model->motion) continue;
        place(*model);
        any = any || model->visible;
    }
    return any;
}

bool ModelLayer::put(std::span<const PlacedObject> places) {
    bool any = false;
    for (const PlacedObject& placed : places) {
        const auto found = models_.find(placed.object);
        if (found == models_.end()) continue; // of a World that is older than the scene
        Model& model = *found->second;
        if (model.put == placed.pose) continue;
        model.put = placed.pose;
        place(model);
        any = any || model.visible;
    }
    return any;
}

void ModelLayer::putNoOthers(std::span<const PlacedObject> places) {
    for (auto& [id, model] : models_) {
        if (!model->put || std::ranges::find(places, id, &PlacedObject::object) != places.end()) continue;
        model->put.reset();
        place(*model);
    }
}

Bounds ModelLayer::movingBounds() const {
    Bounds box;
    for (const auto& [id, model] : models_) {
        if (!(model->motion || model->put) || !model->visible || model->box.empty()) continue;
        const Pose now = poseOf(*model);
        for (int corner = 0; corner < 8; ++corner)
            box.add(now.apply({(corner & 1 ? model->box.high : model->box.low).x(),
                               (corner & 2 ? model->box.high : model->box.low).y(),
                               (corner & 4 ? model->box.high : model->box.low).z()}));
    }
    return box;
}

void ModelLayer::drop(Model& model) {
    for (auto& part : model.parts)
        drop(*part);
    crowdStale_ = crowdStale_ || model.small;
}

void ModelLayer::drop(Part& part) {
    if (part.actor) renderer_.RemoveActor(part.actor);
    part.actor = nullptr;
}

void ModelLayer::setDresses(std::map<ObjectId, std::vector<SurfaceDress>> dresses) {
    dresses_ = std::move(dresses);
    for (auto& [id, model] : models_)
        dress(id, *model);
    tiles_.dropUnused();
    showCrowd();
}

void ModelLayer::dress(ObjectId id, Model& model) {
    const auto found = dresses_.find(id);
    for (std::size_t i = 0; i < model.parts.size(); ++i)
        dress(model, i,
              found != dresses_.end() && i < found->second.size() ? found->second[i] : SurfaceDress{});
    if (highlight_ && highlight_->object == id) glow(true);
}

void ModelLayer::dress(const Model& model, std::size_t surface, const SurfaceDress& dress) {
    Part& part = *model.parts[surface];
    const bool alone = !model.small || dress.mesh || dress.relief;
    if (alone && !part.actor) giveActor(model, part);
    if (!alone && part.actor) drop(part);
    if (alone) dressAlone(model, surface, dress);
    if (model.small) dressInCrowd(part, dress, part.visible && !alone);
}

// A colour that stands for a number has to be the scale's: a part of its light comes from itself, so that the
// shadows are flat.
void ModelLayer::dressInCrowd(Part& part, const SurfaceDress& dress, bool visible) {
    hidingStale_ = hidingStale_ || part.crowd.visible != visible;
    part.crowd.visible = visible;
    if (dress.mesh) return;
    const Eigen::Vector3f colour = dress.colour ? linearColour(*dress.colour) : part.colour;
    const Eigen::Vector3f shine = (dress.colour ? float(kMapGlow) : 0) * colour;
    const Eigen::Vector3f lit = (dress.colour ? float(kMapLight) : 1) * colour;
    part.glow = {shine.x(), shine.y(), shine.z()};
    if (part.crowd.colour == lit && part.crowd.glow == shine && part.crowd.gloss == part.gloss) return;
    part.crowd.gloss = part.gloss;
    part.crowd.colour = lit;
    part.crowd.glow = shine;
    crowd_.paint(part.crowd);
}

/// That of a large body shares its vertices, as long as nothing is asked of single corners.
vtkPolyData* ModelLayer::reliefMesh(const Model& model, Part& part, std::size_t surface,
                                    const Relief& relief) {
    if (!model.small && !relief.corners) return part.own;
    const bool known = part.cornered && part.relief.worn() == &relief;
    if (!part.cornered) part.cornered = corneredMesh(model.small ? *polyData(part.crowd) : *part.own);
    if (!known) giveCorners(*part.cornered, Index(surface), relief);
    return part.cornered;
}

void ModelLayer::dressAlone(const Model& model, std::size_t surface, const SurfaceDress& dress) {
    Part& part = *model.parts[surface];
    const auto relief = dress.mesh ? nullptr : dress.relief;
    const bool byVertex = dress.mesh && dress.mesh->GetPointData()->GetScalars();
    const bool smooth = dress.mesh || part.smooth || model.small;
    part.actor->SetVisibility(part.visible);
    vtkPolyData* mesh = dress.mesh ? dress.mesh.Get()
                        : relief   ? reliefMesh(model, part, surface, *relief)
                                   : part.own.Get();
    part.mapper->SetInputData(mesh);
    part.mapper->setCoarse(mesh == part.own ? part.coarse.Get() : nullptr);
    part.relief.wear(*part.actor, *part.mapper, relief, tiles_);
    part.mapper->SetScalarVisibility(byVertex);
    vtkProperty& look = *part.actor->GetProperty();
    look.SetSpecular(part.gloss);
    look.SetInterpolation(smooth ? VTK_GOURAUD : VTK_FLAT);
    look.SetAmbient(byVertex ? kMapGlow : 1); // with scalars VTK takes their colour for the ambient, too
    part.glow = {};
    if (dress.colour) {
        setScreenColour(*part.actor, *dress.colour);
        const double* c = look.GetDiffuseColor();
        part.glow = {kMapGlow * c[0], kMapGlow * c[1], kMapGlow * c[2]};
    } else {
        look.SetDiffuseColor(part.colour.x(), part.colour.y(), part.colour.z());
    }
    look.SetAmbientColor(part.glow.data());
    look.SetDiffuse(byVertex || dress.colour ? kMapLight : 1);
}

void ModelLayer::setWireframe(bool on) {
    if (std::exchange(wireframe_, on) == on) return;
    for (auto& [id, model] : models_)
        for (auto& part : model->parts)
            if (part->actor) showWireframe(*part->actor, on);
    crowd_.setWireframe(on);
}

void ModelLayer::setHighlight(std::optional<SurfaceRef> surface, const QColor& colour) {
    glow(false);
    highlight_ = surface;
    glow_ = colour;
    glow(true);
}

void ModelLayer::glow(bool on) {
    if (!highlight_) return;
    const auto model = models_.find(highlight_->object);
    if (model == models_.end() || highlight_->surface >= model->second->parts.size()) return;
    Part& part = *model->second->parts[highlight_->surface];
    std::array<double, 3> c = part.glow;
    if (on) c = {c[0] + glow_.redF(), c[1] + glow_.greenF(), c[2] + glow_.blueF()};
    if (part.actor) return part.actor->GetProperty()->SetAmbientColor(c.data());
    part.crowd.glow = {float(c[0]), float(c[1]), float(c[2])};
    crowd_.paint(part.crowd);
}

vtkMatrix4x4* ModelLayer::matrixOf(ObjectId object) const {
    const auto model = models_.find(object);
    if (model == models_.end() || !model->second->visible || model->second->parts.empty()) return nullptr;
    return model->second->matrix;
}

std::optional<Pose> ModelLayer::placeOf(ObjectId object) const {
    if (!matrixOf(object)) return std::nullopt;
    return poseOf(*models_.at(object));
}

void ModelLayer::take(ObjectId id, Model& model) {
    Made made = model.made.get();
    model.coarse = std::move(made.coarse);
    show(model, std::move(made.mesh));
    dress(id, model);
}

bool ModelLayer::takeFinished() {
    bool any = false;
    for (auto& [id, model] : models_) {
        if (!model->made.valid() ||
            model->made.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            continue;
        take(id, *model);
        any = true;
    }
    return any;
}

bool ModelLayer::hasRelief() const {
    return std::ranges::any_of(models_, [](const auto& each) {
        return std::ranges::any_of(each.second->parts,
                                   [](const auto& part) { return part->relief.worn() && part->visible; });
    });
}

bool ModelLayer::hasCoarse() const {
    return std::ranges::any_of(models_,
                               [](const auto& each) { return !each.second->coarse.corners.empty(); });
}

bool ModelLayer::pending() const {
    for (const auto& [id, model] : models_)
        if (model->made.valid()) return true;
    return false;
}

void ModelLayer::finish() {
    for (auto& [id, model] : models_)
        if (model->made.valid()) take(id, *model);
}

const ModelLayer::Part* ModelLayer::visiblePart(const SurfaceRef& surface) const {
    const auto model = models_.find(surface.object);
    if (model == models_.end() || surface.surface >= model->second->parts.size()) return nullptr;
    const Part& part = *model->second->parts[surface.surface];
    return part.visible ? &part : nullptr;
}

bool ModelLayer::shows(const SurfaceRef& surface) const {
    return visiblePart(surface) != nullptr;
}

Outlined ModelLayer::outlinesOf(const std::vector<SurfaceRef>& surfaces) const {
    Outlined outlines;
    std::array<std::vector<const CrowdPart*>, std::tuple_size_v<Outlined>> small;
    std::map<ObjectId, std::size_t> turns;
    for (const SurfaceRef& surface : surfaces) {
        const Part* part = visiblePart(surface);
        if (!part) continue;
        const std::size_t turn =
            turns.try_emplace(surface.object, turns.size()).first->second % outlines.size();
        if (part->actor)
            outlines[turn].push_back(part->actor);
        else
            small[turn].push_back(&part->crowd);
    }
    for (std::size_t i = 0; i < small.size(); ++i)
        if (!small[i].empty()) outlines[i].push_back(crowd_.outlineOf(small[i]));
    return outlines;
}

} // namespace tactum
