#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>

#include "app/commands.h"
#include "app/results.h"
#include "core/base/atomic_file.h"
#include "core/base/text.h"
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

/// A file of the result.
struct OutFile {
    fs::path path;
    std::string bytes;
};

/// A way out of the program: writes the files, and says what becomes of the scene there.
struct Writer {
    std::string_view ending; ///< lower case
    ExportTarget target;
    Result<void> (*write)(const Scene&, const ConvertOptions&, std::vector<Loss>&);
};

tl::unexpected<Error> usageError(const fs::path& file, const std::string& sentence) {
    return tl::unexpected<Error>(Error{Error::Kind::Usage, file.string() + ": " + sentence});
}

/// Whether the text of a file has this word between characters that are none of a name.
bool hasWord(const fs::path& file, const std::string& word) {
    const auto isOfName = [](int c) {
        return std::isalnum(c) || c >= 0x80 ||
               std::string_view("_-.~").find(char(c)) != std::string_view::npos;
    };
    std::ifstream in(file, std::ios::binary);
    std::string text(1, '\n'); // what is before the file
    std::string block(1 << 20, '\0');
    while (in) {
        in.read(block.data(), std::streamsize(block.size()));
        text.append(block, 0, std::size_t(in.gcount()));
        if (!in) text += '\n';
        for (std::size_t at = text.find(word, 1); at != std::string::npos; at = text.find(word, at + 1)) {
            const std::size_t end = at + word.size();
            if (end < text.size() && !isOfName(std::uint8_t(text[at - 1])) &&
                !isOfName(std::uint8_t(text[end])))
                return true;
        }
        text.erase(0, text.size() - std::min(text.size(), word.size() + 1));
    }
    return false;
}

/// Whether a file is one that the input reads beside itself, a material library or a picture. No reader tells
/// what it opened; the input has to name it.
bool isNamedBy(const fs::path& input, const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) || !fs::is_regular_file(input, fault)) return false;
    const fs::path folder = fs::canonical(input.has_parent_path() ? input.parent_path() : ".", fault);
    if (fault) return false;
    const std::string name = fs::weakly_canonical(file, fault).lexically_relative(folder).generic_string();
    return !fault && !name.empty() && !name.starts_with("..") && hasWord(input, name); // readers stay inside
}

/// Before anything is written: files that were not asked for by name must not cost what was there either.
Result<void> checkFiles(const ConvertOptions& options, const std::vector<OutFile>& files) {
    std::vector<fs::path> inputs{options.in}, outputs;
    if (options.path) inputs.push_back(*options.path);
    if (options.report) outputs.push_back(*options.report);
    for (const OutFile& file : files)
        outputs.push_back(file.path);
    if (const auto clash = clashOf(inputs, outputs))
        return usageError(*clash, "would be written beside the result, and " + std::string(kClash));
    for (const OutFile& file : files)
        if (file.path != options.out && isNamedBy(options.in, file.path))
            return usageError(file.path, "belongs to " + options.in.string() +
                                             " and would be replaced; choose another name for the result");
    return {};
}

/// All of them; the last one is the one that was asked for, so that it is there only when all others are.
Result<void> writeAll(const ConvertOptions& options, const std::vector<OutFile>& files) {
    if (const auto apart = checkFiles(options, files); !apart) return apart;
    for (const OutFile& file : files) {
        std::error_code fault;
        if (file.path.has_parent_path()) fs::create_directory(file.path.parent_path(), fault);
        if (const auto written = writeFileAtomically(file.path, file.bytes, 0); !written) return written;
    }
    return {};
}

Result<void> writeGlb(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&) {
    return saveScene(scene, options.out, {}, 0);
}

Result<void> writeBundle(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&) {
    return saveBundle(scene, options.out, {}, 0);
}

/// The images and the device lie beside the scene, which names them.
Result<void> writeX3d(const Scene& scene, const ConvertOptions& options, std::vector<Loss>& losses) {
    const fs::path& out = options.out;
    const X3dNames names = X3dNames::beside(out.stem().string());
    X3dExport x3d = x3dOf(scene, names);
    losses = std::move(x3d.losses);
    std::vector<OutFile> files;
    for (X3dImage& image : x3d.images)
        files.push_back({out.parent_path() / image.name, std::move(image.bytes)});
    files.push_back({out.parent_path() / names.device, std::move(x3d.device)});
    files.push_back({out, std::move(x3d.scene)});
    return writeAll(options, files);
}

std::string endingOf(const fs::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    return ending.empty() ? ending : ending.substr(1);
}

Result<void> writeMesh(const Scene& scene, const ConvertOptions& options, std::vector<Loss>&) {
    const fs::path& out = options.out;
    auto meshes = meshFilesOf(scene, endingOf(out), out.stem().string());
    if (!meshes) return tl::unexpected<Error>(meshes.error());
    std::vector<OutFile> files;
    for (std::size_t i = 1; i < meshes->size(); ++i)
        files.push_back({out.parent_path() / (*meshes)[i].name, std::move((*meshes)[i].bytes)});
    files.push_back({out, std::move(meshes->front().bytes)}); // called as the person calls it
    return writeAll(options, files);
}

constexpr Writer kWriters[] = {{"glb", ExportTarget::Glb, writeGlb},  {"zip", ExportTarget::Glb, writeBundle},
                               {"x3d", ExportTarget::X3d, writeX3d},  {"obj", ExportTarget::Obj, writeMesh},
                               {"ply", ExportTarget::Ply, writeMesh}, {"stl", ExportTarget::Stl, writeMesh},
                               {"off", ExportTarget::Off, writeMesh}};

const Writer* writerFor(const fs::path& out) {
    for (const Writer& writer : kWriters)
        if (endingOf(out) == writer.ending) return &writer;
    return nullptr;
}

std::string writableEndings() {
    std::string text;
    for (const Writer& writer : kWriters)
        text += (text.empty() ? "" : ", ") + std::string(writer.ending);
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

} // namespace

Result<int> runConvert(const ConvertOptions& options) {
    const Writer* writer = writerFor(options.out);
    if (!writer)
        return tl::unexpected(Error{
            Error::Kind::Usage,
            options.out.string() + ": cannot be written by its ending; writable are " + writableEndings()});
    if (const auto folder = checkFolder(options.out); !folder) return tl::unexpected(folder.error());
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
    if (const auto written = writer->write(scene, options, losses); !written)
        return tl::unexpected(written.error());
    for (const Finding& finding : loaded->findings)
        std::cerr << lineOf(finding) << '\n';
    sayLosses(losses);
    if (options.report)
        if (const auto written = writeFile(*options.report, reportJson(losses)); !written)
            return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
