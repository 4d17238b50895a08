#include "ui/view/outline_pass.h"

#include <qopengl.h>

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

namespace tactum {

vtkStandardNewMacro(OutlinePass);

namespace {

// The share of covered samples on two rings around a pixel outside the mask: it falls off softly, which
// smooths the line where nothing is multisampled.
constexpr const char* kEdgeShader = R"(//VTK::System::Dec
in vec2 texCoord;
uniform sampler2D mask;
uniform vec2 pixel;
uniform float width;
uniform vec3 colour;
//VTK::Output::Dec
void main() {
    float inside = texture2D(mask, texCoord).a;
    if (inside > 0.99) discard;
    float near = 0.0, far = 0.0;
    for (int i = 0; i < 12; ++i) {
        float angle = float(i) * 0.5235988;
        vec2 direction = pixel * vec2(cos(angle), sin(angle));
        near += texture2D(mask, texCoord + 0.5 * width * direction).a;
        far += texture2D(mask, texCoord + width * direction).a;
    }
    float alpha = clamp(near / 3.0, 0.0, 1.0) * 0.55 + clamp(far / 4.5, 0.0, 1.0) * 0.45;
    if (alpha < 0.02) discard;
    gl_FragData[0] = vec4(colour, alpha);
}
)";

} // namespace

OutlinePass::OutlinePass() {
    vtkNew<vtkCameraPass> camera;
    vtkNew<vtkOpaquePass> opaque;
    camera->SetDelegatePass(opaque);
    SetDelegatePass(camera);
}

OutlinePass::~OutlinePass() = default;

void OutlinePass::Render(const vtkRenderState* state) {
    NumberOfRenderedProps = 0;
    auto* renderer = state->GetRenderer();
    if (renderer->VisibleActorCount() == 0) return;
    renderer->GetTiledSize(&size_[0], &size_[1]);
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    renderMask(state, window);
    drawEdge(window);
}

void OutlinePass::renderMask(const vtkRenderState* state, vtkOpenGLRenderWindow* window) {
    if (!mask_) {
        framebuffer_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
        framebuffer_->SetContext(window);
        mask_ = vtkSmartPointer<vtkTextureObject>::New();
        mask_->SetContext(window);
        mask_->SetMinificationFilter(vtkTextureObject::Linear);
        mask_->SetMagnificationFilter(vtkTextureObject::Linear);
    }
    if (int(mask_->GetWidth()) != size_[0] || int(mask_->GetHeight()) != size_[1])
        mask_->Create2D(size_[0], size_[1], 4, VTK_UNSIGNED_CHAR, false);
    window->GetState()->PushFramebufferBindings();
    RenderDelegate(state, size_[0], size_[1], size_[0], size_[1], framebuffer_, mask_);
    window->GetState()->PopFramebufferBindings();
}

void OutlinePass::drawEdge(vtkOpenGLRenderWindow* window) {
    auto* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglViewport(0, 0, size_[0], size_[1]);
    state->vtkglScissor(0, 0, size_[0], size_[1]);
    if (!quad_) quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kEdgeShader, nullptr);
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
    mask_->Activate();
    const float pixel[2] = {1.0f / float(size_[0]), 1.0f / float(size_[1])};
    const float colour[3] = {float(colour_.redF()), float(colour_.greenF()), float(colour_.blueF())};
    quad_->Program->SetUniformi("mask", mask_->GetTextureUnit());
    quad_->Program->SetUniform2f("pixel", pixel);
    quad_->Program->SetUniformf("width", width_);
    quad_->Program->SetUniform3f("colour", colour);
    quad_->Render();
    mask_->Deactivate();
}

void OutlinePass::ReleaseGraphicsResources(vtkWindow* window) {
    Superclass::ReleaseGraphicsResources(window);
    quad_.reset();
    if (framebuffer_) framebuffer_->ReleaseGraphicsResources(window);
    if (mask_) mask_->ReleaseGraphicsResources(window);
    framebuffer_ = nullptr;
    mask_ = nullptr;
}

} // namespace tactum
