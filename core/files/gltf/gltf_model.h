// A glTF or glb file parsed by tinygltf, after our own checks of what that library trusts.
#pragma once

#include <functional>
#include <memory>
#include <vector>

// In a namespace of our own: libdraco, which Assimp brings along, exports another one's functions under the
// name that they have by themselves.
#define tinygltf tactum_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "core/base/vec.h"
#include "core/files/gltf/gltf_file.h"

namespace tactum {

/// Parses the file: every buffer view and nesting depth is checked, external buffers come only from
/// the asset's folder, images and skins are left out. Throws ReadFault.
tinygltf::Model parseGltf(const Source& source, const GltfFile& file);

/// The elements of one accessor, whose place in its buffer has been checked. Throws ReadFault.
class GltfAccessor {
public:
    /// `components`: how many numbers an element must have, e.g. 3 for positions.
    GltfAccessor(const Source& source, const tinygltf::Model& model, int index, std::size_t components);

    std::size_t size() const { return count_; }
    /// As a fraction where the accessor is normalised.
    double number(std::size_t element, std::size_t component) const;
    /// Unsigned integers only: of indices.
    std::uint32_t integer(std::size_t element) const;
    bool isUnsigned() const;

private:
    using Fail = std::function<void(const char* what)>; ///< does not return

    void readView(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t size,
                  const Fail& fail);
    void replaceSparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, std::size_t size,
                       const Fail& fail);
    template <class T> T at(std::size_t element, std::size_t component) const;
    template <class T> double scaled(std::size_t element, std::size_t component) const;

    const unsigned char* data_ = nullptr;
    std::shared_ptr<const std::vector<unsigned char>> own_; ///< of a sparse one
    std::size_t count_ = 0, stride_ = 0;
    int type_ = 0;
    bool normalized_ = false;
};

} // namespace tactum
