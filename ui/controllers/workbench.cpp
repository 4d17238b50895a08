#include "ui/controllers/workbench.h"

#include <QBoxLayout>
#include <QDockWidget>

namespace tactum {

QDockWidget& Workbench::dock(const char* name) const {
    return *window.findChild<QDockWidget*>(QString::fromLatin1(name));
}

QBoxLayout& Workbench::strips() const {
    return *window.findChild<QBoxLayout*>(QStringLiteral("strips"));
}

} // namespace tactum
