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

/// A framebuffer's lower left part.
struct Part {
    vtkOpenGLFramebufferObject& pixels;
    std::array<int, 2> size;
};

/// False where the driver does not do it.
bool copy(vtkOpenGLRenderWindow& window, const Part& from, const Part& to) {
    auto* gl = QOpenGLContext::currentContext()->functions();
    auto* state = window.GetState();
    while (gl->glGetError() != GL_NO_ERROR) {
    }
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->PushFramebufferBindings();
    from.pixels.Bind(GL_READ_FRAMEBUFFER);
    from.pixels.ActivateReadBuffer(0);
    to.pixels.Bind(GL_DRAW_FRAMEBUFFER);
    to.pixels.ActivateDrawBuffer(0);
    const auto blit = [&](unsigned int what, unsigned int how) {
        state->vtkglBlitFramebuffer(0, 0, from.size[0], from.size[1], 0, 0, to.size[0], to.size[1], what,
                                    how);
    };
    blit(GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    blit(GL_COLOR_BUFFER_BIT, from.size == to.size ? GL_NEAREST : GL_LINEAR);
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

KeptRenderer::Kept* KeptRenderer::heldCoarse(int samples, Coarse most) {
    for (const Coarse coarse : {Coarse::Relief, Coarse::Meshes, Coarse::Pixels})
        if (Kept& kept = keptOf(samples, coarse); coarse <= most && holds(kept)) return &kept;
    return nullptr;
}

void KeptRenderer::DeviceRender() {
    if (beneath_) return drawOver();
    GlWindow& window = windowOf(*this);
    const int samples = window.GetMultiSamples();
    Kept& exact = keptOf(samples, Coarse::None);
    if (!holds(exact) && window.drawsCoarse()) {
        Kept* coarse = heldCoarse(samples, window.coarse());
        if (!coarse) return drawCoarse(keptOf(samples, window.coarse()));
        if (std::chrono::steady_clock::now() - coarse->since < kSettles) return putBack(*coarse);
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
std::optional<double> KeptRenderer::timeOf(vtkMTimeType& drawnWith, const std::function<void()>& draw) {
    const bool asBefore = drawnWith != 0 && drawnWith == lastChangeOfProps();
    const auto before = std::chrono::steady_clock::now();
    draw();
    drawnWith = lastChangeOfProps();
    if (!GlWindow::rendererIsSoftware()) return std::nullopt;
    QOpenGLContext::currentContext()->functions()->glFinish();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    return asBefore ? std::optional(took.count()) : std::nullopt;
}

void KeptRenderer::drawExact(Kept& kept) {
    const auto took = timeOf(exactWith_, [&] { draw(kept); });
    if (took) budget_.took(*took, windowOf(*this).GetMultiSamples() > 0);
}

void KeptRenderer::drawCoarse(Kept& kept) {
    if (windowOf(*this).coarse() == Coarse::Pixels) return drawSmall(kept);
    if (const auto took = timeOf(coarseWith_, [&] { draw(kept); })) budget_.tookCoarse(*took);
}

void KeptRenderer::drawSmall(Kept& kept) {
    const double side = windowOf(*this).coarseSide();
    SetViewport(0, 0, side, side);
    draw(kept);
    SetViewport(0, 0, 1, 1);
    putBack(kept);
}

void KeptRenderer::keep(Kept& kept) {
    GlWindow& window = windowOf(*this);
    std::array<int, 2> drawn{}, corner{};
    GetTiledSizeAndOrigin(&drawn[0], &drawn[1], &corner[0], &corner[1]);
    const int samples = window.GetMultiSamples();
    if (drawn != kept.drawn) {
        window.GetState()->PushFramebufferBindings();
        window.GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
        const int depth = depthBits();
        kept.pixels->SetContext(&window);
        kept.pixels->PopulateFramebuffer(drawn[0], drawn[1], true, 1, VTK_UNSIGNED_CHAR, true, depth,
                                         samples);
        window.GetState()->PopFramebufferBindings();
        kept.drawn = drawn;
    }
    kept.size = sizeOf(window);
    kept.background = background();
    // What drawing itself brought up to date is in the picture.
    kept.time =
        copy(window, {*window.GetRenderFramebuffer(), drawn}, {*kept.pixels, drawn}) ? lastChange() : 0;
}

void KeptRenderer::putBack(Kept& kept) {
    GlWindow& window = windowOf(*this);
    copy(window, {*kept.pixels, kept.drawn}, {*window.GetRenderFramebuffer(), kept.size});
}

void KeptRenderer::ReleaseGraphicsResources(vtkWindow* window) {
    for (auto& [how, kept] : kept_)
        kept.pixels->ReleaseGraphicsResources(window);
    kept_.clear();
    Superclass::ReleaseGraphicsResources(window);
}

} // namespace tactum
