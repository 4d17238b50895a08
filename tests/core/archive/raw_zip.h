// Zip archives byte by byte, honest or not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tactum::test {

/// An entry, and where header and directory lie about it.
struct RawEntry {
    std::string name = "bad", packed = {};
    std::uint16_t method = 0, flags = 0;
    std::uint32_t attributes = 0100644u << 16;
    std::string extra = {};                       ///< of the directory
    std::optional<std::uint32_t> size = {};       ///< unpacked; without: as long as packed
    std::optional<std::uint32_t> crc = {};        ///< without: that of `packed`
    std::optional<std::uint32_t> begin = {};      ///< of the header, as the directory says
    std::optional<std::uint32_t> packedSize = {}; ///< as both say
    std::uint16_t disk = 0;
    // What the header says instead.
    std::optional<std::string> localName = {};
    std::optional<std::uint32_t> localSize = {};
    std::optional<std::uint16_t> localMethod = {};
    std::string localExtra = {}, descriptor = {};
};

/// The last record, as far as it is not what it should be.
struct RawEnd {
    std::optional<std::uint16_t> entries = {};
    std::optional<std::uint32_t> size = {}, begin = {};
    std::uint16_t disk = 0, commentBytes = 0;
    std::string before = {}, after = {};
};

std::string rawZip(const std::vector<RawEntry>& entries, const RawEnd& end = {});
std::uint32_t crc32(std::string_view bytes);
/// So many zero bytes deflated 158 to 1; a multiple of 258, and one more.
std::string deflatedZeros(std::size_t count);

} // namespace tactum::test
