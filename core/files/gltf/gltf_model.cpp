#include "core/files/gltf/gltf_model.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "core/base/text.h"
#include "core/files/gltf/gltf_packed.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLargestBuffer = std::uint64_t(1) << 32;

/// tinygltf reads external files through these; they end at the folder of the asset.
struct AssetFolder {
    fs::path folder;
    std::string refused; ///< the first file that was asked for and is not there
};

tinygltf::FsCallbacks callbacksFor(AssetFolder& assets) {
    tinygltf::FsCallbacks callbacks{};
    callbacks.FileExists = [](const std::string& name, void* user) {
        auto& home = *static_cast<AssetFolder*>(user);
        const bool exists = !insideFolder(home.folder, name).empty();
        if (!exists && home.refused.empty()) home.refused = name;
        return exists;
    };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name,
                                 void* user) {
        const fs::path file = insideFolder(static_cast<AssetFolder*>(user)->folder, name);
        if (file.empty()) return false;
        const Source source = Source::open(file, kLargestBuffer);
        out->assign(source.bytes().begin(), source.bytes().end());
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                  void*) { return false; };
    callbacks.user_data = &assets;
    return callbacks;
}

bool ignoreImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                 void*) {
    return true;
}

/// What a file may need that is read, or that only the eye misses.
bool isReadable(std::string_view extension) {
    constexpr std::array<std::string_view, 14> known{
        "KHR_mesh_quantization",    "KHR_texture_transform",   "KHR_texture_basisu",
        "KHR_physics_rigid_bodies", "KHR_implicit_shapes",     "KHR_collision_shapes",
        "KHR_lights_punctual",      "EXT_texture_webp",        "EXT_texture_avif",
        "MSFT_texture_dds",         "EXT_mesh_gpu_instancing", "KHR_draco_mesh_compression",
        "EXT_meshopt_compression",  "KHR_meshopt_compression"};
    return extension == kExtension || std::ranges::find(known, extension) != known.end() ||
           extension.starts_with("KHR_materials_");
}

/// Elements that no byte of the file stands for: a short file could ask for any number of them.
void demandFewZeros(const Source& source, const tinygltf::Model& model) {
    constexpr std::size_t kMost = std::size_t(1) << 22;
    std::size_t zeros = 0;
    for (const tinygltf::Accessor& accessor : model.accessors)
        if (accessor.sparse.isSparse && accessor.bufferView < 0) zeros += std::min(accessor.count, kMost + 1);
    if (zeros > kMost)
        source.fail("has more than 4 million sparse elements that are zero; export them without sparse "
                    "accessors");
}

void demandReadable(const Source& source, const tinygltf::Model& model) {
    for (const std::string& extension : model.extensionsRequired)
        if (!isReadable(extension))
            source.fail("needs the extension " + inQuotes(extension) +
                        ", which is not read; export it without");
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = model.bufferViews[i];
        const bool known = view.buffer >= 0 && std::size_t(view.buffer) < model.buffers.size();
        const std::size_t size = known ? model.buffers[std::size_t(view.buffer)].data.size() : 0;
        if (!known || view.byteOffset > size || view.byteLength > size - view.byteOffset)
            source.fail("bufferViews[" + std::to_string(i) +
                        "] reaches beyond its buffer; re-export the file");
    }
}

} // namespace

tinygltf::Model parseGltf(const Source& source, const GltfFile& file) {
    Json json = file.json;
    for (const char* unused : {"images", "textures", "samplers", "skins", "cameras", "extras"})
        json.erase(unused);
    pointAtPacked(json, file.isBinary);
    const std::string text = file.isBinary ? packGlb(json, file.binary) : json.dump();
    AssetFolder assets{source.path().parent_path(), {}};
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(callbacksFor(assets));
    parser.SetImageLoader(ignoreImage, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    bool parsed = false;
    try {
        const auto size = unsigned(text.size());
        const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
        parsed =
            text.size() < kLargestBuffer &&
            (file.isBinary ? parser.LoadBinaryFromMemory(&model, &error, &warning, bytes, size, "")
                           : parser.LoadASCIIFromString(&model, &error, &warning, text.data(), size, ""));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& fault) { // of the JSON library, where a value has a type nobody expects
        error = fault.what();
    }
    if (!assets.refused.empty())
        source.fail("its buffer " + inQuotes(assets.refused) +
                    " is not in its folder; copy it beside the file");
    if (!parsed)
        source.fail("cannot be parsed (" + printable(error.substr(0, error.find('\n')), 160) +
                    "); re-export it");
    demandReadable(source, model);
    demandFewZeros(source, model);
    return model;
}

GltfAccessor::GltfAccessor(const Source& source, const tinygltf::Model& model, int index,
                           std::size_t components) {
    const Fail fail = [&](const char* what) {
        source.fail("accessors[" + std::to_string(index) + "] " + what + "; re-export the file");
    };
    if (index < 0 || std::size_t(index) >= model.accessors.size()) fail("is used but not there");
    const tinygltf::Accessor& accessor = model.accessors[std::size_t(index)];
    const int componentSize = tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType));
    if (componentSize <= 0 ||
        tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)) != int(components))
        fail("has a type that does not fit its use");
    const std::size_t size = std::size_t(componentSize) * components;
    count_ = accessor.count;
    type_ = accessor.componentType;
    normalized_ = accessor.normalized;
    if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) readView(model, accessor, size, fail);
    if (accessor.sparse.isSparse) replaceSparse(model, accessor, size, fail);
}

/// The elements one after the other in a buffer view.
void GltfAccessor::readView(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                            std::size_t size, const Fail& fail) {
    if (accessor.bufferView < 0 || std::size_t(accessor.bufferView) >= model.bufferViews.size())
        fail("has no buffer view");
    const tinygltf::BufferView& view = model.bufferViews[std::size_t(accessor.bufferView)];
    stride_ = view.byteStride ? view.byteStride : size;
    if (stride_ < size && count_ > 1) fail("has elements that overlap");
    const std::size_t room = view.byteLength - std::min(view.byteLength, accessor.byteOffset);
    if (count_ > 0 && (size > room || (count_ - 1) > (room - size) / stride_))
        fail("reaches beyond its buffer view");
    data_ = model.buffers[std::size_t(view.buffer)].data.data() + view.byteOffset + accessor.byteOffset;
}

/// A copy, of zeros where there is no view, in which some elements are others.
void GltfAccessor::replaceSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                                 std::size_t size, const Fail& fail) {
    auto all = std::make_shared<std::vector<unsigned char>>(count_ * size, 0);
    for (std::size_t i = 0; data_ && i < count_; ++i)
        std::memcpy(all->data() + i * size, data_ + i * stride_, size);
    const auto& sparse = accessor.sparse;
    const auto bytesOf = [&](int index, std::size_t offset, std::size_t each) {
        if (index < 0 || std::size_t(index) >= model.bufferViews.size()) fail("is sparse without its values");
        const tinygltf::BufferView& view = model.bufferViews[std::size_t(index)];
        const std::size_t room = view.byteLength - std::min(view.byteLength, offset);
        if (sparse.count < 0 || std::size_t(sparse.count) > room / each)
            fail("has sparse values that reach beyond their buffer view");
        return model.buffers[std::size_t(view.buffer)].data.data() + view.byteOffset + offset;
    };
    const int width = tinygltf::GetComponentSizeInBytes(std::uint32_t(sparse.indices.componentType));
    const bool fits = sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                      sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                      sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!fits) fail("has sparse indices that are not unsigned whole numbers");
    const unsigned char* index =
        bytesOf(sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), std::size_t(width));
    const unsigned char* value =
        bytesOf(sparse.values.bufferView, std::size_t(sparse.values.byteOffset), size);
    std::int64_t last = -1;
    for (int i = 0; i < sparse.count; ++i, index += width, value += size) {
        std::uint32_t place = 0; // little-endian, as glTF and this machine
        std::memcpy(&place, index, std::size_t(width));
        if (std::exchange(last, place) >= place) fail("has sparse indices that do not rise");
        if (place >= count_) fail("has a sparse index beyond its elements");
        std::memcpy(all->data() + place * size, value, size);
    }
    own_ = std::move(all);
    data_ = own_->data();
    stride_ = size;
}

template <class T> T GltfAccessor::at(std::size_t element, std::size_t component) const {
    T value;
    std::memcpy(&value, data_ + element * stride_ + component * sizeof(T), sizeof(T));
    return value;
}

template <class T> double GltfAccessor::scaled(std::size_t element, std::size_t component) const {
    const double value = at<T>(element, component);
    return normalized_ ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
}

double GltfAccessor::number(std::size_t element, std::size_t component) const {
    switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return scaled<std::int8_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return scaled<std::uint8_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return scaled<std::int16_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return scaled<std::uint16_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_INT:
        return scaled<std::int32_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return scaled<std::uint32_t>(element, component);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return at<float>(element, component);
    default:
        return at<double>(element, component);
    }
}

bool GltfAccessor::isUnsigned() const {
    return type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT || type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::uint32_t GltfAccessor::integer(std::size_t element) const {
    if (type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return at<std::uint8_t>(element, 0);
    if (type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return at<std::uint16_t>(element, 0);
    return at<std::uint32_t>(element, 0);
}

} // namespace tactum
