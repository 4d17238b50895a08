// The section of the view: what is cut away is neither drawn nor picked, and casts no shadow.
#include "ui/view/scene_view_impl.h"

namespace tactum {

void SceneView::setSection(const std::optional<SectionPlane>& plane) {
    if (section() == plane) return;
    impl_->sectionHandles.show(plane);
    impl_->picker.setSection(plane);
    impl_->stage.setSection(plane);
    impl_->castShadows(!impl_->shadowTimer.isActive());
    changed();
}

const std::optional<SectionPlane>& SceneView::section() const {
    return impl_->sectionHandles.shown();
}

const SectionGizmo& SceneView::sectionHandles() const {
    return impl_->sectionHandles;
}

Bounds SceneView::bounds() const {
    return impl_->picker.bounds();
}

} // namespace tactum
