#include "ui/controllers/workbench.h"

#include <QDockWidget>

namespace tactum {

QDockWidget& Workbench::dock(const char* name) const {
    return *window.findChild<QDockWidget*>(QString::fromLatin1(name));
}

} // namespace tactum
