#include "core/files/gltf/gltf_packed.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <draco/compression/decode.h>
#include <meshoptimizer.h>

#include "core/base/text.h"
#include "core/files/gltf/gltf_mesh.h"
#include "core/files/gltf/gltf_references.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/readers.h"

namespace tactum {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr std::array kMeshopt{"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr std::size_t kMostBytes = std::size_t(1) << 31; ///< of one view

/// What meshopt says of a view, by either name; or null.
const Json* meshoptOf(const Json& view) {
    for (const char* name : kMeshopt)
        if (const Json* packed = extensionOf(view, name)) return packed;
    return nullptr;
}

void eraseMeshopt(Json& element) {
    for (const char* name : kMeshopt)
        if (extensionOf(element, name)) eraseExtension(element, name);
}

std::string wordIn(const Json& object, const char* key) {
    const Json* word = member(object, key);
    return word && word->is_string() ? word->get<std::string>() : std::string();
}

/// What one view of a file was packed as by meshopt.
struct PackedView {
    std::size_t count = 0, stride = 0;
    std::string mode, filter;

    explicit PackedView(const Json& packed)
        : count(sizeIn(packed, "count")), stride(sizeIn(packed, "byteStride")), mode(wordIn(packed, "mode")),
          filter(wordIn(packed, "filter")) {}
    bool isRight() const {
        if (stride == 0 || count > kMostBytes / stride) return false;
        if (mode == "ATTRIBUTES") return stride % 4 == 0 && stride <= 256 && fitsFilter();
        const bool index = stride == 2 || stride == 4;
        return index && (mode == "INDICES" || (mode == "TRIANGLES" && count % 3 == 0));
    }
    bool fitsFilter() const {
        if (filter == "OCTAHEDRAL") return stride == 4 || stride == 8;
        if (filter == "QUATERNION") return stride == 8;
        return filter.empty() || filter == "NONE" || filter == "EXPONENTIAL";
    }
    bool unpack(const unsigned char* from, std::size_t size, std::vector<unsigned char>& to) const {
        to.resize(count * stride);
        if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer(to.data(), count, stride, from, size) == 0;
        if (mode == "INDICES") return meshopt_decodeIndexSequence(to.data(), count, stride, from, size) == 0;
        if (meshopt_decodeVertexBuffer(to.data(), count, stride, from, size) != 0) return false;
        if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(to.data(), count, stride);
        if (filter == "QUATERNION") meshopt_decodeFilterQuat(to.data(), count, stride);
        if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(to.data(), count, stride);
        return true;
    }
};

template <class T>
bool convert(const draco::PointAttribute& from, std::size_t points, int width,
             std::vector<unsigned char>& to) {
    to.resize(points * std::size_t(width) * sizeof(T));
    T* at = reinterpret_cast<T*>(to.data());
    for (std::size_t i = 0; i < points; ++i, at += width)
        if (!from.ConvertValue<T>(from.mapped_index(draco::PointIndex(std::uint32_t(i))), std::int8_t(width),
                                  at))
            return false;
    return true;
}

/// Its values one after the other, as numbers of the accessor's type.
bool convert(const draco::PointAttribute& from, std::size_t points, const tinygltf::Accessor& as,
             std::vector<unsigned char>& to) {
    const int width = tinygltf::GetNumComponentsInType(std::uint32_t(as.type));
    if (width < 1 || width > 4) return false;
    switch (as.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return convert<float>(from, points, width, to);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return convert<std::int8_t>(from, points, width, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return convert<std::uint8_t>(from, points, width, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return convert<std::int16_t>(from, points, width, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return convert<std::uint16_t>(from, points, width, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return convert<std::uint32_t>(from, points, width, to);
    default:
        return false;
    }
}

/// Null for what is no mesh. Lies about sizes end as lengths that no vector can have.
std::unique_ptr<draco::Mesh> decode(draco::DecoderBuffer& from) {
    try {
        auto decoded = draco::Decoder().DecodeMeshFromBuffer(&from);
        return decoded.ok() ? std::move(decoded).value() : nullptr;
    } catch (const std::length_error&) {
        return nullptr;
    }
}

class Unpacker {
public:
    Unpacker(const Source& source, Json& root, tinygltf::Model& model)
        : source_(source), root_(root), model_(model) {}

    void views() {
        Json* views = arrayIn(root_, "bufferViews");
        for (std::size_t i = 0; views && i < views->size(); ++i)
            if (const Json* packed = meshoptOf((*views)[i])) unpackView(i, PackedView(*packed));
    }
    void primitives() {
        Json* meshes = arrayIn(root_, "meshes");
        for (std::size_t i = 0; meshes && i < meshes->size(); ++i) {
            Json* all = arrayIn((*meshes)[i], "primitives");
            for (std::size_t k = 0; all && k < all->size(); ++k)
                if (const Json* packed = extensionOf((*all)[k], kDraco)) unpack(*packed, i, k, (*all)[k]);
        }
    }

private:
    [[noreturn]] void fail(const std::string& where, const char* what) const {
        source_.fail(where + " " + what + "; export it without compression");
    }

    void unpackView(std::size_t index, const PackedView& packed) {
        const std::string where = "bufferViews[" + std::to_string(index) + "]";
        const tinygltf::BufferView view = model_.bufferViews.at(index);
        std::vector<unsigned char> bytes;
        const unsigned char* from = model_.buffers.at(std::size_t(view.buffer)).data.data() + view.byteOffset;
        if (!packed.isRight() || !packed.unpack(from, view.byteLength, bytes))
            fail(where, "cannot be unpacked by meshoptimizer");
        Json& json = root_["bufferViews"][index];
        model_.bufferViews[index].byteStride = packed.mode == "ATTRIBUTES" ? packed.stride : 0;
        put(index, std::move(bytes));
        eraseMeshopt(json);
    }

    /// Whether no bytes of it are there that anybody could read; an accessor that another primitive had
    /// unpacked has some.
    bool isPacked(const tinygltf::Primitive& primitive) const {
        const auto lacks = [&](int accessor) {
            return accessor >= 0 && std::size_t(accessor) < model_.accessors.size() &&
                   !root_["accessors"][std::size_t(accessor)].contains("bufferView");
        };
        const auto position = primitive.attributes.find("POSITION");
        return lacks(primitive.indices) ||
               (position != primitive.attributes.end() && lacks(position->second));
    }

    void unpack(const Json& packed, std::size_t meshIndex, std::size_t index, Json& json) {
        const std::string where = "meshes[" + std::to_string(meshIndex) + "]";
        if (meshIndex >= model_.meshes.size() || index >= model_.meshes[meshIndex].primitives.size())
            fail(where, "has packed data that belong to nothing");
        tinygltf::Primitive& primitive = model_.meshes[meshIndex].primitives[index];
        if (!isPacked(primitive)) return;
        const int view = indexIn(packed, "bufferView", model_.bufferViews.size());
        if (view < 0) fail(where, "has no packed data");
        const tinygltf::BufferView& of = model_.bufferViews[std::size_t(view)];
        draco::DecoderBuffer in;
        in.Init(reinterpret_cast<const char*>(model_.buffers.at(std::size_t(of.buffer)).data.data()) +
                    of.byteOffset,
                of.byteLength);
        const auto decoded = decode(in);
        if (!decoded) fail(where, "cannot be unpacked by Draco");
        const draco::Mesh& mesh = *decoded;
        if (mesh.num_faces() > kMaxGltfTriangles || mesh.num_points() > kMaxGltfTriangles)
            source_.fail("has more than 67 million triangles; split or simplify it");
        for (const auto& [name, accessor] : primitive.attributes) {
            const Json* ids = member(packed, "attributes");
            if (ids && ids->contains(name))
                unpackAttribute(mesh, sizeIn(*ids, name.c_str()), accessor, where);
        }
        std::vector<unsigned char> corners(std::size_t(mesh.num_faces()) * 3 * sizeof(std::uint32_t));
        auto* at = reinterpret_cast<std::uint32_t*>(corners.data());
        for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
            for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i)))
                *at++ = corner.value();
        put(primitive.indices, std::move(corners), std::size_t(mesh.num_faces()) * 3,
            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, where);
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        json["mode"] = TINYGLTF_MODE_TRIANGLES;
    }

    void unpackAttribute(const draco::Mesh& mesh, std::size_t id, int accessor, const std::string& where) {
        const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(std::uint32_t(id));
        if (!from || accessor < 0 || std::size_t(accessor) >= model_.accessors.size())
            fail(where, "has an attribute that its packed data lack");
        const tinygltf::Accessor& as = model_.accessors[std::size_t(accessor)];
        std::vector<unsigned char> bytes;
        if (!convert(*from, mesh.num_points(), as, bytes)) fail(where, "has packed values of another type");
        put(accessor, std::move(bytes), mesh.num_points(), as.componentType, where);
    }

    /// A new view for an accessor.
    void put(int accessor, std::vector<unsigned char> bytes, std::size_t count, int type,
             const std::string& where) {
        if (accessor < 0 || std::size_t(accessor) >= model_.accessors.size())
            fail(where, "has packed triangles and no accessor for them");
        const std::size_t view = model_.bufferViews.size();
        model_.bufferViews.emplace_back();
        root_["bufferViews"].push_back(Json::object());
        put(view, std::move(bytes));
        tinygltf::Accessor& to = model_.accessors[std::size_t(accessor)];
        Json& json = root_["accessors"][std::size_t(accessor)];
        json["bufferView"] = to.bufferView = int(view);
        json["count"] = to.count = count;
        json["componentType"] = to.componentType = type;
        to.byteOffset = 0;
        json.erase("byteOffset");
    }

    /// These bytes, and nothing else, in a view.
    void put(std::size_t view, std::vector<unsigned char> bytes) {
        tinygltf::BufferView& to = model_.bufferViews[view];
        Json& json = root_["bufferViews"][view];
        json["buffer"] = to.buffer = int(model_.buffers.size());
        json["byteLength"] = to.byteLength = bytes.size();
        to.byteOffset = 0;
        json.erase("byteOffset");
        root_["buffers"].push_back({{"byteLength", bytes.size()}});
        model_.buffers.emplace_back().data = std::move(bytes);
    }

    const Source& source_;
    Json& root_;
    tinygltf::Model& model_;
};

} // namespace

namespace {

/// An accessor without bytes is none to tinygltf, which looks at those of indices.
void pointAtDraco(Json& root) {
    Json *meshes = arrayIn(root, "meshes"), *accessors = arrayIn(root, "accessors");
    for (std::size_t i = 0; meshes && accessors && i < meshes->size(); ++i) {
        Json* primitives = arrayIn((*meshes)[i], "primitives");
        for (std::size_t k = 0; primitives && k < primitives->size(); ++k) {
            const Json* packed = extensionOf((*primitives)[k], kDraco);
            const int corners = packed ? indexIn((*primitives)[k], "indices", accessors->size()) : -1;
            if (corners < 0 || !packed->contains("bufferView")) continue;
            Json& accessor = (*accessors)[std::size_t(corners)];
            if (!accessor.contains("bufferView")) accessor["bufferView"] = (*packed)["bufferView"];
        }
    }
}

} // namespace

void pointAtPacked(Json& root, bool isBinary) {
    pointAtDraco(root);
    bool any = false;
    Json* views = arrayIn(root, "bufferViews");
    for (std::size_t i = 0; views && i < views->size(); ++i) {
        const Json* found = meshoptOf((*views)[i]);
        if (!found) continue;
        any = true;
        const Json packed = *found;
        Json& view = (*views)[i];
        for (const char* key : {"buffer", "byteOffset", "byteLength"}) {
            view.erase(key);
            if (packed.contains(key)) view[key] = packed[key];
        }
        view.erase("byteStride");
    }
    // What stands in for them has no bytes anywhere; only a binary file's first buffer has its own.
    Json* buffers = any ? arrayIn(root, "buffers") : nullptr;
    for (std::size_t i = isBinary; buffers && i < buffers->size(); ++i)
        if (Json& buffer = (*buffers)[i]; buffer.is_object() && !buffer.contains("uri"))
            buffer = {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}};
}

void unpackMeshes(const Source& source, Json& root, tinygltf::Model& model) {
    Unpacker unpacker(source, root, model);
    unpacker.views();
    unpacker.primitives();
    if (Json* meshes = arrayIn(root, "meshes"))
        for (Json& mesh : *meshes)
            if (Json* primitives = arrayIn(mesh, "primitives"))
                for (Json& primitive : *primitives)
                    if (extensionOf(primitive, kDraco)) eraseExtension(primitive, kDraco);
    if (Json* buffers = arrayIn(root, "buffers"))
        for (Json& buffer : *buffers)
            eraseMeshopt(buffer);
    eraseUse(root, kDraco);
    for (const char* name : kMeshopt)
        eraseUse(root, name);
}

} // namespace tactum
