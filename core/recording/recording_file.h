// A recording as a file: a header to be read by people and programs, and the rows as they lie in memory.
//
//   "TACTUMRC"  version, length of the header: 4 bytes each   JSON header
//   scenes      rows of the proxy    rows of the servo    states of the proxy    states of the servo
//   the same four of each further hand
//   fingerprint of everything before: 8 bytes
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/runtime/recorded_run.h"

namespace tactum {

/// Without dot.
inline constexpr std::string_view kRecordingEnding = "tactum-recording";

struct Recording {
    RecordedRun run;
    std::string reason;                         ///< why it was saved, a sentence for the person
    std::vector<std::filesystem::path> sources; ///< files that the scenes came from; may be empty
};

/// The whole file. Scenes of up to 200 000 triangles, and those without sources, are in it; of larger ones
/// only fingerprints, by which the geometry is found again in the sources.
/// Thread: any but real time; some hundred milliseconds for a minute.
std::string recordingBytes(const Recording& recording);

/// Errors: one line with the place and what to do. Nothing in a file is trusted: every length is held against
/// the bytes that are left before memory is asked for. Thread: any but real time.
Result<Recording> parseRecording(std::string_view bytes, const std::filesystem::path& file);
Result<Recording> readRecording(const std::filesystem::path& file);

/// Makes the fingerprint at the end fit, for tests that change bytes on purpose.
void sealRecording(std::string& bytes);

} // namespace tactum
