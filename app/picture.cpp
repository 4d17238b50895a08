#include "app/picture.h"

#include <QApplication>

#include "ui/view/surface_format.h"
#include "ui/view/touch_picture.h"

namespace tactum {

Result<void> writePicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& file) {
    useViewSurfaceFormat();
    int argc = 1;
    char name[] = "tactum";
    char* argv[] = {name, nullptr};
    QApplication application(argc, argv);
    return writeTouchPicture(scene, rows, file, QSize(1600, 1200));
}

} // namespace tactum
