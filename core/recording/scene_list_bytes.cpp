#include "core/recording/scene_list_bytes.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/scene/mechanics_bytes.h"
#include "core/scene/scene_bytes.h"

namespace tactum {
namespace {

/// Beyond this a recording names its geometry instead of holding it.
constexpr std::size_t kMaxTriangles = 200'000, kMaxTexels = std::size_t(1) << 24;
/// Surfaces of all scenes together: more would be no minute's work of a person.
constexpr std::size_t kMaxSurfaces = std::size_t(1) << 22;

/// What the scenes have in common.
struct Tables {
    SceneTables shared;
    std::vector<SceneObject> objects;
};

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
                if (!same) tables.objects.push_back(withoutKept(scene.objects[i]));
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

bool areSmall(const std::vector<RecordedScene>& list) {
    std::set<const void*> seen;
    std::size_t triangles = 0, texels = 0;
    const auto add = [&]<class T>(const T& part) {
        if constexpr (std::is_same_v<T, TriangleSoup>) triangles += part.triangles.size();
        if constexpr (std::is_same_v<T, TextureImage>)
            texels += std::size_t(part.width()) * std::size_t(part.height());
        if constexpr (std::is_same_v<T, PaintedValues>) texels += part.size();
    };
    for (const RecordedScene& each : list) {
        for (const SceneObject& object : each.scene->objects)
            forEachPart(object, [&](const auto& part) {
                if (seen.insert(part.get()).second) add(*part);
            });
    }
    return triangles <= kMaxTriangles && texels <= kMaxTexels;
}

std::string sceneBytes(const std::vector<RecordedScene>& list, const KnownParts& elsewhere) {
    std::vector<RecordedScene> copy = list;
    Tables tables;
    StringOut versions, objects, shapes;
    scenes(versions, copy, tables);
    objects.count(tables.objects, 1);
    for (SceneObject& each : tables.objects)
        objectBytes(objects, each, tables.shared);
    writeTables(shapes, tables.shared, elsewhere);
    return shapes.bytes + objects.bytes + versions.bytes;
}

std::vector<RecordedScene> readScenes(ByteIn& in, const std::function<KnownParts()>& find) {
    Tables tables;
    readTables(in, tables.shared,
               {find,
                {Error::Kind::Input,
                 "the recording: the model that it was made with was changed or is not there; put the file "
                 "back beside the recording"}});
    in.count(tables.objects, 64);
    for (SceneObject& each : tables.objects)
        objectBytes(in, each, tables.shared);
    std::vector<RecordedScene> list;
    scenes(in, list, tables);
    return list;
}

} // namespace tactum
