#include "ui/view/outline_pass.h"

#include <algorithm>
#include <iterator>

#include <qopengl.h>

#include <vtkActorCollection.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include "ui/view/gl_window.h"

namespace tactum {

vtkStandardNewMacro(OutlinePass);

namespace {

// The share of covered samples on two rings around a pixel outside the mask: it falls off softly, which
// smooths the line where nothing is multisampled. Loops without turns inside and far from the mask, because a
// processor that draws runs both sides of an if, but leaves a loop.
constexpr const char* kEdgeShader = R"(//VTK::System::Dec
in vec2 texCoord;
uniform sampler2D mask;
uniform vec2 reach;
uniform vec3 colour;
//VTK::Output::Dec
void main() {
    int looks = texture2D(mask, texCoord).a > 0.99 ? 0 : 4;
    float about = 0.0;
    for (int i = 0; i < looks; ++i)
        about += texture2D(mask, texCoord + 1.5 * reach * vec2(i < 2 ? 0.71 : -0.71, i % 2 == 0 ? 0.71 : -0.71)).a;
    int turns = about > 0.0 ? 8 : 0;
    vec2 direction = vec2(1.0, 0.0);
    float near = 0.0, far = 0.0;
    for (int i = 0; i < turns; ++i) {
        vec2 offset = direction * reach;
        near += texture2D(mask, texCoord + 0.5 * offset).a;
        far += texture2D(mask, texCoord + offset).a;
        direction = vec2(0.70710678 * (direction.x - direction.y), 0.70710678 * (direction.x + direction.y));
    }
    float alpha = clamp(near / 2.0, 0.0, 1.0) * 0.55 + clamp(far / 3.0, 0.0, 1.0) * 0.45;
    gl_FragData[0] = vec4(colour, alpha);
}
)";

/// The rectangle of the screen that holds some actors, grown by a margin; pixels, from the lower left.
std::array<int, 4> screenBox(vtkRenderer& renderer, const std::vector<vtkProp*>& props,
                             std::array<int, 2> size, int margin) {
    vtkBoundingBox box3;
    for (vtkProp* prop : props)
        if (const double* bounds = prop->GetBounds()) box3.AddBounds(bounds);
    std::array<double, 6> bounds{};
    if (box3.IsValid()) box3.GetBounds(bounds.data());
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for (int corner = 0; corner < 8; ++corner) {
        renderer.SetWorldPoint(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
                               bounds[4 + ((corner >> 2) & 1)], 1);
        renderer.WorldToDisplay();
        for (int i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], renderer.GetDisplayPoint()[i] - margin);
            high[i] = std::max(high[i], renderer.GetDisplayPoint()[i] + margin);
        }
    }
    std::array<int, 4> box{};
    for (int i = 0; i < 2; ++i) {
        box[i] = int(std::clamp<double>(low[i], 0, size[i]));
        box[2 + i] = int(std::clamp<double>(high[i] + 1, 0, size[i])) - box[i];
    }
    return box;
}

/// When anything changed that the mask depends on, but the size.
vtkMTimeType lastChange(vtkRenderer& renderer) {
    vtkMTimeType last = renderer.GetActiveCamera()->GetMTime();
    vtkActorCollection* actors = renderer.GetActors();
    vtkCollectionSimpleIterator it;
    for (actors->InitTraversal(it); vtkActor* actor = actors->GetNextActor(it);)
        last = std::max(last, actor->GetRedrawMTime());
    return last;
}

} // namespace

OutlinePass::OutlinePass() {
    vtkNew<vtkCameraPass> camera;
    vtkNew<vtkOpaquePass> opaque;
    camera->SetDelegatePass(opaque);
    SetDelegatePass(camera);
}

OutlinePass::~OutlinePass() = default;

void OutlinePass::setOutlined(Outlined outlined) {
    outlined_ = std::move(outlined);
    forget();
}

void OutlinePass::Render(const vtkRenderState* state) {
    NumberOfRenderedProps = 0;
    auto* renderer = state->GetRenderer();
    std::array<int, 2> size{};
    renderer->GetTiledSize(&size[0], &size[1]);
    auto* window = static_cast<GlWindow*>(renderer->GetRenderWindow());
    const bool coarse = window->drawsCoarse();
    for (std::size_t i = 0; i < outlined_.size(); ++i) {
        std::vector<vtkProp*> props(outlined_[i].begin(), outlined_[i].end());
        if (props.empty()) continue;
        vtkRenderState some(renderer);
        some.SetPropArrayAndCount(props.data(), int(props.size()));
        some.SetFrameBuffer(state->GetFrameBuffer());
        Mask& mask = masks_[{renderer->GetActiveCamera(), i}];
        if (size != mask.size) mask.time = 0;
        mask.size = size;
        if (const vtkMTimeType now = lastChange(*renderer); now != mask.time || coarse != mask.coarse) {
            renderMask(mask, &some, window);
            mask.time = now;
            mask.coarse = coarse;
        }
        drawEdge(mask, window, screenBox(*renderer, props, size, int(width_) + 2));
    }
}

void OutlinePass::renderMask(Mask& mask, const vtkRenderState* state, vtkOpenGLRenderWindow* window) {
    if (!mask.pixels) {
        mask.framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
        mask.framebuffer->SetContext(window);
        mask.pixels = vtkSmartPointer<vtkTextureObject>::New();
        mask.pixels->SetContext(window);
        mask.pixels->SetMinificationFilter(vtkTextureObject::Linear);
        mask.pixels->SetMagnificationFilter(vtkTextureObject::Linear);
    }
    const auto [width, height] = mask.size;
    if (int(mask.pixels->GetWidth()) != width || int(mask.pixels->GetHeight()) != height)
        mask.pixels->Create2D(width, height, 4, VTK_UNSIGNED_CHAR, false);
    window->GetState()->PushFramebufferBindings();
    RenderDelegate(state, width, height, width, height, mask.framebuffer, mask.pixels);
    window->GetState()->PopFramebufferBindings();
}

void OutlinePass::drawEdge(const Mask& mask, vtkOpenGLRenderWindow* window, const std::array<int, 4>& box) {
    auto* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglViewport(0, 0, mask.size[0], mask.size[1]);
    state->vtkglScissor(box[0], box[1], box[2], box[3]);
    if (!quad_) quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kEdgeShader, nullptr);
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
    mask.pixels->Activate();
    const float reach[2] = {width_ / float(mask.size[0]), width_ / float(mask.size[1])};
    const float colour[3] = {float(colour_.redF()), float(colour_.greenF()), float(colour_.blueF())};
    quad_->Program->SetUniformi("mask", mask.pixels->GetTextureUnit());
    quad_->Program->SetUniform2f("reach", reach);
    quad_->Program->SetUniform3f("colour", colour);
    quad_->Render();
    mask.pixels->Deactivate();
}

void OutlinePass::Mask::release(vtkWindow* window) {
    if (framebuffer) framebuffer->ReleaseGraphicsResources(window);
    if (pixels) pixels->ReleaseGraphicsResources(window);
}

void OutlinePass::forget(const vtkCamera& camera, vtkWindow* window) {
    for (auto it = masks_.begin(); it != masks_.end();) {
        const bool goes = it->first.first == &camera;
        if (goes) it->second.release(window);
        it = goes ? masks_.erase(it) : std::next(it);
    }
}

void OutlinePass::ReleaseGraphicsResources(vtkWindow* window) {
    Superclass::ReleaseGraphicsResources(window);
    quad_.reset();
    for (auto& [of, mask] : masks_)
        mask.release(window);
    masks_.clear();
}

} // namespace tactum
