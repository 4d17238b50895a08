#include "ui/view/crowd.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include <vtkActor.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

using CellList = std::vector<int> DisplaySurface::*;
constexpr std::array<CellList, 3> kLists{&DisplaySurface::triangles, &DisplaySurface::segments,
                                         &DisplaySurface::points};

void setSize(vtkFloatArray& array, int vertices) {
    array.SetNumberOfTuples(vertices);
    array.Modified();
}

void fill(vtkFloatArray& array, const CrowdPart& part, const Eigen::Vector3f& value) {
    for (std::size_t i = 0; i < part.positions.size(); i += 3)
        std::copy_n(value.data(), 3, array.GetPointer(3 * part.first + vtkIdType(i)));
    array.Modified();
}

} // namespace

CrowdPart crowdPartOf(const DisplayMesh& mesh, const DisplaySurface& surface) {
    CrowdPart part;
    std::unordered_map<int, int> own;
    const auto copy = [](std::vector<float>& to, const std::vector<float>& from, int vertex) {
        to.insert(to.end(), from.begin() + 3 * vertex, from.begin() + 3 * vertex + 3);
    };
    for (const CellList list : kLists)
        for (const int vertex : surface.*list) {
            const auto [known, isNew] = own.try_emplace(vertex, int(own.size()));
            if (isNew) {
                copy(part.positions, mesh.positions, vertex);
                copy(part.normals, mesh.normals, vertex);
            }
            (part.cells.*list).push_back(known->second);
        }
    return part;
}

Crowd::Crowd(vtkRenderer& renderer) {
    colours_->SetName("bodyColour");
    glows_->SetName("bodyGlow");
    for (vtkFloatArray* array : {positions_.Get(), normals_.Get(), colours_.Get(), glows_.Get()})
        array->SetNumberOfComponents(3);
    gloss_->SetName("bodyGloss");
    points_->SetData(positions_);
    for (const char* name : {"bodyColour", "bodyGlow", "bodyGloss"})
        mapper_->MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    mapper_->ScalarVisibilityOff();
    actor_->SetMapper(mapper_);
    actor_->VisibilityOff();
    actor_->GetProperty()->SetInterpolationToGouraud();
    actor_->GetProperty()->SetPointSize(3);
    useStudioLight(*actor_);
    useVertexColours(*actor_);
    renderer.AddActor(actor_);
}

void Crowd::setParts(std::vector<CrowdPart*> parts) {
    parts_ = std::move(parts);
    int vertices = 0;
    for (CrowdPart* part : parts_) {
        part->first = vertices;
        vertices += int(part->positions.size() / 3);
    }
    for (vtkFloatArray* array :
         {positions_.Get(), normals_.Get(), colours_.Get(), glows_.Get(), gloss_.Get()})
        setSize(*array, vertices);
}

void Crowd::place(const CrowdPart& part, const Pose& X_WB) {
    const Eigen::Matrix3f turn = X_WB.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f shift = X_WB.translation.cast<float>();
    using Vertex = Eigen::Map<const Eigen::Vector3f>;
    for (std::size_t i = 0; i < part.positions.size(); i += 3) {
        const vtkIdType at = 3 * part.first + vtkIdType(i);
        Eigen::Map<Eigen::Vector3f>(positions_->GetPointer(at)) = turn * Vertex(&part.positions[i]) + shift;
        Eigen::Map<Eigen::Vector3f>(normals_->GetPointer(at)) = turn * Vertex(&part.normals[i]);
    }
    positions_->Modified();
    normals_->Modified();
    points_->Modified(); // its box is another one
}

void Crowd::paint(const CrowdPart& part) {
    fill(*colours_, part, part.colour);
    fill(*glows_, part, part.glow);
    std::fill_n(gloss_->GetPointer(part.first), part.positions.size() / 3, part.gloss);
    gloss_->Modified();
}

void Crowd::setWireframe(bool on) {
    showWireframe(*actor_, on);
}

vtkSmartPointer<vtkPolyData> Crowd::cellsOf(const std::vector<const CrowdPart*>& parts) const {
    std::array<std::vector<int>, 3> cells;
    for (const CrowdPart* part : parts)
        for (std::size_t kind = 0; kind < kLists.size(); ++kind)
            for (const int vertex : part->cells.*kLists[kind])
                cells[kind].push_back(part->first + vertex);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->GetPointData()->SetNormals(normals_);
    if (!cells[0].empty()) data->SetPolys(cellArray(cells[0], 3));
    if (!cells[1].empty()) data->SetLines(cellArray(cells[1], 2));
    if (!cells[2].empty()) data->SetVerts(cellArray(cells[2], 1));
    return data;
}

void Crowd::showVisible() {
    std::vector<const CrowdPart*> shown;
    std::ranges::copy_if(parts_, std::back_inserter(shown), &CrowdPart::visible);
    const auto data = cellsOf(shown);
    data->GetPointData()->AddArray(colours_);
    data->GetPointData()->AddArray(glows_);
    data->GetPointData()->AddArray(gloss_);
    mapper_->SetInputData(data);
    actor_->SetVisibility(!shown.empty());
}

vtkSmartPointer<vtkActor> Crowd::outlineOf(const std::vector<const CrowdPart*>& parts) const {
    vtkNew<ModelMapper> mapper;
    mapper->SetInputData(cellsOf(parts));
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
}

} // namespace tactum
