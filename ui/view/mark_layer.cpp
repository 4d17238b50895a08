#include "ui/view/mark_layer.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace tactum {

namespace {

constexpr float kWidth = 2.5f;   // pixels
constexpr double kBehind = 0.45; // opacity of what is hidden

vtkNew<vtkPolyData> edgesOf(const TriangleSoup& soup, const TriangleSet& triangles, const Pose& pose) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    for (Index t : triangles) {
        vtkIdType first = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p_W = pose.apply(soup.positions[soup.triangles[t][i]]);
            const vtkIdType id = points->InsertNextPoint(p_W.data());
            if (i == 0) first = id;
        }
        const vtkIdType loop[] = {first, first + 1, first + 2, first};
        lines->InsertNextCell(4, loop);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

} // namespace

MarkLayer::MarkLayer(vtkRenderer& solid, vtkRenderer& ghost) : solid_(solid), ghost_(ghost) {
    for (vtkActor* actor : {front_.Get(), behind_.Get()}) {
        actor->GetProperty()->SetLineWidth(kWidth);
        actor->GetProperty()->LightingOff();
        actor->VisibilityOff();
        actor->PickableOff();
    }
    behind_->GetProperty()->SetOpacity(kBehind);
    solid_.AddActor(front_);
    ghost_.AddActor(behind_);
}

MarkLayer::~MarkLayer() {
    solid_.RemoveActor(front_);
    ghost_.RemoveActor(behind_);
}

void MarkLayer::show(const TriangleSoup* soup, const TriangleSet& triangles, const Pose& pose) {
    any_ = soup && !triangles.empty();
    for (vtkActor* actor : {front_.Get(), behind_.Get()})
        actor->SetVisibility(any_);
    if (!any_) return;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(edgesOf(*soup, triangles, pose));
    mapper->ScalarVisibilityOff();
    // The lines lie in the very faces that they mark.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);
    front_->SetMapper(mapper);
    behind_->SetMapper(mapper);
}

void MarkLayer::setColour(const QColor& colour) {
    for (vtkActor* actor : {front_.Get(), behind_.Get()})
        actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

} // namespace tactum
