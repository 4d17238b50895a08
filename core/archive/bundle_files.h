// The files of a bundle and its manifest: what each one is called, how long it is, and its fingerprint.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/zip_archive.h"

namespace tactum {

/// What the files of a bundle are called.
namespace bundle_name {
inline constexpr const char* kManifest = "manifest.json";
inline constexpr const char* kScene = "scene.glb";
inline constexpr const char* kX3d = "scene.x3d";
inline constexpr const char* kDevice = "deviceinfo.x3d";
inline constexpr const char* kFinger = "finger.csv"; ///< t,x,y,z: s and m
inline constexpr const char* kForces = "forces.csv"; ///< s, m and N: what it must feel then
inline constexpr const char* kPreview = "preview.png";
inline constexpr const char* kReport = "report.md";
inline constexpr const char* kReadme = "README.md";
} // namespace bundle_name

/// The zip of these files with a manifest before them. The same files give the same bytes. Thread: any but
/// real time.
std::string packBundle(std::span<const ZipEntry> files);

/// The version of a bundle that a later program wrote; none for ours, and for what is no bundle. Unpacks the
/// manifest alone. Thread: any but real time.
std::optional<std::string> laterBundle(std::string_view zip);

/// A bundle whose files are all as its manifest says.
class BundleFiles {
public:
    /// Unpacks all of it. Errors: one line, without the name of the zip: not a zip that readZip() takes, no
    /// manifest, one of a later major version, a file that is missing, changed or not in the manifest.
    static Result<BundleFiles> open(std::string_view zip);

    /// Empty when there is none of that name.
    std::string_view file(std::string_view name) const;
    std::span<const ZipEntry> all() const { return files_; }

private:
    std::vector<ZipEntry> files_;
};

} // namespace tactum
