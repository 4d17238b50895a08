#include "core/files/gltf/gltf_prune.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

/// Extensions that name neither accessors nor buffer views nor meshes; beside these, all of KHR_materials_.
constexpr std::array<std::string_view, 8> kHarmless{
    "KHR_lights_punctual",   "KHR_mesh_quantization", "KHR_node_visibility", "KHR_texture_basisu",
    "KHR_texture_transform", "KHR_xmp_json_ld",       "EXT_texture_webp",    "MPEG_haptic_material"};

bool isHarmless(const Json& name) {
    if (!name.is_string()) return false;
    const std::string text = name.get<std::string>();
    return text.starts_with("KHR_materials_") || std::ranges::find(kHarmless, text) != kHarmless.end();
}

bool mayPrune(const Json& root) {
    if (!member(root, "meshes") || member(root, "skins")) return false;
    if (const Json* used = member(root, "extensionsUsed"); used && !std::ranges::all_of(*used, isHarmless))
        return false;
    const Json* nodes = member(root, "nodes");
    return !nodes || std::ranges::none_of(*nodes, [](const Json& node) { return node.contains("mesh"); });
}

/// New places for those elements of an array that something names.
class Survivors {
public:
    Survivors(Json& root, const char* array) : root_(root), array_(array) {
        const Json* all = member(root, array);
        place_.assign(all && all->is_array() ? all->size() : 0, -1);
    }
    /// Replaces an index by its new one.
    void keep(Json& of, const char* key) {
        const int index = indexIn(of, key, place_.size());
        if (index < 0) return;
        int& place = place_[std::size_t(index)];
        if (place < 0) {
            place = int(kept_.size());
            kept_.push_back(root_[array_][std::size_t(index)]);
        }
        of[key] = place;
    }
    /// The array holds the survivors alone now.
    void settle() {
        if (kept_.empty())
            root_.erase(array_);
        else
            root_[array_] = kept_;
    }

private:
    Json& root_;
    const char* array_;
    std::vector<int> place_;
    Json kept_ = Json::array();
};

void forEach(Json& root, const char* array, const auto& visit) {
    const auto found = root.find(array);
    if (found != root.end() && found->is_array())
        for (Json& element : *found)
            visit(element);
}

} // namespace

void pruneMeshData(Json& root, std::string& binary) {
    if (!mayPrune(root)) return;
    root.erase("meshes");
    Survivors accessors(root, "accessors");
    forEach(root, "animations", [&](Json& animation) {
        forEach(animation, "samplers", [&](Json& sampler) {
            accessors.keep(sampler, "input");
            accessors.keep(sampler, "output");
        });
    });
    accessors.settle();
    Survivors views(root, "bufferViews");
    forEach(root, "accessors", [&](Json& accessor) {
        views.keep(accessor, "bufferView");
        for (const char* part : {"indices", "values"})
            if (accessor.contains("sparse") && accessor["sparse"].contains(part))
                views.keep(accessor["sparse"][part], "bufferView");
    });
    forEach(root, "images", [&](Json& image) { views.keep(image, "bufferView"); });
    views.settle();
    std::string left;
    forEach(root, "bufferViews", [&](Json& view) {
        left.resize((left.size() + 7) / 8 * 8, '\0');
        const std::size_t from = sizeIn(view, "byteOffset");
        view["byteOffset"] = left.size();
        left.append(binary, std::min(from, binary.size()), sizeIn(view, "byteLength"));
    });
    binary = std::move(left);
}

} // namespace tactum
