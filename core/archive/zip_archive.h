// Several files in one: zip archives in memory, read with distrust and written the same way every time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

struct zip; // of libzip

namespace tactum {

/// What an archive may hold at most. A bomb: more than kZipCalm bytes and kZipRatio times the archive's own.
constexpr std::size_t kZipEntries = 4096;
constexpr std::size_t kZipEntryBytes = std::size_t(1) << 30, kZipBytes = std::size_t(2) << 30;
constexpr std::size_t kZipCalm = std::size_t(256) << 20, kZipRatio = 100;

struct ZipEntry {
    std::string name; ///< with / between folders; isZipName() holds
    std::string bytes;
    bool operator==(const ZipEntry&) const = default;
};

/// Whether an entry may be called so: letters and digits of ASCII, space and . _ / -, at most 240 of them;
/// below its folder wherever that is, so neither absolute nor with a part that is empty, "." or "..".
bool isZipName(std::string_view name);

/// An archive of which nothing is unpacked yet. Thread: any but real time, one at a time.
class ZipArchive {
public:
    /// Holds everything that the archive says about itself against the rules (docs/decisions/bundle.md);
    /// `bytes` has to outlive the archive. Errors: one line, which names the entry but not the file.
    static Result<ZipArchive> open(std::string_view bytes);

    /// In their order in the archive; folders are left out.
    const std::vector<std::string>& names() const { return names_; }
    /// The bytes of names()[index]. Errors: what is packed is damaged, longer or shorter than the archive
    /// says, or an archive itself. Never takes more memory than twice what the archive says, whatever comes
    /// out.
    Result<std::string> read(std::size_t index) const;

private:
    using Handle = std::unique_ptr<zip, void (*)(zip*)>;
    explicit ZipArchive(Handle handle) : handle_(std::move(handle)) {}

    Handle handle_;
    std::vector<std::string> names_;
    std::vector<std::size_t> places_, sizes_; ///< of names_: in the archive's directory, and unpacked
};

/// All of it. Thread: any but real time.
Result<std::vector<ZipEntry>> readZip(std::string_view bytes);

/// The same entries give the same bytes: in their order, with fixed times and attributes, deflated unless
/// they are compressed pictures already. The entries have to keep the rules of reading, which is for the
/// caller to see to. Thread: any but real time. Throws std::bad_alloc.
std::string writeZip(std::span<const ZipEntry> entries);

/// One file of a zip of any program, which our own rules need not hold for; capitals of its name do not
/// matter. Errors: one line; there is none of that name, it is longer than `most`, or damaged. Throws
/// std::bad_alloc.
Result<std::string> fileInZip(std::string_view zip, const std::string& name, std::size_t most);

} // namespace tactum
