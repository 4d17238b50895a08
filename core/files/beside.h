// Which files a reader opens beside the one that it is given: what the import process may see of a folder.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace tactum {

/// The endings, in lower case and without dot, of what the reader of this file may open in its folder. Empty
/// for formats that hold everything themselves. Thread: any but real time.
std::vector<std::string_view> endingsBeside(const std::filesystem::path& file);

} // namespace tactum
