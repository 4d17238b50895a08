// Draws only the outline of what a renderer holds. Private to this folder.
#pragma once

#include <array>
#include <map>
#include <memory>

#include <QColor>

#include <vtkImageProcessingPass.h>
#include <vtkSmartPointer.h>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkCamera;
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
    void forget() {
        for (auto& [camera, mask] : masks_)
            mask.time = 0;
    }
    /// The mask of that camera is not needed any more; with the window's context current.
    void forget(const vtkCamera& camera, vtkWindow* window);

    void Render(const vtkRenderState* state) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
    OutlinePass();
    ~OutlinePass() override;

private:
    /// Kept while neither its camera nor the actors change.
    struct Mask {
        void release(vtkWindow* window);

        std::array<int, 2> size{};
        vtkMTimeType time = 0;
        bool coarse = false; ///< it is that of coarser meshes
        vtkSmartPointer<vtkOpenGLFramebufferObject> framebuffer;
        vtkSmartPointer<vtkTextureObject> pixels;
    };
    void renderMask(Mask& mask, const vtkRenderState* state, vtkOpenGLRenderWindow* window);
    void drawEdge(const Mask& mask, vtkOpenGLRenderWindow* window, const std::array<int, 4>& box);

    std::map<const vtkCamera*, Mask> masks_;
    QColor colour_;
    float width_ = 2;
    std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

} // namespace tactum
