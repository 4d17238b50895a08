// A renderer that smooths the edges in the picture of all layers so far. Private to this folder.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLRenderer.h>

namespace tactum {

/// For the last layer. VTK's own switch would smooth nothing where the layer itself is empty. Thread: ui.
class SmoothedRenderer : public vtkOpenGLRenderer {
public:
    static SmoothedRenderer* New();
    vtkTypeMacro(SmoothedRenderer, vtkOpenGLRenderer)

        void setSmoothed(bool smoothed) {
        smoothed_ = smoothed;
    }
    bool smoothed() const { return smoothed_; }
    void DeviceRender() override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

private:
    vtkNew<vtkOpenGLFXAAFilter> filter_; ///< Lottes, FXAA, NVIDIA 2009
    bool smoothed_ = false;
};

} // namespace tactum
