#include "ui/view/scene_view_impl.h"

namespace tactum {

void SceneView::setCasters(const Scene& scene) {
    impl_->casters.clear();
    for (const SceneObject& object : scene.objects) {
        if (!object.visible) continue;
        ShadowCaster caster{object.geometry, {}, object.pose, object.motion || object.body != kWorldBody};
        for (const Surface& surface : object.surfaces)
            caster.seen.push_back(surface.visible);
        impl_->casters.emplace_back(object.id, std::move(caster));
    }
    impl_->castShadows(!impl_->shadowTimer.isActive());
}

void SceneView::Impl::castShadows(bool rest) {
    std::vector<ShadowCaster> now;
    for (auto& [id, caster] : casters) {
        if (const auto place = model.placeOf(id); place && caster.moves) caster.X_WB = *place;
        now.push_back(caster);
        now.back().section = sectionHandles.shown();
    }
    if (occlusion.setCasters(now)) stage.forgetPicture();
    ground.setCasters(std::move(now), rest);
    if (ground.pending() || occlusion.pending()) meshTimer.start();
}

std::size_t SceneView::boundaryEdgesShown() const {
    return impl_->boundaries.count();
}

double SceneView::gridStep() const {
    return impl_->ground.step(impl_->camera());
}

} // namespace tactum
