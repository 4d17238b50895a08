#include "ui/controllers/dock_widths.h"

#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>

namespace tactum {

namespace {

constexpr Qt::DockWidgetArea kSides[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea};

} // namespace

DockWidths::DockWidths(QMainWindow& window) : QObject(&window), window_(window) {
    window.installEventFilter(this);
    for (auto* dock : window.findChildren<QDockWidget*>())
        dock->installEventFilter(this);
}

QVariantList DockWidths::widths() const {
    QVariantList widths;
    for (const auto side : kSides)
        widths << wanted_.at(side);
    return widths;
}

void DockWidths::restore(const QVariantList& widths) {
    for (std::size_t i = 0; i < std::size(kSides); ++i)
        if (const int width = widths.value(qsizetype(i)).toInt(); width > 0) wanted_[kSides[i]] = width;
}

bool DockWidths::eventFilter(QObject* watched, QEvent* event) {
    const bool resized = event->type() == QEvent::Resize;
    if (resized && watched != &window_ && window_.width() == settled_) // else it is the window's doing
        note(static_cast<QDockWidget&>(*watched));
    if ((resized && watched == &window_) || event->type() == QEvent::Show)
        QMetaObject::invokeMethod(this, &DockWidths::settle, Qt::QueuedConnection); // all is laid out then
    return QObject::eventFilter(watched, event);
}

void DockWidths::note(QDockWidget& dock) {
    const bool drawn = QGuiApplication::mouseButtons() & Qt::LeftButton;
    if (drawn && dock.isVisible() && !dock.isFloating())
        wanted_[window_.dockWidgetArea(&dock)] = dock.width();
}

void DockWidths::settle() {
    for (const auto side : kSides) {
        QDockWidget* dock = shownIn(side);
        if (dock && dock->width() < wanted_[side])
            window_.resizeDocks({dock}, {wanted_[side]}, Qt::Horizontal);
    }
    settled_ = window_.width();
}

/// What tabs hide is not laid out.
QDockWidget* DockWidths::shownIn(Qt::DockWidgetArea side) const {
    for (auto* dock : window_.findChildren<QDockWidget*>())
        if (dock->isVisible() && !dock->isFloating() && window_.dockWidgetArea(dock) == side &&
            !dock->visibleRegion().isEmpty())
            return dock;
    return nullptr;
}

} // namespace tactum
