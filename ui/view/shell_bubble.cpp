#include "ui/view/shell_bubble.h"

#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "ui/view/studio_light.h"

namespace tactum {

ShellBubble::ShellBubble(vtkRenderer& renderer) : renderer_(renderer) {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1);
    ball->SetThetaResolution(64);
    ball->SetPhiResolution(48);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    actor_->SetMapper(mapper);
    useBubbleLight(*actor_);
    renderer_.AddActor(actor_);
}

ShellBubble::~ShellBubble() {
    renderer_.RemoveActor(actor_);
}

void ShellBubble::setColour(const QColor& colour) {
    setScreenColour(*actor_, colour);
}

void ShellBubble::place(const Vec3& centre, double radius) {
    actor_->SetPosition(centre.x(), centre.y(), centre.z());
    actor_->SetScale(radius);
}

} // namespace tactum
