#include "ui/view/touch_shape.h"

#include <vtkAlgorithm.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {
constexpr double kGhostOpacity = 0.42;
}

TouchShape::TouchShape(vtkRenderer& solid, vtkRenderer& ghost, vtkAlgorithm& source) {
    mapper_->SetInputConnection(source.GetOutputPort());
    for (vtkActor* actor : {solid_.Get(), ghost_.Get()}) {
        actor->SetMapper(mapper_);
        // Blended in place: sorting a few small things is not worth a pass of its own.
        actor->ForceOpaqueOn();
        useStudioLight(*actor);
    }
    solid.AddActor(solid_);
    ghost.AddActor(ghost_);
}

void TouchShape::setColour(const QColor& colour, double opacity) {
    for (vtkActor* actor : {solid_.Get(), ghost_.Get()}) {
        setScreenColour(*actor, colour);
        const QColor glow =
            QColor::fromRgbF(0.12f * colour.redF(), 0.12f * colour.greenF(), 0.12f * colour.blueF());
        actor->GetProperty()->SetAmbientColor(glow.redF(), glow.greenF(), glow.blueF());
    }
    solid_->GetProperty()->SetOpacity(opacity);
    ghost_->GetProperty()->SetOpacity(opacity * kGhostOpacity);
}

void TouchShape::setVisible(bool visible) {
    solid_->SetVisibility(visible);
    ghost_->SetVisibility(visible);
}

void TouchShape::place(const Vec3& p, const Vec3& axis, double across, double along) {
    const Mat3 turn = Quat::FromTwoVectors(Vec3::UnitY(), axis).toRotationMatrix();
    const Mat3 linear = turn * Vec3(across, along, across).asDiagonal();
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, linear(row, column));
        matrix->SetElement(row, 3, p[row]);
    }
    solid_->SetUserMatrix(matrix);
    ghost_->SetUserMatrix(matrix);
}

} // namespace tactum
