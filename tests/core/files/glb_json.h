// The JSON of a binary glTF, as a test changes it. Throws where a scene cannot be written.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"

namespace tactum::test {

inline std::string saved(const Scene& scene) {
    const auto glb = glbOf(scene);
    return glb ? *glb : throw std::runtime_error(glb.error().text);
}

inline std::uint32_t jsonLengthOf(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    return length;
}

inline Json jsonOf(const std::string& glb) {
    return Json::parse(glb.substr(20, jsonLengthOf(glb)));
}

/// The same with other JSON; what its buffers hold stays.
inline std::string withJson(const std::string& glb, const Json& json) {
    return packGlb(json, std::string_view(glb).substr(28 + jsonLengthOf(glb)));
}

} // namespace tactum::test
