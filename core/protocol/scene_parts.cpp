#include "core/protocol/scene_parts.h"

#include "core/scene/scene_bytes.h"

namespace tactum {

std::shared_ptr<const KnownParts> SceneParts::of(const Scene& scene) {
    const std::lock_guard lock(mutex_);
    return known_ = std::make_shared<const KnownParts>(scene, *known_);
}

Result<Scene> SceneParts::read(std::string_view bytes, const Scene& base) {
    const auto known = of(base);
    try {
        ByteIn in(bytes, "the scene", 0, "use the same version of Tactum on both sides");
        Scene scene = readScene(
            in,
            {[&] { return *known; },
             {Error::Kind::Input, "the scene names a part that this server has no more: send all of it"}});
        in.demand(in.left() == 0, "it is followed by something else");
        return scene;
    } catch (const ByteFault& fault) {
        return tl::unexpected(fault.error);
    }
}

} // namespace tactum
