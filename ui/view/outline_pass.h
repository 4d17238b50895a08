// Draws only the outline of what a renderer holds. Private to this folder.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <QColor>

#include <vtkImageProcessingPass.h>
#include <vtkSmartPointer.h>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkActor;
class vtkCamera;
class vtkTextureObject;

namespace tactum {

/// Actors by the outline that they share. More objects than that take turns.
using Outlined = std::array<std::vector<vtkSmartPointer<vtkActor>>, 4>;

/// Renders the actors of each outline as a mask beside the picture and then colours the pixels around the
/// mask's edge. For a renderer of a layer above 0, seen through everything beneath it. Thread: ui.
class OutlinePass : public vtkImageProcessingPass {
public:
    static OutlinePass* New();
    vtkTypeMacro(OutlinePass, vtkImageProcessingPass)

        void setColour(const QColor& colour) {
        colour_ = colour;
    }
    /// Width in device pixels.
    void setWidth(float pixels) { width_ = pixels; }

    /// Of the renderer's actors; those that are not among them have no outline.
    void setOutlined(Outlined outlined);

    /// The next outlines are those of new masks.
    void forget() {
        for (auto& [of, mask] : masks_)
            mask.time = 0;
    }
    /// The masks of that camera are not needed any more; with the window's context current.
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

    Outlined outlined_;
    std::map<std::pair<const vtkCamera*, std::size_t>, Mask> masks_; ///< of each outline
    QColor colour_;
    float width_ = 2;
    std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

} // namespace tactum
