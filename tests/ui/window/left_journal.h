// What a run that ended without saving has left.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/process_mark.h"
#include "core/files/journal.h"
#include "ui/document/journal.h"

namespace tactum {

/// Its folder; `edited`: seconds since 1970.
inline std::filesystem::path leaveJournal(const Scene& scene, const std::string& title, std::int64_t edited) {
    static std::uint64_t count = 0;
    ProcessMark dead = ownMark();
    dead.began = ++count; // nobody's any more
    const std::filesystem::path folder = Journal::home() / (nameOf(dead) + "_0");
    if (!writeJournal(folder, {.file = "/nowhere/" + title, .title = title, .edited = edited}, scene))
        qFatal("the journal cannot be written");
    return folder;
}

} // namespace tactum
