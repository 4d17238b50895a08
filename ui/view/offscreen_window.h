// A VTK render window without a widget. Private to this folder.
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <vtkNew.h>

#include "core/base/result.h"
#include "ui/view/gl_window.h"

namespace tactum {

/// Draws into memory, multisampled. Needs a QGuiApplication on a platform with OpenGL. Thread: main.
class OffscreenWindow {
public:
    OffscreenWindow();
    ~OffscreenWindow();
    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    /// False where there is no OpenGL 3.2.
    bool isValid() const { return valid_; }
    vtkRenderWindow& window() { return *window_.Get(); }
    QImage render(QSize pixels);

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
    vtkNew<GlWindow> window_;
    bool valid_ = false;
};

} // namespace tactum
