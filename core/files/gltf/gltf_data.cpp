#include "core/files/gltf/gltf_data.h"

#include <algorithm>

#include "core/files/images/write_png.h"

namespace tactum {

int GltfData::add(const char* array, Json element) {
    Json& all = root_[array];
    if (!all.is_array()) all = Json::array();
    all.push_back(std::move(element));
    return int(all.size()) - 1;
}

std::size_t GltfData::count(const char* array) const {
    const auto found = root_.find(array);
    return found != root_.end() && found->is_array() ? found->size() : 0;
}

int GltfData::addView(std::string_view bytes, int target) {
    binary_.resize((binary_.size() + 7) / 8 * 8, '\0');
    Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (target) view["target"] = target;
    binary_ += bytes;
    return add("bufferViews", std::move(view));
}

int GltfData::addAccessor(int view, int component, const char* type, std::size_t count) {
    return add("accessors",
               {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
}

int GltfData::addAttribute(const std::vector<Eigen::Vector3f>& values, bool bounds) {
    const int accessor = addAccessor(addView(bytesOf(values), kVertices), kFloat, "VEC3", values.size());
    if (!bounds) return accessor;
    Eigen::Vector3f low = values.front(), high = values.front();
    for (const Eigen::Vector3f& value : values)
        low = low.cwiseMin(value), high = high.cwiseMax(value);
    Json& json = root_["accessors"].back();
    json["min"] = {low.x(), low.y(), low.z()};
    json["max"] = {high.x(), high.y(), high.z()};
    return accessor;
}

int GltfData::addAttribute(const std::vector<float>& values) {
    return addAccessor(addView(bytesOf(values), kVertices), kFloat, "SCALAR", values.size());
}

int GltfData::addAttribute(const std::vector<Eigen::Vector2f>& values) {
    return addAccessor(addView(bytesOf(values), kVertices), kFloat, "VEC2", values.size());
}

int GltfData::addAttribute(const std::vector<Eigen::Vector4f>& values) {
    return addAccessor(addView(bytesOf(values), kVertices), kFloat, "VEC4", values.size());
}

int GltfData::addIndices(const std::vector<std::uint32_t>& values) {
    return addAccessor(addView(bytesOf(values), kIndices), kUnsigned, "SCALAR", values.size());
}

int GltfData::addNumbers(const std::vector<float>& values, const char* type, bool bounds) {
    const std::size_t width = type == std::string_view("SCALAR") ? 1 : std::size_t(type[3] - '0');
    const int accessor = addAccessor(addView(bytesOf(values)), kFloat, type, values.size() / width);
    if (!bounds) return accessor;
    const auto [low, high] = std::ranges::minmax(values);
    root_["accessors"].back()["min"] = {low};
    root_["accessors"].back()["max"] = {high};
    return accessor;
}

int GltfData::addTexture(const std::shared_ptr<const TextureImage>& image) {
    const auto [found, isNew] = textures_.try_emplace(image.get(), 0);
    if (isNew) found->second = addTexture(encodePng(*image, progress_), image->name());
    return found->second;
}

int GltfData::addTexture(const std::string& png, const std::string& name) {
    Json image{{"bufferView", addView(png)}, {"mimeType", "image/png"}};
    if (!name.empty()) image["name"] = name;
    return add("textures", {{"source", add("images", std::move(image))}});
}

int GltfData::addSharedTexture(const std::string& png) {
    const auto [found, isNew] = shared_.try_emplace(png, 0);
    if (isNew) found->second = addTexture(png, {});
    return found->second;
}

std::string GltfData::finish() {
    if (!binary_.empty()) root_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return std::move(binary_);
}

} // namespace tactum
