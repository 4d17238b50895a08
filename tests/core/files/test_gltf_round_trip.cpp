// A scene in its own file: nothing is lost on the way there and back, of ours or of others.
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/save_scene.h"
#include "core/scene/selection_sets.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_round_trip {

using namespace tactum;
using tactum::test::difference;
using tactum::test::SceneDice;

namespace {

TriangleSoup lopsided() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}};
    return soup;
}

/// A world of another program: paint, a body, a camera below a mesh, an animated lamp, a second scene.
const std::string kForeign = R"(
"scene":0,"scenes":[{"nodes":[0,2,4],"extras":{"mood":"dark"}},{"name":"spare","nodes":[4]}],
"nodes":[{"name":"arm","translation":[0,1,0],"children":[1]},
{"name":"hand","mesh":0,"translation":[0,2,0],"children":[3],"extensions":{"THEIR_body":{"mass":3,"of":2}}},
{"name":"stone","mesh":0,"translation":[5,0,0]},
{"name":"eye","camera":0,"translation":[0,0,2]},{"name":"lamp","extras":{"watt":60}}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.01}}],
"materials":[{"name":"paint","extras":[1,2],"extensions":{"THEIR_paint":{"gloss":0.25,"map":{"index":0}}},
"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[0.5,0.25,1,0.5]}}],
"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],
"images":[{"name":"dot","uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNgAAAAAgABSK+kcQAAAABJRU5ErkJggg=="}],
"animations":[{"channels":[{"sampler":0,"target":{"node":4,"path":"translation"}}],"samplers":[{"input":2,"output":3}]}],
"extensionsUsed":["THEIR_paint","THEIR_body","THEIR_world"],"extensions":{"THEIR_world":{"wind":[1,0,0]}},
"extras":{"author":"Ada"},"theirArray":[{"a":1}])";

Json theirs() {
    Json json = Json::parse(asGltf(lopsided(), kForeign));
    json["meshes"][0]["primitives"][0]["material"] = 0;
    for (const char* type : {"SCALAR", "VEC3"}) // of the lamp's one key
        json["accessors"].push_back(
            {{"bufferView", 0}, {"componentType", 5126}, {"type", type}, {"count", 1}});
    return json;
}

/// A mesh with normals, so that corners at one position are several vertices, with two painted surfaces.
Scene painted() {
    auto soup = std::make_shared<TriangleSoup>(lopsided());
    soup->surfaceOf = {0, 1, 0};
    for (int i = 0; i < 9; ++i)
        soup->cornerNormals.push_back(i % 2 == 0 ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY());
    SceneObject object;
    object.name = "painted";
    object.geometry = soup;
    object.surfaces.resize(2);
    object.surfaces[0].name = "skin", object.surfaces[1].name = "nail";
    TextureLayer layer;
    layer.pattern.source = TextureSource::Painted;
    layer.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector{0.0F, 0.1F, 0.7F, 1.0F});
    object.surfaces[0].layers = {layer};
    layer.mask = layer.pattern;
    layer.pattern.painted.values =
        std::make_shared<const PaintedValues>(std::vector{1.0F, 0.2F, 0.0F, 1 / 3.0F});
    object.surfaces[1].layers = {layer};
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

std::size_t jsonLength(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    return length;
}

} // namespace

class TestGltfRoundTrip : public QObject {
    Q_OBJECT

    FileFolder folder_;

    Scene load(const std::string& glb) {
        const auto loaded = folder_.load(glb.starts_with("glTF") ? "scene.glb" : "scene.gltf", glb);
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return loaded->scene;
    }
    static std::string saved(const Scene& scene) {
        const auto glb = glbOf(scene);
        return glb ? *glb : throw std::runtime_error(glb.error().text);
    }

    /// The JSON of a glb.
    static Json jsonOf(const std::string& glb) { return Json::parse(glb.substr(20, jsonLength(glb))); }

private slots:
    void foreignMembersOfAWrongFormDoNotStopSaving() {
        for (const char* place : {"/materials/0/extensions", "/materials/0/pbrMetallicRoughness",
                                  "/meshes/0/extensions", "/nodes/1/extensions", "/nodes/2/extras",
                                  "/extensions", "/asset/extras", "/bufferViews/0/byteOffset"})
            for (const Json& wrong : {Json::array(), Json(7), Json("text"), Json(true), Json(-34962.5)}) {
                Json json = theirs();
                json[Json::json_pointer(place)] = wrong;
                const auto loaded = folder_.load("wrong.gltf", json.dump());
                if (!loaded) continue; // refused: as good
                QVERIFY2(glbOf(loaded->scene), place);
            }
    }

    void selectionSetsComeBack() {
        Scene scene = painted();
        scene.objects[0].sets = {{"nail & rim", {{1, 3}}}, {"skin", {{0, 1}, {2, 3}}}};
        const std::string glb = saved(scene);
        const Scene again = load(glb);
        QCOMPARE(difference(scene, again), std::string());
        QCOMPARE(saved(again), glb);
        Scene without = again;
        without.objects[0].sets.clear();
        QCOMPARE(load(saved(without)).objects[0].sets.size(), 0u);
    }

    /// Whatever stands there: the scene is read, and the sets that are whole are kept.
    void selectionSetsThatDoNotFitAreSaid() {
        Scene scene = painted();
        scene.objects[0].sets = {{"a", {{0, 2}}}, {"b", {{2, 3}}}};
        const auto files = gltfFilesOf(scene, "scene");
        VERIFY_RESULT(files);
        const Json whole = Json::parse(files->json);
        const std::string sets = "/meshes/0/extensions/TACTUM_haptics/sets";
        const auto readWith = [&](const std::string& place, const Json& value) {
            Json json = whole;
            json[Json::json_pointer(sets + place)] = value;
            folder_.write(files->binaryName, files->binary);
            return folder_.load("scene.gltf", json.dump());
        };
        const Json& parts = whole[Json::json_pointer(sets + "/parts")];
        const Json many(std::vector<Json>(kMaxSets + 1, parts[0]));
        const struct {
            const char* place;
            Json value;
            std::size_t kept;
            const char* what = ".sets has 1 set without a name";
        } cases[] = {{"/of", 4, 0, ".sets is of a mesh of other triangles"},
                     {"/of", "3", 0, ".sets is damaged"},
                     {"/parts", 7, 0, ".sets is damaged"},
                     {"/parts", many, 0, ".sets has more than 256 sets"},
                     {"", Json::array(), 0, ".sets is damaged"},
                     {"/parts/0", 7, 1},
                     {"/parts/0/name", Json(), 1},
                     {"/parts/0/name", "", 1},
                     {"/parts/0/name", "  ", 1},
                     {"/parts/0/name", "b", 1},
                     {"/parts/0/ranges", -1, 1},
                     {"/parts/0/ranges", 1e300, 1},
                     {"/parts/0/ranges", 100'000, 1},
                     {"/parts/0/ranges", 0, 1}}; // the positions
        for (const auto& [place, value, kept, what] : cases) {
            const auto loaded = readWith(place, value);
            VERIFY_RESULT(loaded);
            QCOMPARE(loaded->scene.objects[0].sets.size(), kept);
            const auto said = std::ranges::find_if(loaded->findings, [w = what](const Finding& finding) {
                return finding.sentence.find(w) != std::string::npos;
            });
            QVERIFY2(said != loaded->findings.end(), what);
        }
    }

    /// tinygltf takes it for none; so do the views that are moved together when they are written.
    void anOffsetThatIsNoWholeNumberIsNone() {
        for (const double offset : {4.5, -34962.5, 1e300}) {
            Json json = theirs();
            json["buffers"].push_back(json["buffers"][0]);
            json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", offset}, {"byteLength", 4}});
            json["accessors"][2]["bufferView"] = json["bufferViews"].size() - 1; // of the lamp's times
            const Scene scene = load(json.dump());
            const Json after = jsonOf(saved(scene));
            const Json& accessor =
                after["accessors"][after["animations"][0]["samplers"][0]["input"].get<int>()];
            const Json& view = after["bufferViews"][accessor["bufferView"].get<int>()];
            QCOMPARE(view["byteOffset"].get<std::size_t>() % 8, std::size_t(0));
            json.erase("extensionsUsed"); // which keeps meshes and their data from being left out
            saved(load(json.dump()));
        }
    }

    void whatOthersHavePutInStays() {
        const Json before = theirs();
        const auto loaded = folder_.load("theirs.gltf", before.dump());
        VERIFY_RESULT(loaded);
        Scene scene = loaded->scene;
        QCOMPARE(scene.objects.size(), std::size_t(2));
        scene.objects[0].surfaces[0].material.stiffness = 321; // what Tactum is for
        scene.objects[1].pose.translation += Vec3(1, 0, 0);
        const std::string first = saved(scene);
        for (const std::string& glb : {first, saved(load(first))}) {
            const Json after = jsonOf(glb);
            for (const char* path :
                 {"/materials/0/extensions/THEIR_paint", "/materials/0/extras",
                  "/materials/0/pbrMetallicRoughness/baseColorTexture", "/nodes/1/extensions/THEIR_body",
                  "/nodes/3/camera", "/cameras", "/extensions/THEIR_world", "/extras", "/theirArray",
                  "/textures/0", "/samplers", "/animations/0/channels/0/target", "/scenes/1/name",
                  "/scenes/0/extras/mood", "/images/0/name"}) {
                const Json::json_pointer place(path);
                QVERIFY2(after.contains(place), path);
                QVERIFY2(after.at(place) == before.at(place), path);
            }
            const Json& used = after.at("extensionsUsed");
            QCOMPARE_EQ(std::ranges::count(used, Json("THEIR_paint")), 1);
            const Scene again = load(glb);
            QCOMPARE(difference(scene, again), std::string());
        }
        QCOMPARE(saved(load(first)), first);
    }
    void othersFeelTheLargestSurface() {
        Scene scene = SceneDice(5).scene();
        scene.mechanics = {};
        for (SceneObject& object : scene.objects)
            for (Surface& surface : object.surfaces)
                surface.material = {1234, 0, 0.75, 0.5, 0};
        const std::string glb = saved(scene);
        Json json = jsonOf(glb);
        for (const Json& node : json["nodes"])
            if (node.contains("mesh"))
                QVERIFY(
                    node["extensions"]["KHR_physics_rigid_bodies"]["collider"].contains("physicsMaterial"));
        QCOMPARE_EQ(json["extensions"]["KHR_physics_rigid_bodies"]["physicsMaterials"][0]["staticFriction"],
                    0.75);
        // As another program would read them that does not know ours.
        for (const char* array : {"nodes", "meshes", "materials"})
            for (Json& element : json[array])
                if (element.contains("extensions")) element["extensions"].erase("TACTUM_haptics");
        json["extensions"].erase("TACTUM_haptics");
        const Scene again = load(packGlb(json, std::string_view(glb).substr(28 + jsonLength(glb))));
        const Material& felt = again.objects[0].surfaces[0].material;
        QVERIFY2(std::abs(felt.stiffness - 1234) < 0.1, std::to_string(felt.stiffness).c_str());
        QCOMPARE(felt.staticFriction, 0.75);
        COMPARE_NEAR(felt.dynamicFriction, 0.5, 1e-4, "");
        QCOMPARE_EQ(jsonOf(saved(again))["extensionsUsed"],
                    Json({"MPEG_haptic_material", "KHR_physics_rigid_bodies",
                          "TACTUM_haptics"})); // theirs stay, as they are
    }
    void hapticMaterialsWithoutUnitsAreTakenWithAWord() {
        Json json = theirs();
        json["extensionsUsed"].push_back("MPEG_haptic_material");
        json["extensions"]["MPEG_haptic_material"]["materials"] = Json::array(
            {{{"stiffness", Json::array({{{"texture", {{"index", 0}}}, {"type", "High_Resolution"}}})},
              {"vibrotactileTexture",
               Json::array({{{"texture", {{"index", 0}}}, {"type", "High_Resolution"}}})}}});
        json["meshes"][0]["extensions"]["MPEG_haptic_material"]["hapticMaterialIndex"] = 0;
        const auto loaded = folder_.load("theirs.gltf", json.dump());
        VERIFY_RESULT(loaded);
        COMPARE_CONTAINS(said(*loaded), "as it has no unit");
        const Surface& surface = loaded->scene.objects[0].surfaces[0];
        QCOMPARE(surface.layers.size(), std::size_t(1));
        QCOMPARE(surface.layers[0].strength, 1e-3);
        QCOMPARE(surface.material.stiffness, 0.0); // a black picture
    }
    /// Data of meshes that are objects now would be there twice, and twice more with the next program.
    void whatWasReadIsNotKeptTwice() {
        Json json = theirs();
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        std::string positions(3 * 4 * 30000, '\0');
        json["buffers"].push_back(
            {{"byteLength", positions.size()},
             {"uri", "data:application/octet-stream;base64," +
                         QByteArray::fromStdString(positions).toBase64().toStdString()}});
        json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", positions.size()}});
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", 5126},
                                     {"type", "VEC3"},
                                     {"count", 30000}});
        json["meshes"][0]["primitives"][0]["attributes"]["_WEAR"] = json["accessors"].size() - 1;
        const auto loaded = folder_.load("theirs.gltf", json.dump());
        VERIFY_RESULT(loaded);
        const std::string glb = saved(loaded->scene);
        QVERIFY2(glb.size() < 20000, std::to_string(glb.size()).c_str());
        const Json after = jsonOf(glb);
        const int input = after["animations"][0]["samplers"][0]["input"];
        QCOMPARE(after["accessors"][std::size_t(input)]["type"].get<std::string>(), std::string("SCALAR"));
        QCOMPARE(saved(load(glb)), glb);
    }
    /// The lamp hangs on a body that an edit moves.
    void foreignChildrenStayInTheWorld() {
        Json json = theirs();
        json["nodes"][3].erase("camera");
        json.erase("cameras");
        Scene scene = folder_.load("theirs.gltf", json.dump())->scene;
        scene.objects[0].pose = {Quat(Eigen::AngleAxisd(1, Vec3::UnitX())), {4, 5, 6}};
        const Json after = jsonOf(saved(scene));
        const auto matrix = after.at("nodes").at(3).at("matrix").get<std::vector<double>>();
        const Vec3 inBody(matrix[12], matrix[13], matrix[14]);
        COMPARE_NEAR(scene.objects[0].pose.apply(inBody), Vec3(0, 3, 2), 1e-12, "m");
    }
    /// Two surfaces, of one mesh and of different ones: values of the vertices, each list once.
    void whatIsPaintedIsAnAttribute() {
        const Scene scene = painted();
        const std::string glb = saved(scene);
        const Json json = jsonOf(glb);
        const Json& primitives = json["meshes"][0]["primitives"];
        QCOMPARE(primitives.size(), std::size_t(2));
        for (const Json& primitive : primitives) {
            const Json& attributes = primitive["attributes"];
            QVERIFY(attributes.contains("_TACTUM_PAINT_0"));
            QVERIFY(attributes.contains("_TACTUM_PAINT_1"));
            QVERIFY(!attributes.contains("_TACTUM_PAINT_2"));
            const Json &values = json["accessors"][attributes["_TACTUM_PAINT_0"].get<std::size_t>()],
                       &places = json["accessors"][attributes["POSITION"].get<std::size_t>()];
            QCOMPARE_EQ(values["type"], "SCALAR");
            QCOMPARE_EQ(values["componentType"], 5126);
            QCOMPARE_EQ(values["count"], places["count"]);
            QCOMPARE_GT(values["count"], 4); // vertices are split
        }
        const auto loaded = folder_.load("scene.glb", glb);
        VERIFY_RESULT(loaded);
        COMPARE_LACKS(said(*loaded), "PAINT");
        const std::string found = difference(scene, loaded->scene);
        QVERIFY2(found.empty(), found.c_str());
        const auto& layers = loaded->scene.objects[0].surfaces[0].layers;
        QCOMPARE_EQ(layers[0].pattern.painted.values->all(), std::vector<float>({0, 0.1F, 0.7F, 1}));
        QVERIFY(layers[0].pattern.painted.values ==
                loaded->scene.objects[0].surfaces[1].layers[0].mask->painted.values);
        QCOMPARE(saved(loaded->scene), glb);
    }
    /// As one does that knows nothing of ours but keeps the attributes of vertices.
    void whatIsPaintedStaysOnAMeshThatAnotherProgramHasChanged() {
        const std::string glb = saved(painted());
        Json json = jsonOf(glb);
        json["meshes"][0].erase("extensions");
        const Scene scene = load(packGlb(json, std::string_view(glb).substr(28 + jsonLength(glb))));
        const SceneObject& object = scene.objects[0];
        const auto& values = *object.surfaces[0].layers[0].pattern.painted.values;
        QCOMPARE(values.size(), object.geometry->positions.size());
        const std::vector<float> expected{0, 0.1F, 0.7F, 1};
        for (std::size_t i = 0; i < values.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                if (object.geometry->positions[i] == lopsided().positions[k])
                    QCOMPARE(values.all()[i], expected[k]);
    }
    /// What the file said before of where values are is not kept.
    void whatIsNoLongerPaintedIsGone() {
        Scene scene = load(saved(painted()));
        scene.objects[0].surfaces[0].layers[0].pattern.painted = {};
        auto& other = scene.objects[0].surfaces[1].layers[0].pattern.painted; // of another mesh now
        other.values = std::make_shared<const PaintedValues>(std::vector{0.5F, 0.25F});
        const std::string glb = saved(scene);
        const Json json = jsonOf(glb);
        const auto patternOf = [&](std::size_t material) {
            return json["materials"][material]["extensions"]["TACTUM_haptics"]["layers"][0]["pattern"];
        };
        QVERIFY(!patternOf(0).contains("painted"));
        QVERIFY(patternOf(1)["painted"].contains("bufferView"));
        QVERIFY(!patternOf(1)["painted"].contains("attribute"));
        const std::string found = difference(scene, load(glb));
        QVERIFY2(found.empty(), found.c_str());
    }
    void damagedPaintIsSaid_data() {
        QTest::addColumn<QString>("damage");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("gone") << "gone"
                              << "what is painted names values that are not there";
        QTest::newRow("few") << "few"
                             << "is not a number from 0 to 1 for each vertex";
        QTest::newRow("beyond") << "beyond"
                                << "is not a number from 0 to 1 for each vertex";
    }
    void damagedPaintIsSaid() {
        QFETCH(QString, damage);
        QFETCH(QString, sentence);
        const std::string glb = saved(painted());
        std::string binary(std::string_view(glb).substr(28 + jsonLength(glb)));
        Json json = jsonOf(glb);
        Json& values =
            json["accessors"]
                [json["meshes"][0]["primitives"][0]["attributes"]["_TACTUM_PAINT_0"].get<std::size_t>()];
        if (damage == "few") values["count"] = 2;
        if (damage == "gone")
            for (Json& primitive : json["meshes"][0]["primitives"])
                primitive["attributes"].erase("_TACTUM_PAINT_0");
        const float high = 2;
        if (damage == "beyond")
            std::memcpy(binary.data() +
                            json["bufferViews"][values["bufferView"].get<std::size_t>()]["byteOffset"]
                                .get<std::size_t>(),
                        &high, sizeof high);
        const auto loaded = folder_.load("scene.glb", packGlb(json, binary));
        QVERIFY(loaded.has_value());
        COMPARE_CONTAINS(said(*loaded), sentence.toStdString());
        QCOMPARE_EQ(loaded->scene.objects[0].surfaces[0].layers.size(), 1);
    }

    void whatALaterVersionAddsStays() {
        const std::string first = saved(SceneDice(3).scene());
        Json json = jsonOf(first);
        for (Json& material : json["materials"]) {
            material["extensions"]["TACTUM_haptics"]["heat"] = {{"warmth", 3}};
            for (Json& layer : material["extensions"]["TACTUM_haptics"]["layers"])
                layer["pattern"]["sparkle"] = true;
        }
        json["extensions"]["TACTUM_haptics"]["version"] = "1.7";
        json["extensions"]["TACTUM_haptics"]["tide"] = {0, -9.81, 0};
        const std::string later = packGlb(json, std::string_view(first).substr(28 + jsonLength(first)));
        const Json after = jsonOf(saved(load(later)));
        for (std::size_t i = 0; i < json["materials"].size(); ++i) {
            const Json& was = json["materials"][i]["extensions"]["TACTUM_haptics"];
            QCOMPARE_EQ(after["materials"][i]["extensions"]["TACTUM_haptics"], was);
        }
        QCOMPARE_EQ(after["extensions"]["TACTUM_haptics"]["tide"],
                    json["extensions"]["TACTUM_haptics"]["tide"]);
    }
    /// For the work space and the safety of a device: docs/format.md.
    void reservedKeysOfTheRootStay() {
        const std::string first = saved(SceneDice(4).scene());
        Json json = jsonOf(first);
        Json& ours = json["extensions"]["TACTUM_haptics"];
        ours["workspace"] = {{"low", {-0.1, 0, -0.1}}, {"high", {0.1, 0.1, 0.1}}};
        ours["safety"] = {{"force", 4.5}};
        std::string glb = packGlb(json, std::string_view(first).substr(28 + jsonLength(first)));
        for (int i = 0; i < 2; ++i) {
            Scene scene = load(glb);
            scene.proxyRadius *= 1.5; // ours is written anew
            glb = saved(scene);
            Json now = jsonOf(glb)["extensions"]["TACTUM_haptics"];
            QCOMPARE_EQ(now["workspace"], ours["workspace"]);
            QCOMPARE_EQ(now["safety"], ours["safety"]);
            QCOMPARE_EQ(now["proxyRadius"], scene.proxyRadius);
        }
    }
    void anotherMajorVersionIsRefused() {
        const std::string glb = saved(SceneDice(1).scene());
        Json json = jsonOf(glb);
        json["extensions"]["TACTUM_haptics"]["version"] = "2.0";
        const auto loaded =
            folder_.load("later.glb", packGlb(json, std::string_view(glb).substr(28 + jsonLength(glb))));
        QVERIFY(!loaded);
        COMPARE_CONTAINS(loaded.error().text, "later Tactum (version 2.0");
        const auto saving = saveScene(SceneDice(1).scene(), folder_.path() / "later.glb");
        QVERIFY(!saving);
        COMPARE_CONTAINS(saving.error().text, "choose another name");
        QVERIFY(!folder_.load("later.glb", packGlb(json, "")));
    }
    void randomScenesComeBackWhole() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const Scene scene = SceneDice(seed).scene();
            const std::string first = saved(scene);
            const Scene again = load(first);
            const std::string found = difference(scene, again);
            QVERIFY2(found.empty(), (std::to_string(seed) + ": " + found).c_str());
            const std::string second = saved(again);
            QVERIFY2(second == first, std::to_string(seed).c_str());
            if (const QString keep = qEnvironmentVariable("TACTUM_KEEP_SCENES"); !keep.isEmpty())
                std::ofstream(keep.toStdString() + "/" + std::to_string(seed) + ".glb", std::ios::binary)
                    << first;
        }
    }
};

TACTUM_TEST(TestGltfRoundTrip)

} // namespace test_gltf_round_trip

#include "test_gltf_round_trip.moc"
