#include "core/files/journal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <new>
#include <set>
#include <sstream>
#include <vector>

#include "core/archive/sha256.h"
#include "core/base/atomic_file.h"
#include "core/base/byte_stream.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/source.h"
#include "core/scene/scene_bytes.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

// A glb is a header, a chunk of JSON with all numbers, and a chunk of meshes and images. The journal keeps
// the header and the JSON in one file, and the rest in blocks, each a file named by its fingerprint: an edit
// of a number writes kilobytes, and the last block, where small pictures of a material for other programs
// are. Who replaces the first file has changed the journal, so that is done last.
constexpr std::string_view kMagic = "tactum journal 4\n";
// Of earlier versions, as long: without steps, and with steps of another form.
constexpr std::string_view kWithoutHistory = "tactum journal 1\n";
constexpr std::array<std::string_view, 2> kOtherSteps{"tactum journal 2\n", "tactum journal 3\n"};
constexpr const char *kNumbers = "journal", *kUnpacked = "scene.glb";
constexpr std::string_view kShapes = "shapes-";
constexpr std::size_t kBlock = std::size_t(4) << 20;
constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;
constexpr std::uint64_t kMax = std::uint64_t(4) << 30; // what a glb can hold

/// Of a block: tells it from every other one that chance or a bad disk could put in its place.
struct Print {
    std::uint64_t bytes = 0, low = 0xcbf29ce484222325u, high = 0x9e3779b97f4a7c15u;

    explicit Print(std::string_view text) : bytes(text.size()) {
        for (; text.size() >= 8; text.remove_prefix(8))
            mix(text.substr(0, 8));
        mix(text);
    }
    Print() = default;
    bool operator==(const Print&) const = default;
    std::string name() const {
        std::string digits;
        for (const std::uint64_t part : {low, high})
            for (int shift = 60; shift >= 0; shift -= 4)
                digits += "0123456789abcdef"[part >> shift & 15];
        return std::string(kShapes) + digits;
    }

private:
    /// Each step can be undone, so two blocks that differ in one word never have one print.
    void mix(std::string_view part) {
        std::uint64_t word = 0;
        std::memcpy(&word, part.data(), part.size());
        low = std::rotl((low ^ word) * 0x100000001b3u, 29);
        high = std::rotl((high ^ word) * 0xff51afd7ed558ccdu, 31);
    }
};

struct Journal {
    JournalEntry entry;
    std::vector<Print> blocks;
    std::string numbers; ///< the beginning of the glb
    std::string history; ///< see historyOf()
};

template <class Io> void fields(Io& io, Journal& journal) {
    JournalEntry& entry = journal.entry;
    std::string file = entry.file.native();
    io(file), io(entry.fileWritten), io(entry.fileBytes), io(entry.own), io(entry.title), io(entry.edited);
    entry.file = file;
    io.count(journal.blocks, sizeof(Print));
    for (Print& each : journal.blocks)
        io(each.bytes), io(each.low), io(each.high);
    io(journal.numbers);
}

/// What its scenes have in common.
struct HistoryTables {
    SceneTables shared;
    std::vector<SceneObject> objects;
};

/// A scene as a row of numbers: an object that is as it was in the scene before is the same one.
template <class Io>
void stateBytes(Io& io, Scene& scene, HistoryTables& tables, std::vector<std::uint32_t>& before) {
    Scene bare = scene;
    bare.objects.clear();
    sceneBytes(io, bare, tables.shared);
    std::vector<std::uint32_t> numbers(scene.objects.size());
    if constexpr (!Io::kReads)
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const bool same = i < before.size() && tables.objects[before[i]] == scene.objects[i];
            numbers[i] = same ? before[i] : std::uint32_t(tables.objects.size());
            if (!same) tables.objects.push_back(scene.objects[i]);
        }
    io.bulk(numbers);
    if constexpr (Io::kReads) {
        scene = std::move(bare);
        for (const std::uint32_t number : numbers) {
            io.demand(number < tables.objects.size(), "a step names an object that there is not");
            scene.objects.push_back(tables.objects[number]);
        }
    }
    before = std::move(numbers);
}

template <class Io> void historyBytes(Io& io, SceneHistory& history, HistoryTables& tables) {
    std::vector<std::uint32_t> before;
    for (auto* steps : {&history.done, &history.undone}) {
        io.count(*steps, 16);
        for (SceneHistory::Step& step : *steps)
            io(step.text), stateBytes(io, step.scene, tables, before);
    }
}

/// What is in the scene itself is only named.
std::string bytesOf(SceneHistory history, const KnownParts& elsewhere) {
    HistoryTables tables;
    StringOut states, objects, shapes;
    historyBytes(states, history, tables);
    objects.count(tables.objects, 64);
    for (SceneObject& each : tables.objects)
        objectBytes(objects, each, tables.shared), authorBytes(objects, each);
    writeTables(shapes, tables.shared, elsewhere);
    return shapes.bytes + objects.bytes + states.bytes;
}

SceneHistory readHistory(ByteIn& in, const Scene& scene) {
    HistoryTables tables;
    readTables(in, tables.shared, {[&] { return KnownParts(scene); }});
    in.count(tables.objects, 64);
    for (SceneObject& each : tables.objects)
        objectBytes(in, each, tables.shared), authorBytes(in, each);
    SceneHistory history;
    historyBytes(in, history, tables);
    return history;
}

/// The steps next to the present that fit.
std::string historyOf(const Scene& scene, SceneHistory history) {
    constexpr std::size_t kMostBytes = std::size_t(16) << 20;
    const KnownParts elsewhere(history.size() > 0 ? scene : Scene());
    while (history.size() > 0) {
        std::string bytes = bytesOf(history, elsewhere);
        if (bytes.size() <= kMostBytes) return bytes;
        for (auto* steps : {&history.done, &history.undone})
            steps->erase(steps->begin(), steps->begin() + std::ptrdiff_t(steps->size() + 1) / 2);
    }
    return {};
}

std::string bytesOf(Journal journal) {
    StringOut out;
    fields(out, journal);
    out(journal.history);
    return std::string(kMagic) + sha256(out.bytes) + out.bytes;
}

/// Where the meshes and images of a glb begin. How long all of them are stands before them.
std::size_t endOfNumbers(std::string_view glb) {
    std::uint32_t json = 0;
    std::memcpy(&json, glb.data() + kGlbHeader, sizeof json);
    return std::min(glb.size(), kGlbHeader + kChunkHeader + json + kChunkHeader);
}

tl::unexpected<Error> damaged(const fs::path& folder, const std::string& what) {
    return inputError(shownPath(folder) + ": the journal is damaged: " + what);
}

Result<std::string> contentOf(const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) || fs::file_size(file, fault) > kMax)
        return damaged(file.parent_path(), file.filename().string() + " is missing");
    std::ostringstream bytes;
    std::ifstream in(file, std::ios::binary);
    if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
    if (!in || !bytes) return machineError(shownPath(file) + ": cannot be read; check the disk");
    return std::move(bytes).str();
}

Result<Journal> readStamp(const fs::path& folder) {
    const auto bytes = contentOf(folder / kNumbers);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    constexpr std::size_t kPrint = 64;
    const std::string_view all = *bytes;
    const bool isOld = all.starts_with(kWithoutHistory);
    const bool otherSteps =
        std::ranges::any_of(kOtherSteps, [&](std::string_view magic) { return all.starts_with(magic); });
    if (!(all.starts_with(kMagic) || otherSteps || isOld) || all.size() < kMagic.size() + kPrint)
        return damaged(folder, "it does not begin as one");
    const std::string_view rest = all.substr(kMagic.size() + kPrint);
    if (sha256(rest) != all.substr(kMagic.size(), kPrint)) return damaged(folder, "bytes have changed");
    try {
        ByteIn in(rest, "the journal", kMagic.size() + kPrint, "it was kept");
        Journal journal;
        fields(in, journal);
        if (!isOld) in(journal.history);
        if (otherSteps) journal.history.clear();
        return journal;
    } catch (const ByteFault& fault) {
        return damaged(folder, fault.error.text);
    }
}

/// What no journal names any more, and what an interrupted save left.
void tidy(const fs::path& folder, const std::set<std::string>& named) {
    std::error_code fault;
    for (const auto& each : fs::directory_iterator(folder, fault)) {
        const std::string name = each.path().filename();
        const bool isOld = name.starts_with(kShapes) && !named.contains(name);
        if (isOld || name.starts_with(".tactum-") || name == kUnpacked) fs::remove(each.path(), fault);
    }
}

Result<void> replaceJournal(const fs::path& folder, const JournalEntry& entry, std::string_view glb,
                            std::string history) {
    const std::size_t end = endOfNumbers(glb);
    Journal journal{entry, {}, std::string(glb.substr(0, end)), std::move(history)};
    std::set<std::string> named;
    std::error_code fault;
    fs::create_directories(folder, fault); // what is wrong with it the first write says
    for (std::string_view rest = glb.substr(end); !rest.empty();) {
        const std::string_view block = rest.substr(0, kBlock);
        rest.remove_prefix(block.size());
        const Print& print = journal.blocks.emplace_back(block);
        const fs::path file = folder / *named.insert(print.name()).first;
        if (fs::file_size(file, fault) == block.size()) continue; // a file of that name is whole
        if (const auto written = writeFileAtomically(file, block, 0); !written) return written;
    }
    if (const auto written = writeFileAtomically(folder / kNumbers, bytesOf(journal), 0); !written)
        return written;
    tidy(folder, named);
    return {};
}

} // namespace

Result<void> writeJournal(const fs::path& folder, const JournalEntry& entry, const Scene& scene,
                          const SceneHistory& history, const Progress& progress) {
    try {
        const auto glb = glbOf(scene, progress);
        if (!glb) return tl::unexpected<Error>(glb.error());
        if (progress.isCancelled()) return cancelledError();
        return replaceJournal(folder, entry, *glb, historyOf(scene, history));
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(folder) + ": not enough memory for the journal; close other programs");
    }
}

Result<JournalEntry> readJournalEntry(const fs::path& folder) {
    auto journal = readStamp(folder);
    if (!journal) return tl::unexpected<Error>(journal.error());
    return std::move(journal->entry);
}

Result<fs::path> unpackJournal(const fs::path& folder) {
    const auto journal = readStamp(folder);
    if (!journal) return tl::unexpected<Error>(journal.error());
    std::string glb = journal->numbers;
    for (const Print& print : journal->blocks) {
        const auto block = contentOf(folder / print.name());
        if (!block) return tl::unexpected<Error>(block.error());
        if (Print(*block) != print) return damaged(folder, "meshes or images have changed");
        glb += *block;
    }
    const fs::path file = folder / kUnpacked;
    if (const auto written = writeFileAtomically(file, glb, 0); !written)
        return tl::unexpected<Error>(written.error());
    return file;
}

Result<SceneHistory> readJournalHistory(const fs::path& folder, const Scene& scene) {
    const auto journal = readStamp(folder);
    if (!journal) return tl::unexpected<Error>(journal.error());
    if (journal->history.empty()) return SceneHistory();
    try {
        ByteIn in(journal->history, "the history in the journal", 0, "the scene itself can be recovered");
        return readHistory(in, scene);
    } catch (const ByteFault& fault) {
        return damaged(folder, fault.error.text);
    }
}

bool holdsJournal(const fs::path& folder) {
    std::error_code fault;
    return fs::exists(folder / kNumbers, fault);
}

void removeJournal(const fs::path& folder) {
    std::error_code fault; // what cannot be removed is offered again
    fs::remove(folder / kNumbers, fault);
    if (!fault) fs::remove_all(folder, fault);
}

void touchJournal(const fs::path& folder) {
    std::error_code fault; // a journal that is not there needs none
    fs::last_write_time(folder / kNumbers, fs::file_time_type::clock::now(), fault);
}

fs::file_time_type lastSignOf(const fs::path& folder) {
    std::error_code fault;
    const auto written = fs::last_write_time(folder / kNumbers, fault);
    return fault ? fs::last_write_time(folder, fault) : written;
}

} // namespace tactum
