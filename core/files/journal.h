// The recovery journal of a scene that is being edited: a folder that holds it whole at every moment.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

/// What is known of a scene in a journal besides the scene itself.
struct JournalEntry {
    std::filesystem::path file;   ///< that it came from; may be empty
    std::int64_t fileWritten = 0; ///< when that one was written, in ticks of file_time_type
    std::uint64_t fileBytes = 0;  ///< how long it was then
    bool own = false;             ///< it may be written over
    std::string title;            ///< what the window called it
    std::int64_t edited = 0;      ///< until when its edits are in here, s since 1970

    bool operator==(const JournalEntry&) const = default;
};

/// What can be undone and done again about a scene.
struct SceneHistory {
    struct Step {
        std::string text; ///< names it
        Scene scene;      ///< of a done one as it was before, of an undone one as it is after it
    };
    std::vector<Step> done, undone; ///< the one that is next to the present is the last of each

    std::size_t size() const { return done.size() + undone.size(); }
};

/// Makes the journal hold this scene, and of its history the steps next to the present: as many as fit into
/// 16 MiB besides the meshes and images of the scene itself. Whatever happens meanwhile it holds the one from
/// before or this one, whole. Meshes and images are written again only when they are others than before. The
/// folder is made when it is not there. Errors: one line; the journal is then as it was. Thread: any but real
/// time, one at a time for a folder.
Result<void> writeJournal(const std::filesystem::path& folder, const JournalEntry& entry, const Scene& scene,
                          const SceneHistory& history = {}, const Progress& progress = {});

/// Errors: one line with the folder; damaged journals are of the kind Input. Thread: any but real time.
Result<JournalEntry> readJournalEntry(const std::filesystem::path& folder);

/// Puts the scene of the journal together as the file of a scene, in the same folder, and gives it back.
/// Every byte of it is one that was written. Errors as above. Thread: any but real time.
Result<std::filesystem::path> unpackJournal(const std::filesystem::path& folder);

/// The history of `scene`, which was read from what unpackJournal() gave; it shares meshes and images with
/// it. Errors as above. Thread: any but real time.
Result<SceneHistory> readJournalHistory(const std::filesystem::path& folder, const Scene& scene);

/// Whether there is one, damaged or not: the first write to a folder may not have ended.
bool holdsJournal(const std::filesystem::path& folder);
/// The whole folder. Who is killed meanwhile leaves a journal that is whole, or none.
void removeJournal(const std::filesystem::path& folder);

/// A sign of life: see process_mark.h. Thread: any but real time.
void touchJournal(const std::filesystem::path& folder);
std::filesystem::file_time_type lastSignOf(const std::filesystem::path& folder);

} // namespace tactum
