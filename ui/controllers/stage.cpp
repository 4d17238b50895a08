#include "ui/controllers/stage.h"

#include <QStackedWidget>

#include "ui/document/document.h"
#include "ui/view/scene_view.h"

namespace tactum {

Stage::Stage(Document& document, SceneView& view, QStackedWidget& centre, QWidget& start, QObject* parent)
    : QObject(parent), document_(document), view_(view), centre_(centre), start_(start) {}

void Stage::showCentre() {
    const bool apart = apart_ && apart_();
    centre_.setCurrentWidget(!document_.isOpen() && !apart ? &start_ : static_cast<QWidget*>(&view_));
}

void Stage::showView() {
    centre_.setCurrentWidget(&view_);
}

void Stage::showOther(const Scene& scene) {
    emit otherShown();
    view_.setSelection({});
    view_.setScene(scene);
    view_.setProxyRadius(scene.proxyRadius);
    showView();
    view_.fitAll();
}

void Stage::showOwn() {
    view_.setScene(document_.scene());
    view_.setProxyRadius(document_.scene().proxyRadius);
    view_.setSelection(document_.selected());
    if (!document_.empty()) view_.fitAll();
    showCentre();
}

} // namespace tactum
