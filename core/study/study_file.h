// Studies as files: a zip of study.json and a scene for each condition. docs/guide/studies.md says it in
// words.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/study/design.h"

namespace tactum {

/// The end of a study's file name, without the dot.
inline constexpr std::string_view kStudyEnding = "tactum-study";
/// Of the format. Another major number is another format, a higher minor one has members that we do not know.
inline constexpr int kStudyMajor = 1, kStudyMinor = 1;

/// A design with what its conditions are.
struct Study {
    StudyDesign design;
    std::vector<Scene> conditions; ///< as many as design.conditions
};

/// Errors: one line that names the file, the place in it and the remedy. Thread: any but real time; the
/// scenes are read in processes of their own.
Result<Study> readStudy(const std::filesystem::path& file, const Progress& progress = {});
/// Writes it whole or not at all. A study that check() refuses is written as well: it may be unfinished.
/// Errors: one line with the path. Thread: any but real time.
Result<void> writeStudy(const Study& study, const std::filesystem::path& file, const Progress& progress = {});

/// The design as its file has it, and back; `where` stands for the file in errors. What check() refuses is
/// read: who edits it can mend it.
std::string designText(const StudyDesign& design);
Result<StudyDesign> parseDesign(std::string_view text, const std::filesystem::path& where);

} // namespace tactum
