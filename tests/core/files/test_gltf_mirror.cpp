// The feel in extras, for programs that drop our extension: everything that numbers and words can say comes
// back, and what does not is named.
#include <QTest>

#include "core/base/numbers.h"
#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/readers.h"
#include "core/scene/bodies.h"
#include "core/scene/world_fields.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_mirror {

using namespace tactum;
using tactum::test::SceneDice;

namespace {

struct Parts {
    Json json;
    std::string binary;

    explicit Parts(const Scene& scene) {
        const auto glb = glbOf(scene);
        if (!glb) throw std::runtime_error(glb.error().text);
        std::uint32_t length = 0;
        std::memcpy(&length, glb->data() + 12, 4);
        json = Json::parse(glb->substr(20, length));
        if (glb->size() > 28 + length) binary = glb->substr(28 + length);
    }
    std::string glb() const { return packGlb(json, binary); }
    Json& extras(std::size_t material = 0) { return json["materials"][material]["extras"]; }
};

void dropOurs(Json& json) {
    if (json.is_object()) json.erase("TACTUM_haptics");
    for (Json& each : json)
        if (each.is_structured()) dropOurs(each);
}

void dropExtensions(Json& json) {
    if (json.is_object())
        for (const char* key : {"extensions", "extensionsUsed"})
            json.erase(key);
    for (Json& each : json)
        if (each.is_structured()) dropExtensions(each);
}

/// As `gltf-transform copy` and Blender leave them.
Parts passedOn(const Scene& scene) {
    Parts parts(scene);
    dropExtensions(parts.json);
    return parts;
}

Scene plate() {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    soup->triangles = {{0, 2, 1}};
    soup->surfaceOf = {0};
    SceneObject object;
    object.name = "plate";
    object.geometry = soup;
    object.surfaces = {namedSurface("cork")};
    object.surfaces[0].material = {321, 1.5, 0.7, 0.3, 2.25};
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

/// What can go through extras: no pictures, and nothing painted.
std::vector<TextureLayer> withoutPictures(std::vector<TextureLayer> layers) {
    for (TextureLayer& layer : layers) {
        layer.pattern.image = nullptr, layer.pattern.painted = {};
        if (layer.mask) layer.mask->image = nullptr, layer.mask->painted = {};
    }
    return layers;
}

} // namespace

class TestGltfMirror : public QObject {
    Q_OBJECT

    FileFolder folder_;

    LoadedScene load(const Parts& parts) {
        const auto loaded = folder_.load("scene.glb", parts.glb());
        if (!loaded) throw std::runtime_error(loaded.error().text);
        return *loaded;
    }
    Surface surfaceOf(const Parts& parts) { return load(parts).scene.objects.at(0).surfaces.at(0); }

private slots:
    // Bodies stand in an extension that others keep: what the world they move in is like comes back beside
    // them.
    void theWorldOfBodiesComesBackWithoutOurExtension() {
        Scene scene = plate();
        makeBody(scene, scene.objects[0].id);
        scene.mechanics.airDensity = 1.2, scene.mechanics.forceScale = 50, scene.mechanics.timeScale = 0.002;
        Parts parts(scene);
        dropOurs(parts.json);
        const LoadedScene loaded = readGltf(Source::ofBytes("a.glb", parts.glb()), {});
        QCOMPARE(loaded.scene.mechanics.bodies.size(), std::size_t(1));
        for (const WorldField& field : kWorldFields)
            QCOMPARE(loaded.scene.mechanics.*field.value, scene.mechanics.*field.value);
        parts.json["scenes"][0]["extras"]["tactum_air_density"] = "thick";
        COMPARE_CONTAINS(said(load(parts)), "extras.airDensity is not a number that it may be");
    }

    void everyValueComesBackWithoutOurExtension() {
        int layers = 0;
        for (unsigned seed = 0; seed < 60; ++seed) {
            Scene scene = SceneDice(seed).scene();
            scene.mechanics = {};
            int number = 0; // a name for each to be found by
            for (SceneObject& object : scene.objects) {
                object.motion = nullptr, object.body = kWorldBody;
                object.name = std::to_string(++number);
                for (Surface& surface : object.surfaces)
                    surface.name = std::to_string(++number);
            }
            const Scene back = load(passedOn(scene)).scene;
            QCOMPARE(back.proxyRadius, scene.proxyRadius);
            for (const SceneObject& object : scene.objects)
                for (const Surface& surface : object.surfaces) {
                    const auto there = std::ranges::find(back.objects, object.name, &SceneObject::name);
                    if (there == back.objects.end()) continue; // without triangles
                    const auto felt = std::ranges::find(there->surfaces, surface.name, &Surface::name);
                    if (felt == there->surfaces.end()) continue;
                    QCOMPARE(felt->material, surface.material);
                    QCOMPARE(felt->shading, surface.shading);
                    QCOMPARE(felt->sides, surface.sides);
                    QCOMPARE(felt->visible, surface.visible);
                    QCOMPARE(felt->locked, surface.locked);
                    QVERIFY(felt->layers == withoutPictures(surface.layers));
                    layers += int(felt->layers.size());
                }
        }
        QCOMPARE_GT(layers, 50);
    }

    void itIsSaidWhatComesFromExtrasAndWhatIsLost() {
        Scene scene = plate();
        const std::string usual = said(load(Parts(scene))); // of its shape
        Parts parts = passedOn(scene);
        COMPARE_CONTAINS(said(load(parts)), "the feel of 1 material comes from extras");
        TextureLayer grain;
        grain.name = "grain";
        grain.pattern.source = TextureSource::Image;
        scene.objects[0].surfaces[0].layers = {grain};
        COMPARE_CONTAINS(said(load(passedOn(scene))),
                         "layer \"grain\" of material \"cork\" has lost its picture");
        parts.json["materials"][0].erase("extras");
        COMPARE_CONTAINS(said(load(parts)), "\"cork\" has lost its feel");
        parts.json["scenes"][0].erase("extras"); // as if it had never been ours
        QCOMPARE(said(load(parts)), usual);
    }

    void whatIsChangedElsewhereCounts() {
        Parts parts = passedOn(plate());
        parts.extras()["tactum_stiffness"] = 99;
        parts.extras()["tactum_sides"] = "front";
        parts.extras()["tactum_shading_on"] = 1; // Blender 3.4 has no truth values
        const Surface surface = surfaceOf(parts);
        QCOMPARE(surface.material.stiffness, 99.0);
        QVERIFY(surface.sides == Sides::Front && surface.shading.on);
    }

    void ourExtensionCountsMore() {
        Parts parts(plate());
        parts.extras()["tactum_stiffness"] = 99;
        QCOMPARE(surfaceOf(parts).material.stiffness, 321.0);
    }

    void extrasOfOthersStayAndAreNotMixedWithOurs() {
        Parts parts(plate());
        parts.extras()["maker"] = "Ada";
        const Parts again(load(parts).scene);
        QVERIFY(again.json["materials"][0]["extras"] == parts.extras());
        parts.extras() = Json::array({1, 2});
        QVERIFY(Parts(load(parts).scene).extras() == parts.extras());
    }

    /// The properties, ranges and initial values that it shows.
    void theAddOnForBlenderHasOurTable() {
        std::ifstream file(TACTUM_SAMPLES "/../blender/tactum_haptics.py");
        const std::string text(std::istreambuf_iterator<char>(file), {});
        for (const MaterialField& field : kMaterialFields) {
            const Parameter& parameter = *field.parameter;
            std::string key = "tactum_" + std::string(parameter.key);
            std::ranges::replace(key, '-', '_');
            std::string row = "(\"" + key + "\", \"" + std::string(parameter.label) + "\", \"" +
                              std::string(parameter.unit) + "\"";
            for (const double number : {parameter.minimum, parameter.maximum, parameter.initial})
                appendNumber(row += ", ", number);
            COMPARE_CONTAINS(text, row + "),");
        }
    }

    void whatIsNoFeelIsSaid() {
        const Json deep = Json(std::string(100000, '[') + std::string(100000, ']'));
        for (const auto& [key, wrong] : {std::pair<const char*, Json>{"stiffness", "hard"},
                                         {"sides", 7},
                                         {"shading_on", "yes"},
                                         {"layers", 5},
                                         {"layers", "no JSON"},
                                         {"layers", deep}}) {
            Parts parts = passedOn(plate());
            parts.extras()[std::string("tactum_") + key] = wrong;
            const LoadedScene loaded = load(parts);
            COMPARE_CONTAINS(said(loaded), "material \"cork\": extras");
            QVERIFY(loaded.scene.objects[0].surfaces[0].layers.empty());
        }
    }
};

TACTUM_TEST(TestGltfMirror)

} // namespace test_gltf_mirror

#include "test_gltf_mirror.moc"
