// Draws only the outline of what a renderer holds. Private to this folder.
#pragma once

#include <array>
#include <memory>

#include <QColor>

#include <vtkImageProcessingPass.h>
#include <vtkSmartPointer.h>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace tactum {

/// Renders the actors as a mask beside the picture and then colours the pixels around the mask's edge.
/// For a renderer of a layer above 0, seen through everything beneath it. Thread: ui.
class OutlinePass : public vtkImageProcessingPass {
public:
    static OutlinePass* New();
    vtkTypeMacro(OutlinePass, vtkImageProcessingPass)

        void setColour(const QColor& colour) {
        colour_ = colour;
    }
    /// Width in device pixels.
    void setWidth(float pixels) { width_ = pixels; }

    /// The next outline is that of a new mask.
    void forget() { maskTime_ = 0; }

    void Render(const vtkRenderState* state) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
    OutlinePass();
    ~OutlinePass() override;

private:
    void renderMask(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
    void drawEdge(vtkOpenGLRenderWindow* window, const std::array<int, 4>& box);

    std::array<int, 2> size_{};
    vtkMTimeType maskTime_ = 0; ///< the mask is kept while neither camera nor actors change
    bool coarse_ = false;       ///< it is that of coarser meshes
    QColor colour_;
    float width_ = 2;
    vtkSmartPointer<vtkOpenGLFramebufferObject> framebuffer_;
    vtkSmartPointer<vtkTextureObject> mask_;
    std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

} // namespace tactum
