#include "ui/engine/held_key.h"

#include <algorithm>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QWidget>

namespace tactum {

namespace {
constexpr int kToHear = 60; // ms
} // namespace

HeldKey::HeldKey(Qt::Key key, int milliseconds, QObject* parent) : QObject(parent), key_(key) {
    for (QTimer* timer : {&timer_, &last_})
        timer->setSingleShot(true);
    last_.setInterval(std::min(kToHear, milliseconds));
    timer_.setInterval(milliseconds - last_.interval());
    connect(&timer_, &QTimer::timeout, &last_, qOverload<>(&QTimer::start));
    connect(&last_, &QTimer::timeout, this, &HeldKey::held);
    qApp->installEventFilter(this);
}

void HeldKey::stop() {
    timer_.stop();
    last_.stop();
}

bool HeldKey::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (press || event->type() == QEvent::KeyRelease) {
        const auto* key = static_cast<QKeyEvent*>(event);
        // A held key repeats as pairs of release and press: those say nothing, but that it is held still.
        const bool again = press && lost_ && key->isAutoRepeat();
        if (key->key() == key_ && (!key->isAutoRepeat() || again)) {
            lost_ = false;
            if (!press)
                stop();
            else if (!timer_.isActive() && !last_.isActive())
                timer_.start();
        }
    }
    // The release of a key goes elsewhere once the program is not in front.
    if (event->type() == QEvent::ApplicationDeactivate) stop();
    // And with the dialog or the menu that it has closed.
    const auto* popup = event->type() == QEvent::Hide ? qobject_cast<const QWidget*>(watched) : nullptr;
    const bool closed =
        event->type() == QEvent::WindowUnblocked || (popup && popup->windowType() == Qt::Popup);
    if (closed && (timer_.isActive() || last_.isActive())) {
        stop();
        lost_ = true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace tactum
