// What a PLY file says about itself: elements, their counts, their properties.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/files/source.h"

namespace tactum {

/// Unknown: of text, where it is one word.
enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64, Unknown };

constexpr std::size_t sizeOf(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 1};
    return sizes[std::size_t(type)];
}
constexpr bool isInteger(PlyType type) {
    return type < PlyType::Float32;
}

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> countType; ///< of a list; nothing for a single value
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The place of the first property with one of these names, in their order.
    std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
    /// The least number of bytes that one of these takes in a file.
    std::uint64_t leastSize(bool ascii) const;
};

struct PlyHeader {
    enum class Encoding { Ascii, LittleEndian, BigEndian };
    Encoding encoding = Encoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyOffset = 0; ///< of the first byte after the header
};

/// Reads the header and sees that the file is long enough for what it promises. Throws ReadFault.
PlyHeader readPlyHeader(const Source& source);

} // namespace tactum
