// The files that one conversion writes: the result, and what lies beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands.h"

namespace tactum {

struct OutFile {
    std::filesystem::path path;
    std::string bytes;
};

/// All of them or none: when one cannot be written, what was there before is there again. The last one is the
/// one that was asked for, so that it is there only when all others are. None is written when one would
/// replace an input, what an input reads beside itself, another output, or what was there beside the result
/// and is not of it.
Result<void> writeAll(const ConvertOptions& options, const std::vector<OutFile>& files);

} // namespace tactum
