#include "ui/view/path_layer.h"

#include <algorithm>
#include <vector>

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTubeFilter.h>

#include "ui/view/touch_shape.h"

namespace tactum {

namespace {

// Logical pixels.
constexpr double kFingerLine = 1.4, kProxyLine = 1.7, kLongestArrow = 90, kPathShaft = 1.3, kPathHead = 4.2,
                 kHeadLength = 11, kMinArrow = 4;
constexpr std::size_t kArrows = 48;

/// The path as a line whose points are at least a pixel apart.
vtkNew<vtkPolyData> lineOf(const TouchTrace& rows, Vec3 TouchRow::*place, double pixel) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> line;
    line->InsertNextCell(0);
    Vec3 last = Vec3::Constant(1e300);
    for (const TouchRow& row : rows) {
        if (((row.*place) - last).norm() < pixel) continue;
        last = row.*place;
        line->InsertCellPoint(points->InsertNextPoint(last.data()));
    }
    line->UpdateCellCount(int(points->GetNumberOfPoints()));
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(line);
    return data;
}

/// A line with a width.
vtkNew<vtkTubeFilter> tubeOf(const TouchTrace& rows, Vec3 TouchRow::*place, double pixel, double width) {
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(lineOf(rows, place, pixel));
    tube->SetRadius(width * pixel);
    tube->SetNumberOfSides(10);
    tube->CappingOn();
    return tube;
}

double largestForce(const TouchTrace& rows) {
    double most = 0;
    for (const TouchRow& row : rows)
        most = std::max(most, row.force.norm());
    return most;
}

} // namespace

struct PathLayer::Impl {
    Impl(vtkRenderer& solid, vtkRenderer& ghost, const TouchTrace& rows, double pixel)
        : finger(solid, ghost, *tubeOf(rows, &TouchRow::finger, pixel, kFingerLine)),
          proxy(solid, ghost, *tubeOf(rows, &TouchRow::proxy, pixel, kProxyLine)) {}

    TouchShape finger, proxy;
    std::vector<std::unique_ptr<TouchArrow>> arrows;
};

PathLayer::PathLayer(vtkRenderer& solid, vtkRenderer& ghost, const TouchTrace& rows, const ViewCamera& camera,
                     const Theme& theme) {
    const double pixel = camera.pixelSize(camera.focus);
    impl_ = std::make_unique<Impl>(solid, ghost, rows, pixel);
    impl_->finger.setColour(theme.finger);
    impl_->proxy.setColour(theme.proxy);
    const double most = largestForce(rows);
    for (std::size_t i = 0; i < rows.size(); i += std::max<std::size_t>(1, rows.size() / kArrows)) {
        const TouchRow& row = rows[i];
        const double pixels = most > 0 ? kLongestArrow * row.force.norm() / most : 0;
        if (pixels < kMinArrow) continue;
        auto& arrow = *impl_->arrows.emplace_back(std::make_unique<TouchArrow>(solid, ghost));
        arrow.setColour(theme.proxy);
        arrow.place(row.proxy, row.proxy + pixels * pixel * row.force.normalized(), kPathShaft * pixel,
                    kPathHead * pixel, kHeadLength * pixel);
    }
}

PathLayer::~PathLayer() = default;

} // namespace tactum
