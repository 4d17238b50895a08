// Keeps the occlusion of a scene that is shown. Private to this folder.
#pragma once

#include <vector>

#include "ui/view/aside.h"
#include "ui/view/gl_window.h"
#include "ui/view/occlusion_bake.h"

namespace tactum {

/// Baked aside. Until then there is none: one of before would be dark where nothing is any more. Thread: ui.
class OcclusionLayer {
public:
    explicit OcclusionLayer(GlWindow& window) : window_(window) {}

    /// What stands in the scene. What moves counts for nothing. True if the window has none any more.
    bool setCasters(std::vector<ShadowCaster> casters);
    bool pending() const { return work_.pending(); }
    /// Gives what was made since to the window; true if anything was. Nothing that VTK watches changes by
    /// either.
    bool takeFinished();

private:
    GlWindow& window_;
    Aside<std::optional<OcclusionVolume>> work_;
    std::vector<ShadowCaster> wanted_;
};

} // namespace tactum
