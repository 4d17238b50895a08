#include "core/import/scene_transfer.h"

#include <algorithm>
#include <unordered_set>

#include "core/base/text.h"
#include "core/scene/layer_bytes.h"
#include "core/scene/mechanics_bytes.h"
#include "core/scene/shape_bytes.h"

namespace tactum {
namespace {

struct Tables {
    LayerTables shared;
    SharedTable<TriangleSoup> soups;
    SharedTable<Motion> motions;
};

/// Text for a person: it may be shown in a window and on a terminal.
template <class Io> void shownText(Io& io, std::string& text, std::size_t limit) {
    io(text);
    if constexpr (Io::kReads) text = printable(text, limit);
}
constexpr ObjectId kMaxObjects = ObjectId(1) << 31; ///< Scene::add() counts on from the highest
constexpr std::size_t kLongestSentence = 4000;

/// What only the writer of a file looks at again, and does not trust either.
template <class Io, class T, class Inside>
void keptBytes(Io& io, std::shared_ptr<const T>& kept, Inside inside) {
    bool there = kept != nullptr;
    io(there);
    if (!there) return;
    T value = kept ? *kept : T{};
    inside(value);
    if constexpr (Io::kReads) kept = std::make_shared<const T>(std::move(value));
}

void makeShown(Mechanics& mechanics) {
    for (RigidBody& body : mechanics.bodies)
        body.name = printable(body.name, kLongestName);
    for (Joint& joint : mechanics.joints)
        joint.name = printable(joint.name, kLongestName);
}

// Each function names all members of its struct: one more there does not compile here until it has its line.

template <class Io> void transfer(Io& io, Kept& kept) {
    auto& [index, json] = kept;
    io(index);
    keptBytes(io, json, [&](std::string& text) { io(text); });
}

template <class Io> void transfer(Io& io, KeptFile& kept) {
    auto& [foreign] = kept;
    keptBytes(io, foreign, [&](ForeignGltf& file) {
        auto& [json, binary] = file;
        io(json), io(binary);
    });
}

template <class Io> void transfer(Io& io, Finding& finding, Tables&) {
    auto& [severity, object, sentence, remedy] = finding;
    choose(io, severity, 3);
    shownText(io, object, kLongestName);
    shownText(io, sentence, kLongestSentence), shownText(io, remedy, kLongestSentence);
}

template <class Io> void transfer(Io& io, Shading& shading, Tables&) {
    auto& [on, normals, creaseAngle] = shading;
    io(on), io(creaseAngle);
    choose(io, normals, 2);
}

template <class Io> void transfer(Io& io, TextureLayer& layer, Tables& tables) {
    layerBytes(io, layer, tables.shared);
    if constexpr (Io::kReads) layer.name = printable(layer.name, kLongestName);
}

template <class Io, class T>
void transferEach(Io& io, std::vector<T>& list, std::size_t least, Tables& tables) {
    io.count(list, least);
    for (T& each : list)
        transfer(io, each, tables);
}

template <class Io> void transfer(Io& io, Surface& surface, Tables& tables) {
    auto& [name, material, shading, layers, colour, sides, visible, locked, kept] = surface;
    shownText(io, name, kLongestName);
    numbersByKey(io, kMaterialFields, material);
    transfer(io, shading, tables);
    transferEach(io, layers, 64, tables);
    io(colour);
    choose(io, sides, kSidesNames.size());
    io(visible), io(locked);
    transfer(io, kept);
}

template <class Io> void transfer(Io& io, SceneObject& object, Tables& tables) {
    auto& [id, name, pose, motion, geometry, surfaces, body, visible, kept, keptMesh] = object;
    io(id), io(pose), io(body), io(visible);
    transfer(io, kept), transfer(io, keptMesh);
    shownText(io, name, kLongestName);
    link(io, motion, tables.motions), link(io, geometry, tables.soups);
    transferEach(io, surfaces, 64, tables);
    if constexpr (!Io::kReads) return;
    io.demand(geometry != nullptr, "an object has no geometry");
    const Index count = Index(surfaces.size());
    const bool known = std::ranges::all_of(geometry->surfaceOf, [&](Index index) { return index < count; });
    io.demand(known, "a triangle is of a surface that there is not");
}

template <class Io> void transfer(Io& io, Scene& scene, Tables& tables) {
    auto& [objects, mechanics, proxyRadius, finger, kept] = scene;
    io(proxyRadius);
    mechanicsBytes(io, mechanics);
    if constexpr (Io::kReads) makeShown(mechanics);
    keptBytes(io, finger, [&](std::vector<FingerPoint>& points) {
        io.count(points, 32);
        for (auto& [t, position] : points)
            io(t), io(position);
        io.demand(isFingerPath(points), "its finger path has no rows of rising time");
    });
    transfer(io, kept);
    transferEach(io, objects, 64, tables);
    if constexpr (!Io::kReads) return;
    std::unordered_set<ObjectId> seen;
    for (const SceneObject& object : objects)
        io.demand(object.id != 0 && object.id < kMaxObjects && seen.insert(object.id).second,
                  "the numbers of the objects are not those of one scene");
    const auto& bodies = mechanics.bodies;
    for (const SceneObject& object : objects)
        io.demand(object.body == kWorldBody ||
                      std::ranges::find(bodies, object.body, &RigidBody::id) != bodies.end(),
                  "an object is of a body that there is not");
}

template <class Io> void transfer(Io& io, LoadedScene& loaded, Tables& tables) {
    auto& [scene, findings, ours] = loaded;
    io(ours);
    transfer(io, scene, tables);
    transferEach(io, findings, 25, tables);
}

template <class T> void writeTable(ByteOut& out, SharedTable<T>& table) {
    out.count(table.items, 1);
    for (const auto& each : table.items)
        write(out, *each);
}

template <class T, class Read>
void readTable(ByteIn& in, SharedTable<T>& table, std::size_t least, Read read) {
    in.count(table.items, least);
    for (auto& each : table.items)
        each = read(in);
}

} // namespace

// What is named comes before what names it, and is known only after.
void writeTransfer(ByteOut& out, const LoadedScene& loaded) {
    Tables tables;
    StringOut values;
    transfer(values, const_cast<LoadedScene&>(loaded), tables); // writing does not touch it
    writeTable(out, tables.soups); // first, where they lie as in memory: they are the most
    writeTable(out, tables.shared.images);
    writeTable(out, tables.shared.paints);
    writeTable(out, tables.motions);
    out.append(values.bytes.data(), values.bytes.size());
}

LoadedScene readTransfer(std::string_view bytes) {
    ByteIn in(bytes, "the scene from the import process", 0,
              "the reader was broken by the file; do not trust it");
    Tables tables;
    readTable(in, tables.soups, 40, readSoup);
    readTable(in, tables.shared.images, 28, readImage);
    readTable(in, tables.shared.paints, 8, readPainted);
    readTable(in, tables.motions, 32, readMotion);
    LoadedScene loaded;
    transfer(in, loaded, tables);
    in.demand(in.left() == 0, "it is followed by something else");
    return loaded;
}

} // namespace tactum
