// A recorded touch in the scene: both paths and some of the forces. Private to this folder.
#pragma once

#include <memory>

#include "core/haptics/replay.h"
#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class vtkRenderer;

namespace tactum {

class PathLayer {
public:
    /// Builds the actors for a trace seen by this camera. Lines have a width in pixels.
    PathLayer(vtkRenderer& solid, vtkRenderer& ghost, const TouchTrace& rows, const ViewCamera& camera,
              const Theme& theme);
    ~PathLayer();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
