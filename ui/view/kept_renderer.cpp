#include "ui/view/kept_renderer.h"

#include <algorithm>

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp3D.h>
#include <vtkPropCollection.h>

#include "ui/view/gl_window.h"

namespace tactum {

vtkStandardNewMacro(KeptRenderer);

namespace {

/// After which a picture of the coarse model gives way to the exact one.
constexpr std::chrono::milliseconds kSettles{250};

GlWindow& windowOf(vtkRenderer& renderer) {
    return static_cast<GlWindow&>(*renderer.GetRenderWindow());
}

std::array<int, 2> sizeOf(vtkOpenGLRenderWindow& window) {
    const int* size = window.GetSize();
    return {size[0], size[1]};
}

/// Of the framebuffer that is bound: copies must have the same, or nothing is copied.
int depthBits() {
    GLint bits = 0;
    QOpenGLContext::currentContext()->functions()->glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    return bits;
}

/// False where the driver does not do it.
bool copy(vtkOpenGLRenderWindow& window, vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to) {
    auto* gl = QOpenGLContext::currentContext()->functions();
    auto* state = window.GetState();
    while (gl->glGetError() != GL_NO_ERROR) {
    }
    const auto [width, height] = sizeOf(window);
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->PushFramebufferBindings();
    from.Bind(GL_READ_FRAMEBUFFER);
    from.ActivateReadBuffer(0);
    to.Bind(GL_DRAW_FRAMEBUFFER);
    to.ActivateDrawBuffer(0);
    state->vtkglBlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                                GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    state->PopFramebufferBindings();
    return gl->glGetError() == GL_NO_ERROR;
}

} // namespace

vtkMTimeType KeptRenderer::lastChangeOfProps() {
    vtkMTimeType last = GetViewProps()->GetMTime();
    vtkCollectionSimpleIterator it;
    GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = GetViewProps()->GetNextProp(it)) {
        last = std::max(last, prop->GetRedrawMTime());
        if (auto* placed = vtkProp3D::SafeDownCast(prop))
            last = std::max(last, placed->GetUserTransformMatrixMTime());
    }
    return last;
}

// Not the renderer's own time: it is another one whenever cameras take turns, or windows of other shapes.
vtkMTimeType KeptRenderer::lastChange() {
    const vtkMTimeType last = std::max(GetActiveCamera()->GetMTime(), lastChangeOfProps());
    return beneath_ ? std::max(last, beneath_->lastChange()) : last;
}

KeptRenderer::Background KeptRenderer::background() {
    if (beneath_) return beneath_->background();
    const double *low = GetBackground(), *high = GetBackground2();
    return {low[0], low[1], low[2], high[0], high[1], high[2]};
}

KeptRenderer::Kept& KeptRenderer::keptOf(int samples, Coarse coarse) {
    return kept_[{GetActiveCamera(), samples, coarse}];
}

void KeptRenderer::forget(const vtkCamera& camera) {
    std::erase_if(kept_, [&](auto& each) {
        if (std::get<0>(each.first) != &camera) return false;
        each.second.pixels->ReleaseGraphicsResources(GetRenderWindow());
        return true;
    });
}

bool KeptRenderer::holds(const Kept& kept) {
    return kept.time != 0 && kept.time == lastChange() && kept.background == background() &&
           kept.size == sizeOf(windowOf(*this));
}

void KeptRenderer::DeviceRender() {
    if (beneath_) return drawOver();
    GlWindow& window = windowOf(*this);
    const int samples = window.GetMultiSamples();
    Kept& exact = keptOf(samples, Coarse::None);
    if (!holds(exact) && window.drawsCoarse()) {
        Kept& coarse = keptOf(samples, window.coarse());
        if (!holds(coarse)) return draw(coarse);
        if (std::chrono::steady_clock::now() - coarse.since < kSettles) return putBack(coarse);
    }
    window.setCoarse(Coarse::None);
    if (holds(exact)) return putBack(exact);
    drawExact(exact);
}

// Where the model is drawn coarsely, that is what it lies over.
void KeptRenderer::drawOver() {
    if (VisibleActorCount() == 0) return; // nothing is added to what lies beneath
    GlWindow& window = windowOf(*this);
    Kept& kept = keptOf(window.GetMultiSamples(), window.coarse());
    holds(kept) ? putBack(kept) : draw(kept);
}

void KeptRenderer::draw(Kept& kept) {
    ++drawn_;
    Superclass::DeviceRender();
    keep(kept);
    kept.since = std::chrono::steady_clock::now();
}

// A processor that draws is waited for: what it still has to do would hold the window a moment later.
void KeptRenderer::drawExact(Kept& kept) {
    const bool asBefore = drawnWith_ != 0 && drawnWith_ == lastChangeOfProps();
    const auto before = std::chrono::steady_clock::now();
    draw(kept);
    drawnWith_ = lastChangeOfProps();
    if (!GlWindow::rendererIsSoftware()) return;
    QOpenGLContext::currentContext()->functions()->glFinish();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    if (asBefore) budget_.took(took.count(), windowOf(*this).GetMultiSamples() > 0);
}

void KeptRenderer::keep(Kept& kept) {
    GlWindow& window = windowOf(*this);
    const std::array<int, 2> size = sizeOf(window);
    const int samples = window.GetMultiSamples();
    if (size != kept.size) {
        window.GetState()->PushFramebufferBindings();
        window.GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
        const int depth = depthBits();
        kept.pixels->SetContext(&window);
        kept.pixels->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, depth, samples);
        window.GetState()->PopFramebufferBindings();
        kept.size = size;
    }
    kept.background = background();
    // What drawing itself brought up to date is in the picture.
    kept.time = copy(window, *window.GetRenderFramebuffer(), *kept.pixels) ? lastChange() : 0;
}

void KeptRenderer::putBack(Kept& kept) {
    GlWindow& window = windowOf(*this);
    copy(window, *kept.pixels, *window.GetRenderFramebuffer());
}

void KeptRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    for (auto& [how, kept] : kept_)
        kept.pixels->ReleaseGraphicsResources(window);
    kept_.clear();
    Superclass::ReleaseGraphicsResources(window);
}

} // namespace tactum
