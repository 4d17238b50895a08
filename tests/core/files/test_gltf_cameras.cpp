// Saved cameras as cameras of glTF: there and back to the bit, those of other programs, and damaged ones.
#include <numbers>

#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/readers.h"
#include "core/scene/placing.h"
#include "tests/core/files/glb_json.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_cameras {

using namespace tactum;
using tactum::test::difference;
using test::jsonOf;
using test::saved;
using test::withJson;

namespace {

TriangleSoup sheet() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    soup.triangles = {{0, 1, 2}};
    return soup;
}

Scene sheetScene() {
    auto soup = std::make_shared<TriangleSoup>(sheet());
    soup->surfaceOf = {0};
    SceneObject object;
    object.name = "sheet";
    object.geometry = soup;
    object.surfaces = {namedSurface("paper")};
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

SavedCamera camera(const std::string& name, bool parallel) {
    SavedCamera made;
    made.name = name;
    made.pose = {Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), {0.1, 0.2, 1 / 3.0}};
    made.parallel = parallel;
    (parallel ? made.height : made.angle) = 0.6180339887;
    made.ahead = 0.7;
    return made;
}

/// A file of another program: one camera on a bare node, one below a node that is scaled and moved, one that
/// an animation moves, one that nothing can be seen by.
std::string theirs(const std::string& lens = R"({"type":"perspective","perspective":{"yfov":0}})") {
    return asGltf(sheet(), R"(
"scene":0,"scenes":[{"nodes":[0,1,2,4,5]}],
"nodes":[{"name":"sheet","mesh":0},
{"name":"front","camera":0,"translation":[0.25,0.5,4],"extras":{"crew":1}},
{"name":"stand","translation":[10,0,0],"scale":[2,2,2],"children":[3]},
{"camera":1,"translation":[0,1,0],"rotation":[-0.7071067811865475,0,0,0.7071067811865476]},
{"name":"rides","camera":0},{"name":"blind","camera":2}],
"cameras":[{"name":"wide","type":"perspective","extras":{"film":35},
"perspective":{"aspectRatio":1.5,"yfov":0.7,"znear":0.01}},
{"name":"plan","type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0.1,"zfar":50}},)" +
                               lens + R"(],
"animations":[{"channels":[{"sampler":0,"target":{"node":4,"path":"translation"}}],"samplers":[{"input":2,"output":3}]}])");
}

} // namespace

class TestGltfCameras : public QObject {
    Q_OBJECT

    FileFolder folder_;

    LoadedScene load(const std::string& bytes) {
        const auto loaded = folder_.load(bytes.starts_with("glTF") ? "scene.glb" : "scene.gltf", bytes);
        if (!loaded) throw std::runtime_error(loaded.error().text);
        return *loaded;
    }
    /// With the two keys of the animation.
    std::string theirsWhole() {
        Json json = Json::parse(theirs());
        for (const char* type : {"SCALAR", "VEC3"})
            json["accessors"].push_back(
                {{"bufferView", 0}, {"componentType", 5126}, {"type", type}, {"count", 1}});
        return json.dump();
    }

private slots:
    void camerasComeBack() {
        Scene scene = sheetScene();
        scene.cameras = {camera("eye & \"ear\"", false), camera("plan", true), camera("near", false)};
        scene.cameras[2].near = 0.05, scene.cameras[2].far = 3;
        const std::string glb = saved(scene);
        const LoadedScene again = load(glb);
        COMPARE_LACKS(said(again), "camera");
        QCOMPARE(difference(scene, again.scene), std::string());
        QCOMPARE(saved(again.scene), glb);
        Scene without = again.scene;
        without.cameras.clear();
        const Json json = jsonOf(saved(without));
        QVERIFY(!json.contains("cameras"));
        QCOMPARE(json["nodes"].size(), std::size_t(1));
    }

    /// What Blender and three.js read.
    void theyAreCamerasOfGltf() {
        Scene scene = sheetScene();
        scene.cameras = {camera("eye", false), camera("plan", true)};
        const Json json = jsonOf(saved(scene));
        QCOMPARE(json["cameras"].size(), std::size_t(2));
        const Json &eye = json["nodes"][1], &lens = json["cameras"][0], &plan = json["cameras"][1];
        QCOMPARE_EQ(eye["name"], "eye");
        QCOMPARE_EQ(eye["camera"], 0);
        COMPARE_NEAR(eye["translation"][1].get<double>(), 0.2, 1e-15, "m");
        QCOMPARE_EQ(lens["type"], "perspective");
        COMPARE_NEAR(lens["perspective"]["yfov"].get<double>(), 0.6180339887, 1e-15, "rad");
        QCOMPARE_GT(lens["perspective"]["znear"].get<double>(), 0);
        QCOMPARE_EQ(plan["type"], "orthographic");
        COMPARE_NEAR(plan["orthographic"]["ymag"].get<double>(), 0.5 * 0.6180339887, 1e-15, "m");
        COMPARE_NEAR(plan["orthographic"]["xmag"].get<double>(), 0.5 * 0.6180339887 * 16 / 9, 1e-15, "m");
        QCOMPARE_GT(plan["orthographic"]["zfar"].get<double>(), plan["orthographic"]["znear"].get<double>());
        const Json& shown = json["scenes"][0]["nodes"];
        for (const int node : {1, 2})
            QVERIFY(std::ranges::find(shown, Json(node)) != shown.end());
    }

    void thoseOfOtherProgramsAreOffered() {
        const LoadedScene loaded = load(theirsWhole());
        const auto& cameras = loaded.scene.cameras;
        QCOMPARE(cameras.size(), std::size_t(2));
        QCOMPARE(cameras[0].name, std::string("front"));
        COMPARE_NEAR(cameras[0].pose.translation, Vec3(0.25, 0.5, 4), 1e-15, "m");
        COMPARE_NEAR(cameras[0].angle, 0.7, 1e-15, "rad");
        COMPARE_NEAR(cameras[0].ahead, 4, 1e-12, "m");  // the sheet is there
        QCOMPARE(cameras[1].name, std::string("plan")); // of the camera, for its node has none
        QVERIFY(cameras[1].parallel);
        COMPARE_NEAR(cameras[1].height, 4, 1e-15, "m");
        COMPARE_NEAR(cameras[1].pose.translation, Vec3(10, 2, 0), 1e-12, "m");
        COMPARE_NEAR(cameras[1].pose.rotate(-Vec3::UnitZ()), Vec3(0, -1, 0), 1e-12, "");
        COMPARE_CONTAINS(said(loaded), "camera \"blind\" has no lens");
        COMPARE_LACKS(said(loaded), "rides");
    }

    /// Once more, scaled as a person's hand demands, and then to the bit.
    void whatOtherProgramsPutBesideThemStays() {
        Scene scene = load(theirsWhole()).scene;
        scaleScene(scene, 0.1, Vec3::Zero());
        const std::string first = saved(scene);
        const Json json = jsonOf(first);
        QCOMPARE(json["cameras"].size(), std::size_t(3));
        const Json& wide = json["cameras"][0];
        QCOMPARE_EQ(wide["name"], "wide");
        QCOMPARE_EQ(wide["extras"]["film"], 35);
        QCOMPARE_EQ(wide["perspective"]["aspectRatio"], 1.5);
        COMPARE_NEAR(wide["perspective"]["znear"].get<double>(), 0.001, 1e-15, "m");
        QVERIFY(!wide["perspective"].contains("zfar"));
        COMPARE_NEAR(json["cameras"][1]["orthographic"]["xmag"].get<double>(), 0.3, 1e-15, "m");
        QCOMPARE_EQ(json["nodes"][1]["extras"]["crew"], 1);
        QCOMPARE_EQ(json["nodes"][4]["camera"], 0); // the one that moves is where it was
        QCOMPARE_EQ(json["nodes"][5]["camera"], 2);
        const Scene again = load(first).scene;
        QCOMPARE(difference(scene, again), std::string());
        QCOMPARE(saved(again), first);
    }

    void oneThatIsRemovedIsGone() {
        Scene scene = load(theirsWhole()).scene;
        removeCamera(scene, "front");
        renameCamera(scene, "plan", "from above");
        const Scene again = load(saved(scene)).scene;
        QCOMPARE(again.cameras.size(), std::size_t(1));
        QCOMPARE(again.cameras[0].name, std::string("from above"));
    }

    /// Blender writes a file of ours anew: without what it does not know, and with a camera more.
    void withoutOurExtensionTheyAreThere() {
        Scene scene = sheetScene();
        scene.cameras = {camera("eye", false)};
        const std::string glb = saved(scene);
        Json json = jsonOf(glb);
        json["nodes"][1].erase("extensions");
        json["extensions"].erase("TACTUM_haptics");
        const auto cameras = load(withJson(glb, json)).scene.cameras;
        QCOMPARE(cameras.size(), std::size_t(1));
        QCOMPARE(cameras[0].angle, scene.cameras[0].angle);
        COMPARE_NEAR(cameras[0].pose.translation, scene.cameras[0].pose.translation, 1e-12, "m");
    }

    void oneThatAnotherProgramAddsToOursIsOurs() {
        Scene scene = sheetScene();
        scene.cameras = {camera("eye", false)};
        const std::string glb = saved(scene);
        Json json = jsonOf(glb);
        json["cameras"].push_back(
            {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
        json["nodes"].push_back({{"name", "eye"}, {"camera", 1}, {"translation", {0, 0, 9}}});
        json["scenes"][0]["nodes"].push_back(2);
        const Scene loaded = load(withJson(glb, json)).scene;
        QCOMPARE(loaded.cameras.size(), std::size_t(2));
        QCOMPARE(loaded.cameras[1].name, std::string("eye 2"));
        const std::string first = saved(loaded);
        QCOMPARE(jsonOf(first)["cameras"].size(), std::size_t(2));
        const Scene again = load(first).scene;
        QCOMPARE(difference(loaded, again), std::string());
        QCOMPARE(saved(again), first);
    }

    /// The scene is there whatever stands in its cameras, and one sentence for each that is left out.
    void damagedOnesAreLeftOut() {
        const char* lenses[] = {
            "7",
            "{}",
            R"({"type":"perspective"})",
            R"({"type":"perspective","perspective":[1]})",
            R"({"type":"perspective","perspective":{"yfov":"wide"}})",
            R"({"type":"perspective","perspective":{"yfov":-1,"znear":0.1}})",
            R"({"type":"perspective","perspective":{"yfov":3.2,"znear":0.1}})",
            R"({"type":"perspective","perspective":{"yfov":1,"znear":-1}})",
            R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":0}})",
            R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":-2}})",
            R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1e300}})",
            R"({"type":"orthographic","perspective":{"yfov":1}})",
            R"({"type":["perspective"],"perspective":{"yfov":null}})",
        };
        for (const char* lens : lenses) {
            Json json = Json::parse(theirs(lens));
            json.erase("animations");
            const auto loaded = folder_.load("scene.gltf", json.dump());
            QVERIFY2(loaded, lens);
            QCOMPARE(loaded->scene.cameras.size(), std::size_t(3)); // "rides" stands now
            QCOMPARE(QString::fromStdString(said(*loaded)).count("camera \"blind\""), 1);
            QVERIFY2(glbOf(loaded->scene), lens);
        }
        for (const Json& wrong : {Json(99), Json(-1), Json("front"), Json::object()}) {
            Json json = Json::parse(theirs());
            json.erase("animations");
            json["nodes"][5]["camera"] = wrong;
            const auto loaded = folder_.load("scene.gltf", json.dump());
            if (loaded) QVERIFY(glbOf(loaded->scene)); // else refused: as good
        }
    }

    void planesThatSeeNothingAreAsItSuits() {
        Json json = Json::parse(
            theirs(R"({"type":"perspective","perspective":{"yfov":1,"znear":5,"zfar":1,"aspectRatio":-1}})"));
        json.erase("animations");
        const auto loaded = folder_.load("scene.gltf", json.dump());
        VERIFY_RESULT(loaded);
        const auto blind = std::ranges::find(loaded->scene.cameras, "blind", &SavedCamera::name);
        QVERIFY(blind != loaded->scene.cameras.end());
        QCOMPARE_EQ(blind->near, 0.0);
        QCOMPARE_EQ(blind->far, 0.0);
        const Json written = jsonOf(saved(loaded->scene));
        for (const Json& each : written["cameras"])
            if (each["type"] == "perspective") QCOMPARE_GT(each["perspective"].value("aspectRatio", 1.0), 0);
    }

    void notMoreThanCanBeAreRead() {
        Json json = Json::parse(theirs());
        json.erase("animations");
        for (std::size_t i = 0; i < kMaxCameras; ++i) {
            json["scenes"][0]["nodes"].push_back(json["nodes"].size());
            json["nodes"].push_back({{"camera", 0}});
        }
        const LoadedScene loaded = load(json.dump());
        QCOMPARE(loaded.scene.cameras.size(), kMaxCameras);
        QVERIFY(areCameras(loaded.scene.cameras));
        COMPARE_CONTAINS(said(loaded), "3 cameras are more than there can be: \"wide\", \"wide\", \"wide\"");
    }

    /// Whatever a file says of one, or ten thousand: a person reads a line.
    void manyThatAreLeftOutAreOneSentence() {
        Json json = Json::parse(theirs());
        json.erase("animations");
        for (int i = 0; i < 9744; ++i) {
            json["scenes"][0]["nodes"].push_back(json["nodes"].size());
            json["nodes"].push_back({{"camera", 2}, {"name", "eye " + std::to_string(i)}});
        }
        const LoadedScene loaded = load(json.dump());
        COMPARE_CONTAINS(said(loaded), "9745 cameras have no lens that anything could be seen by: "
                                       "\"blind\", \"eye 0\", \"eye 1\" and others");
        QCOMPARE(QString::fromStdString(said(loaded)).count("camera"), 1);
    }

    /// docs/format.md: an angle above 0 and below pi.
    void everyAngleOfTheFormatIsRead() {
        for (const double angle :
             {1e-9, 5e-5, std::numbers::pi - 5e-5, std::nextafter(std::numbers::pi, 0.0)}) {
            Json json = Json::parse(theirs());
            json.erase("animations");
            json["cameras"][2]["perspective"]["yfov"] = angle;
            const LoadedScene loaded = load(json.dump());
            COMPARE_LACKS(said(loaded), "camera");
            QCOMPARE(loaded.scene.cameras.back().angle, angle);
            QCOMPARE(load(saved(loaded.scene)).scene.cameras.back().angle, angle);
        }
        for (const double angle : {0.0, std::numbers::pi, std::nextafter(std::numbers::pi, 4.0)}) {
            Json json = Json::parse(theirs());
            json.erase("animations");
            json["cameras"][2]["perspective"]["yfov"] = angle;
            COMPARE_CONTAINS(said(load(json.dump())), "\"blind\" has no lens");
        }
    }

    /// Nothing that is felt stands by it.
    void aCameraWithoutAPlaceIsLeftOut() {
        const Json places[] = {
            {{"rotation", {0, 0, 0, 0}}},
            {{"rotation", {0, 1, 0}}},
            {{"rotation", "up"}},
            {{"rotation", {1, 2, 3, "w"}}},
            {{"translation", {1e300, 0, 0}}},
            {{"translation", {1, 2}}},
            {{"translation", {nullptr, 0, 0}}},
            {{"scale", {1e300, 1, 1}}},
            {{"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
        };
        for (const Json& place : places)
            for (const char* physics : {"", "KHR_physics_rigid_bodies"}) {
                Json json = Json::parse(theirs(R"({"type":"perspective","perspective":{"yfov":1}})"));
                json.erase("animations");
                json["nodes"][5].update(place);
                json["nodes"][5]["children"] = {6}; // another camera, which has no place either
                json["nodes"].push_back({{"name", "beside"}, {"camera", 0}});
                if (*physics) json["nodes"][0]["extensions"][physics] = {{"motion", {{"mass", 1}}}};
                const auto loaded = folder_.load("scene.gltf", json.dump());
                VERIFY_RESULT(loaded);
                QCOMPARE(loaded->scene.objects.size(), std::size_t(1));
                QCOMPARE(loaded->scene.mechanics.bodies.size(), std::size_t(*physics ? 1 : 0));
                const QString told = QString::fromStdString(said(*loaded));
                QVERIFY2(told.contains("\"blind\"") && told.contains("a place that is none"),
                         qPrintable(told + QString::fromStdString(place.dump())));
                QVERIFY(!told.contains("unit length"));
                VERIFY_RESULT(folder_.load("again.glb", saved(loaded->scene)));
            }
    }

    /// Otherwise it would be felt somewhere else.
    void aMeshBelowOneWithoutAPlaceIsRefused() {
        Json json = Json::parse(theirs());
        json.erase("animations");
        json["nodes"][5]["rotation"] = {0, 0, 0, 0};
        json["nodes"][5]["children"] = {0};
        json["scenes"][0]["nodes"] = {1, 2, 4, 5};
        const auto loaded = folder_.load("scene.gltf", json.dump());
        QVERIFY(!loaded);
        COMPARE_CONTAINS(loaded.error().text, "nodes[5] has no usable rotation");
    }
};

TACTUM_TEST(TestGltfCameras)

} // namespace test_gltf_cameras

#include "test_gltf_cameras.moc"
