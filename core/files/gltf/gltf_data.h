// What a glTF file is put together from: elements of its arrays, and the binary chunk behind them.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/files/gltf/gltf_file.h"
#include "core/surface/texture_image.h"

namespace tactum {

/// Appends elements; returns their indices. What is in the arrays already keeps its place.
class GltfData {
public:
    /// `root` and `progress` outlive this; `binary` is what its buffer views refer to. After a cancel
    /// pictures are left empty.
    GltfData(Json& root, std::string binary, const Progress& progress)
        : root_(root), progress_(progress), binary_(std::move(binary)) {}

    int add(const char* array, Json element);
    std::size_t count(const char* array) const;

    /// A buffer view of these bytes, at a multiple of eight.
    int addView(std::string_view bytes, int target = 0);
    template <class T> int addRawView(const std::vector<T>& values) {
        return addView({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }
    /// Accessors of their own views: vertex attributes with their bounds, indices, and numbers of animations.
    int addAttribute(const std::vector<Eigen::Vector3f>& values, bool bounds);
    int addAttribute(const std::vector<float>& values);
    int addAttribute(const std::vector<Eigen::Vector2f>& values);
    int addAttribute(const std::vector<Eigen::Vector4f>& values);
    int addIndices(const std::vector<std::uint32_t>& values);
    /// `type`: SCALAR, VEC3 or VEC4. `bounds`: of a scalar.
    int addNumbers(const std::vector<float>& values, const char* type, bool bounds = false);

    /// The texture of an image, which is stored once as PNG.
    int addTexture(const std::shared_ptr<const TextureImage>& image);
    int addTexture(const std::string& png, const std::string& name);
    /// The same without a name; equal pictures are stored once.
    int addSharedTexture(const std::string& png);

    /// Takes the binary chunk, and says in the root how long it is.
    std::string finish();

private:
    static constexpr int kVertices = 34962, kIndices = 34963, kFloat = 5126, kUnsigned = 5125;

    int addAccessor(int view, int component, const char* type, std::size_t count);
    template <class T> std::string_view bytesOf(const std::vector<T>& values) {
        return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
    }

    Json& root_;
    const Progress& progress_;
    std::string binary_;
    std::map<const TextureImage*, int> textures_;
    std::map<std::string, int> shared_; ///< by their bytes
};

} // namespace tactum
