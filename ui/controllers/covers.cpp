#include "ui/controllers/covers.h"

#include <QEvent>
#include <QRegion>
#include <QWidget>

#include "ui/view/scene_view.h"

namespace tactum {

Covers::Covers(QWidget& body, SceneView& view) : QObject(&body), body_(body), view_(view) {
    view.installEventFilter(this);
    body.installEventFilter(this);
    for (QWidget* each : over())
        each->installEventFilter(this);
}

QList<QWidget*> Covers::over() const {
    QList<QWidget*> all = body_.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    all.removeIf([this](const QWidget* each) { return each->isAncestorOf(&view_); });
    return all;
}

bool Covers::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::Show || type == QEvent::Hide || type == QEvent::Resize || type == QEvent::Move)
        tell();
    if (type == QEvent::ChildAdded && watched == &body_)
        static_cast<QChildEvent*>(event)->child()->installEventFilter(this);
    return QObject::eventFilter(watched, event);
}

void Covers::tell() {
    QRegion covered;
    for (const QWidget* each : over())
        if (each->isVisible()) covered += QRect(view_.mapFrom(&body_, each->pos()), each->size());
    view_.setCovered(covered);
}

} // namespace tactum
