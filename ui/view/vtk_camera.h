// The view's camera as VTK's. Private to this folder.
#pragma once

#include <numbers>

#include <vtkCamera.h>

#include "ui/view/view_camera.h"

namespace tactum {

inline void applyCamera(const ViewCamera& from, vtkCamera& to) {
    to.SetFocalPoint(from.focus.data());
    to.SetPosition(from.eye().data());
    to.SetViewUp(from.up().data());
    to.SetViewAngle(from.fieldOfView * 180 / std::numbers::pi);
}

} // namespace tactum
