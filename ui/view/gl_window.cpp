#include "ui/view/gl_window.h"

#include <cstring>

#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>

namespace tactum {

vtkStandardNewMacro(GlWindow);

void GlWindow::connect(std::function<void()> makeCurrent, std::function<bool()> isCurrent) {
    makeCurrent_ = std::move(makeCurrent);
    isCurrent_ = std::move(isCurrent);
}

bool GlWindow::IsCurrent() {
    return isCurrent_ && isCurrent_();
}

// Making a widget current binds its framebuffer behind VTK's state cache, so it is done only when needed.
void GlWindow::MakeCurrent() {
    if (makeCurrent_ && !IsCurrent()) makeCurrent_();
}

// GLEW built for GLX reports an error on EGL and Wayland, after it has loaded every function: the error
// says only that there is no GLX.
void GlWindow::OpenGLInitContext() {
    const int warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::SetGlobalWarningDisplay(0);
    Superclass::OpenGLInitContext();
    vtkObject::SetGlobalWarningDisplay(warnings);
    Initialized = true;
    GlewInitValid = true;
}

void GlWindow::PushContext() {
    auto* context = QOpenGLContext::currentContext();
    stack_.emplace_back(context, context ? context->surface() : nullptr);
    MakeCurrent();
}

void GlWindow::PopContext() {
    const auto [context, surface] = stack_.back();
    stack_.pop_back();
    if (context && context != QOpenGLContext::currentContext()) context->makeCurrent(surface);
}

void GlWindow::ReleaseGraphicsResources(vtkWindow* window) {
    occlusion_.release(*this);
    Superclass::ReleaseGraphicsResources(window);
}

void GlWindow::renderFrame() {
    drawAside([this] { Render(); });
}

void GlWindow::renderFrameAt(int left, int bottom) {
    GLint bound = 0;
    QOpenGLContext::currentContext()->functions()->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    drawAside([&] {
        Render();
        auto* state = GetState();
        state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
        state->vtkglDisable(GL_SCISSOR_TEST);
        const int *size = GetSize(), width = size[0], height = size[1];
        BlitDisplayFramebuffer(0, 0, 0, width, height, left, bottom, width, height, GL_COLOR_BUFFER_BIT,
                               GL_NEAREST);
    });
}

void GlWindow::drawAside(const std::function<void()>& draw) {
    auto* state = GetState();
    state->Reset(); // Qt has changed it since the last frame
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglEnable(GL_MULTISAMPLE); // a painter without antialiasing switches it off
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw();
    state->Pop();
}

bool GlWindow::rendererIsSoftware() {
    auto* gl = QOpenGLContext::currentContext()->functions();
    const auto* name = reinterpret_cast<const char*>(gl->glGetString(GL_RENDERER));
    return name &&
           (std::strstr(name, "llvmpipe") || std::strstr(name, "softpipe") || std::strstr(name, "SWR"));
}

} // namespace tactum
