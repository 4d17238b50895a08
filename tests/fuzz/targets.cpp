#include "tests/fuzz/targets.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/archive/zip_archive.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/images/read_image.h"
#include "core/files/read_finger_path.h"
#include "core/files/readers.h"
#include "core/import/scene_transfer.h"
#include "core/presets/preset_file.h"
#include "core/presets/read_hatt.h"
#include "core/protocol/edits.h"
#include "core/protocol/uploads.h"
#include "core/recording/events.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "tests/support/random_touch.h"

namespace tactum::fuzz {
namespace {

[[noreturn]] void found(const std::string& what) {
    std::cerr << "FOUND: " << what << '\n';
    std::abort();
}

void demandOneLine(const Error& error) {
    if (error.text.empty() || error.text.find('\n') != std::string::npos)
        found("an error that is not one line: " + error.text);
}

/// A folder of this process alone, for readers that look beside their file.
const std::filesystem::path& folder() {
    static const std::filesystem::path made = [] {
        std::string name = (std::filesystem::temp_directory_path() / "tactum-fuzz-XXXXXX").string();
        if (!mkdtemp(name.data())) found("no folder to work in");
        static const std::string kept = name;
        std::atexit([] { std::filesystem::remove_all(kept); });
        return std::filesystem::path(name);
    }();
    return made;
}

/// What loadScene() gives goes to another process, is checked there, and is felt.
void demandSound(const LoadedScene& loaded) {
    StringOut out;
    writeTransfer(out, loaded);
    try {
        readTransfer(out.bytes);
    } catch (const ByteFault& fault) {
        found("the import process would be refused its scene: " + fault.error.text);
    }
    // A step that moves bodies takes 45 ms here, and the whole of a file should end within seconds.
    const int strokes = loaded.scene.mechanics.bodies.empty() ? 20 : 2;
    const std::string fault = test::faultOfTouch(loaded.scene, strokes);
    if (!fault.empty()) found(fault);
}

template <LoadedScene (*read)(const Source&, const Progress&)>
void readAs(std::string_view name, std::string_view bytes) {
    try {
        demandSound(read(Source::ofBytes(folder() / name, bytes), {}));
    } catch (const ReadFault& fault) {
        demandOneLine(fault.error);
    }
}

/// What stands behind the line "#mtl" is the library beside it.
void readObjAndMtl(std::string_view bytes) {
    constexpr std::string_view kRest = "\n#mtl\n";
    const std::size_t cut = bytes.find(kRest);
    const std::string_view library = cut == bytes.npos ? "" : bytes.substr(cut + kRest.size());
    std::ofstream(folder() / "m.mtl", std::ios::binary) << library;
    readAs<readObj>("a.obj", bytes.substr(0, cut));
}

/// The model of a package that is whole; what is damaged in packages is for "zip".
void readModelOf3mf(std::string_view bytes) {
    const std::vector<ZipEntry> entries{
        {"_rels/.rels",
         "<Relationships><Relationship Target='/3D/3dmodel.model' "
         "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>"},
        {"3D/3dmodel.model", std::string(bytes)}};
    readAs<read3mf>("a.3mf", writeZip(entries));
}

/// Our own files can be saved again, and then opened again.
void readOwn(std::string_view bytes) {
    try {
        const LoadedScene loaded = readGltf(Source::ofBytes(folder() / "a.glb", bytes), {});
        demandSound(loaded);
        const auto saved = glbOf(loaded.scene);
        if (!saved) return demandOneLine(saved.error());
        if (readGltf(Source::ofBytes(folder() / "b.glb", *saved), {}).scene.objects.size() !=
            loaded.scene.objects.size())
            found("saving lost an object");
    } catch (const ReadFault& fault) {
        demandOneLine(fault.error);
    }
}

/// A library with known faults, which is why it runs in a process of its own; that one catches as well.
void readRare(std::string_view name, std::string_view bytes) {
    try {
        readAs<readAssimp>(name, bytes);
    } catch (const std::exception&) {
    }
}

void readPicture(std::string_view bytes) {
    const auto loaded = readImage(bytes, "picture", "a.glb");
    if (!loaded) demandOneLine(loaded.error());
}

void readFinger(std::string_view bytes) {
    const auto path = readFingerPath(bytes, "a.csv");
    if (!path) demandOneLine(path.error());
}

/// What a preset does to a surface is inside every range, and it can be written and read again.
void demandSoundPreset(const Result<LoadedPreset>& read) {
    if (!read) return demandOneLine(read.error());
    const Surface surface = applied({}, read->preset);
    for (const MaterialField& field : kMaterialFields)
        if (!field.parameter->allows(surface.material.*field.value)) found("a preset out of range");
    for (const TextureLayer& layer : surface.layers)
        if (!strengthParameter(layer.target).allows(layer.strength)) found("a layer out of range");
    const std::string text = presetText(read->preset);
    const auto again = parsePreset(text, "b.tactum-preset");
    if (!again) found("what was written cannot be read: " + again.error().text);
    if (presetText(again->preset) != text) found("a preset changes when it is written again");
}

void readRun(std::string_view bytes) {
    std::string sealed(bytes); // else hardly any would get beyond its fingerprint
    sealRecording(sealed);
    auto recording = parseRecording(sealed, folder() / "a.tactum-recording");
    if (!recording) return demandOneLine(recording.error());
    eventsOf(recording->run);
    auto player = Player::open(std::make_shared<const RecordedRun>(std::move(recording->run)));
    if (!player) return demandOneLine(player.error());
    player->advanceTo(player->run().begin() + 0.1);
}

/// Of two triangles, as an object and as an upload: what edits of strangers are made to.
const LoadedScene& small() {
    static const LoadedScene made = [] {
        auto soup = std::make_shared<TriangleSoup>();
        soup->positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0.1, 0.02}};
        soup->triangles = {{0, 1, 2}, {1, 3, 2}};
        soup->surfaceOf = {0, 1};
        SceneObject object;
        object.name = "small";
        object.geometry = std::move(soup);
        object.surfaces.resize(2);
        LoadedScene loaded;
        loaded.scene.add(std::move(object));
        return loaded;
    }();
    return made;
}

void makeStrangersEdits(std::string_view bytes) {
    v1::Transaction transaction;
    if (bytes.size() > (1 << 20) || !transaction.ParseFromArray(bytes.data(), int(bytes.size()))) return;
    LoadedScene edited = small();
    const auto upload = std::make_shared<const LoadedScene>(small());
    SceneParts parts;
    const auto made = makeEdits(
        edited.scene, transaction.edit(),
        [&](std::uint64_t number) { return number == 1 ? upload : nullptr; }, parts);
    if (!made) return demandOneLine(made.error());
    demandSound(edited);
}

/// As a window sends it.
void takeStrangersScene(std::string_view bytes) {
    SceneParts parts;
    const auto made = parts.read(bytes, small().scene);
    if (!made) return demandOneLine(made.error());
    demandSound({*made, {}, true});
}

/// Behind a byte that says how long the head is.
void takeStrangersMesh(std::string_view bytes) {
    if (bytes.empty()) return;
    const std::size_t length = std::min<std::size_t>(std::uint8_t(bytes[0]), bytes.size() - 1);
    v1::UploadHead head;
    if (!head.ParseFromArray(bytes.data() + 1, int(length)) || !head.has_mesh()) return;
    Uploads uploads;
    Incoming incoming(uploads, {});
    const auto taken = incoming.begin(head).and_then([&] { return incoming.add(bytes.substr(1 + length)); });
    if (!taken) return demandOneLine(taken.error());
    if (!incoming.complete()) return;
    const auto loaded = incoming.read({});
    if (!loaded) return demandOneLine(loaded.error());
    demandSound(*loaded);
}

constexpr Target kTargets[] = {
    {"obj", readObjAndMtl},
    {"ply", [](std::string_view bytes) { readAs<readPly>("a.ply", bytes); }},
    {"stl", [](std::string_view bytes) { readAs<readStl>("a.stl", bytes); }},
    {"off", [](std::string_view bytes) { readAs<readOff>("a.off", bytes); }},
    {"gltf", [](std::string_view bytes) { readAs<readGltf>("a.gltf", bytes); }},
    {"glb", [](std::string_view bytes) { readAs<readGltf>("a.glb", bytes); }},
    {"own", readOwn, true},
    {"x3d", [](std::string_view bytes) { readAs<readX3d>("a.x3d", bytes); }},
    {"3mf", readModelOf3mf},
    {"zip", [](std::string_view bytes) { readAs<readBundle>("a.zip", bytes); }},
    {"image", readPicture},
    {"finger", readFinger},
    {"preset", [](std::string_view bytes) { demandSoundPreset(parsePreset(bytes, "a.tactum-preset")); }},
    {"hatt", [](std::string_view bytes) { demandSoundPreset(parseHatt(bytes, "a.xml")); }},
    {"recording", readRun},
    {"edits", makeStrangersEdits},
    {"mesh", takeStrangersMesh},
    {"scene", takeStrangersScene},
    {"3ds", [](std::string_view bytes) { readRare("a.3ds", bytes); }},
    {"fbx", [](std::string_view bytes) { readRare("a.fbx", bytes); }},
    {"dae", [](std::string_view bytes) { readRare("a.dae", bytes); }},
};

} // namespace

std::span<const Target> targets() {
    return kTargets;
}

} // namespace tactum::fuzz
