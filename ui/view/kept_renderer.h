// A renderer whose picture is kept while nothing in it changes. Private to this folder.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>

#include "ui/view/gl_window.h"
#include "ui/view/picture_budget.h"

class vtkOpenGLFramebufferObject;

namespace tactum {

/// Copies what it has drawn, colours and depth, and puts the copy back for as long as it would draw the same:
/// until its camera, its background, its list of props, one of them with all that VTK gives a time (place,
/// property, texture, mapper, data), the window's size or its number of samples changes. So it holds for
/// everything that VTK would draw anew by itself; a uniform of a shader has no such time. One picture for
/// each camera and number of samples: several views take turns, and so do a picture that moves and one that
/// rests. In a window that draws coarsely the
/// exact picture is put back as long as it holds, and drawn again when nothing but the touch has changed for
/// a moment; with fewer pixels the picture is drawn small, and put back as large as the window. For layer 0
/// of a GlWindow, or over another one. Thread: ui.
class KeptRenderer : public vtkOpenGLRenderer {
public:
    static KeptRenderer* New();
    vtkTypeMacro(KeptRenderer, vtkOpenGLRenderer)

        void DeviceRender() override;
    /// Blends in the order of the props. VTK's own pass for any order costs 20 ms of 1280 x 800 where the
    /// processor draws, and nothing here needs it: what is laid over the model is one layer, and bubbles are
    /// of one colour.
    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* = nullptr) override {
        UpdateTranslucentPolygonalGeometry();
    }
    void ReleaseGraphicsResources(vtkWindow* window) override;

    /// The renderer of the layer beneath: what it draws is in this one's picture, too.
    void setBeneath(KeptRenderer& beneath) { beneath_ = &beneath; }
    /// The next picture is drawn, whatever is kept.
    void forget() {
        for (auto& [how, kept] : kept_)
            kept.time = 0;
    }
    /// What is kept of it is not needed any more; with the window's context current.
    void forget(const vtkCamera& camera);
    /// How many pictures were drawn, and not put back.
    int drawn() const { return drawn_; }
    /// What drawing took where the processor draws.
    PictureBudget& budget() { return budget_; }

private:
    using Background = std::array<double, 6>;              ///< below and above
    using How = std::tuple<const vtkCamera*, int, Coarse>; ///< the number is that of samples
    struct Kept {
        vtkNew<vtkOpenGLFramebufferObject> pixels;
        std::array<int, 2> size{};  ///< of the window
        std::array<int, 2> drawn{}; ///< of its picture, which may be smaller
        Background background{};
        vtkMTimeType time = 0;                       ///< of the last change that is in it; 0: none is
        std::chrono::steady_clock::time_point since; ///< when it was drawn
    };

    vtkMTimeType lastChangeOfProps();
    vtkMTimeType lastChange();
    Background background();
    Kept& keptOf(int samples, Coarse coarse);
    bool holds(const Kept& kept);
    /// The best coarse picture that holds, if it leaves out no more than that.
    Kept* heldCoarse(int samples, Coarse most);
    void drawOver();
    void draw(Kept& kept);
    void drawSmall(Kept& kept);
    void drawExact(Kept& kept);
    void drawCoarse(Kept& kept);
    /// What `draw` takes where the processor draws, s; nothing for a card, and where the props have changed
    /// since it was timed last, with the change that is given.
    std::optional<double> timeOf(vtkMTimeType& drawnWith, const std::function<void()>& draw);
    void keep(Kept& kept);
    void putBack(Kept& kept);

    KeptRenderer* beneath_ = nullptr;
    std::map<How, Kept> kept_;
    PictureBudget budget_;
    vtkMTimeType exactWith_ = 0, coarseWith_ = 0; ///< the last change of a prop when each was drawn last
    int drawn_ = 0;
};

} // namespace tactum
