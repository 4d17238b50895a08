#include "ui/view/model_layer.h"

#include <chrono>

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {

/// Up to here normals are made at once: less than a tenth of a second.
constexpr std::size_t kQuickTriangles = 40000;

vtkSmartPointer<vtkFloatArray> vectors(const std::vector<float>& values) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(vtkIdType(values.size() / 3));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

vtkSmartPointer<vtkCellArray> cells(const std::vector<int>& corners, int each) {
    vtkNew<vtkTypeInt32Array> offsets, connectivity;
    offsets->SetNumberOfValues(vtkIdType(corners.size()) / each + 1);
    for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
        offsets->SetValue(i, int(i) * each);
    connectivity->SetNumberOfValues(vtkIdType(corners.size()));
    std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(offsets, connectivity);
    return array;
}

vtkSmartPointer<vtkPolyData> polyData(vtkPoints* points, vtkDataArray* normals,
                                      const DisplaySurface& surface) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    if (normals) data->GetPointData()->SetNormals(normals);
    data->SetPolys(cells(surface.triangles, 3));
    if (!surface.segments.empty()) data->SetLines(cells(surface.segments, 2));
    if (!surface.points.empty()) data->SetVerts(cells(surface.points, 1));
    return data;
}

vtkSmartPointer<vtkMatrix4x4> matrixOf(const Pose& pose) {
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
    vtkPolyData& shown = *model.parts.front()->mapper->GetInput();
    const vtkSmartPointer<vtkPoints> points = shown.GetPoints();
    const vtkSmartPointer<vtkDataArray> normals = shown.GetPointData()->GetNormals();
    model.soup = object.geometry;
    resize(model, object.surfaces.size());
    show(model, points, normals);
}

void ModelLayer::show(Model& model, DisplayMesh mesh) {
    vtkNew<vtkPoints> points;
    points->SetData(vectors(mesh.positions));
    model.corners = std::move(mesh.corners);
    show(model, points, mesh.normals.empty() ? nullptr : vectors(mesh.normals).Get());
}

void ModelLayer::show(Model& model, vtkPoints* points, vtkDataArray* normals) {
    const auto surfaces = bySurface(model.corners, model.soup->surfaceOf, model.parts.size());
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        Part& part = *model.parts[i];
        part.mapper->SetInputData(polyData(points, normals, surfaces[i]));
        part.actor->GetProperty()->SetInterpolation(normals ? VTK_GOURAUD : VTK_FLAT);
    }
}

void ModelLayer::update(Model& model, const SceneObject& object) {
    model.visible = object.visible;
    model.rest = object.pose;
    model.motion = object.motion;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        vtkActor& actor = *model.parts[i]->actor;
        const auto& c = object.surfaces[i].colour;
        actor.GetProperty()->SetDiffuseColor(c.x(), c.y(), c.z());
        actor.SetVisibility(object.visible && object.surfaces[i].visible);
    }
    place(model);
}

void ModelLayer::place(Model& model) {
    const auto matrix = matrixOf(model.motion ? model.rest * model.motion->at(time_) : model.rest);
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
    if (part.actor == highlighted_) highlighted_ = nullptr;
    renderer_.RemoveActor(part.actor);
}

void ModelLayer::setHighlight(std::optional<SurfaceRef> surface, const QColor& glow) {
    if (highlighted_) highlighted_->GetProperty()->SetAmbientColor(0, 0, 0);
    highlighted_ = surface ? actorOf(*surface) : nullptr;
    if (!highlighted_) return;
    highlighted_->GetProperty()->SetAmbientColor(glow.redF(), glow.greenF(), glow.blueF());
}

bool ModelLayer::takeFinished() {
    bool any = false;
    for (auto& [id, model] : models_) {
        if (!model->smooth.valid() ||
            model->smooth.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            continue;
        show(*model, model->smooth.get());
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
        if (model->smooth.valid()) show(*model, model->smooth.get());
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
