// The report of a scene as a file: HTML, or the same on pages of PDF.
#pragma once

#include <filesystem>

#include "core/report/scene_report.h"

namespace tactum {

/// Written whole or not at all, in place of what was there. Needs a QGuiApplication, on any platform, for
/// PDF. Errors: those of sceneReport(), another ending, a file that cannot be written. Thread: any but real
/// time.
Result<void> writeReportFile(const ReportSubject& subject, const std::filesystem::path& file,
                             const Progress& progress = {});

} // namespace tactum
