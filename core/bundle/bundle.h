// A scene as one file for others: for every target its form, with the proof of what it must feel like.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/finger_path.h"
#include "core/scene/scene.h"

namespace tactum {

/// The endings of bundles, without dot: their own, which desktops know them by, and that of what they are.
inline constexpr const char* kBundleEnding = "tactum";
inline constexpr const char* kBundleZipEnding = "zip";

/// The bytes of a bundle (docs/format.md): scene.glb, scene.x3d with its images and deviceinfo.x3d, a finger
/// path and what it must feel, preview.png, report.md, a README, and a manifest. The same scene gives the
/// same bytes. Errors: cancelled, a scene that cannot be touched or written. Thread: any but real time.
Result<std::string> bundleOf(const Scene& scene, const Progress& progress = {});

struct MadeBundle {
    std::string bytes;
    bool touches = false; ///< its finger path meets anything at all
};
/// The same, with what whoever exports it should know.
Result<MadeBundle> makeBundle(const Scene& scene, const Progress& progress = {});

/// The same, written whole or not at all; the last `backups` versions stay beside it, three if nothing else
/// is said. A bundle of a later major version, or one whose scene is of one, is not replaced: what this
/// version does not know would be lost.
Result<void> saveBundle(const Scene& scene, const std::filesystem::path& file, const Progress& progress = {});
Result<void> saveBundle(const Scene& scene, const std::filesystem::path& file, const Progress& progress,
                        int backups);
/// The same; tells whether the finger path of the bundle touches anything.
Result<bool> saveTouchedBundle(const Scene& scene, const std::filesystem::path& file,
                               const Progress& progress, int backups);

/// What a bundle is opened for when somebody wants to know whether a renderer feels as it should.
struct Bundle {
    Scene scene;
    std::vector<FingerPoint> finger; ///< the path
    std::vector<Vec3>
        forces; ///< N, world frame: what each of its points must feel, before any device's limit
};

/// Opens a bundle in this process; importScene() is for files nobody trusts. Errors: one line with the path.
/// Thread: any but real time.
Result<Bundle> openBundle(const std::filesystem::path& file);
/// The rest of a bundle whose scene importScene() has read. Errors and thread: likewise.
Result<Bundle> openBundle(const std::filesystem::path& file, Scene scene);

} // namespace tactum
