// What a zip archive says about itself, held against the rules before anything is unpacked. For this folder
// only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tactum {

/// Thrown at the first fault of an archive, one line; never leaves the folder.
struct ZipFault {
    std::string text;
};

/// `what` about the entry of that name, which may be anything.
[[noreturn]] void failZipEntry(std::string_view name, const std::string& what);

/// One line of the directory, folders included.
struct ZipRecord {
    std::string_view name;
    std::uint16_t method = 0; ///< 0 stored, 8 deflated
    std::uint32_t crc = 0, packed = 0, size = 0;
    std::size_t begin = 0, end = 0; ///< of header and packed bytes in the archive
    bool isFolder() const { return name.ends_with('/'); }
};

/// Every entry, whose header and packed bytes lie within `bytes` and apart from each other's. Throws
/// ZipFault.
std::vector<ZipRecord> readZipDirectory(std::string_view bytes);

/// Names that no folder can hold together, and sizes beyond the limits. `archiveBytes`: of the whole archive.
/// Throws ZipFault.
void checkZipNames(const std::vector<ZipRecord>& records);
void checkZipSizes(const std::vector<ZipRecord>& records, std::size_t archiveBytes);

} // namespace tactum
