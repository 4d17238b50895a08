#include "ui/view/occlusion_layer.h"

#include <utility>

namespace tactum {

bool OcclusionLayer::setCasters(std::vector<ShadowCaster> casters) {
    std::erase_if(casters, [](const ShadowCaster& caster) { return caster.moves; });
    if (casters == wanted_) return false;
    wanted_ = std::move(casters);
    work_.start([casters = wanted_](const Progress& progress) { return occlusionOf(casters, progress); });
    if (!window_.occlusion().volume()) return false;
    window_.occlusion().set(nullptr);
    return true;
}

bool OcclusionLayer::takeFinished() {
    auto made = work_.take();
    if (!made) return false;
    if (*made) window_.occlusion().set(std::make_shared<const OcclusionVolume>(std::move(**made)));
    return true;
}

} // namespace tactum
