#include "ui/view/model_layer.h"

#include <chrono>

#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

/// Up to here normals are made at once: less than a tenth of a second.
constexpr std::size_t kQuickTriangles = 40000;
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

vtkSmartPointer<vtkMatrix4x4> matrixFrom(const Pose& pose) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    const Mat3 rotation = pose.rotation.toRotationMatrix();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, rotation(row, column));
        matrix->SetElement(row, 3, pose.translation[row]);
    }
    return matrix;
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
        update(*model, object);
    }
    for (auto& [id, model] : models_)
        drop(*model);
    models_ = std::move(models);
}

std::unique_ptr<ModelLayer::Model> ModelLayer::build(const SceneObject& object) {
    auto model = std::make_unique<Model>();
    model->soup = object.geometry;
    resize(*model, object.surfaces.size());
    if (object.geometry->triangles.size() <= kQuickTriangles) {
        show(*model, smoothMesh(*object.geometry));
    } else {
        show(*model, flatMesh(*object.geometry));
        model->smooth = std::async(std::launch::async, [soup = model->soup, stop = &model->cancelled] {
            return smoothMesh(*soup, Progress{{}, stop});
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
        auto& part = *model.parts.emplace_back(std::make_unique<Part>());
        part.actor->SetMapper(part.mapper);
        part.actor->GetProperty()->SetPointSize(3);
        useStudioLight(*part.actor);
        renderer_.AddActor(part.actor);
    }
}

/// Triangles are of other surfaces now: the vertices stay.
void ModelLayer::regroup(Model& model, const SceneObject& object) {
    vtkPolyData& shown = *model.parts.front()->own;
    const vtkSmartPointer<vtkPoints> points = shown.GetPoints();
    const vtkSmartPointer<vtkDataArray> normals = shown.GetPointData()->GetNormals();
    model.soup = object.geometry;
    resize(model, object.surfaces.size());
    show(model, points, normals);
}

void ModelLayer::show(Model& model, DisplayMesh mesh) {
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(mesh.positions));
    model.corners = std::move(mesh.corners);
    show(model, points, mesh.normals.empty() ? nullptr : vectorArray(mesh.normals).Get());
}

void ModelLayer::show(Model& model, vtkPoints* points, vtkDataArray* normals) {
    const auto surfaces = bySurface(model.corners, model.soup->surfaceOf, model.parts.size());
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        Part& part = *model.parts[i];
        part.own = polyData(points, normals, surfaces[i]);
        part.smooth = normals != nullptr;
        part.mapper->SetInputData(part.own);
        part.actor->GetProperty()->SetInterpolation(normals ? VTK_GOURAUD : VTK_FLAT);
    }
}

void ModelLayer::update(Model& model, const SceneObject& object) {
    model.visible = object.visible;
    model.rest = object.pose;
    model.motion = object.motion;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        vtkActor& actor = *model.parts[i]->actor;
        model.parts[i]->colour = object.surfaces[i].colour;
        actor.SetVisibility(object.visible && object.surfaces[i].visible);
    }
    dress(object.id, model);
    place(model);
}

void ModelLayer::place(Model& model) {
    const auto matrix = matrixFrom(model.motion ? model.rest * model.motion->at(time_) : model.rest);
    for (auto& part : model.parts)
        part->actor->SetUserMatrix(matrix);
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

Bounds ModelLayer::movingBounds() const {
    Bounds box;
    for (const auto& [id, model] : models_) {
        if (!model->motion || !model->visible) continue;
        for (const auto& part : model->parts) {
            const double* b = part->actor->GetBounds();
            if (!b) continue; // nothing is in it
            box.add({b[0], b[2], b[4]});
            box.add({b[1], b[3], b[5]});
        }
    }
    return box;
}

void ModelLayer::drop(Model& model) {
    for (auto& part : model.parts)
        drop(*part);
}

void ModelLayer::drop(Part& part) {
    renderer_.RemoveActor(part.actor);
}

void ModelLayer::setDresses(std::map<ObjectId, std::vector<SurfaceDress>> dresses) {
    dresses_ = std::move(dresses);
    for (auto& [id, model] : models_)
        dress(id, *model);
}

// A colour that stands for a number has to be the scale's: a part of its light comes from itself, so that the
// shadows are flat.
void ModelLayer::dress(ObjectId id, Model& model) {
    const auto found = dresses_.find(id);
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        Part& part = *model.parts[i];
        const SurfaceDress dress =
            found != dresses_.end() && i < found->second.size() ? found->second[i] : SurfaceDress{};
        const bool byVertex = dress.mesh && dress.mesh->GetPointData()->GetScalars();
        const bool smooth = dress.mesh || part.smooth;
        part.mapper->SetInputData(dress.mesh ? dress.mesh : part.own);
        part.mapper->SetScalarVisibility(byVertex);
        vtkProperty& look = *part.actor->GetProperty();
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
    if (highlight_ && highlight_->object == id) glow(true);
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
    part.actor->GetProperty()->SetAmbientColor(c.data());
}

vtkMatrix4x4* ModelLayer::matrixOf(ObjectId object) const {
    const auto model = models_.find(object);
    if (model == models_.end() || !model->second->visible || model->second->parts.empty()) return nullptr;
    return model->second->parts.front()->actor->GetUserMatrix();
}

bool ModelLayer::takeFinished() {
    bool any = false;
    for (auto& [id, model] : models_) {
        if (!model->smooth.valid() ||
            model->smooth.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            continue;
        show(*model, model->smooth.get());
        dress(id, *model);
        any = true;
    }
    return any;
}

bool ModelLayer::pending() const {
    for (const auto& [id, model] : models_)
        if (model->smooth.valid()) return true;
    return false;
}

void ModelLayer::finish() {
    for (auto& [id, model] : models_)
        if (model->smooth.valid()) {
            show(*model, model->smooth.get());
            dress(id, *model);
        }
}

vtkActor* ModelLayer::actorOf(const SurfaceRef& surface) const {
    const auto model = models_.find(surface.object);
    if (model == models_.end() || !model->second->visible) return nullptr;
    const auto& parts = model->second->parts;
    if (surface.surface >= parts.size()) return nullptr;
    vtkActor* actor = parts[surface.surface]->actor;
    return actor->GetVisibility() ? actor : nullptr;
}

} // namespace tactum
