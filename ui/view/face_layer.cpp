#include "ui/view/face_layer.h"

#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kOpacity = 0.55;

/// Segments and points of the soup come out as triangles without an area, which are not drawn.
vtkSmartPointer<vtkCellArray> faceCellsOf(const TriangleSoup& soup, std::span<const Index> faces) {
    std::vector<int> corners;
    corners.reserve(3 * faces.size());
    for (const Index face : faces)
        for (const Index corner : soup.triangles[face])
            corners.push_back(int(corner));
    return cellArray(corners, 3);
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
    data->SetPolys(faceCellsOf(*soup_, faces));
    mapper_->SetInputData(data);
}

void FaceLayer::place(vtkMatrix4x4* matrix) {
    if (!matrix) actor_->VisibilityOff();
    actor_->SetUserMatrix(matrix);
}

} // namespace tactum
