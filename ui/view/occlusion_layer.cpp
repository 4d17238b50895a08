#include "ui/view/occlusion_layer.h"

#include <utility>

namespace tactum {

bool OcclusionLayer::setCasters(std::vector<ShadowCaster> casters) {
    std::erase_if(casters, [](const ShadowCaster& caster) { return caster.moves; });
    if (casters == wanted_) return false;
    wanted_ = std::move(casters);
    work_.forget();
    started_.clear();
    start();
    if (!window_.occlusion().volume()) return false;
    window_.occlusion().set(nullptr);
    return true;
}

void OcclusionLayer::start() {
    if (wanted_ == started_) return;
    started_ = wanted_;
    work_.start([casters = wanted_](const Progress& progress) { return occlusionOf(casters, progress); });
}

bool OcclusionLayer::takeFinished() {
    auto made = work_.take();
    if (!made) return false;
    if (*made) window_.occlusion().set(std::make_shared<const OcclusionVolume>(std::move(**made)));
    start();
    return true;
}

} // namespace tactum
