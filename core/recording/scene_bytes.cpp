#include "core/recording/scene_bytes.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/recording/fingerprint.h"
#include "core/scene/layer_bytes.h"
#include "core/scene/mechanics_bytes.h"
#include "core/scene/shape_bytes.h"

namespace tactum {
namespace {

/// Beyond this a recording names its geometry instead of holding it.
constexpr std::size_t kMaxTriangles = 200'000, kMaxTexels = std::size_t(1) << 24;
/// Surfaces of all scenes together: more would be no minute's work of a person.
constexpr std::size_t kMaxSurfaces = std::size_t(1) << 22;

/// What objects share, each once.
struct Tables {
    LayerTables shared;
    SharedTable<TriangleSoup> soups;
    SharedTable<Motion> motions;
    std::vector<SceneObject> objects;
};

template <class Io> void surface(Io& io, Surface& s, Tables& tables) {
    io(s.name), io(s.colour), io(s.shading.on), io(s.shading.creaseAngle);
    choose(io, s.shading.normals, 2);
    choose(io, s.sides, kSidesNames.size());
    io(s.visible);
    numbersByKey(io, kMaterialFields, s.material);
    io.count(s.layers, 64);
    for (TextureLayer& each : s.layers)
        layerBytes(io, each, tables.shared);
}

template <class Io> void object(Io& io, SceneObject& o, Tables& tables) {
    io(o.id), io(o.name), io(o.pose), io(o.visible), io(o.body);
    link(io, o.motion, tables.motions);
    link(io, o.geometry, tables.soups);
    io.count(o.surfaces, 64);
    for (Surface& each : o.surfaces)
        surface(io, each, tables);
    if constexpr (!Io::kReads) return;
    io.demand(o.geometry != nullptr, "an object has no geometry");
    const bool known =
        std::ranges::all_of(o.geometry->surfaceOf, [&](Index index) { return index < o.surfaces.size(); });
    io.demand(known, "a triangle is of a surface that there is not");
}

template <class T, class Parts> void writeTable(ByteOut& out, SharedTable<T>& table, const Parts& elsewhere) {
    std::set<std::uint64_t> known;
    for (const auto& part : elsewhere)
        known.insert(fingerprintOf(*part));
    out.count(table.items, 1);
    for (const auto& each : table.items) {
        std::uint64_t fingerprint = fingerprintOf(*each);
        bool whole = !known.contains(fingerprint);
        out(whole), out(fingerprint);
        if (whole) write(out, *each);
    }
}

/// `known`: the table of KnownParts.
template <class T, class Read, class Known>
void readTable(ByteIn& in, SharedTable<T>& table, Read read, Known known) {
    in.count(table.items, 9);
    for (auto& each : table.items) {
        bool whole = false;
        std::uint64_t fingerprint = 0;
        in(whole), in(fingerprint);
        if (whole) {
            each = read(in);
            in.demand(fingerprintOf(*each) == fingerprint,
                      "geometry, an image or painted values have changed");
            continue;
        }
        const auto& parts = known();
        const auto found = std::ranges::find_if(
            parts, [&](const auto& part) { return fingerprintOf(*part) == fingerprint; });
        if (found == parts.end())
            throw ByteFault{{Error::Kind::Input,
                             "the recording: the model that it was made with was changed or is not "
                             "there; put the file back beside the recording"}};
        each = *found;
    }
}

/// One row of numbers for each scene; an object that is as it was in the scene before is the same one.
template <class Io> void scenes(Io& io, std::vector<RecordedScene>& list, Tables& tables) {
    io.count(list, 32);
    std::vector<std::uint32_t> before;
    std::optional<Mechanics> mechanics; ///< of the scene before
    std::size_t surfaces = 0;
    for (RecordedScene& each : list) {
        io(each.numbers.revision), io(each.numbers.shapeRevision), io.bulk(each.numbers.placedIn);
        Scene scene = each.scene ? *each.scene : Scene{};
        io(scene.proxyRadius);
        bool still = mechanics && *mechanics == scene.mechanics;
        io(still);
        io.demand(!still || mechanics, "the first scene has the bodies of the one before it");
        if (!still)
            mechanicsBytes(io, scene.mechanics);
        else if constexpr (Io::kReads)
            scene.mechanics = *mechanics;
        mechanics = scene.mechanics;
        std::vector<std::uint32_t> numbers(scene.objects.size());
        if constexpr (!Io::kReads)
            for (std::size_t i = 0; i < scene.objects.size(); ++i) {
                const bool same = i < before.size() && tables.objects[before[i]] == scene.objects[i];
                numbers[i] = same ? before[i] : std::uint32_t(tables.objects.size());
                if (!same) tables.objects.push_back(scene.objects[i]);
            }
        io.bulk(numbers);
        if constexpr (Io::kReads) {
            for (const std::uint32_t number : numbers) {
                io.demand(number < tables.objects.size(), "a scene names an object that there is not");
                surfaces += tables.objects[number].surfaces.size() + 1;
                io.demand(surfaces <= kMaxSurfaces, "it has more surfaces than there can be");
                scene.objects.push_back(tables.objects[number]);
            }
            each.scene = std::make_shared<const Scene>(std::move(scene));
        }
        before = std::move(numbers);
    }
}

} // namespace

void KnownParts::addAllOf(const Scene& scene) {
    for (const SceneObject& each : scene.objects) {
        if (each.geometry) soups.push_back(each.geometry);
        for (const Surface& part : each.surfaces)
            for (const TextureLayer& felt : part.layers) {
                add(felt.pattern);
                if (felt.mask) add(*felt.mask);
            }
    }
}

void KnownParts::add(const TexturePattern& pattern) {
    if (pattern.image) images.push_back(pattern.image);
    if (pattern.painted.values) paints.push_back(pattern.painted.values);
}

bool areSmall(const std::vector<RecordedScene>& list) {
    std::set<const void*> seen;
    std::size_t triangles = 0, texels = 0;
    for (const RecordedScene& each : list) {
        KnownParts parts;
        parts.addAllOf(*each.scene);
        for (const auto& geometry : parts.soups)
            if (seen.insert(geometry.get()).second) triangles += geometry->triangles.size();
        for (const auto& image : parts.images)
            if (seen.insert(image.get()).second)
                texels += std::size_t(image->width()) * std::size_t(image->height());
        for (const auto& painted : parts.paints)
            if (seen.insert(painted.get()).second) texels += painted->size();
    }
    return triangles <= kMaxTriangles && texels <= kMaxTexels;
}

// What is named comes before what names it, and is known only after.
std::string sceneBytes(const std::vector<RecordedScene>& list, const KnownParts& elsewhere) {
    std::vector<RecordedScene> copy = list;
    Tables tables;
    StringOut versions, objects, shapes;
    scenes(versions, copy, tables);
    objects.count(tables.objects, 1);
    for (std::size_t i = 0; i < tables.objects.size(); ++i)
        object(objects, tables.objects[i], tables);
    writeTable(shapes, tables.shared.images, elsewhere.images);
    writeTable(shapes, tables.shared.paints, elsewhere.paints);
    writeTable(shapes, tables.soups, elsewhere.soups);
    shapes.count(tables.motions.items, 1);
    for (const auto& each : tables.motions.items)
        write(shapes, *each);
    return shapes.bytes + objects.bytes + versions.bytes;
}

std::vector<RecordedScene> readScenes(ByteIn& in, const std::function<KnownParts()>& find) {
    Tables tables;
    std::optional<KnownParts> known;
    const auto parts = [&]() -> const KnownParts& { return known ? *known : known.emplace(find()); };
    readTable(
        in, tables.shared.images, readImage, [&]() -> const auto& { return parts().images; });
    readTable(
        in, tables.shared.paints, readPainted, [&]() -> const auto& { return parts().paints; });
    readTable(
        in, tables.soups, readSoup, [&]() -> const auto& { return parts().soups; });
    in.count(tables.motions.items, 32);
    for (auto& each : tables.motions.items)
        each = readMotion(in);
    in.count(tables.objects, 64);
    for (SceneObject& each : tables.objects)
        object(in, each, tables);
    std::vector<RecordedScene> list;
    scenes(in, list, tables);
    return list;
}

} // namespace tactum
