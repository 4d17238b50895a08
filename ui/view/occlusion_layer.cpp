#include "ui/view/occlusion_layer.h"

#include <algorithm>
#include <utility>

namespace tactum {

bool OcclusionLayer::setCasters(std::vector<ShadowCaster> casters) {
    std::erase_if(casters, [](const ShadowCaster& caster) { return caster.moves; });
    const bool same = std::ranges::equal(casters, wanted_, {}, &ShadowCaster::soup, &ShadowCaster::soup);
    wanted_ = std::move(casters);
    if (!same) {
        work_.forget();
        started_.clear();
    }
    if (!work_.pending()) start();
    if (same || !window_.occlusion().volume()) return false;
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
