// What the import process gives up before it looks at the file. For this folder only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactum {

/// From here on this process can read `file` and what its format may name beside it or up to three folders
/// below (endingsBeside()), use memory and processor, and speak through what
/// is open already: nothing else, for good. Returns the protections that this machine does not have. To be
/// called while there is only one thread.
std::vector<std::string> enterSandbox(const std::filesystem::path& file);

} // namespace tactum
