#include "ui/view/offscreen_window.h"

#include <vtkUnsignedCharArray.h>

namespace tactum {

namespace {
constexpr int kOffscreenSamples = 8;
}

OffscreenWindow::OffscreenWindow() {
    surface_.create();
    valid_ = context_.create() && context_.makeCurrent(&surface_) &&
             context_.format().version() >= qMakePair(3, 2);
    if (!valid_) return;
    window_->connect([this] { context_.makeCurrent(&surface_); },
                     [this] { return QOpenGLContext::currentContext() == &context_; });
    window_->SetOwnContext(false);
    window_->SetForceMaximumHardwareLineWidth(1);
    window_->SetMultiSamples(kOffscreenSamples);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetReadyForRendering(true);
    window_->OpenGLInitContext();
}

OffscreenWindow::~OffscreenWindow() {
    if (!valid_) return;
    context_.makeCurrent(&surface_);
    window_->Finalize();
    window_->connect({}, {});
    context_.doneCurrent();
}

QImage OffscreenWindow::render(QSize pixels) {
    context_.makeCurrent(&surface_);
    window_->SetSize(pixels.width(), pixels.height());
    window_->renderFrame();
    vtkNew<vtkUnsignedCharArray> rgba;
    window_->GetRGBACharPixelData(0, 0, pixels.width() - 1, pixels.height() - 1, 0, rgba);
    const QImage upsideDown(rgba->GetPointer(0), pixels.width(), pixels.height(), QImage::Format_RGBX8888);
    return upsideDown.mirrored();
}

} // namespace tactum
