#include "ui/tools/touch_hint.h"

#include <QEvent>
#include <QSettings>

#include "ui/base/style.h"

namespace tactum {

namespace {
const auto kHintKey = QStringLiteral("hints/touched");
}

TouchHint::TouchHint(QWidget* parent) : QLabel(tr("Drag on the model to touch it"), parent) {
    setObjectName(QStringLiteral("hint"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    parent->installEventFilter(this);
    hide();
}

void TouchHint::offer() {
    if (QSettings().value(kHintKey).toBool()) return;
    show();
    place();
}

void TouchHint::followed() {
    if (isHidden()) return;
    hide();
    QSettings().setValue(kHintKey, true);
}

void TouchHint::keepAbove(int height) {
    below_ = height;
    place();
}

bool TouchHint::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QLabel::eventFilter(watched, event);
}

void TouchHint::place() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - 4 * kRhythm - below_);
}

} // namespace tactum
