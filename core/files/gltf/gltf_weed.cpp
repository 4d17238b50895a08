#include "core/files/gltf/gltf_weed.h"

#include <algorithm>
#include <functional>

#include "core/base/text.h"
#include "core/files/gltf/gltf_references.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

constexpr const char* kPacked = "KHR_draco_mesh_compression";

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

/// Whether an accessor has bytes of its own; one that is not there is for whoever reads it.
bool hasData(const Json& accessors, const Json& of, const char* key) {
    const int index = indexIn(of, key, accessors.size());
    return index < 0 || accessors[std::size_t(index)].contains("bufferView");
}

bool isOnlyPacked(const Json& accessors, const Json& primitive) {
    const Json* attributes = member(primitive, "attributes");
    return !hasData(accessors, primitive, "indices") ||
           (attributes && !hasData(accessors, *attributes, "POSITION"));
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

void erasePackedCopies(Json& root) {
    const Json* accessors = arrayIn(root, "accessors");
    Json* meshes = arrayIn(root, "meshes");
    if (!accessors || !meshes) return;
    for (Json& mesh : *meshes) {
        Json* primitives = arrayIn(mesh, "primitives");
        for (std::size_t i = 0; primitives && i < primitives->size(); ++i) {
            Json& primitive = (*primitives)[i];
            if (extensionOf(primitive, kPacked) && !isOnlyPacked(*accessors, primitive))
                eraseExtension(primitive, kPacked);
        }
    }
}

} // namespace tactum
