#include "core/files/load_scene.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/files/beside.h"
#include "core/files/guarded.h"
#include "core/files/readers.h"
#include "core/files/world_mesh.h"
#include "core/geometry/mesh_health.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(8) << 30;

/// What a format names beside itself: nothing, pictures, materials and pictures, or pictures and buffers,
/// which have many endings.
enum class Beside { Nothing, Pictures, Materials, Buffers };

struct Format {
    std::string_view ending;
    LoadedScene (*read)(const Source&, const Progress&);
    Beside beside;
};
constexpr Format kFormats[] = {{"obj", readObj, Beside::Materials},   {"ply", readPly, Beside::Nothing},
                               {"stl", readStl, Beside::Nothing},     {"off", readOff, Beside::Nothing},
                               {"gltf", readGltf, Beside::Buffers},   {"glb", readGltf, Beside::Buffers},
                               {"x3d", readX3d, Beside::Pictures},    {"3ds", readAssimp, Beside::Pictures},
                               {"fbx", readAssimp, Beside::Pictures}, {"dae", readAssimp, Beside::Pictures},
                               {"3mf", read3mf, Beside::Nothing},     {"tactum", readBundle, Beside::Nothing},
                               {"zip", readBundle, Beside::Nothing}};

const Format* formatOf(const std::filesystem::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    for (const Format& format : kFormats)
        if (ending == "." + std::string(format.ending)) return &format;
    return nullptr;
}

std::string allEndings() {
    std::string text;
    for (const Format& format : kFormats)
        text += (text.empty() ? "" : ", ") + std::string(format.ending);
    return text;
}

/// What a file may be in spite of its ending, and what to do then.
struct Disguise {
    std::string_view magic;
    const char* sentence;
};
constexpr Disguise kDisguises[] = {
    {"PK\x03\x04",
     "is a ZIP archive; unpack it and open the model that is inside, or call it .tactum if it is a bundle"},
    {"\x1f\x8b", "is compressed by gzip; unpack it first"},
    {"BZh", "is compressed by bzip2; unpack it first"},
    {"\xFD"
     "7zXZ",
     "is compressed by xz; unpack it first"},
    {"7z\xBC\xAF", "is a 7-Zip archive; unpack it and open the model that is inside"},
    {"Rar!", "is a RAR archive; unpack it and open the model that is inside"},
    {"%PDF", "is a PDF document; export the model itself"},
    {"\x89PNG", "is a PNG picture; open a model"},
    {"\xFF\xD8\xFF", "is a JPEG picture; open a model"},
    {"<!DOCTYPE html", "is a web page; download the model itself"},
};

void refuseDisguises(const Source& source, bool mayBeZip) {
    for (const Disguise& disguise : kDisguises)
        if (source.bytes().starts_with(disguise.magic) && !(mayBeZip && disguise.magic == "PK\x03\x04"))
            source.fail(disguise.sentence);
}

/// One unit of these is whatever it was in the program that wrote the file. Said only where it cannot be a
/// metre.
void sayWhatIsOpen(LoadedScene& loaded, const Format& format) {
    constexpr double kLargest = 5; // m: nothing that a hand reaches is larger
    constexpr std::string_view kWithoutUnit[] = {"obj", "ply", "stl", "off"};
    if (std::ranges::find(kWithoutUnit, format.ending) == std::end(kWithoutUnit)) return;
    loaded.unitGuessed = loaded.upGuessed = true;
    const double across = boundsOf(loaded.scene).diagonal();
    if (!(across > kLargest)) return;
    loaded.findings.push_back(unitGuess(loaded.scene, "in millimetres it would be " +
                                                          withUnit(across / 1000, "m") +
                                                          ": tactum convert --unit mm"));
}

/// A unit of 0, or every index the same.
void sayWhereNoSize(LoadedScene& loaded) {
    std::size_t vertices = 0;
    for (const SceneObject& object : loaded.scene.objects)
        vertices += object.geometry->positions.size();
    if (vertices < 2 || boundsOf(loaded.scene).diagonal() > 0) return;
    loaded.findings.push_back({Finding::Severity::Warning, "",
                               "is of no size: all its vertices lie at one place",
                               "export it again; its unit may be 0"});
}

LoadedScene load(const std::filesystem::path& file, const Progress& progress) {
    const Source source = Source::open(file, kLargestFile, partOf(progress, 0.0, 0.1));
    const Format* format = formatOf(file);
    if (!format) source.fail("cannot tell its format by its ending; readable are " + allEndings());
    refuseDisguises(source, format->read == readBundle || format->read == read3mf);
    LoadedScene loaded = format->read(source, partOf(progress, 0.1, 1.0));
    if (loaded.scene.objects.empty() && loaded.scene.mechanics.bodies.empty())
        source.fail("has no faces, lines or points; export the mesh with its faces");
    sayWhatIsOpen(loaded, *format);
    sayWhereNoSize(loaded);
    if (progress.report) progress.report(1.0);
    return loaded;
}

} // namespace

const std::vector<std::string>& readableEndings() {
    static const std::vector<std::string> endings = [] {
        std::vector<std::string> all;
        for (const Format& format : kFormats)
            all.emplace_back(format.ending);
        return all;
    }();
    return endings;
}

std::vector<std::string_view> endingsBeside(const std::filesystem::path& file) {
    const Format* format = formatOf(file);
    if (!format || format->beside == Beside::Nothing) return {};
    std::vector<std::string_view> endings{"png", "jpg", "jpeg", "tif", "tiff"};
    if (format->beside == Beside::Materials) endings.push_back("mtl");
    if (format->beside == Beside::Buffers)
        for (const std::string_view buffer : {"bin", "buf", "buffer", "dat", "data", "glbin", "webp", "ktx2"})
            endings.push_back(buffer);
    return endings;
}

Result<LoadedScene> loadScene(const std::filesystem::path& file, const Progress& progress) {
    return guarded<LoadedScene>(file, "to open it; close other programs",
                                [&] { return load(file, progress); });
}

Finding noteOfCloud(std::size_t points) {
    return {Finding::Severity::Note, "", "has vertices alone: " + counted(points, "point"),
            "each is felt by itself; export the mesh with its faces if it has some"};
}

Surface namedSurface(std::string name) {
    Surface surface;
    surface.name = std::move(name);
    return surface;
}

std::string stemOf(const Source& source) {
    return printable(source.path().stem().string());
}

} // namespace tactum
