#include <iostream>

#include "app/commands.h"
#include "app/results.h"
#include "core/base/atomic_file.h"
#include "core/bundle/bundle.h"
#include "core/files/loss_report.h"
#include "core/files/mesh/write_mesh.h"
#include "core/files/read_finger_path.h"
#include "core/files/save_scene.h"
#include "core/files/x3d/write_x3d.h"
#include "core/import/import_scene.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

/// A way out of the program: writes the files, and says what becomes of the scene there.
struct Writer {
    std::string_view ending;
    ExportTarget target;
    Result<void> (*write)(const Scene&, const fs::path&, std::vector<Loss>&);
};

/// All of them; the last one is the one that was asked for, so that it is there only when all others are.
template <class Files> Result<void> writeAll(const fs::path& folder, const Files& files) {
    for (const auto& [name, bytes] : files) {
        std::error_code fault;
        fs::create_directories((folder / name).parent_path(), fault);
        if (const auto written = writeFileAtomically(folder / name, bytes); !written) return written;
    }
    return {};
}

Result<void> writeGlb(const Scene& scene, const fs::path& out, std::vector<Loss>&) {
    return saveScene(scene, out);
}

Result<void> writeBundle(const Scene& scene, const fs::path& out, std::vector<Loss>&) {
    return saveBundle(scene, out);
}

/// The images and the device lie beside the scene, which names them.
Result<void> writeX3d(const Scene& scene, const fs::path& out, std::vector<Loss>& losses) {
    const X3dExport x3d = x3dOf(scene);
    losses = x3d.losses;
    std::vector<std::pair<std::string, std::string>> files;
    for (const X3dImage& image : x3d.images)
        files.emplace_back(image.name, image.bytes);
    files.emplace_back("deviceinfo.x3d", x3d.device);
    files.emplace_back(out.filename().string(), x3d.scene);
    return writeAll(out.parent_path(), files);
}

Result<void> writeMesh(const Scene& scene, const fs::path& out, std::vector<Loss>&) {
    const std::string ending = out.extension().string().substr(1);
    auto files = meshFilesOf(scene, ending, out.stem().string());
    if (!files) return tl::unexpected<Error>(files.error());
    std::vector<std::pair<std::string, std::string>> all;
    for (auto file = files->rbegin(); file != files->rend(); ++file)
        all.emplace_back(file->name, std::move(file->bytes));
    return writeAll(out.parent_path(), all);
}

constexpr Writer kWriters[] = {{"glb", ExportTarget::Glb, writeGlb},  {"zip", ExportTarget::Glb, writeBundle},
                               {"x3d", ExportTarget::X3d, writeX3d},  {"obj", ExportTarget::Obj, writeMesh},
                               {"ply", ExportTarget::Ply, writeMesh}, {"stl", ExportTarget::Stl, writeMesh},
                               {"off", ExportTarget::Off, writeMesh}};

const Writer* writerFor(const fs::path& out) {
    for (const Writer& writer : kWriters)
        if (out.extension() == "." + std::string(writer.ending)) return &writer;
    return nullptr;
}

std::string writableEndings() {
    std::string text;
    for (const Writer& writer : kWriters)
        text += (text.empty() ? "" : ", ") + std::string(writer.ending);
    return text;
}

/// One line for each thing that is not kept as it is.
void sayLosses(const std::vector<Loss>& losses) {
    for (const Loss& loss : losses)
        if (loss.kind != LossKind::Kept)
            std::cerr << kLossKinds[std::size_t(loss.kind)] << ": "
                      << (loss.object.empty() ? "scene" : loss.object) << ": " << loss.what << ": "
                      << loss.sentence << '\n';
}

} // namespace

Result<int> runConvert(const ConvertOptions& options) {
    const Writer* writer = writerFor(options.out);
    if (!writer)
        return tl::unexpected(Error{
            Error::Kind::Usage,
            options.out.string() + ": cannot be written by its ending; writable are " + writableEndings()});
    auto loaded = importScene(options.in);
    if (!loaded) return tl::unexpected(loaded.error());
    Scene& scene = loaded->scene;
    if (options.fitDiagonal) fitDiagonal(scene, *options.fitDiagonal);
    if (options.path) {
        auto finger = readFingerPath(*options.path);
        if (!finger) return tl::unexpected(finger.error());
        scene.finger = std::make_shared<const std::vector<FingerPoint>>(std::move(*finger));
    }
    std::vector<Loss> losses = lossesOf(scene, writer->target);
    if (const auto written = writer->write(scene, options.out, losses); !written)
        return tl::unexpected(written.error());
    sayLosses(losses);
    if (options.report)
        if (const auto written = writeFile(*options.report, reportJson(losses)); !written)
            return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
