// What another program adds to a file of ours stays, whatever its place; what cannot stay is said.
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/readers.h"
#include "core/motion/motion_build.h"
#include "tests/core/files/glb_json.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_foreign {

using namespace tactum;
using tactum::test::difference;
using tactum::test::SceneDice;
using test::saved;

namespace {

constexpr const char* kOurs = "TACTUM_haptics";
constexpr const char* kPhysics = "KHR_physics_rigid_bodies";
constexpr const char* kDot =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNg"
    "AAAAAgABSK+kcQAAAABJRU5ErkJggg==";

/// A glb for another program to change.
struct Parts {
    Json json;
    std::string binary;

    explicit Parts(const std::string& glb) {
        std::uint32_t length = 0;
        std::memcpy(&length, glb.data() + 12, 4);
        json = Json::parse(glb.substr(20, length));
        if (glb.size() > 28 + length) binary = glb.substr(28 + length);
    }
    std::string glb() const { return packGlb(json, binary); }

    int add(const char* array, Json element) {
        json[array].push_back(std::move(element));
        return int(json[array].size()) - 1;
    }
    /// An accessor of numbers of its own.
    int addNumbers(const std::vector<float>& numbers, const char* type, std::size_t count) {
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        const int view =
            add("bufferViews",
                {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", 4 * numbers.size()}});
        binary.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
        json["buffers"][0]["byteLength"] = binary.size();
        return add("accessors",
                   {{"bufferView", view}, {"componentType", 5126}, {"type", type}, {"count", count}});
    }
    std::vector<float> numbers(int accessor) const {
        const Json& view =
            json["bufferViews"][json["accessors"][std::size_t(accessor)]["bufferView"].get<std::size_t>()];
        std::vector<float> all(view["byteLength"].get<std::size_t>() / 4);
        std::memcpy(all.data(), binary.data() + view.value("byteOffset", std::size_t(0)), 4 * all.size());
        return all;
    }
    /// The element of this name, or null.
    Json element(const char* array, const std::string& name) const {
        for (const Json& each : json.value(array, Json::array()))
            if (each.value("name", std::string()) == name) return each;
        return {};
    }
    int index(const char* array, const std::string& name) const {
        for (std::size_t i = 0; json.contains(array) && i < json[array].size(); ++i)
            if (json[array][i].value("name", std::string()) == name) return int(i);
        return -1;
    }
};

/// A body of one surface, at rest or moving up and down.
SceneObject body(const std::string& name, bool moves) {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1.1, 1, 1}}; // 1.1 is not exact in single precision
    soup.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 3}, {0, 3, 2}};
    soup.surfaceOf = {0, 0, 0, 0};
    SceneObject object;
    object.name = name;
    object.pose = {Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY())), {0.1, 0.2, 0.3}};
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces = {namedSurface(name + " surface")};
    object.surfaces[0].material.stiffness = 321;
    if (!moves) return object;
    Track<Vec3> up{Interpolation::Linear, {0, 1}, {{0, 0, 0}, {0, 0.1, 0}}, {}, {}};
    object.motion = std::make_shared<const Motion>(makeMotion(std::move(up), {}, 1));
    return object;
}

Scene bodies(bool moves = false) {
    Scene scene;
    scene.add(body("first", moves));
    scene.add(body("second", false)).pose.translation.x() = 3;
    return scene;
}

} // namespace

class TestGltfForeign : public QObject {
    Q_OBJECT

    FileFolder folder_;

    LoadedScene load(const std::string& glb) {
        const auto loaded = folder_.load("scene.glb", glb);
        if (!loaded) throw std::runtime_error(loaded.error().text);
        return *loaded;
    }
    /// After loading and saving; a second time must not change a byte.
    Parts again(const Parts& changed) {
        const std::string first = saved(load(changed.glb()).scene);
        const std::string second = saved(load(first).scene);
        if (first != second) throw std::runtime_error("the second save differs");
        return Parts(first);
    }
    static std::string allOf(const LoadedScene& loaded) {
        std::string text;
        for (const Finding& finding : loaded.findings)
            text += finding.sentence + " | ";
        return text;
    }

private slots:
    void aCameraAddedToASampleStays() {
        std::ifstream file(TACTUM_SAMPLES "/teapot.glb", std::ios::binary);
        Parts glb(std::string(std::istreambuf_iterator<char>(file), {}));
        const Scene before = load(glb.glb()).scene;
        const std::size_t size = glb.glb().size();
        const int camera = glb.add("cameras", {{"name", "wide"}, {"type", "perspective"}});
        const int eye = glb.add("nodes", {{"name", "eye"}, {"camera", camera}, {"translation", {0, 0, 2}}});
        glb.json["scenes"][0]["nodes"].push_back(eye);
        Parts after = again(glb);
        const Json node = after.element("nodes", "eye");
        QVERIFY(node.is_object());
        QCOMPARE_EQ(node["translation"], Json({0, 0, 2}));
        QCOMPARE_EQ(after.json["cameras"][node["camera"].get<std::size_t>()]["name"], "wide");
        const Json& shown = after.json["scenes"][0]["nodes"];
        QCOMPARE_EQ(std::ranges::count(shown, Json(after.index("nodes", "eye"))), 1);
        QCOMPARE(difference(before, load(after.glb()).scene), std::string());
        QCOMPARE_LT(after.glb().size(), size + 1000); // nothing of ours is there twice
    }

    void everyKindThatIsAddedStays() {
        Parts glb(saved(bodies()));
        const int lamp =
            glb.add("nodes", {{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        glb.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({{{"type", "point"}}});
        glb.json["extensionsUsed"].push_back("KHR_lights_punctual");
        const int times = glb.addNumbers({0, 0.5f, 2}, "SCALAR", 3);
        const int ways = glb.addNumbers({1, 2, 3, 4, 5, 6, 7, 8, 9}, "VEC3", 3);
        glb.add("animations",
                {{"name", "sway"},
                 {"channels",
                  Json::array({{{"sampler", 0}, {"target", {{"node", lamp}, {"path", "translation"}}}}})},
                 {"samplers", Json::array({{{"input", times}, {"output", ways}}})}});
        glb.json["scenes"][0]["name"] = "stage";
        glb.json["scenes"][0]["extras"] = {{"mood", "dark"}};
        glb.json["scenes"][0]["nodes"].push_back(lamp);
        glb.add("scenes", {{"name", "spare"}, {"nodes", {lamp}}});
        const int dot = glb.add("images", {{"name", "dot"}, {"uri", kDot}, {"extras", 7}});
        const int texture = glb.add(
            "textures",
            {{"name", "dots"}, {"source", dot}, {"sampler", glb.add("samplers", {{"wrapS", 33071}})}});
        glb.add("materials", {{"name", "unused"}, {"emissiveTexture", {{"index", texture}}}});
        glb.add("skins", {{"joints", {lamp}}});
        Parts after = again(glb);
        const int now = after.index("nodes", "lamp");
        QCOMPARE_GE(now, 0);
        const Json sway = after.element("animations", "sway");
        QVERIFY(sway.is_object());
        QCOMPARE(sway["channels"][0]["target"]["node"].get<int>(), now);
        QCOMPARE(after.numbers(sway["samplers"][0]["input"]), (std::vector<float>{0, 0.5f, 2}));
        QCOMPARE(after.numbers(sway["samplers"][0]["output"])[8], 9.0f);
        QCOMPARE_EQ(after.json["scenes"][0]["name"], "stage");
        QCOMPARE_EQ(after.json["scenes"][0]["extras"]["mood"], "dark");
        QCOMPARE_EQ(after.element("scenes", "spare")["nodes"], Json({now}));
        QCOMPARE_EQ(after.json["skins"][0]["joints"], Json({now}));
        const Json unused = after.element("materials", "unused");
        QVERIFY(unused.is_object());
        const Json& kept = after.json["textures"][unused["emissiveTexture"]["index"].get<std::size_t>()];
        QCOMPARE_EQ(kept["name"], "dots");
        QCOMPARE_EQ(after.json["samplers"][kept["sampler"].get<std::size_t>()]["wrapS"], 33071);
        QCOMPARE_EQ(after.json["images"][kept["source"].get<std::size_t>()]["extras"], 7);
        QCOMPARE(difference(bodies(), load(after.glb()).scene), std::string());
    }

    /// A picture for the eye on a material of ours, and a camera that rides on a body of ours.
    void whatIsHungOnOursFollows() {
        for (const bool moves : {false, true}) {
            Parts glb(saved(bodies(moves)));
            const int texture =
                glb.add("textures", {{"name", "dots"}, {"source", glb.add("images", {{"uri", kDot}})}});
            glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
            const int camera = glb.add("cameras", {{"type", "perspective"}});
            const int eye =
                glb.add("nodes", {{"name", "eye"}, {"camera", camera}, {"translation", {0, 0, 2}}});
            const int body = glb.index("nodes", "first");
            glb.json["nodes"][std::size_t(body)]["children"] = {eye};
            Parts after = again(glb);
            const Json material = after.element("materials", "first surface");
            const std::size_t index = material["pbrMetallicRoughness"]["baseColorTexture"]["index"];
            QCOMPARE_EQ(after.json["textures"][index]["name"], "dots");
            QCOMPARE_EQ(after.element("nodes", "first")["children"], Json({after.index("nodes", "eye")}));
            QCOMPARE_EQ(after.element("nodes", "eye")["translation"], Json({0, 0, 2}));
            QVERIFY(!after.element("nodes", "eye").contains("matrix"));
            QCOMPARE(difference(bodies(moves), load(after.glb()).scene), std::string());
            // Moved by an edit, the camera stays in the world; once more, and it still does.
            Scene edited = load(after.glb()).scene;
            edited.find(1)->pose.translation.y() += 5;
            const Parts third(saved(edited));
            const auto matrix = third.element("nodes", "eye")["matrix"].get<std::vector<double>>();
            COMPARE_NEAR(matrix[13], -5, 1e-12, "");
            again(third);
        }
    }

    void bodiesOfOthersBecomeObjectsOnce() {
        Parts glb(saved(bodies()));
        const int spots = glb.addNumbers({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
        const int mesh =
            glb.add("meshes", {{"name", "leaf"},
                               {"primitives", Json::array({{{"attributes", {{"POSITION", spots}}}}})}});
        const int leaf = glb.add("nodes", {{"name", "leaf"}, {"mesh", mesh}, {"extras", "green"}});
        const int group =
            glb.add("nodes", {{"name", "group"}, {"children", {leaf, 0}}, {"translation", {1, 0, 0}}});
        glb.json["scenes"][0]["nodes"] = {1, group};
        const LoadedScene loaded = load(glb.glb());
        QCOMPARE(loaded.scene.objects.size(), std::size_t(3));
        Parts after = again(glb);
        QCOMPARE(after.json["meshes"].size(), std::size_t(3));
        QCOMPARE_EQ(after.element("nodes", "leaf")["extras"], "green");
        QCOMPARE_EQ(after.element("nodes", "group")["translation"], Json({1, 0, 0}));
        QCOMPARE(difference(loaded.scene, load(after.glb()).scene), std::string());
    }

    /// Another program puts one into a scene that is not shown, and shows it again later.
    void objectsThatAreNotShownStay() {
        Parts glb(saved(bodies()));
        glb.json["scenes"][0]["nodes"] = {0};
        glb.add("scenes", {{"name", "stock"}, {"nodes", {1}}});
        QCOMPARE(load(glb.glb()).scene.objects.size(), std::size_t(1));
        Parts after = again(glb);
        const Json stock = after.element("scenes", "stock")["nodes"];
        QVERIFY(stock.is_array());
        after.json["scenes"][0]["nodes"].push_back(stock[0]);
        QCOMPARE(difference(bodies(), load(after.glb()).scene), std::string());
        QCOMPARE(again(after).json["meshes"].size(), std::size_t(3)); // the foreign one stays as it is
    }

    /// In a file that holds foreign data already, and whose data another program packs anew.
    void dataPackedAnewAreFound() {
        Parts glb(saved(bodies()));
        const int times = glb.addNumbers({0, 0.5f, 2}, "SCALAR", 3);
        glb.json["accessors"][std::size_t(times)]["name"] = "times";
        Parts packed = again(glb);
        QVERIFY(packed.json["extensions"][kOurs]["foreign"]["bytes"] > 0);
        packed.binary = std::string(64, 'x') + packed.binary;
        for (Json& view : packed.json["bufferViews"])
            view["byteOffset"] = view.value("byteOffset", std::size_t(0)) + 64;
        packed.json["buffers"][0]["byteLength"] = packed.binary.size();
        Parts after = again(packed);
        QCOMPARE(after.numbers(after.index("accessors", "times")), (std::vector<float>{0, 0.5f, 2}));
        QCOMPARE_LT(after.binary.size(), packed.binary.size());
    }

    /// A motion that another program gives an object makes it a body, with the collider that was a copy.
    void aMotionOfAnotherProgramMakesABody() {
        Parts glb(saved(bodies()));
        glb.json["nodes"][0]["extensions"][kPhysics]["motion"] = {{"mass", 3}};
        Parts after = again(glb);
        const Scene scene = load(after.glb()).scene;
        QCOMPARE(scene.mechanics.bodies.size(), std::size_t(1));
        QCOMPARE(scene.mechanics.bodies[0].mass, 3.0);
        QCOMPARE(scene.objects[0].body, scene.mechanics.bodies[0].id);
        QVERIFY(!scene.mechanics.colliders.empty());
        QCOMPARE(saved(scene) == after.glb(), true);
    }

    void whatStandsBesideOurCopiesStays() {
        Parts glb(saved(bodies()));
        glb.json["nodes"][0]["extensions"][kPhysics]["trigger"] = {{"nodes", Json::array()}};
        glb.json["extensions"][kPhysics]["physicsJoints"] = Json::array({{{"limits", Json::array()}}});
        glb.json["extensions"]["MPEG_haptic_material"]["extras"] = "note";
        Parts after = again(glb);
        QVERIFY(after.json["nodes"][0]["extensions"][kPhysics].contains("trigger"));
        QVERIFY(after.json["nodes"][0]["extensions"][kPhysics].contains("collider"));
        QCOMPARE(after.json["extensions"][kPhysics]["physicsJoints"].size(), std::size_t(1));
        QCOMPARE(after.json["extensions"][kPhysics]["physicsMaterials"].size(), std::size_t(2));
        QCOMPARE_EQ(after.json["extensions"]["MPEG_haptic_material"]["extras"], "note");
    }

    void whatCannotStayIsSaid() {
        const std::string glb = saved(bodies());
        const auto says = [&](const char* place, const Json& value, const char* part) {
            Parts changed(glb);
            changed.json[Json::json_pointer(place)] = value;
            const LoadedScene loaded = load(changed.glb());
            COMPARE_CONTAINS(said(loaded), part);
        };
        says("/images/0/extras", 1, "images: extras of 1 of its own images");
        says("/textures/0/sampler", 0, "textures: sampler of 1");
        says("/accessors/0/extras", 1, "accessors: extras of 1");
        says("/buffers/0/extras", 1, "extras or extensions of a buffer");
        Parts moved(glb);
        moved.json["extensionsUsed"].push_back("THEIR_links");
        moved.add("nodes", {{"name", "end"}, {"extensions", {{"THEIR_links", {{"node", 2}}}}}});
        const LoadedScene loaded = load(moved.glb());
        COMPARE_CONTAINS(said(loaded), "is not known here");
        QVERIFY2(load(glb).findings.empty(), allOf(load(glb)).c_str());
    }

    void unknownMembersOfOurMeshStay() {
        Parts glb(saved(bodies()));
        glb.json["meshes"][0]["extensions"][kOurs]["heat"] = {{"warmth", 3}};
        QCOMPARE_EQ(again(glb).json["meshes"][0]["extensions"][kOurs]["heat"]["warmth"], 3);
        Scene scene = load(glb.glb()).scene;
        TriangleSoup exact = *scene.objects[0].geometry; // now single precision says all
        exact.positions[3].x() = 1;
        scene.objects[0].geometry = std::make_shared<const TriangleSoup>(exact);
        const Json ours = Parts(saved(scene)).json["meshes"][0]["extensions"][kOurs];
        QVERIFY(ours.contains("heat"));
        QVERIFY(!ours.contains("positions"));
    }

    /// What another program knows of a layer goes with that layer, and not with one that took its place.
    void unknownMembersOfALayerStayWithItsName() {
        Scene scene = bodies();
        TextureLayer coarse, fine;
        coarse.name = "coarse";
        fine.name = "fine";
        scene.objects[0].surfaces[0].layers = {coarse, fine};
        Parts glb(saved(scene));
        Json& layers = glb.json["materials"][0]["extensions"][kOurs]["layers"];
        layers[0]["warmth"] = 3;
        layers[1]["warmth"] = 5;
        Scene loaded = load(glb.glb()).scene;
        loaded.objects[0].surfaces[0].layers[0].name = "another";
        const Json after = Parts(saved(loaded)).json["materials"][0]["extensions"][kOurs]["layers"];
        QVERIFY(!after[0].contains("warmth"));
        QCOMPARE_EQ(after[1]["warmth"], 5);
        loaded = load(glb.glb()).scene;
        loaded.objects[0].surfaces[0].layers.pop_back();
        const Json fewer = Parts(saved(loaded)).json["materials"][0]["extensions"][kOurs]["layers"];
        QCOMPARE(fewer.size(), std::size_t(1));
        QCOMPARE_EQ(fewer[0]["warmth"], 3);
    }

    /// Where a node cannot say a pose exactly, the pose stands beside it. Another program writes the node in
    /// single precision.
    void aPoseFarAwayIsExact() {
        Scene scene = bodies();
        const Vec3 far(1234.56789012345, -9876.54321098765, 1e-3);
        scene.objects[1].pose = {Quat(std::nextafter(1.0, 2.0), 0, 0, 0), far}; // of more than 1
        Parts glb(saved(scene));
        Json& place = glb.json["nodes"][std::size_t(glb.index("nodes", "second"))]["translation"];
        place = {float(far.x()), float(far.y()), float(far.z())};
        QCOMPARE(load(glb.glb()).scene.objects[1].pose.translation, far);
        place = {1, 2, 3}; // moved, and so the node counts
        QCOMPARE(load(glb.glb()).scene.objects[1].pose.translation, Vec3(1, 2, 3));
    }

    void anImageTakenAwayIsNotNamedAgain() {
        Scene scene = bodies();
        TextureLayer layer;
        layer.pattern.source = TextureSource::Image;
        layer.pattern.image =
            std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{9}, "dot");
        scene.objects[0].surfaces[0].layers = {layer};
        Scene loaded = load(saved(scene)).scene;
        QVERIFY(loaded.objects[0].surfaces[0].layers[0].pattern.image);
        loaded.objects[0].surfaces[0].layers[0].pattern.image = nullptr;
        const Json layers = Parts(saved(loaded)).json["materials"][0]["extensions"][kOurs]["layers"];
        QVERIFY(!layers[0]["pattern"].contains("texture"));
    }

    void partsOfPrimitivesStayOrAreSaid() {
        Parts glb(saved(bodies()));
        Json& primitive = glb.json["meshes"][0]["primitives"][0];
        primitive["extras"] = {{"seam", 1}};
        primitive["extensions"]["KHR_materials_variants"]["mappings"] =
            Json::array({{{"material", glb.add("materials", {{"name", "red"}})}, {"variants", {0}}}});
        const int wear = glb.addNumbers({1, 2, 3, 4}, "SCALAR", 4);
        glb.json["meshes"][0]["primitives"][0]["attributes"]["_WEAR"] = wear;
        const LoadedScene loaded = load(glb.glb());
        COMPARE_CONTAINS(said(loaded), "_WEAR of its meshes");
        Parts after = again(glb);
        Json now = after.json["meshes"][0]["primitives"][0];
        QCOMPARE_EQ(now["extras"]["seam"], 1);
        QCOMPARE(now["extensions"]["KHR_materials_variants"]["mappings"][0]["material"].get<int>(),
                 after.index("materials", "red"));
    }

    void meshesThatStayBesideTheirObjectsAreSaid() {
        Parts glb(saved(bodies()));
        for (const char* array : {"nodes", "meshes", "materials"})
            for (Json& element : glb.json[array])
                element.erase("extensions");
        glb.json.erase("extensions");
        glb.json["extensionsUsed"] = {"THEIR_data"};
        const LoadedScene loaded = load(glb.glb());
        COMPARE_CONTAINS(said(loaded), "2 of its meshes stay in the file");
        glb.json["extensionsUsed"] = {"KHR_materials_clearcoat"};
        COMPARE_LACKS(said(load(glb.glb())), "stay in the file");
    }

    void damageToOurExtensionIsSaid() {
        const Scene scene = bodies(true);
        const std::string glb = saved(scene);
        const Parts whole(glb);
        const std::string body = "/nodes/" + std::to_string(whole.index("nodes", "first")) + "/extensions/";
        const auto says = [&](const std::string& place, const Json& value, const char* part) {
            Parts changed(glb);
            changed.json[Json::json_pointer(place)] = value;
            const auto loaded = folder_.load("damaged.glb", changed.glb());
            VERIFY_RESULT(loaded);
            const bool warned = std::ranges::any_of(loaded->findings, [&](const Finding& finding) {
                return finding.severity == Finding::Severity::Warning &&
                       finding.sentence.find(part) != std::string::npos;
            });
            QVERIFY2(warned, (place + ": " + allOf(*loaded)).c_str());
            QCOMPARE(loaded->scene.objects.size(), std::size_t(2));
        };
        const std::string root = "/extensions/TACTUM_haptics/", mesh = "/meshes/0" + root;
        says(root + "finger", 999, "finger path");
        says(root + "proxyRadius", "x", "proxyRadius is not a number");
        says(root + "reach", 7, "reach is none of position, rate and drift");
        says(root + "reach", "fast", "reach is none of position, rate and drift");
        says(root + "shellRadius", -1, "shellRadius is no number from 0.005 to 0.5 m");
        says(root + "shellRadius", "x", "shellRadius is no number from 0.005 to 0.5 m");
        says(root + "copies", {kOurs}, "copies names what is no copy");
        says(root + "foreign", {{"nodes", 99999999}}, "foreign.nodes is 99999999");
        says(root + "foreign", {{"bytes", -1}}, "foreign.bytes is -1");
        says(root + "foreign", 5, "foreign is not an object");
        const int positions = whole.json["meshes"][0]["extensions"][kOurs]["positions"];
        says(mesh + "positions", 0, "positions does not fit");
        says(mesh + "order", positions, "order does not fit");
        says(mesh + "order", 999, "order does not fit");
        Parts shuffled(glb);
        const std::size_t views = shuffled.json["bufferViews"].size();
        shuffled.addNumbers({0, 0}, "SCALAR", 2); // a permutation of one only
        shuffled.json["bufferViews"].back()["byteLength"] = 4;
        shuffled.json["accessors"].back()["count"] = 1;
        QCOMPARE(shuffled.json["bufferViews"].size(), views + 1);
        COMPARE_LACKS(said(load(shuffled.glb())), "order does not fit"); // nothing names it yet
        shuffled.json["meshes"][0]["extensions"][kOurs]["order"] = views;
        COMPARE_CONTAINS(said(load(shuffled.glb())), "order does not fit"); // of other triangles
        Parts zeros(glb); // as many, but not those that are drawn
        zeros.addNumbers(std::vector<float>(24, 0.f), "SCALAR", 24);
        zeros.json["meshes"][0]["extensions"][kOurs]["positions"] = zeros.json["bufferViews"].size() - 1;
        COMPARE_CONTAINS(said(load(zeros.glb())), "positions does not fit");
        says(mesh + "uvs", 0, "uvs does not fit");
        says(mesh + "copies", positions, "copies does not fit");
        says(mesh + "surfaces", {0, 0, 0}, "surfaces is not a list of different materials");
        says(mesh + "surfaces", {99}, "surfaces is not a list of different materials");
        says(body + kOurs + "/visible", 5, "visible is not true or false");
        says(body + kOurs + "/motion/duration", -1, "motion is damaged");
        says("/materials/0/extensions/TACTUM_haptics/stiffness", nullptr, "stiffness is not a number");
        QVERIFY2(load(glb).findings.empty(), allOf(load(glb)).c_str());
    }

    void anArrayThatIsNoneHasNoPlaces() {
        for (const char* array : {"materials", "nodes", "bufferViews", "accessors", "images", "textures"})
            for (const Json& wrong : {Json::object(), Json(7), Json()}) {
                Parts parts(saved(bodies()));
                parts.json[array] = wrong;
                const auto loaded = folder_.load("scene.glb", parts.glb());
                if (loaded) load(saved(loaded->scene)); // or refused
            }
    }

    void damagedCountsLoseNothing() {
        Parts glb(saved(bodies()));
        glb.add("nodes", {{"name", "lamp"}});
        Parts counted = again(glb);
        for (const Json& wrong : {Json{{"nodes", 99999999}, {"bytes", -1}}, Json(5), Json{{"nodes", "x"}}}) {
            counted.json["extensions"][kOurs]["foreign"] = wrong;
            Parts after = again(counted);
            QVERIFY(after.element("nodes", "lamp").is_object());
            QCOMPARE(after.json["nodes"].size(), std::size_t(3));
        }
        counted.json["extensions"][kOurs]["copies"] = {kOurs};
        QCOMPARE(difference(bodies(), load(counted.glb()).scene), std::string());
    }

    void onlyAGreaterMajorVersionIsALaterOne() {
        Parts glb(saved(bodies()));
        Json& version = glb.json["extensions"][kOurs]["version"];
        for (const Json& later : {Json("2"), Json("2.0"), Json(3), Json("17.1.2")}) {
            version = later;
            const auto loaded = folder_.load("later.glb", glb.glb());
            QVERIFY(!loaded);
            COMPARE_CONTAINS(loaded.error().text, "later Tactum");
        }
        for (const Json& none : {Json(0.9), Json("0.9"), Json("x"), Json("1"), Json("1.0.0"), Json(1.0),
                                 Json(nullptr), Json("1."), Json("")}) {
            version = none;
            const LoadedScene loaded = load(glb.glb());
            COMPARE_CONTAINS(said(loaded), "is not a version");
            QCOMPARE(difference(bodies(), loaded.scene), std::string());
        }
        for (const char* usual : {"1.0", "1.7", "01.0"}) {
            version = usual;
            QVERIFY2(load(glb.glb()).findings.empty(), usual);
        }
    }
};

TACTUM_TEST(TestGltfForeign)

} // namespace test_gltf_foreign

#include "test_gltf_foreign.moc"
