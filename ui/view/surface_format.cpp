#include "ui/view/surface_format.h"

#include <QSurfaceFormat>

namespace tactum {

void useViewSurfaceFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0); // the render window has its own multisampled buffer
    QSurfaceFormat::setDefaultFormat(format);
}

} // namespace tactum
