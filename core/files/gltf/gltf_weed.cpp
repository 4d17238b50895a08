#include "core/files/gltf/gltf_weed.h"

#include <algorithm>
#include <functional>

#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

bool isIndex(const Json& object, const char* key) {
    return indexIn(object, key, std::size_t(1) << 30) >= 0;
}

bool isSampler(const Json& sampler) {
    const Json* interpolation = member(sampler, "interpolation");
    return isIndex(sampler, "input") && isIndex(sampler, "output") &&
           (!interpolation || interpolation->is_string());
}

bool isChannel(const Json& channel) {
    const Json* target = member(channel, "target");
    const Json* path = target ? member(*target, "path") : nullptr;
    return isIndex(channel, "sampler") && path && path->is_string() &&
           (!target->contains("node") || isIndex(*target, "node"));
}

bool isAnimation(const Json& animation) {
    const auto isListOf = [&](const char* key, bool (*isOne)(const Json&)) {
        const Json* list = member(animation, key);
        return list && list->is_array() && std::ranges::all_of(*list, isOne);
    };
    return isListOf("channels", isChannel) && isListOf("samplers", isSampler);
}

} // namespace

std::size_t eraseDamagedAnimations(Json& root) {
    const auto found = root.find("animations");
    if (found == root.end()) return 0;
    if (!found->is_array()) return root.erase("animations");
    const std::size_t before = found->size();
    found->erase(std::remove_if(found->begin(), found->end(), std::not_fn(isAnimation)), found->end());
    const std::size_t damaged = before - found->size();
    if (damaged > 0 && found->empty()) root.erase(found);
    return damaged;
}

} // namespace tactum
