#include "core/recording/scene_bytes.h"

#include <algorithm>
#include <set>

namespace tactum {
namespace {

/// Beyond this a recording names its geometry instead of holding it.
constexpr std::size_t kMostTriangles = 200'000, kMostTexels = std::size_t(1) << 24;
/// Surfaces of all scenes together: more would be no minute's work of a person.
constexpr std::size_t kMostSurfaces = std::size_t(1) << 22;

template <class T> using Shared = std::shared_ptr<const T>;

/// What objects share, each once.
struct Tables {
    std::vector<Shared<TextureImage>> images;
    std::vector<Shared<TriangleSoup>> soups;
    std::vector<Shared<Motion>> motions;
    std::vector<SceneObject> objects;
};

/// A reference into a table: 0 for none. Writing fills the table.
template <class Io, class T> void link(Io& io, Shared<T>& to, std::vector<Shared<T>>& table) {
    std::uint32_t number = 0;
    if constexpr (!Io::kReads) {
        const auto found = std::ranges::find(table, to);
        number = to ? std::uint32_t(found - table.begin()) + 1 : 0;
        if (to && found == table.end()) table.push_back(to);
    }
    io(number);
    io.demand(number <= table.size(), "it names what it does not have");
    if constexpr (Io::kReads) to = number == 0 ? nullptr : table[number - 1];
}

/// Values of a parameter table by their keys: a recording outlives a change of the table.
template <class Io, class Table, class Values> void numbers(Io& io, const Table& table, Values& values) {
    std::uint32_t count = std::uint32_t(table.size());
    io(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        std::string key;
        double value = 0;
        if constexpr (!Io::kReads) {
            key = std::string(table[i].parameter->key);
            value = values.*table[i].value;
        }
        io(key), io(value);
        if constexpr (Io::kReads)
            for (const auto& field : table)
                if (field.parameter->key == key) values.*field.value = value;
    }
}

template <class Io> void pattern(Io& io, TexturePattern& p, Tables& tables) {
    choose(io, p.source, kTextureSources.size());
    choose(io, p.mapping, kTextureMappings.size());
    link(io, p.image, tables.images);
    io(p.frame);
    numbers(io, kPatternFields, p);
}

template <class Io> void layer(Io& io, TextureLayer& l, Tables& tables) {
    io(l.name), io(l.enabled), io(l.strength), io(l.opacity), io(l.ownPlane);
    choose(io, l.target, kTextureTargets.size());
    choose(io, l.blend, kTextureBlends.size());
    pattern(io, l.pattern, tables);
    bool masked = l.mask.has_value();
    io(masked);
    if (!masked) return;
    if (!l.mask) l.mask.emplace();
    pattern(io, *l.mask, tables);
}

template <class Io> void surface(Io& io, Surface& s, Tables& tables) {
    io(s.name), io(s.colour), io(s.shading.on), io(s.shading.creaseAngle);
    choose(io, s.shading.normals, 2);
    choose(io, s.sides, 3);
    numbers(io, kMaterialFields, s.material);
    io.count(s.layers, 64);
    for (TextureLayer& each : s.layers)
        layer(io, each, tables);
}

template <class Io> void object(Io& io, SceneObject& o, Tables& tables) {
    io(o.id), io(o.name), io(o.pose), io(o.visible);
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

template <class T> void writeTable(FileOut& out, std::vector<Shared<T>>& table, bool whole) {
    out.count(table, 1);
    for (const Shared<T>& each : table) {
        std::uint64_t fingerprint = fingerprintOf(*each);
        out(whole), out(fingerprint);
        if (whole) write(out, *each);
    }
}

/// `known`: the table of KnownParts.
template <class T, class Read, class Known>
void readTable(FileIn& in, std::vector<Shared<T>>& table, Read read, Known known) {
    in.count(table, 9);
    for (Shared<T>& each : table) {
        bool whole = false;
        std::uint64_t fingerprint = 0;
        in(whole), in(fingerprint);
        if (whole) {
            each = read(in);
            in.demand(fingerprintOf(*each) == fingerprint, "geometry or an image has changed");
            continue;
        }
        const std::vector<Shared<T>>& parts = known();
        const auto found = std::ranges::find_if(
            parts, [&](const Shared<T>& part) { return fingerprintOf(*part) == fingerprint; });
        if (found == parts.end())
            throw RecordingFault{{Error::Kind::Input,
                                  "the recording: the model that it was made with was changed or is not "
                                  "there; put the file back beside the recording"}};
        each = *found;
    }
}

/// One row of numbers for each scene; an object that is as it was in the scene before is the same one.
template <class Io> void scenes(Io& io, std::vector<RecordedScene>& list, Tables& tables) {
    io.count(list, 32);
    std::vector<std::uint32_t> before;
    std::size_t surfaces = 0;
    for (RecordedScene& each : list) {
        io(each.numbers.revision), io(each.numbers.shapeRevision), io.bulk(each.numbers.placedIn);
        Scene scene = each.scene ? *each.scene : Scene{};
        io(scene.proxyRadius);
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
                io.demand(surfaces <= kMostSurfaces, "it has more surfaces than there can be");
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
                if (felt.pattern.image) images.push_back(felt.pattern.image);
                if (felt.mask && felt.mask->image) images.push_back(felt.mask->image);
            }
    }
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
    }
    return triangles <= kMostTriangles && texels <= kMostTexels;
}

// What is named comes before what names it, and is known only after.
std::string sceneBytes(const std::vector<RecordedScene>& list, bool whole) {
    std::vector<RecordedScene> copy = list;
    Tables tables;
    FileOut versions, objects, shapes;
    scenes(versions, copy, tables);
    objects.count(tables.objects, 1);
    for (std::size_t i = 0; i < tables.objects.size(); ++i)
        object(objects, tables.objects[i], tables);
    writeTable(shapes, tables.images, whole);
    writeTable(shapes, tables.soups, whole);
    shapes.count(tables.motions, 1);
    for (const auto& each : tables.motions)
        write(shapes, *each);
    return shapes.bytes + objects.bytes + versions.bytes;
}

std::vector<RecordedScene> readScenes(FileIn& in, const std::function<KnownParts()>& find) {
    Tables tables;
    std::optional<KnownParts> known;
    const auto parts = [&]() -> const KnownParts& { return known ? *known : known.emplace(find()); };
    readTable(
        in, tables.images, readImage, [&]() -> const auto& { return parts().images; });
    readTable(
        in, tables.soups, readSoup, [&]() -> const auto& { return parts().soups; });
    in.count(tables.motions, 32);
    for (auto& each : tables.motions)
        each = readMotion(in);
    in.count(tables.objects, 64);
    for (SceneObject& each : tables.objects)
        object(in, each, tables);
    std::vector<RecordedScene> list;
    scenes(in, list, tables);
    return list;
}

} // namespace tactum
