#include "core/bundle/write_scene.h"

#include "core/base/text.h"
#include "core/bundle/bundle.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/mesh/write_mesh.h"
#include "core/files/save_scene.h"
#include "core/files/x3d/write_x3d.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

/// Writes the files, and says what becomes of the scene there.
struct Writer {
    SceneFormat format;
    Result<void> (*write)(const Scene&, const OutputPlaces&, WrittenScene&, const Progress&);
};

Result<void> writeGlb(const Scene& scene, const OutputPlaces& places, WrittenScene&,
                      const Progress& progress) {
    return saveScene(scene, places.out, progress, 0);
}

/// Text, with the data in a file beside it.
Result<void> writeGltf(const Scene& scene, const OutputPlaces& places, WrittenScene&,
                       const Progress& progress) {
    const fs::path& out = places.out;
    if (const auto free = demandReplaceable(out); !free) return free;
    auto gltf = gltfFilesOf(scene, out.stem().string(), progress);
    if (!gltf) return tl::unexpected<Error>(gltf.error());
    std::vector<OutFile> files;
    if (!gltf->binary.empty())
        files.push_back({out.parent_path() / gltf->binaryName, std::move(gltf->binary)});
    files.push_back({out, std::move(gltf->json)});
    return writeAll(places, files);
}

Result<void> writeBundle(const Scene& scene, const OutputPlaces& places, WrittenScene& written,
                         const Progress& progress) {
    const auto touches = saveTouchedBundle(scene, places.out, progress, 0);
    if (!touches) return tl::unexpected<Error>(touches.error());
    written.touches = *touches;
    return {};
}

/// The images and the device lie beside the scene, which names them.
Result<void> writeX3d(const Scene& scene, const OutputPlaces& places, WrittenScene& written,
                      const Progress& progress) {
    const fs::path& out = places.out;
    const X3dNames names = X3dNames::beside(out.stem().string());
    auto x3d = x3dOf(scene, names, progress);
    if (!x3d) return tl::unexpected<Error>(x3d.error());
    written.losses = std::move(x3d->losses);
    std::vector<OutFile> files;
    for (X3dImage& image : x3d->images)
        files.push_back({out.parent_path() / image.name, std::move(image.bytes)});
    files.push_back({out.parent_path() / names.device, std::move(x3d->device)});
    files.push_back({out, std::move(x3d->scene)});
    return writeAll(places, files);
}

std::string endingOf(const fs::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    return ending.empty() ? ending : ending.substr(1);
}

Result<void> writeMesh(const Scene& scene, const OutputPlaces& places, WrittenScene&, const Progress&) {
    const fs::path& out = places.out;
    auto meshes = meshFilesOf(scene, endingOf(out), out.stem().string());
    if (!meshes) return tl::unexpected<Error>(meshes.error());
    std::vector<OutFile> files;
    for (std::size_t i = 1; i < meshes->size(); ++i)
        files.push_back({out.parent_path() / (*meshes)[i].name, std::move((*meshes)[i].bytes)});
    files.push_back({out, std::move(meshes->front().bytes)}); // called as the person calls it
    return writeAll(places, files);
}

constexpr Writer kWriters[] = {
    {{"glb", ExportTarget::Glb, true}, writeGlb},       {{"gltf", ExportTarget::Glb, false}, writeGltf},
    {{"tactum", ExportTarget::Glb, true}, writeBundle}, {{"zip", ExportTarget::Glb, true}, writeBundle},
    {{"x3d", ExportTarget::X3d, false}, writeX3d},      {{"obj", ExportTarget::Obj, false}, writeMesh},
    {{"ply", ExportTarget::Ply, true}, writeMesh},      {{"stl", ExportTarget::Stl, true}, writeMesh},
    {{"off", ExportTarget::Off, true}, writeMesh}};

Result<const Writer*> writerFor(const fs::path& out) {
    for (const Writer& writer : kWriters)
        if (endingOf(out) == writer.format.ending) return &writer;
    return tl::unexpected(
        Error{Error::Kind::Usage,
              out.string() + ": cannot be written by its ending; writable are " + writableEndings()});
}

} // namespace

Result<SceneFormat> formatOf(const fs::path& out) {
    const auto writer = writerFor(out);
    if (!writer) return tl::unexpected<Error>(writer.error());
    return (*writer)->format;
}

std::string writableEndings(bool alone) {
    std::string text;
    for (const auto& [format, write] : kWriters)
        if (format.alone || !alone) text += (text.empty() ? "" : ", ") + std::string(format.ending);
    return text;
}

Result<void> checkFolder(const fs::path& out) {
    const fs::path folder = out.has_parent_path() ? out.parent_path() : ".";
    std::error_code fault;
    if (fs::is_directory(folder, fault)) return {};
    return machineError(out.string() + ": cannot be written: there is no folder " + folder.string() +
                        "; make it, or check the path");
}

Result<WrittenScene> writeScene(const Scene& scene, const OutputPlaces& places, const Progress& progress) {
    const auto writer = writerFor(places.out);
    if (!writer) return tl::unexpected<Error>(writer.error());
    if (const auto folder = checkFolder(places.out); !folder) return tl::unexpected<Error>(folder.error());
    WrittenScene written{lossesOf(scene, (*writer)->format.target)};
    if (const auto done = (*writer)->write(scene, places, written, progress); !done)
        return tl::unexpected<Error>(done.error());
    return written;
}

} // namespace tactum
