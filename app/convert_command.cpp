#include <fstream>
#include <iostream>

#include "app/commands.h"
#include "app/output_files.h"
#include "app/results.h"
#include "app/streams.h"
#include "app/terminal_progress.h"
#include "core/base/text.h"
#include "core/bundle/bundle.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/loss_report.h"
#include "core/files/mesh/write_mesh.h"
#include "core/files/read_finger_path.h"
#include "core/files/save_scene.h"
#include "core/files/x3d/write_x3d.h"
#include "core/scene/placing.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

/// A way out of the program: writes the files, and says what becomes of the scene there.
struct Writer {
    std::string_view ending; ///< lower case
    ExportTarget target;
    Result<void> (*write)(const Scene&, const ConvertOptions&, std::vector<Loss>&, const Progress&);
    bool alone = true; ///< one file, that names no other
};

Result<void> writeGlb(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&,
                      const Progress& progress) {
    return saveScene(scene, options.out, progress, 0);
}

/// Text, with the data in a file beside it.
Result<void> writeGltf(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&,
                       const Progress& progress) {
    const fs::path& out = options.out;
    if (const auto free = demandReplaceable(out); !free) return free;
    auto gltf = gltfFilesOf(scene, out.stem().string(), progress);
    if (!gltf) return tl::unexpected<Error>(gltf.error());
    std::vector<OutFile> files;
    if (!gltf->binary.empty())
        files.push_back({out.parent_path() / gltf->binaryName, std::move(gltf->binary)});
    files.push_back({out, std::move(gltf->json)});
    return writeAll(options, files);
}

Result<void> writeBundle(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&,
                         const Progress& progress) {
    const auto touches = saveTouchedBundle(scene, options.out, progress, 0);
    if (!touches) return tl::unexpected<Error>(touches.error());
    if (!*touches)
        std::cerr
            << "warning: the finger path of the bundle touches nothing, so that its forces show nothing; "
               "give it another one with --path\n";
    return {};
}

/// The images and the device lie beside the scene, which names them.
Result<void> writeX3d(const Scene& scene, const ConvertOptions& options, std::vector<Loss>& losses,
                      const Progress& progress) {
    const fs::path& out = options.out;
    const X3dNames names = X3dNames::beside(out.stem().string());
    auto x3d = x3dOf(scene, names, progress);
    if (!x3d) return tl::unexpected<Error>(x3d.error());
    losses = std::move(x3d->losses);
    std::vector<OutFile> files;
    for (X3dImage& image : x3d->images)
        files.push_back({out.parent_path() / image.name, std::move(image.bytes)});
    files.push_back({out.parent_path() / names.device, std::move(x3d->device)});
    files.push_back({out, std::move(x3d->scene)});
    return writeAll(options, files);
}

std::string endingOf(const fs::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    return ending.empty() ? ending : ending.substr(1);
}

Result<void> writeMesh(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&,
                       const Progress&) {
    const fs::path& out = options.out;
    auto meshes = meshFilesOf(scene, endingOf(out), out.stem().string());
    if (!meshes) return tl::unexpected<Error>(meshes.error());
    std::vector<OutFile> files;
    for (std::size_t i = 1; i < meshes->size(); ++i)
        files.push_back({out.parent_path() / (*meshes)[i].name, std::move((*meshes)[i].bytes)});
    files.push_back({out, std::move(meshes->front().bytes)}); // called as the person calls it
    return writeAll(options, files);
}

constexpr Writer kWriters[] = {
    {"glb", ExportTarget::Glb, writeGlb},        {"gltf", ExportTarget::Glb, writeGltf, false},
    {"tactum", ExportTarget::Glb, writeBundle},  {"zip", ExportTarget::Glb, writeBundle},
    {"x3d", ExportTarget::X3d, writeX3d, false}, {"obj", ExportTarget::Obj, writeMesh, false},
    {"ply", ExportTarget::Ply, writeMesh},       {"stl", ExportTarget::Stl, writeMesh},
    {"off", ExportTarget::Off, writeMesh}};

const Writer* writerFor(const fs::path& out) {
    for (const Writer& writer : kWriters)
        if (endingOf(out) == writer.ending) return &writer;
    return nullptr;
}

std::string writableEndings(bool toPipe = false) {
    std::string text;
    for (const Writer& writer : kWriters)
        if (writer.alone || !toPipe) text += (text.empty() ? "" : ", ") + std::string(writer.ending);
    return text;
}

/// Before the work, and the same for every format.
Result<void> checkFolder(const fs::path& out) {
    const fs::path folder = out.has_parent_path() ? out.parent_path() : ".";
    std::error_code fault;
    if (fs::is_directory(folder, fault)) return {};
    return machineError(out.string() + ": cannot be written: there is no folder " + folder.string() +
                        "; make it, or check the path");
}

/// One line for each thing that is not kept as it is.
void sayLosses(const std::vector<Loss>& losses) {
    for (const Loss& loss : losses)
        if (loss.kind != LossKind::Kept)
            std::cerr << kLossKinds[std::size_t(loss.kind)] << ": "
                      << (loss.object.empty() ? "scene" : loss.object) << ": " << loss.what << ": "
                      << loss.sentence << '\n';
}

Result<int> convert(const ConvertOptions& options) {
    const Writer* writer = writerFor(options.out);
    if (!writer)
        return tl::unexpected(Error{
            Error::Kind::Usage,
            options.out.string() + ": cannot be written by its ending; writable are " + writableEndings()});
    if (const auto folder = checkFolder(options.out); !folder) return tl::unexpected(folder.error());
    auto loaded = importGiven(options.in);
    if (!loaded) return tl::unexpected(loaded.error());
    Scene& scene = loaded->scene;
    if (const auto taken = takeAsGiven(*loaded, options.axes, options.in); !taken)
        return tl::unexpected(taken.error());
    if (options.fitDiagonal) fitDiagonal(scene, *options.fitDiagonal); // the finger of the scene as well
    if (options.path) { // one that is given is where the result is, as it is for `touch`
        auto finger = readFingerPath(*options.path);
        if (!finger) return tl::unexpected(finger.error());
        scene.finger = std::make_shared<const std::vector<FingerPoint>>(std::move(*finger));
    }
    std::vector<Loss> losses = lossesOf(scene, writer->target);
    {
        const TerminalProgress terminal("writing " + shownPath(options.out));
        if (const auto written = writer->write(scene, options, losses, terminal.progress()); !written)
            return tl::unexpected(written.error());
    }
    for (const std::string& line : linesOf(loaded->findings))
        std::cerr << line << '\n';
    sayLosses(losses);
    if (options.report)
        if (const auto written = writeFile(*options.report, reportJson(losses)); !written)
            return tl::unexpected(written.error());
    return 0;
}

/// By way of a file. A format whose files name each other cannot go through a pipe.
Result<int> convertToOutput(ConvertOptions options) {
    const std::string name = "standard output";
    const auto usage = [&](const std::string& text) {
        return tl::unexpected(Error{Error::Kind::Usage, name + ": " + text});
    };
    std::string bytes;
    Result<int> code = 0;
    { // the folder is gone when the bytes go out, whoever is no longer there to read them
        const ScratchFolder folder("pipe");
        if (folder.path().empty())
            return machineError(name + ": there is no folder for temporary files; set TMPDIR to one");
        options.out = folder.path() / ("standard-output." + options.to.value_or(""));
        const Writer* writer = writerFor(options.out);
        if (!writer || lowerCase(*options.to) != writer->ending) // an ending, and no part of a path
            return usage("needs --to with one of " + writableEndings(true));
        if (!writer->alone)
            return usage("." + *options.to + " is several files that name each other; write it to a file");
        code = convert(options);
        if (!code) return tl::unexpected(renamed(code.error(), folder, name));
        std::ifstream in(options.out, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    if (const auto written = writeFile("-", bytes); !written) return tl::unexpected(written.error());
    return code;
}

} // namespace

Result<int> runConvert(const ConvertOptions& options) {
    if (isDash(options.out)) return convertToOutput(options);
    if (options.to)
        return tl::unexpected(
            Error{Error::Kind::Usage, "--to: is for - alone, a file says its format by its ending"});
    return convert(options);
}

} // namespace tactum
