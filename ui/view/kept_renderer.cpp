#include "ui/view/kept_renderer.h"

#include <algorithm>

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp3D.h>
#include <vtkPropCollection.h>

namespace tactum {

vtkStandardNewMacro(KeptRenderer);

namespace {

vtkOpenGLRenderWindow& windowOf(vtkRenderer& renderer) {
    return static_cast<vtkOpenGLRenderWindow&>(*renderer.GetRenderWindow());
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

vtkMTimeType KeptRenderer::lastChange() {
    vtkMTimeType last = std::max(GetMTime(), GetViewProps()->GetMTime()); // the camera's is among its own
    vtkCollectionSimpleIterator it;
    GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = GetViewProps()->GetNextProp(it)) {
        last = std::max(last, prop->GetRedrawMTime());
        if (auto* placed = vtkProp3D::SafeDownCast(prop))
            last = std::max(last, placed->GetUserTransformMatrixMTime());
    }
    return beneath_ ? std::max(last, beneath_->lastChange()) : last;
}

void KeptRenderer::DeviceRender() {
    if (beneath_ && VisibleActorCount() == 0) return; // nothing is added to what lies beneath
    vtkOpenGLRenderWindow& window = windowOf(*this);
    Kept& kept = kept_[window.GetMultiSamples()];
    if (kept.time != 0 && kept.time == lastChange() && kept.size == sizeOf(window)) return putBack(kept);
    ++drawn_;
    Superclass::DeviceRender();
    keep(kept);
}

void KeptRenderer::keep(Kept& kept) {
    vtkOpenGLRenderWindow& window = windowOf(*this);
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
    // What drawing itself brought up to date is in the picture.
    kept.time = copy(window, *window.GetRenderFramebuffer(), *kept.pixels) ? lastChange() : 0;
}

void KeptRenderer::putBack(Kept& kept) {
    vtkOpenGLRenderWindow& window = windowOf(*this);
    copy(window, *kept.pixels, *window.GetRenderFramebuffer());
}

void KeptRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    for (auto& [samples, kept] : kept_)
        kept.pixels->ReleaseGraphicsResources(window);
    kept_.clear();
    Superclass::ReleaseGraphicsResources(window);
}

} // namespace tactum
