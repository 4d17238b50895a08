#include "core/scene/scene_bytes.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "core/base/text.h"
#include "core/scene/mechanics_bytes.h"
#include "core/scene/selection_sets.h"
#include "core/scene/shape_bytes.h"

namespace tactum {
namespace {

constexpr ObjectId kMaxObjects = ObjectId(1) << 31; ///< Scene::add() counts on from the highest

/// It may be shown in a window and on a terminal.
template <class Io> void nameBytes(Io& io, std::string& name) {
    io(name);
    if constexpr (Io::kReads) name = printable(name, kLongestName);
}

/// What only the writer of a file looks at again, and does not trust either.
template <class Io, class T, class Inside>
void sharedBytes(Io& io, std::shared_ptr<const T>& shared, Inside inside) {
    bool there = shared != nullptr;
    io(there);
    if (!there) return;
    T value = shared ? *shared : T{};
    inside(value);
    if constexpr (Io::kReads) shared = std::make_shared<const T>(std::move(value));
}

// Each function names all members of its struct: one more there does not compile here until it has its line.

template <class Io> void keptBytes(Io& io, Kept& kept) {
    auto& [index, json] = kept;
    io(index);
    sharedBytes(io, json, [&](std::string& text) { io(text); });
}

template <class Io> void keptBytes(Io& io, KeptFile& kept) {
    auto& [foreign] = kept;
    sharedBytes(io, foreign, [&](ForeignGltf& file) {
        auto& [json, binary] = file;
        io(json), io(binary);
    });
}

template <class Io> void shadingBytes(Io& io, Shading& shading) {
    auto& [on, normals, creaseAngle] = shading;
    io(on), io(creaseAngle);
    choose(io, normals, 2);
}

template <class Io> void surfaceBytes(Io& io, Surface& surface, SceneTables& tables) {
    auto& [name, material, shading, layers, colour, sides, visible, locked, kept] = surface;
    nameBytes(io, name);
    numbersByKey(io, kMaterialFields, material);
    shadingBytes(io, shading);
    io.count(layers, 64);
    for (TextureLayer& layer : layers) {
        layerBytes(io, layer, tables.shared);
        if constexpr (Io::kReads) layer.name = printable(layer.name, kLongestName);
    }
    io(colour);
    choose(io, sides, kSidesNames.size());
    io(visible), io(locked);
    keptBytes(io, kept);
}

template <class Io> void mechanicsWithNames(Io& io, Mechanics& mechanics) {
    mechanicsBytes(io, mechanics);
    if constexpr (!Io::kReads) return;
    for (RigidBody& body : mechanics.bodies)
        body.name = printable(body.name, kLongestName);
    for (Joint& joint : mechanics.joints)
        joint.name = printable(joint.name, kLongestName);
}

void demandOneScene(const ByteIn& in, const Scene& scene) {
    std::unordered_set<ObjectId> seen;
    for (const SceneObject& object : scene.objects)
        in.demand(object.id != 0 && object.id < kMaxObjects && seen.insert(object.id).second,
                  "the numbers of the objects are not those of one scene");
    const auto& bodies = scene.mechanics.bodies;
    for (const SceneObject& object : scene.objects)
        in.demand(object.body == kWorldBody ||
                      std::ranges::find(bodies, object.body, &RigidBody::id) != bodies.end(),
                  "an object is of a body that there is not");
}

template <class T>
void writeTable(ByteOut& out, const SharedTable<T>& table, const KnownTable<T>& elsewhere) {
    std::uint64_t count = table.items.size();
    out(count);
    for (const auto& each : table.items) {
        std::uint64_t print = elsewhere.printOf(each.get());
        if (print == 0 && !elsewhere.empty()) print = fingerprintOf(*each);
        if (print != 0 && !elsewhere.find(print)) print = 0;
        out(print); // 0: it follows; eight bytes, so that what follows lies as it does in memory
        if (print == 0) write(out, *each);
    }
}

/// `known()`: the KnownParts.
template <class T, class Read, class Known>
void readTable(ByteIn& in, SharedTable<T>& table, Read read, Known known, const Error& missing) {
    in.count(table.items, 8);
    for (auto& each : table.items) {
        std::uint64_t print = 0;
        in(print);
        each = print == 0 ? read(in) : known().template of<T>().find(print);
        if (!each) throw ByteFault{missing};
    }
}

} // namespace

template <class Io> void objectBytes(Io& io, SceneObject& object, SceneTables& tables) {
    auto& [id, name, pose, motion, geometry, surfaces, body, visible, group, sets, kept, keptMesh] = object;
    io(id), io(pose), io(body), io(visible);
    keptBytes(io, kept), keptBytes(io, keptMesh);
    nameBytes(io, name);
    link(io, motion, tables.motions), link(io, geometry, tables.soups);
    io.count(surfaces, 64);
    for (Surface& surface : surfaces)
        surfaceBytes(io, surface, tables);
    static_cast<void>(group), static_cast<void>(sets); // authorBytes()
    if constexpr (!Io::kReads) return;
    io.demand(geometry != nullptr, "an object has no geometry");
    const Index count = Index(surfaces.size());
    const bool known = std::ranges::all_of(geometry->surfaceOf, [&](Index index) { return index < count; });
    io.demand(known, "a triangle is of a surface that there is not");
}

template <class Io> void authorBytes(Io& io, SceneObject& object) {
    nameBytes(io, object.group);
    io.count(object.sets, 16);
    for (auto& [name, triangles] : object.sets)
        nameBytes(io, name), io.bulk(triangles);
    io.demand(!Io::kReads || areSetsOf(object.sets, object.geometry->triangles.size()),
              "a selection set is not of its object's triangles");
}

template <class Io> void cameraBytes(Io& io, SavedCamera& camera) {
    auto& [name, pose, parallel, angle, height, ahead, near, far, kept, keptCamera] = camera;
    nameBytes(io, name);
    io(pose), io(parallel), io(angle), io(height), io(ahead), io(near), io(far);
    keptBytes(io, kept), keptBytes(io, keptCamera);
}

template <class Io> void sceneBytes(Io& io, Scene& scene, SceneTables& tables) {
    auto& [objects, mechanics, proxyRadius, reach, finger, cameras, kept] = scene;
    io(proxyRadius);
    choose(io, reach.mode, kReachModes), io(reach.shell);
    mechanicsWithNames(io, mechanics);
    sharedBytes(io, finger, [&](std::vector<FingerPoint>& points) {
        io.count(points, 32);
        for (auto& [t, position] : points)
            io(t), io(position);
        io.demand(isFingerPath(points), "its finger path has no rows of rising time");
    });
    io.count(cameras, 64);
    for (SavedCamera& camera : cameras)
        cameraBytes(io, camera);
    io.demand(!Io::kReads || areCameras(cameras), "a camera sees nothing, or two have one name");
    keptBytes(io, kept);
    io.count(objects, 64);
    for (SceneObject& object : objects)
        objectBytes(io, object, tables), authorBytes(io, object);
    if constexpr (Io::kReads) demandOneScene(io, scene);
}

template void objectBytes(StringOut&, SceneObject&, SceneTables&);
template void objectBytes(ByteIn&, SceneObject&, SceneTables&);
template void authorBytes(StringOut&, SceneObject&);
template void authorBytes(ByteIn&, SceneObject&);
template void sceneBytes(StringOut&, Scene&, SceneTables&);
template void sceneBytes(ByteIn&, Scene&, SceneTables&);

void writeTables(ByteOut& out, const SceneTables& tables, const KnownParts& elsewhere) {
    writeTable(out, tables.soups,
               elsewhere.of<TriangleSoup>()); // first, where they lie as in memory: they are the most
    writeTable(out, tables.shared.images, elsewhere.of<TextureImage>());
    writeTable(out, tables.shared.paints, elsewhere.of<PaintedValues>());
    writeTable(out, tables.motions, elsewhere.of<Motion>());
}

void readTables(ByteIn& in, SceneTables& tables, const Elsewhere& elsewhere) {
    std::optional<KnownParts> asked;
    const auto known = [&]() -> const KnownParts& {
        return asked ? *asked : asked.emplace(elsewhere.parts());
    };
    readTable(in, tables.soups, readSoup, known, elsewhere.missing);
    readTable(in, tables.shared.images, readImage, known, elsewhere.missing);
    readTable(in, tables.shared.paints, readPainted, known, elsewhere.missing);
    readTable(in, tables.motions, readMotion, known, elsewhere.missing);
}

std::string bytesOf(const Scene& scene, const KnownParts& elsewhere) {
    SceneTables tables;
    StringOut values, out;
    sceneBytes(values, const_cast<Scene&>(scene), tables); // writing does not touch it
    writeTables(out, tables, elsewhere);
    return out.bytes + values.bytes;
}

Scene readScene(ByteIn& in, const Elsewhere& elsewhere) {
    SceneTables tables;
    readTables(in, tables, elsewhere);
    Scene scene;
    sceneBytes(in, scene, tables);
    return scene;
}

SceneObject withoutKept(SceneObject object) {
    object.kept = object.keptMesh = {};
    for (Surface& surface : object.surfaces)
        surface.kept = {};
    return object;
}

Scene withoutKept(Scene scene) {
    for (SceneObject& object : scene.objects)
        object = withoutKept(std::move(object));
    for (SavedCamera& camera : scene.cameras)
        camera.kept = camera.keptCamera = {};
    scene.kept = {};
    return scene;
}

} // namespace tactum
