// The layout is that of APPNOTE.TXT 6.3 of PKWARE, whose section is named at each part.
#include "core/archive/zip_directory.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/archive/zip_archive.h"

namespace tactum {

namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50,
                        kEndLocator64 = 0x07064b50;
constexpr std::size_t kLocalBytes = 30, kCentralBytes = 46, kEndBytes = 22, kLocator64Bytes = 20;
constexpr std::uint16_t kDescriptorFollows = 1 << 3; ///< the header may leave out sizes and sum

[[noreturn]] void fail(const char* what) {
    throw ZipFault{what};
}

template <class T> T number(std::string_view bytes, std::size_t at) {
    static_assert(std::endian::native == std::endian::little);
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}
std::uint16_t u16(std::string_view bytes, std::size_t at) {
    return number<std::uint16_t>(bytes, at);
}
std::uint32_t u32(std::string_view bytes, std::size_t at) {
    return number<std::uint32_t>(bytes, at);
}

/// Where the directory lies.
struct Directory {
    std::size_t begin = 0, end = 0, entries = 0;
};

/// 4.3.16, end of central directory record. It has to be the last thing: where programs would have to search
/// for it, two of them may find two archives in one file.
Directory findDirectory(std::string_view bytes) {
    if (!bytes.starts_with("PK")) fail("is no zip archive");
    if (bytes.size() < kEndBytes || u32(bytes, bytes.size() - kEndBytes) != kEnd)
        fail("is a zip archive without its end: it was cut off, or something follows");
    const std::size_t at = bytes.size() - kEndBytes;
    const std::string_view end = bytes.substr(at);
    if (u16(end, 20) != 0) fail("is a zip archive whose comment is missing");
    if (u16(end, 4) != 0 || u16(end, 6) != 0 || u16(end, 8) != u16(end, 10))
        fail("is one part of several of a zip archive");
    const std::size_t entries = u16(end, 10), size = u32(end, 12), begin = u32(end, 16);
    if (entries == 0xffff || size == 0xffffffff || begin == 0xffffffff ||
        (at >= kLocator64Bytes && u32(bytes, at - kLocator64Bytes) == kEndLocator64))
        fail("is a zip64 archive, which is for more than a bundle may hold");
    if (begin + size != at) fail("is a zip archive whose directory is not where it says");
    return {begin, at, entries};
}

/// 4.5: extra fields, of which some would change what the others say.
void checkExtra(std::string_view extra, std::string_view name) {
    while (!extra.empty()) {
        if (extra.size() < 4 || extra.size() - 4 < u16(extra, 2))
            failZipEntry(name, "an extra field is longer than its header");
        if (u16(extra, 0) == 0x0001)
            failZipEntry(name, "is of zip64, which is for larger ones than it may be");
        if (u16(extra, 0) == 0x7075) failZipEntry(name, "has a second name");
        extra.remove_prefix(4 + u16(extra, 2));
    }
}

/// 4.4.15, upper half of the external attributes: the mode that Unix has for it.
void checkMode(std::uint32_t attributes, const ZipRecord& record) {
    const std::uint32_t type = attributes >> 16 & 0170000;
    if (type == 0120000) failZipEntry(record.name, "is a link");
    if (type != 0 && type != (record.isFolder() ? 0040000u : 0100000u))
        failZipEntry(record.name, "is neither a file nor a folder, or not the one that its name says");
}

void checkCoding(std::uint16_t flags, const ZipRecord& record) {
    if (flags & (1 << 0 | 1 << 6 | 1 << 13)) failZipEntry(record.name, "is encrypted");
    if (flags & 1 << 5) failZipEntry(record.name, "is a patch of another file");
    if (record.method != 0 && record.method != 8)
        failZipEntry(record.name,
                     "is packed in a way that is not read here (" + std::to_string(record.method) + ")");
}

/// 4.3.7: the header before the packed bytes says the same as the directory.
void checkLocal(std::string_view bytes, const Directory& directory, std::uint16_t flags, ZipRecord& record) {
    if (directory.begin < kLocalBytes || record.begin > directory.begin - kLocalBytes)
        failZipEntry(record.name, "begins behind the end of the files");
    const std::string_view header = bytes.substr(record.begin);
    if (u32(header, 0) != kLocal) failZipEntry(record.name, "has no header");
    const std::size_t nameBytes = u16(header, 26), extraBytes = u16(header, 28);
    record.end = record.begin + kLocalBytes + nameBytes + extraBytes + record.packed;
    if (record.end > directory.begin) failZipEntry(record.name, "reaches beyond the end of the files");
    if (header.substr(kLocalBytes, nameBytes) != record.name)
        failZipEntry(record.name, "has another name in its header");
    checkExtra(header.substr(kLocalBytes + nameBytes, extraBytes), record.name);
    const bool same =
        u32(header, 14) == record.crc && u32(header, 18) == record.packed && u32(header, 22) == record.size;
    const bool isLeftOut = u32(header, 14) == 0 && u32(header, 18) == 0 && u32(header, 22) == 0;
    if (u16(header, 6) != flags || u16(header, 8) != record.method ||
        !(same || (isLeftOut && flags & kDescriptorFollows)))
        failZipEntry(record.name, "its header and the directory contradict each other");
}

/// 4.3.12, central directory header; gives back how long it is.
std::size_t readRecord(std::string_view bytes, const Directory& directory, std::size_t at,
                       ZipRecord& record) {
    if (directory.end - at < kCentralBytes || u32(bytes, at) != kCentral)
        fail("is a zip archive with fewer entries than it says");
    const std::string_view header = bytes.substr(at, directory.end - at);
    const std::size_t nameBytes = u16(header, 28), extraBytes = u16(header, 30);
    const std::size_t length = kCentralBytes + nameBytes + extraBytes + u16(header, 32);
    if (length > header.size()) fail("is a zip archive with a name that is longer than its directory");
    record = {.name = header.substr(kCentralBytes, nameBytes),
              .method = u16(header, 10),
              .crc = u32(header, 16),
              .packed = u32(header, 20),
              .size = u32(header, 24),
              .begin = u32(header, 42)};
    checkExtra(header.substr(kCentralBytes + nameBytes, extraBytes), record.name);
    if (u16(header, 34) != 0) failZipEntry(record.name, "is in another part of the archive");
    checkMode(u32(header, 38), record);
    checkCoding(u16(header, 8), record);
    checkLocal(bytes, directory, u16(header, 8), record);
    return length;
}

void checkOverlap(std::vector<ZipRecord> records) {
    std::ranges::sort(records, {}, &ZipRecord::begin);
    for (std::size_t i = 1; i < records.size(); ++i)
        if (records[i].begin < records[i - 1].end) failZipEntry(records[i].name, "lies over another entry");
}

} // namespace

std::vector<ZipRecord> readZipDirectory(std::string_view bytes) {
    const Directory directory = findDirectory(bytes);
    if (directory.entries > kZipEntries) fail("is a zip archive of more than 4096 entries");
    std::vector<ZipRecord> records(directory.entries);
    std::size_t at = directory.begin;
    for (ZipRecord& record : records)
        at += readRecord(bytes, directory, at, record);
    if (at != directory.end) fail("is a zip archive with more in its directory than it says");
    checkOverlap(records);
    return records;
}

} // namespace tactum
