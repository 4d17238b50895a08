// A scene on one page: what it looks like, how it feels and why, what is wrong with it, and what a stroke
// gives.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/presets/preset.h"
#include "core/scene/findings.h"
#include "core/scene/scene.h"

namespace tactum {

/// The device that the scene is felt with. 0: not known.
struct ReportDevice {
    std::string name;
    double maxForce = 0;         ///< N
    double maxStiffness = 0;     ///< N/m at 1 kHz, the maker's figure
    double stiffnessCeiling = 0; ///< N/m, what the guard lets through now
};

/// Of the scene as somebody sees it. Without any it is drawn as previewOf() does.
struct ReportPicture {
    std::string png;
    int width = 0, height = 0; ///< pixels
};

struct ReportSubject {
    const Scene& scene;
    std::string name;                  ///< of its file
    std::string fingerprint;           ///< SHA-256 of its file; empty: it is not saved as it is
    std::string version;               ///< of the program
    std::string date;                  ///< see reportDate()
    std::span<const Finding> found{};  ///< by who read the file
    std::span<const Preset> presets{}; ///< whose sources are told where a surface has their values
    std::optional<ReportDevice> device{};
    ReportPicture picture{};
};

/// The endings of reports as files.
inline constexpr const char *kHtmlEnding = ".html", *kPdfEnding = ".pdf";
/// Error for a file of another ending.
Result<void> checkReportFile(const std::filesystem::path& file);
/// "2026-11-26 17:05 UTC": the moment that SOURCE_DATE_EPOCH says, else now.
std::string reportDate();

/// One page of HTML with everything in it: no scripts, and nothing from elsewhere. Tables have headers,
/// pictures say what they show. The same subject gives the same bytes. Errors: cancelled, a scene that cannot
/// be touched. Thread: any but real time.
Result<std::string> sceneReport(const ReportSubject& subject, const Progress& progress = {});

} // namespace tactum
