// Reads sources and build files and says where they leave the plan of the house.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tactum::architecture {

/// A source file; `path` from the root of the repository, with slashes: "core/base/vec.h".
struct SourceFile {
    std::string path;
    std::string text;
};

/// One sentence for each fault: file, what is wrong, what to do.
using Faults = std::vector<std::string>;

/// Every .h and .cpp under app, core, device and ui, sorted by path.
std::vector<SourceFile> readSources(const std::filesystem::path& root);

/// Every CMakeLists.txt under them.
std::vector<SourceFile> readBuildFiles(const std::filesystem::path& root);

/// What stands between the quotes or brackets of every #include, in order.
std::vector<std::string> includesOf(std::string_view text);

/// The room that a file lies in; empty when it lies in none.
std::string_view roomOf(std::string_view path);

/// Includes of other rooms that no arrow allows, and of libraries out of their place.
Faults wrongIncludes(const SourceFile& file);

/// Rooms that the USES of a tactum_room() in a CMakeLists.txt names without an arrow.
Faults wrongLinks(const SourceFile& cmakeLists);

/// Headers without #pragma once, files without a comment in their first line, core headers with <iostream>.
Faults formFaults(const SourceFile& file);

/// Whether some sentence of it says "Thread: ... real time", and not "any but real time".
bool isMarkedRealtime(const SourceFile& file);

/// What runs in real time, in the order of `files`: whatever is marked so or opens a RealtimeScope, the
/// source of each header that is marked, and so on through all that these include, whose own headers may be
/// unmarked.
std::vector<SourceFile> realtimeSources(const std::vector<SourceFile>& files);

/// What a file that runs in real time must not include.
Faults realtimeFaults(const SourceFile& file);

/// A ring of headers that include each other, named in order; empty when there is none.
Faults includeRings(const std::vector<SourceFile>& files);

/// A ring in the plan itself.
Faults roomRings();

} // namespace tactum::architecture
