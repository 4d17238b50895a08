#include "core/files/gltf/gltf_references.h"

#include <algorithm>
#include <string_view>

#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

/// Beside all of KHR_materials_, which name textures by members that say so.
constexpr std::array<std::string_view, 12> kFollowed{
    "EXT_mesh_gpu_instancing", "EXT_texture_avif",    "EXT_texture_webp",   "KHR_lights_punctual",
    "KHR_mesh_quantization",   "KHR_node_visibility", "KHR_texture_basisu", "KHR_texture_transform",
    "KHR_xmp_json_ld",         kMpegExtension,        kPhysicsExtension,    kExtension};

class Visit {
public:
    explicit Visit(const VisitReference& visit) : visit_(visit) {}

    void operator()(Json* object, const char* key, const char* array) const {
        if (!object || !object->is_object()) return;
        const auto found = object->find(key);
        if (found != object->end()) one(*found, array);
    }
    /// A list of indices, or an object whose values are indices.
    void all(Json* object, const char* key, const char* array, Naming naming = Naming::Holds) const {
        Json* list = in(object, key);
        if (!list || !list->is_structured()) return;
        for (Json& each : *list)
            one(each, array, naming);
        if (list->is_array()) list->erase(std::remove(list->begin(), list->end(), Json()), list->end());
        if (naming == Naming::Lists && list->empty()) object->erase(key);
    }
    static Json* in(Json* object, const char* key) {
        if (!object || !object->is_object()) return nullptr;
        const auto found = object->find(key);
        return found == object->end() ? nullptr : &*found;
    }
    static Json* extension(Json& element, const char* name) { return in(in(&element, "extensions"), name); }
    static void each(Json* object, const char* key, const auto& does) {
        Json* list = in(object, key);
        if (list && list->is_array())
            for (Json& element : *list)
                does(element);
    }
    /// Members named "texture" or "...Texture", at any depth.
    void textures(Json& within) const {
        if (!within.is_structured()) return;
        for (const auto& [key, value] : within.items()) {
            const bool names = within.is_object() && std::string_view(key).ends_with("exture");
            if (names) (*this)(&value, "index", "textures");
            textures(value);
        }
    }

private:
    void one(Json& index, const char* array, Naming naming = Naming::Holds) const {
        if (index.is_number_integer() && index.get<std::int64_t>() >= 0) visit_(array, index, naming);
    }
    const VisitReference& visit_;
};

void visitMesh(Json& mesh, const Visit& visit) {
    Visit::each(&mesh, "primitives", [&](Json& primitive) {
        visit(&primitive, "indices", "accessors");
        visit(&primitive, "material", "materials");
        visit.all(&primitive, "attributes", "accessors");
        Visit::each(&primitive, "targets", [&](Json& target) {
            Json holder{{"target", std::move(target)}};
            visit.all(&holder, "target", "accessors");
            target = std::move(holder["target"]);
        });
        Visit::each(Visit::extension(primitive, "KHR_materials_variants"), "mappings",
                    [&](Json& mapping) { visit(&mapping, "material", "materials"); });
    });
    Json* ours = Visit::extension(mesh, kExtension);
    for (const char* key : {"positions", "copies", "order", "uvs"})
        visit(ours, key, "bufferViews");
    visit.all(ours, "surfaces", "materials");
    Visit::each(Visit::in(ours, "sets"), "parts", [&](Json& set) { visit(&set, "ranges", "bufferViews"); });
}

void visitMaterial(Json& material, const Visit& visit) {
    visit.textures(material);
    Visit::each(Visit::extension(material, kExtension), "layers", [&](Json& layer) {
        for (const char* pattern : {"pattern", "mask"})
            visit(Visit::in(Visit::in(&layer, pattern), "painted"), "bufferView", "bufferViews");
    });
}

void visitNode(Json& node, const Visit& visit) {
    visit(&node, "mesh", "meshes");
    visit(&node, "skin", "skins");
    visit(&node, "camera", "cameras");
    visit.all(&node, "children", "nodes", Naming::Lists);
    visit.all(Visit::extension(node, "EXT_mesh_gpu_instancing"), "attributes", "accessors");
    Json* body = Visit::extension(node, kPhysicsExtension);
    visit(Visit::in(body, "joint"), "connectedNode", "nodes");
    for (const char* shape : {"collider", "trigger"}) {
        visit(Visit::in(Visit::in(body, shape), "geometry"), "node", "nodes");
        visit(Visit::in(Visit::in(body, shape), "geometry"), "mesh", "meshes");
    }
    visit.all(Visit::in(body, "trigger"), "nodes", "nodes");
}

void visitAnimation(Json& animation, const Visit& visit) {
    Visit::each(&animation, "samplers", [&](Json& sampler) {
        visit(&sampler, "input", "accessors");
        visit(&sampler, "output", "accessors");
    });
    Visit::each(&animation, "channels",
                [&](Json& channel) { visit(Visit::in(&channel, "target"), "node", "nodes"); });
}

void visitTexture(Json& texture, const Visit& visit) {
    visit(&texture, "source", "images");
    visit(&texture, "sampler", "samplers");
    for (const char* kind : {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif"})
        visit(Visit::extension(texture, kind), "source", "images");
}

void visitSkin(Json& skin, const Visit& visit) {
    visit(&skin, "inverseBindMatrices", "accessors");
    visit(&skin, "skeleton", "nodes");
    visit.all(&skin, "joints", "nodes");
}

void visitAccessor(Json& accessor, const Visit& visit) {
    visit(&accessor, "bufferView", "bufferViews");
    for (const char* part : {"indices", "values"})
        visit(Visit::in(Visit::in(&accessor, "sparse"), part), "bufferView", "bufferViews");
}

} // namespace

Json* arrayIn(Json& root, const char* key) {
    const auto found = root.find(key);
    return found != root.end() && found->is_array() ? &*found : nullptr;
}

void visitReferences(const char* array, Json& element, const VisitReference& visitor) {
    const Visit visit(visitor);
    const std::string_view of = array;
    if (of == "accessors") visitAccessor(element, visit);
    if (of == "animations") visitAnimation(element, visit);
    if (of == "images") visit(&element, "bufferView", "bufferViews");
    if (of == "materials") visitMaterial(element, visit);
    if (of == "meshes") visitMesh(element, visit);
    if (of == "nodes") visitNode(element, visit);
    if (of == "scenes") visit.all(&element, "nodes", "nodes", Naming::Lists);
    if (of == "skins") visitSkin(element, visit);
    if (of == "textures") visitTexture(element, visit);
}

void visitRootReferences(Json& root, const VisitReference& visitor) {
    const Visit visit(visitor);
    visit(Visit::extension(root, kExtension), "finger", "bufferViews");
    if (Json* haptics = Visit::extension(root, kMpegExtension)) visit.textures(*haptics);
    if (Json* all = Visit::in(&root, "extensions")) visit.textures(*all);
}

bool followsReferences(const std::string& extension) {
    return extension.starts_with("KHR_materials_") ||
           std::ranges::find(kFollowed, extension) != kFollowed.end();
}

} // namespace tactum
