// The rules for names and sizes: rows of docs/decisions/bundle.md.
#include <algorithm>
#include <cstring>
#include <map>

#include "core/archive/zip_archive.h"
#include "core/archive/zip_directory.h"

namespace tactum {

namespace {

constexpr std::size_t kLongestName = 240; // with a folder before it still a path on any system
/// Deflate makes at most so many bytes of one (zlib, "Maximum expansion factor").
constexpr std::size_t kDeflateLimit = 1032;

bool isLetterOrDigit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Null when there is none.
const char* faultInName(std::string_view name) {
    if (name.empty()) return "has no name";
    if (name.size() > kLongestName) return "has too long a name";
    if (name.find('\0') != name.npos) return "has a zero in its name";
    if (name.find('\\') != name.npos) return "has a backslash in its name";
    if (name.size() > 1 && name[1] == ':') return "is on a drive of its own";
    if (name.front() == '/') return "begins at the root of the disk";
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (part == "..") return "leaves its folder";
        if (part == "." || part.empty()) return "has an empty part in its name";
        begin = end + 1;
    }
    const bool plain =
        std::ranges::all_of(name, [](char c) { return isLetterOrDigit(c) || std::strchr("._ /-", c); });
    return plain ? nullptr : "has a sign in its name that is no letter, digit, space, dot, _ or -";
}

std::string_view withoutSlash(const ZipRecord& record) {
    return record.name.substr(0, record.name.size() - record.isFolder());
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return lower;
}

void checkSize(const ZipRecord& record) {
    if (record.isFolder() && record.size + record.packed > 0)
        failZipEntry(record.name, "is a folder with bytes in it");
    if (record.size > kZipEntryBytes) failZipEntry(record.name, "is larger than 1 GiB");
    if (record.method == 0 ? record.size != record.packed
                           : record.size > kDeflateLimit * (std::size_t(record.packed) + 1))
        failZipEntry(record.name, "cannot be as large as it says");
}

} // namespace

bool isZipName(std::string_view name) {
    return faultInName(name) == nullptr;
}

void checkZipNames(const std::vector<ZipRecord>& records) {
    std::map<std::string, const ZipRecord*> known; // in lower case: some disks do not tell the cases apart
    for (const ZipRecord& record : records) {
        const std::string_view name = withoutSlash(record);
        if (const char* fault = faultInName(name)) failZipEntry(record.name, fault);
        const auto [other, isFirst] = known.emplace(lowerCase(name), &record);
        if (isFirst) continue;
        failZipEntry(record.name, withoutSlash(*other->second) == name
                                      ? "is there twice"
                                      : "is there twice but for its capitals");
    }
    for (const ZipRecord& record : records)
        for (std::size_t slash = record.name.find('/'); slash != std::string_view::npos;
             slash = record.name.find('/', slash + 1)) {
            const auto folder = known.find(lowerCase(record.name.substr(0, slash)));
            if (folder != known.end() && !folder->second->isFolder())
                failZipEntry(folder->second->name, "is a file and a folder");
        }
}

void checkZipSizes(const std::vector<ZipRecord>& records, std::size_t archiveBytes) {
    std::size_t total = 0;
    for (const ZipRecord& record : records) {
        checkSize(record);
        total += record.size;
    }
    if (total > kZipBytes) throw ZipFault{"is a zip archive of more than 2 GiB"};
    if (total > kZipCalm && total / kZipRatio > archiveBytes)
        throw ZipFault{"is a zip archive that grows more than a hundredfold: a bomb"};
}

} // namespace tactum
