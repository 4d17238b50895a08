#include "core/archive/zip_archive.h"

#include <algorithm>
#include <cassert>
#include <new>

#include <zip.h>

#include "core/archive/zip_directory.h"
#include "core/base/realtime.h"

namespace tactum {

namespace {

using namespace std::string_view_literals;

constexpr const char* kRemedy = "; use another one, or make it again";
constexpr std::size_t kAtOnce = 64 * 1024;

/// What begins an archive or a compressed stream. None has a place in a bundle: a bomb is made of such.
bool isArchive(std::string_view bytes) {
    constexpr std::string_view kBegins[] = {"PK\3\4"sv,
                                            "PK\5\6"sv,
                                            "\x1f\x8b"sv,
                                            "7z\xbc\xaf\x27\x1c"sv,
                                            "Rar!\x1a\x07"sv,
                                            "BZh"sv,
                                            "\xfd"
                                            "7zXZ\0"sv,
                                            "\x28\xb5\x2f\xfd"sv};
    const bool isTar = bytes.size() > 262 && bytes.substr(257, 5) == "ustar";
    return isTar || std::ranges::any_of(kBegins, [&](auto begin) { return bytes.starts_with(begin); });
}

bool isCompressedPicture(std::string_view bytes) {
    return bytes.starts_with("\x89PNG"sv) || bytes.starts_with("\xff\xd8\xff"sv);
}

/// The library reads the same directory in the same way, or we do not go on.
void expectSame(zip* library, std::size_t place, const ZipRecord& record) {
    zip_stat_t stat{};
    if (zip_stat_index(library, place, 0, &stat) != 0 || stat.name != record.name ||
        stat.size != record.size || stat.comp_size != record.packed || stat.crc != record.crc ||
        stat.comp_method != record.method)
        failZipEntry(record.name, "is not the same to every program that reads it");
}

using Source = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

Source sourceOf(std::string_view bytes) {
    zip_error_t error{};
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error), &zip_source_free);
    if (!source) throw std::bad_alloc();
    return source;
}

std::string unpacked(zip_file_t* file, const std::string& name, std::size_t size) {
    std::string bytes;
    bytes.reserve(size);
    std::string part(kAtOnce, '\0');
    while (true) {
        const zip_int64_t count = file ? zip_fread(file, part.data(), part.size()) : -1;
        if (count < 0) failZipEntry(name, "is damaged");
        if (std::size_t(count) > size - bytes.size()) failZipEntry(name, "holds more than it says");
        if (count == 0) break;
        bytes.append(part, 0, std::size_t(count));
    }
    if (bytes.size() < size) failZipEntry(name, "holds less than it says");
    if (isArchive(bytes)) failZipEntry(name, "is an archive itself");
    return bytes;
}

/// Everything of an entry but its bytes, and how those are packed, is fixed.
void addEntry(zip* library, const ZipEntry& entry) {
    assert(isZipName(entry.name));
    zip_source_t* source = zip_source_buffer(library, entry.bytes.data(), entry.bytes.size(), 0);
    const zip_int64_t at = source ? zip_file_add(library, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (at < 0) zip_source_free(source);
    const bool stored = entry.bytes.empty() || isCompressedPicture(entry.bytes);
    const zip_uint16_t firstOfJanuary1980 = 1 << 5 | 1;
    if (at < 0 ||
        zip_set_file_compression(library, zip_uint64_t(at), stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 6) != 0 ||
        zip_file_set_dostime(library, zip_uint64_t(at), 0, firstOfJanuary1980, 0) != 0 ||
        zip_file_set_external_attributes(library, zip_uint64_t(at), 0, ZIP_OPSYS_UNIX, 0100644u << 16) != 0)
        throw std::bad_alloc(); // the names are good and differ: nothing else is left that could be wrong
}

std::string contentOf(zip_source_t* source) {
    zip_stat_t stat{};
    if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) throw std::bad_alloc();
    std::string bytes(stat.size, '\0');
    if (zip_source_read(source, bytes.data(), bytes.size()) != zip_int64_t(bytes.size()))
        throw std::bad_alloc();
    zip_source_close(source);
    return bytes;
}

} // namespace

void failZipEntry(std::string_view name, const std::string& what) {
    std::string shown(name.substr(0, 60));
    for (char& c : shown)
        if (c < ' ' || c > '~') c = '?';
    throw ZipFault{"entry \"" + shown + "\": " + what};
}

Result<ZipArchive> ZipArchive::open(std::string_view bytes) {
    assertNotRealtime();
    try {
        const std::vector<ZipRecord> records = readZipDirectory(bytes);
        checkZipNames(records);
        checkZipSizes(records, bytes.size());
        Source source = sourceOf(bytes);
        Handle handle(zip_open_from_source(source.get(), ZIP_RDONLY, nullptr), &zip_discard);
        if (!handle) throw ZipFault{"is a zip archive that cannot be read"};
        source.release(); // the library's now
        ZipArchive archive(std::move(handle));
        for (std::size_t place = 0; place < records.size(); ++place) {
            expectSame(archive.handle_.get(), place, records[place]);
            if (records[place].isFolder()) continue;
            archive.names_.emplace_back(records[place].name);
            archive.places_.push_back(place);
            archive.sizes_.push_back(records[place].size);
        }
        return archive;
    } catch (const ZipFault& fault) {
        return inputError(fault.text + kRemedy);
    }
}

Result<std::string> ZipArchive::read(std::size_t index) const {
    assertNotRealtime();
    try {
        const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> file(
            zip_fopen_index(handle_.get(), places_[index], 0), &zip_fclose);
        return unpacked(file.get(), names_[index], sizes_[index]);
    } catch (const ZipFault& fault) {
        return inputError(fault.text + kRemedy);
    }
}

Result<std::vector<ZipEntry>> readZip(std::string_view bytes) {
    const auto archive = ZipArchive::open(bytes);
    if (!archive) return tl::unexpected(archive.error());
    std::vector<ZipEntry> entries;
    for (std::size_t i = 0; i < archive->names().size(); ++i) {
        auto content = archive->read(i);
        if (!content) return tl::unexpected(content.error());
        entries.push_back({archive->names()[i], std::move(*content)});
    }
    return entries;
}

std::string writeZip(std::span<const ZipEntry> entries) {
    assertNotRealtime();
    if (entries.empty()) return "PK\5\6" + std::string(18, '\0'); // the library makes no archive of nothing
    Source result = sourceOf({});
    std::unique_ptr<zip, decltype(&zip_discard)> library(
        zip_open_from_source(result.get(), ZIP_TRUNCATE, nullptr), &zip_discard);
    if (!library) throw std::bad_alloc();
    zip_source_keep(result.get()); // for us, beside the library
    for (const ZipEntry& entry : entries)
        addEntry(library.get(), entry);
    if (zip_close(library.get()) != 0) throw std::bad_alloc();
    library.release();
    return contentOf(result.get());
}

Result<std::string> fileInZip(std::string_view zip, const std::string& name, std::size_t most) {
    assertNotRealtime();
    try {
        Source source = sourceOf(zip);
        const std::unique_ptr<zip_t, decltype(&zip_discard)> library(
            zip_open_from_source(source.get(), ZIP_RDONLY, nullptr), &zip_discard);
        if (!library) throw ZipFault{"is no zip archive, or one that was cut off"};
        source.release(); // the library's now
        const zip_int64_t place = zip_name_locate(library.get(), name.c_str(), ZIP_FL_NOCASE);
        zip_stat_t stat{};
        if (place < 0 || zip_stat_index(library.get(), zip_uint64_t(place), 0, &stat) != 0)
            failZipEntry(name, "is not there");
        if (stat.size > most) failZipEntry(name, "is larger than " + std::to_string(most) + " bytes");
        const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> file(
            zip_fopen_index(library.get(), zip_uint64_t(place), 0), &zip_fclose);
        return unpacked(file.get(), name, stat.size);
    } catch (const ZipFault& fault) {
        return inputError(fault.text + kRemedy);
    }
}

} // namespace tactum
