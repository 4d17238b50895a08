// The mouse and the keys on the handles of the view.
#include <algorithm>

#include <QGuiApplication>
#include <QKeyEvent>

#include "ui/view/scene_view_impl.h"

namespace tactum {

bool SceneView::Impl::takeHandles(QPointF cursor) {
    const auto under =
        std::ranges::find_if(handles, [&](ViewHandles* each) { return each->take(cursor, camera()); });
    if (under == handles.end()) return false;
    grabbed(**under);
    return true;
}

void SceneView::Impl::grabbed(ViewHandles& which) {
    drag = ViewDrag::Handles;
    taken = &which;
    if (taken == &mapping) emit view.mappingGrabbed();
    if (taken == &joint) emit view.jointGrabbed();
    if (taken == &path) emit view.pathGrabbed();
    if (taken == &arranging) emit view.arrangeGrabbed();
}

void SceneView::Impl::leadHandles(QPointF cursor, Qt::KeyboardModifiers modifiers) {
    if (taken == &mapping) emit view.mappingDragged(mapping.dragged(cursor, camera()));
    if (taken == &joint) emit view.jointDragged(joint.dragged(cursor, camera()));
    if (taken == &path)
        emit view.pathDragged(path.dragged(cursor, camera(), modifiers & Qt::ControlModifier));
    if (taken == &sectionHandles)
        emit view.sectionDragged(sectionHandles.dragged(cursor, camera(), modifiers & Qt::ControlModifier));
    if (taken != &arranging) return;
    const bool fine = modifiers & Qt::ShiftModifier;
    arranging.lead(cursor - cursorAt, fine);
    arranged = arranging.dragged(camera(), modifiers & Qt::ControlModifier, fine);
    emit view.arrangeDragged(*arranged);
}

void SceneView::Impl::giveUpHandles() {
    letGo(true);
    view.changed();
}

bool SceneView::Impl::arrangeKey(int key) {
    if (holdsArranging()) {
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            letGo();
            return true;
        }
        if (key >= Qt::Key_X && key <= Qt::Key_Z)
            arranging.keepTo(key - Qt::Key_X);
        else if (!arranging.type(key))
            return false;
        leadHandles(cursorAt, QGuiApplication::keyboardModifiers());
        return true;
    }
    if (tool != ViewTool::Arrange || drag != ViewDrag::None) return false;
    if (key != Qt::Key_G && key != Qt::Key_R && key != Qt::Key_S) return false;
    if (!arranging.shows()) {
        emit view.arrangeAsked();
        return true;
    }
    arranging.grabFree(key == Qt::Key_G   ? ArrangeHandle::Move
                       : key == Qt::Key_R ? ArrangeHandle::Turn
                                          : ArrangeHandle::Scale,
                       cursorAt);
    grabbed(arranging);
    return true;
}

/// What ends or guides a drag of the handles is no command meanwhile.
bool SceneView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && impl_->holdsArranging()) event->accept();
    return VtkWidget::event(event);
}

} // namespace tactum
