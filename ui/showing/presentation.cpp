#include "ui/showing/presentation.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

#include "ui/view/scene_view.h"

namespace tactum {

namespace {

constexpr int kPointerRests = 3000;                      // ms
constexpr double kLargerWords = 1.6, kLargerTouch = 1.5; // than at a desk

} // namespace

Presentation::Presentation(QMainWindow& window, SceneView& view)
    : QObject(&window), window_(window), view_(view) {
    rest_.setSingleShot(true);
    rest_.setInterval(kPointerRests);
    connect(&rest_, &QTimer::timeout, this, &Presentation::hidePointer);
}

Presentation::~Presentation() {
    showPointer();
}

void Presentation::set(bool on) {
    if (on == on_) return;
    on_ = on;
    // Not hidden: the keys of its commands would be gone with it.
    window_.menuBar()->setMaximumHeight(on ? 0 : QWIDGETSIZE_MAX);
    window_.statusBar()->setVisible(!on);
    for (auto* bar : window_.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        bar->setVisible(!on);
    QFont words = QApplication::font(&view_);
    if (on) words.setPointSizeF(kLargerWords * words.pointSizeF());
    view_.setFont(words);
    view_.setTouchScale(on ? kLargerTouch : 1);
    if (on) {
        before_ = window_.windowState();
        window_.setWindowState(before_ | Qt::WindowFullScreen);
        qApp->installEventFilter(this);
        rest_.start();
    } else {
        window_.setWindowState(before_);
        qApp->removeEventFilter(this);
        rest_.stop();
        showPointer();
    }
    view_.setFocus();
}

bool Presentation::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::MouseMove || type == QEvent::MouseButtonPress || type == QEvent::Wheel) {
        showPointer();
        rest_.start();
    }
    return QObject::eventFilter(watched, event);
}

void Presentation::hidePointer() {
    // A dialog or a menu is pointed at.
    if (QApplication::activeModalWidget() || QApplication::activePopupWidget()) return rest_.start();
    if (!std::exchange(pointerHidden_, true)) QApplication::setOverrideCursor(Qt::BlankCursor);
}

void Presentation::showPointer() {
    if (std::exchange(pointerHidden_, false)) QApplication::restoreOverrideCursor();
}

} // namespace tactum
