#include "ui/view/touch_shape.h"

#include <algorithm>

#include <vtkAlgorithm.h>
#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kGhostOpacity = 0.5;

/// From the origin to Y = 1, radius 1.
vtkNew<vtkCylinderSource> rod() {
    vtkNew<vtkCylinderSource> source;
    source->SetRadius(1);
    source->SetHeight(1);
    source->SetCenter(0, 0.5, 0);
    source->SetResolution(20);
    return source;
}

/// The same as a cone with its tip at Y = 1.
vtkNew<vtkConeSource> cone() {
    vtkNew<vtkConeSource> source;
    source->SetRadius(1);
    source->SetHeight(1);
    source->SetDirection(0, 1, 0);
    source->SetCenter(0, 0.5, 0);
    source->SetResolution(28);
    return source;
}

} // namespace

TouchShape::TouchShape(vtkRenderer& solid, vtkRenderer& ghost, vtkAlgorithm& source)
    : inSolid_(solid), inGhost_(ghost) {
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

TouchShape::~TouchShape() {
    inSolid_.RemoveActor(solid_);
    inGhost_.RemoveActor(ghost_);
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
    const Mat3 turn = turnOnto(Vec3::UnitY(), axis).toRotationMatrix();
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

TouchArrow::TouchArrow(vtkRenderer& solid, vtkRenderer& ghost)
    : shaft_(solid, ghost, *rod()), head_(solid, ghost, *cone()) {}

void TouchArrow::setColour(const QColor& colour, double opacity) {
    shaft_.setColour(colour, opacity);
    head_.setColour(colour, opacity);
}

void TouchArrow::setVisible(bool visible) {
    shaft_.setVisible(visible);
    head_.setVisible(visible);
}

void TouchArrow::place(const Vec3& from, const Vec3& to, double shaftRadius, double headRadius,
                       double headLength) {
    const double length = (to - from).norm();
    const Vec3 axis = (to - from) / length;
    headLength = std::min(headLength, length);
    shaft_.place(from, axis, shaftRadius, length - 0.9 * headLength);
    head_.place(to - headLength * axis, axis, headRadius, headLength);
}

} // namespace tactum
