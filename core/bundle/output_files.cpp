#include "core/bundle/output_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include <unistd.h>

#include "core/base/atomic_file.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> usageError(const fs::path& file, const std::string& sentence) {
    return tl::unexpected<Error>(Error{Error::Kind::Usage, file.string() + ": " + sentence});
}

bool isOfName(char c) {
    return std::isalnum(std::uint8_t(c)) || std::uint8_t(c) >= 0x80 ||
           std::string_view("_-.~").find(c) != std::string_view::npos;
}

/// Whether the text of a file has this word between characters that are none of a name; a full stop may
/// follow.
bool hasWord(const fs::path& file, const std::string& word) {
    std::ifstream in(file, std::ios::binary);
    std::string text(1, '\n'); // what is before the file
    std::string block(1 << 20, '\0');
    while (in) {
        in.read(block.data(), std::streamsize(block.size()));
        text.append(block, 0, std::size_t(in.gcount()));
        if (!in) text += "\n\n";
        for (std::size_t at = text.find(word, 1); at != std::string::npos; at = text.find(word, at + 1)) {
            const std::size_t end = at + word.size();
            if (end + 1 < text.size() && !isOfName(text[at - 1]) &&
                !isOfName(text[text[end] == '.' ? end + 1 : end]))
                return true;
        }
        text.erase(0, text.size() - std::min(text.size(), word.size() + 2));
    }
    return false;
}

/// Whether a file is one that the input reads beside itself, a material library or a picture. No reader tells
/// what it opened; the input has to name it.
bool isNamedBy(const fs::path& input, const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) || !fs::is_regular_file(input, fault)) return false;
    const fs::path folder = fs::canonical(input.has_parent_path() ? input.parent_path() : ".", fault);
    if (fault) return false;
    const std::string name = fs::weakly_canonical(file, fault).lexically_relative(folder).generic_string();
    return !fault && !name.empty() && !name.starts_with("..") && hasWord(input, name); // readers stay inside
}

bool holds(const fs::path& file, const std::string& bytes) {
    std::error_code fault;
    if (fs::file_size(file, fault) != bytes.size() || fault) return false;
    std::ifstream in(file, std::ios::binary);
    return std::equal(bytes.begin(), bytes.end(), std::istreambuf_iterator<char>(in));
}

/// Whether it is there already and is neither what an earlier result of this name has beside it nor the same.
bool isStrangers(const fs::path& result, const OutFile& file) {
    std::error_code fault;
    return file.path != result && fs::exists(file.path, fault) && !isNamedBy(result, file.path) &&
           !holds(file.path, file.bytes);
}

/// Where a name leads. A pipe has none: it is called as the person calls it.
fs::path placeOf(const fs::path& name) {
    std::error_code fault;
    const auto place = fs::weakly_canonical(name, fault);
    return fault ? name : place;
}

/// Before anything is written: files that were not asked for by name must not cost what was there either.
Result<void> checkFiles(const OutputPlaces& places, const std::vector<OutFile>& files) {
    std::vector<fs::path> outputs = places.outputs;
    for (const OutFile& file : files)
        outputs.push_back(file.path);
    if (const auto clash = clashOf(places.inputs, outputs))
        return usageError(*clash, "would be written beside the result, and " + std::string(kClash));
    for (const fs::path& input : places.inputs)
        for (const OutFile& file : files)
            if (file.path != places.out && isNamedBy(input, file.path))
                return usageError(file.path,
                                  "belongs to " + input.string() +
                                      " and would be replaced; choose another name for the result");
    for (const OutFile& file : files)
        if (isStrangers(places.out, file))
            return usageError(file.path, "is there already, and would be replaced by what lies beside " +
                                             places.out.filename().string() +
                                             "; move it away, or choose another name for the result");
    return {};
}

/// What stood in the places of an export, to be put back when one of its files cannot be written.
class OldFiles {
public:
    OldFiles() = default;
    OldFiles(const OldFiles&) = delete;
    OldFiles& operator=(const OldFiles&) = delete;
    ~OldFiles() {
        std::error_code fault;
        for (auto old = olds_.rbegin(); old != olds_.rend(); ++old) {
            if (old->keep.empty())
                fs::remove(old->place, fault);
            else if (fs::rename(old->keep, old->place, fault); !fault)
                fs::remove(old->keep, fault); // which stays where both still name the same file
        }
        for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder)
            fs::remove(*folder, fault); // only when nothing is in it
    }

    void willMake(const fs::path& folder) {
        std::error_code fault;
        if (fs::create_directory(folder, fault)) folders_.push_back(folder);
    }
    /// A second name for what is there, which needs no space; a copy where the disk knows no second names.
    Result<void> willReplace(const fs::path& file) {
        std::error_code fault;
        if (fs::is_directory(file, fault)) return {}; // whoever writes it says why not
        const bool isThere = fs::exists(file, fault);
        Old old{isThere ? fs::canonical(file, fault) : file, {}};
        if (isThere) {
            old.keep = old.place.parent_path() /
                       (".tactum-old-" + std::to_string(getpid()) + "-" + std::to_string(olds_.size()));
            fs::remove(old.keep, fault);
            fs::create_hard_link(old.place, old.keep, fault);
            if (fault) fs::copy_file(old.place, old.keep, fault);
            if (fault)
                return machineError(file.string() + ": cannot be kept while the export is written (" +
                                    fault.message() + "); check the folder and the free space");
        }
        olds_.push_back(std::move(old));
        return {};
    }
    /// Everything is written.
    void forget() {
        std::error_code fault;
        for (const Old& old : olds_)
            if (!old.keep.empty()) fs::remove(old.keep, fault);
        olds_.clear();
        folders_.clear();
    }

private:
    struct Old {
        fs::path place, keep; ///< `keep` is empty when nothing was there
    };
    std::vector<Old> olds_;
    std::vector<fs::path> folders_;
};

} // namespace

std::optional<fs::path> clashOf(const std::vector<fs::path>& inputs, const std::vector<fs::path>& outputs) {
    std::vector<fs::path> taken;
    for (const auto& input : inputs)
        if (input != "-") taken.push_back(placeOf(input));
    for (const auto& output : outputs) {
        const auto file = placeOf(output);
        if (std::ranges::find(taken, file) != taken.end() && !fs::is_character_file(file)) return output;
        taken.push_back(file);
    }
    return std::nullopt;
}

Result<void> writeAll(const OutputPlaces& places, const std::vector<OutFile>& files) {
    if (const auto apart = checkFiles(places, files); !apart) return apart;
    OldFiles olds;
    for (const OutFile& file : files) {
        if (file.path.has_parent_path()) olds.willMake(file.path.parent_path());
        if (const auto kept = olds.willReplace(file.path); !kept) return kept;
        if (const auto written = writeFileAtomically(file.path, file.bytes, 0); !written) return written;
    }
    olds.forget();
    return {};
}

} // namespace tactum
