#include "ui/view/smoothed_renderer.h"

#include <vtkObjectFactory.h>

namespace tactum {

vtkStandardNewMacro(SmoothedRenderer);

void SmoothedRenderer::DeviceRender() {
    Superclass::DeviceRender();
    if (smoothed_) filter_->Execute(this);
}

void SmoothedRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    filter_->ReleaseGraphicsResources();
    Superclass::ReleaseGraphicsResources(window);
}

} // namespace tactum
