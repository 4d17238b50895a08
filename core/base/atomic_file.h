// A file that is written whole or not at all, whatever happens meanwhile.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// How many of its last versions a file keeps beside it, unless somebody says otherwise.
inline constexpr int kBackups = 3;

/// Where the file's `age`-th last version is kept, 1 the newest: scene.glb1 beside scene.glb, as Blender
/// does.
std::filesystem::path backupOf(const std::filesystem::path& file, int age);

/// Makes `file` hold these bytes. At every moment, also after a crash, a full disk or a power cut, it is
/// either as it was or as it shall be; after success it outlives a power cut. The last `backups` versions
/// stay beside it. A link is followed: the file that it leads to is replaced, which keeps its permissions
/// and, where this is allowed, its owner. Other hard links of it keep the old version. Errors: one line with
/// the path and the reason, for a folder, a device or pipe, and a file nobody may write as well. Then nothing
/// is left behind, and the file is as it was, but for one: the line that begins with "was written" tells that
/// it may not outlive a power cut. Thread: any but real time.
Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view bytes,
                                 int backups = kBackups);

} // namespace tactum
