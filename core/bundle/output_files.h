// The files that one export writes: the result, and what lies beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace tactum {

/// Where an export goes, and what it must leave alone.
struct OutputPlaces {
    std::filesystem::path out;                  ///< that was asked for
    std::vector<std::filesystem::path> inputs;  ///< that the scene came from, with all that they name
    std::vector<std::filesystem::path> outputs; ///< other results of the same work
};

struct OutFile {
    std::filesystem::path path;
    std::string bytes;
};

/// Nothing, or the output that is also an input or an earlier output; a result that replaced one of them
/// would be work lost. "-" among inputs is standard input, which is no file.
std::optional<std::filesystem::path> clashOf(const std::vector<std::filesystem::path>& inputs,
                                             const std::vector<std::filesystem::path>& outputs);
/// What a person is told of a clash.
inline constexpr const char* kClash = "is also an input or another output; give each its own file";

/// All of them or none: when one cannot be written, what was there before is there again. The last one is the
/// one that was asked for, so that it is there only when all others are. None is written when one would
/// replace an input, what an input reads beside itself, another output, or what was there beside the result
/// and is not of it. Thread: any but real time.
Result<void> writeAll(const OutputPlaces& places, const std::vector<OutFile>& files);

} // namespace tactum
