#include "core/files/gltf/gltf_foreign.h"

#include <algorithm>
#include <set>

#include "core/base/text.h"
#include "core/files/gltf/gltf_prune.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;

template <int N> std::optional<Eigen::Matrix<double, N, 1>> numbersOf(const Json& node, const char* key) {
    const Json* found = member(node, key);
    if (!found || !found->is_array() || found->size() != N) return std::nullopt;
    Eigen::Matrix<double, N, 1> numbers;
    for (int i = 0; i < N; ++i) {
        if (!(*found)[std::size_t(i)].is_number()) return std::nullopt;
        numbers[i] = (*found)[std::size_t(i)].get<double>();
    }
    return numbers;
}

Affine localOf(const Json& node) {
    if (const auto matrix = numbersOf<16>(node, "matrix")) {
        Affine local;
        local.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data());
        return local;
    }
    Affine local = Affine::Identity();
    if (const auto t = numbersOf<3>(node, "translation")) local.translate(*t);
    if (const auto r = numbersOf<4>(node, "rotation")) local.rotate(Quat(*r));
    if (const auto s = numbersOf<3>(node, "scale")) local.scale(*s);
    return local;
}

void eraseKeys(Json& object, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        object.erase(key);
}

/// One buffer out of all.
std::string mergedBuffers(Json& root, const tinygltf::Model& model) {
    std::string binary;
    std::vector<std::size_t> begin;
    for (const tinygltf::Buffer& buffer : model.buffers) {
        binary.resize((binary.size() + 7) / 8 * 8, '\0');
        begin.push_back(binary.size());
        binary.append(reinterpret_cast<const char*>(buffer.data.data()), buffer.data.size());
    }
    root.erase("buffers");
    if (begin.size() < 2) return binary;
    Json* views = arrayIn(root, "bufferViews");
    if (!views) return binary;
    for (Json& view : *views) {
        const int buffer = indexIn(view, "buffer", begin.size());
        if (buffer < 0) continue;
        view["byteOffset"] = sizeIn(view, "byteOffset") + begin[std::size_t(buffer)];
        view["buffer"] = 0;
    }
    return binary;
}

const char* mimeTypeOf(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG")) return "image/png";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
    return nullptr; // of an extension, which knows where it is
}

/// Pictures beside the file come into it.
void embedImages(const Source& source, Json& root, const tinygltf::Model& model, std::string& binary,
                 std::vector<std::string>& missing) {
    Json* images = arrayIn(root, "images");
    if (!images) return;
    for (Json& image : *images) {
        const Json* uri = image.is_object() ? member(image, "uri") : nullptr;
        if (!uri) continue;
        const std::string bytes = imageBytes(source, image, model);
        const char* type = mimeTypeOf(bytes);
        if (!type) {
            missing.push_back(uri->is_string() ? uri->get<std::string>().substr(0, 80) : "?");
            continue;
        }
        binary.resize((binary.size() + 7) / 8 * 8, '\0');
        root["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
        binary += bytes;
        image.erase("uri");
        image["bufferView"] = root["bufferViews"].size() - 1;
        image["mimeType"] = type;
    }
}

/// Those that became objects, where their data may not be left out.
std::size_t meshesWithoutNode(Json& root) {
    const Json* meshes = arrayIn(root, "meshes");
    std::set<int> shown;
    if (const Json* nodes = arrayIn(root, "nodes"); nodes && meshes)
        for (const Json& node : *nodes)
            if (const int mesh = indexIn(node, "mesh", meshes->size()); mesh >= 0) shown.insert(mesh);
    return meshes ? meshes->size() - shown.size() : 0;
}

bool isNothing(const Json& root) {
    for (const auto& [key, value] : root.items()) {
        const bool usual = key == "asset"    ? value.size() <= 2 && !value.contains("extras")
                           : key == "scenes" ? value == Json::array({Json::object()})
                                             : key == "scene";
        if (!usual) return false;
    }
    return true;
}

} // namespace

Json usualLook() {
    return {{"metallicFactor", 0.0}, {"roughnessFactor", 0.7}};
}

Json foreignRoot(const Scene& scene) {
    Json root = scene.kept.foreign ? Json::parse(scene.kept.foreign->json, nullptr, false) : Json::object();
    if (!root.is_object()) return Json::object();
    if (root.contains("extensions") && !root["extensions"].is_object()) root.erase("extensions");
    return root;
}

Json arrayCounts(const Json& root) {
    Json counts = Json::object();
    for (const char* key : kGltfArrays)
        if (const auto found = root.find(key); found != root.end() && found->is_array() && !found->empty())
            counts[key] = found->size();
    return counts;
}

/// A factor goes with the picture that it scales: alone it would be the look of nothing.
Json lookAlone(const Json& material) {
    const auto taken = [](const Json& from, const char* picture, std::initializer_list<const char*> keys,
                          Json& to) {
        for (const char* key : keys)
            if (const Json* found = member(from, picture) ? nullptr : member(from, key)) to[key] = *found;
    };
    const Json* whole = member(material, "pbrMetallicRoughness");
    const Json from = whole && whole->is_object() ? *whole : Json::object();
    Json pbr = Json::object(), look = Json::object();
    if (member(from, "metallicRoughnessTexture")) pbr = usualLook();
    taken(from, "metallicRoughnessTexture", {"metallicFactor", "roughnessFactor"}, pbr);
    taken(from, "baseColorTexture", {"baseColorFactor"}, pbr);
    taken(material, "emissiveTexture", {"emissiveFactor"}, look);
    if (!member(from, "baseColorTexture")) taken(material, "", {"alphaMode", "alphaCutoff"}, look);
    taken(material, "", {"name", "doubleSided"}, look);
    look["pbrMetallicRoughness"] = std::move(pbr);
    return look;
}

ForeignTree::ForeignTree(Json& root) : root_(root) {
    const Json* nodes = arrayIn(root, "nodes");
    parent_.assign(nodes ? nodes->size() : 0, -1);
    for (std::size_t i = 0; i < parent_.size(); ++i)
        if (const Json* children = member((*nodes)[i], "children"); children && children->is_array())
            for (const Json& child : *children)
                if (child.is_number_unsigned() && child.get<std::uint64_t>() < parent_.size())
                    parent_[child.get<std::size_t>()] = int(i);
}

Affine ForeignTree::worldOf(int node) const {
    Affine world = Affine::Identity();
    std::size_t levels =
        0; // the reader has seen that there is no cycle; a scene from elsewhere may not have one
    for (; node >= 0 && levels <= parent_.size(); node = parent_[std::size_t(node)], ++levels)
        world = localOf(root_["nodes"][std::size_t(node)]) * world;
    return world;
}

bool ForeignTree::isAnimated(int node) const {
    const auto animations = root_.find("animations");
    if (animations == root_.end()) return false;
    for (const Json& animation : *animations)
        for (const Json& channel : animation.value("channels", Json::array()))
            if (const Json* target = member(channel, "target");
                target && indexIn(*target, "node", parent_.size()) == node)
                return true;
    return false;
}

void ForeignTree::uproot(int node, const Pose& pose) {
    Json& json = root_["nodes"][std::size_t(node)];
    const Affine now = Eigen::Translation3d(pose.translation) * pose.rotation;
    const bool stays = parent_[std::size_t(node)] < 0 && localOf(json).matrix() == now.matrix();
    const Affine toNew = now.inverse() * worldOf(node);
    if (const Json* children = member(json, "children"); children && !stays)
        for (const Json& each : *children) {
            const int child = indexIn(Json{{"i", each}}, "i", parent_.size());
            if (child < 0 || isAnimated(child)) continue; // an animated node may have no matrix
            Json& moved = root_["nodes"][std::size_t(child)];
            const Eigen::Matrix4d local = (toNew * localOf(moved)).matrix();
            eraseKeys(moved, {"translation", "rotation", "scale"});
            moved["matrix"] = std::vector<double>(local.data(), local.data() + 16);
        }
    const auto forget = [node](Json& of, const char* key) {
        if (!of.is_object() || !member(of, key) || !of[key].is_array()) return;
        Json& list = of[key];
        list.erase(std::remove(list.begin(), list.end(), Json(node)), list.end());
        if (list.empty()) of.erase(key);
    };
    if (parent_[std::size_t(node)] >= 0)
        forget(root_["nodes"][std::size_t(parent_[std::size_t(node)])], "children");
    if (Json* scenes = arrayIn(root_, "scenes"))
        for (Json& scene : *scenes)
            forget(scene, "nodes");
    parent_[std::size_t(node)] = -1;
}

std::string imageBytes(const Source& source, const Json& image, const tinygltf::Model& model) {
    constexpr std::uint64_t kLargestImage = std::uint64_t(1) << 30;
    const int view = indexIn(image, "bufferView", model.bufferViews.size());
    if (view >= 0) {
        const tinygltf::BufferView& from = model.bufferViews[std::size_t(view)];
        const auto& data = model.buffers[std::size_t(from.buffer)].data;
        return {reinterpret_cast<const char*>(data.data()) + from.byteOffset, from.byteLength};
    }
    const Json* uri = member(image, "uri");
    if (!uri || !uri->is_string()) return {};
    const std::string reference = uri->get<std::string>();
    if (tinygltf::IsDataURI(reference)) {
        std::vector<unsigned char> bytes;
        std::string type;
        tinygltf::DecodeDataURI(&bytes, type, reference, 0, false);
        return {bytes.begin(), bytes.end()};
    }
    const auto file = insideFolder(source.path().parent_path(), withoutPercents(reference));
    if (file.empty()) return {};
    return std::string(Source::open(file, kLargestImage).bytes());
}

std::shared_ptr<const ForeignGltf> foreignOf(const Source& source, const GltfFile& file,
                                             const tinygltf::Model& model, const GltfParting& parting,
                                             std::vector<std::string>& missing, std::size_t& idleMeshes) {
    Json root = parting.root();
    std::string binary = mergedBuffers(root, model);
    if (extensionOf(file.json)) parting.settle(root, binary);
    embedImages(source, root, model, binary, missing);
    if (!extensionOf(file.json)) pruneMeshData(root, binary);
    idleMeshes = meshesWithoutNode(root);
    if (isNothing(root)) return nullptr;
    return std::make_shared<const ForeignGltf>(
        ForeignGltf{root.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(binary)});
}

} // namespace tactum
