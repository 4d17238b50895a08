// VTK's generic OpenGL window, told by two functions how to reach its context. Private to this folder.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <vtkGenericOpenGLRenderWindow.h>

#include "ui/view/occlusion_texture.h"

class QOpenGLContext;
class QSurface;

namespace tactum {

/// What is drawn more coarsely than it is, to save time.
enum class Coarse {
    None,
    Relief, ///< noise without its finest octaves, of three planes mostly the one that faces most
    Meshes, ///< that as well, and coarser meshes where there are some
    Pixels, ///< that as well, and fewer pixels
};

/// A render window for a context that Qt owns. Thread: ui.
class GlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GlWindow* New();
    vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

        /// How to make the context current and whether it is. Empty functions: there is no context.
        void connect(std::function<void()> makeCurrent, std::function<bool()> isCurrent);

    void MakeCurrent() override;
    bool IsCurrent() override;
    int SupportsOpenGL() override { return 1; }
    void OpenGLInitContext() override;
    void PushContext() override;
    void PopContext() override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

    /// `side`: of what is drawn with fewer pixels, in sides of the window.
    void setCoarse(Coarse coarse, double side = 1) {
        coarse_ = coarse;
        coarseSide_ = side;
    }
    double coarseSide() const { return coarseSide_; }
    Coarse coarse() const { return coarse_; }
    bool drawsCoarse() const { return coarse_ != Coarse::None; }
    /// What takes light away from what a ModelMapper draws here.
    OcclusionTexture& occlusion() { return occlusion_; }
    /// Renders one frame into the framebuffer that is bound now, and leaves Qt's view of the state intact.
    void renderFrame();
    /// The same into a part of it, which is as large as this window; from the lower left corner. For a window
    /// that does not bring its frames there by itself.
    void renderFrameAt(int left, int bottom);
    /// The same for what `draw` renders, in the size that it says itself.
    void drawAside(const std::function<void()>& draw);
    /// True when the current context draws on the processor.
    static bool rendererIsSoftware();

private:
    std::function<void()> makeCurrent_;
    std::function<bool()> isCurrent_;
    std::vector<std::pair<QOpenGLContext*, QSurface*>> stack_;
    Coarse coarse_ = Coarse::None;
    double coarseSide_ = 1;
    OcclusionTexture occlusion_;
};

} // namespace tactum
