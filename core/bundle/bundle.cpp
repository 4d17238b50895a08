#include "core/bundle/bundle.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <new>

#include "core/archive/bundle_files.h"
#include "core/base/atomic_file.h"
#include "core/base/numbers.h"
#include "core/bundle/bundle_bytes.h"
#include "core/bundle/bundle_readme.h"
#include "core/bundle/forces_csv.h"
#include "core/bundle/preview.h"
#include "core/bundle/sample_stroke.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/load_scene.h"
#include "core/files/loss_report.h"
#include "core/files/read_finger_path.h"
#include "core/files/save_scene.h"
#include "core/files/source.h"
#include "core/files/x3d/write_x3d.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"

namespace tactum {
namespace {

/// How the limit in deviceinfo.x3d, which is no value of the scene, compares with what the path needs.
Loss forceLimitOf(const TouchTrace& rows) {
    const double most = largestForceOf(rows);
    const auto newtons = [](double force) {
        std::string text;
        appendNumber(text, std::round(100 * force) / 100);
        return text + " N";
    };
    const std::string sentence = newtons(kX3dForceLimit) +
                                 " in deviceinfo.x3d, which a light desk device gives for as long as one "
                                 "likes; the finger path needs up to " +
                                 newtons(most);
    if (most <= kX3dForceLimit) return {ExportTarget::X3d, "", "force limit", LossKind::Kept, sentence};
    return {ExportTarget::X3d, "", "force limit", LossKind::Degraded,
            sentence + ": raise forceLimit for a device that can give it"};
}

std::vector<Loss> reportOf(const Scene& scene, const X3dExport& x3d, const TouchTrace& rows) {
    std::vector<Loss> losses;
    for (const ExportTarget target : {ExportTarget::Glb, ExportTarget::Mpeg, ExportTarget::KhrPhysics})
        for (Loss& loss : lossesOf(scene, target))
            losses.push_back(std::move(loss));
    losses.insert(losses.end(), x3d.losses.begin(), x3d.losses.end());
    losses.push_back(forceLimitOf(rows));
    return losses;
}

/// The version of a bundle that a later program wrote, or of its scene; whatever else is there may be
/// replaced.
std::optional<std::string> laterFormatOf(const std::filesystem::path& file) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) return std::nullopt;
    const auto bytes = bundleBytes(file);
    if (!bytes) return std::nullopt;
    if (const auto later = laterBundle(*bytes)) return later;
    const auto files = BundleFiles::open(*bytes);
    return files ? laterSceneFormat(files->file(bundle_name::kScene)) : std::nullopt;
}

} // namespace

Result<std::string> bundleBytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    if (!in.good() && !in.eof()) return machineError(file.string() + ": cannot be read; check its rights");
    return bytes;
}

Result<std::string> bundleOf(const Scene& scene, const Progress& progress) {
    auto made = makeBundle(scene, progress);
    if (!made) return tl::unexpected<Error>(made.error());
    return std::move(made->bytes);
}

Result<MadeBundle> makeBundle(const Scene& scene, const Progress& progress) {
    const auto reached = [&](double part) {
        if (progress.report) progress.report(part);
        return !progress.isCancelled();
    };
    const auto world = compile(scene);
    if (!world) return tl::unexpected<Error>(world.error());
    if (!reached(0.2)) return cancelledError();
    auto glb = glbOf(scene, partOf(progress, 0.2, 0.3));
    if (!glb) return tl::unexpected<Error>(glb.error());
    if (!reached(0.3)) return cancelledError();
    auto written = x3dOf(scene, {}, partOf(progress, 0.3, 0.8)); // its pictures can take most of the time
    if (!written) return tl::unexpected<Error>(written.error());
    X3dExport& x3d = *written;
    const std::vector<FingerPoint> finger = scene.finger ? *scene.finger : sampleStroke(**world);
    const TouchTrace rows = replay(**world, finger);
    std::vector<ZipEntry> files{{bundle_name::kScene, std::move(*glb)},
                                {bundle_name::kFinger, fingerCsv(finger)},
                                {bundle_name::kForces, forcesCsv(rows)},
                                {bundle_name::kPreview, previewOf(scene)},
                                {bundle_name::kReport, reportMarkdown(reportOf(scene, x3d, rows))},
                                {bundle_name::kReadme, bundleReadme(scene, rows)},
                                {bundle_name::kX3d, std::move(x3d.scene)},
                                {bundle_name::kDevice, std::move(x3d.device)}};
    for (X3dImage& image : x3d.images)
        files.push_back({std::move(image.name), std::move(image.bytes)});
    if (!reached(0.9)) return cancelledError();
    return MadeBundle{packBundle(files), touchesAnything(rows)};
}

Result<bool> saveTouchedBundle(const Scene& scene, const std::filesystem::path& file,
                               const Progress& progress, int backups) {
    try {
        if (const auto later = laterFormatOf(file))
            return inputError(shownPath(file) + ": holds a bundle of a later Tactum (version " + *later +
                              " of the format), which would be lost; choose another name");
        const auto bundle = makeBundle(scene, partOf(progress, 0, 0.95));
        if (!bundle) return tl::unexpected<Error>(bundle.error());
        if (progress.isCancelled()) return cancelledError();
        if (const auto written = writeFileAtomically(file, bundle->bytes, backups); !written)
            return tl::unexpected<Error>(written.error());
        return bundle->touches;
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(file) +
                            ": not enough memory to export the scene; close other programs");
    }
}

Result<void> saveBundle(const Scene& scene, const std::filesystem::path& file, const Progress& progress,
                        int backups) {
    const auto saved = saveTouchedBundle(scene, file, progress, backups);
    if (!saved) return tl::unexpected<Error>(saved.error());
    return {};
}

Result<void> saveBundle(const Scene& scene, const std::filesystem::path& file, const Progress& progress) {
    return saveBundle(scene, file, progress, kBackups);
}

Result<Bundle> openBundle(const std::filesystem::path& file) {
    auto loaded = loadScene(file);
    if (!loaded) return tl::unexpected<Error>(loaded.error());
    return openBundle(file, std::move(loaded->scene));
}

Result<Bundle> openBundle(const std::filesystem::path& file, Scene scene) {
    const auto bytes = bundleBytes(file);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    const auto files = BundleFiles::open(*bytes);
    if (!files) return inputError(file.string() + ": " + files.error().text);
    Bundle bundle;
    bundle.scene = std::move(scene);
    auto finger = readFingerPath(files->file(bundle_name::kFinger), file / bundle_name::kFinger);
    if (!finger) return tl::unexpected<Error>(finger.error());
    const auto forces = readForces(files->file(bundle_name::kForces), file / bundle_name::kForces);
    if (!forces) return tl::unexpected<Error>(forces.error());
    bundle.finger = std::move(*finger);
    for (const FeltRow& row : forces->rows)
        bundle.forces.push_back(row.force);
    if (bundle.forces.size() != bundle.finger.size())
        return inputError(file.string() +
                          ": its forces.csv has other rows than finger.csv; export the bundle again");
    return bundle;
}

} // namespace tactum
