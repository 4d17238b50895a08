#include "ui/view/face_layer.h"

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kOpacity = 0.55;

/// Segments and points of the soup come out as triangles without an area, which are not drawn.
vtkNew<vtkCellArray> cellsOf(const TriangleSoup& soup, std::span<const Index> faces) {
    vtkNew<vtkTypeInt32Array> offsets, connectivity;
    offsets->SetNumberOfValues(vtkIdType(faces.size()) + 1);
    connectivity->SetNumberOfValues(3 * vtkIdType(faces.size()));
    for (std::size_t i = 0; i < faces.size(); ++i) {
        offsets->SetValue(vtkIdType(i), 3 * int(i));
        for (int corner = 0; corner < 3; ++corner)
            connectivity->SetValue(3 * vtkIdType(i) + corner,
                                   int(soup.triangles[faces[i]][std::size_t(corner)]));
    }
    offsets->SetValue(vtkIdType(faces.size()), 3 * int(faces.size()));
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    return cells;
}

} // namespace

FaceLayer::FaceLayer(vtkRenderer& renderer) {
    mapper_->SetResolveCoincidentTopologyToPolygonOffset();
    mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2);
    actor_->SetMapper(mapper_);
    actor_->GetProperty()->SetOpacity(kOpacity);
    actor_->PickableOff();
    useNoLight(*actor_);
    actor_->VisibilityOff();
    renderer.AddActor(actor_);
}

void FaceLayer::setTheme(const Theme& theme) {
    actor_->GetProperty()->SetColor(theme.accent.redF(), theme.accent.greenF(), theme.accent.blueF());
}

void FaceLayer::show(std::shared_ptr<const TriangleSoup> soup, std::span<const Index> faces) {
    actor_->SetVisibility(soup && !faces.empty());
    if (!soup || faces.empty()) return;
    if (soup_ != soup) {
        points_->SetDataTypeToFloat();
        points_->SetNumberOfPoints(vtkIdType(soup->positions.size()));
        for (std::size_t i = 0; i < soup->positions.size(); ++i)
            points_->SetPoint(vtkIdType(i), soup->positions[i].data());
        points_->Modified();
    }
    soup_ = std::move(soup);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(cellsOf(*soup_, faces));
    mapper_->SetInputData(data);
}

void FaceLayer::place(vtkMatrix4x4* matrix) {
    if (!matrix) actor_->VisibilityOff();
    actor_->SetUserMatrix(matrix);
}

} // namespace tactum
