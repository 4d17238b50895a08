// Groups as nodes of glTF: there and back to the bit, where other programs see the same places, and damaged.
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/scene/bodies.h"
#include "core/scene/groups.h"
#include "tests/core/files/glb_json.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_groups {

using namespace tactum;
using tactum::test::difference;
using test::jsonOf;
using test::saved;
using test::withJson;

namespace {

void addTent(Scene& scene, const std::string& name, const std::string& group) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    soup->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    soup->surfaceOf = {0, 0, 0, 0};
    SceneObject object;
    object.name = name, object.group = group;
    object.geometry = soup;
    object.surfaces = {namedSurface("paper")};
    object.pose = {Quat(Eigen::AngleAxisd(0.7 + double(scene.objects.size()), Vec3(1, 2, 3).normalized())),
                   {0.1, 0.2, 1 / 3.0}};
    scene.add(std::move(object));
}

/// Nodes 0 to 3 are its objects; 4 and 5 are the groups.
Scene fourTents() {
    Scene scene;
    addTent(scene, "a", "");
    addTent(scene, "b", "lid & \"pot\"");
    addTent(scene, "c", "lid & \"pot\"");
    addTent(scene, "d", "spoons");
    return scene;
}

int nodeNamed(const Json& json, const std::string& name) {
    for (std::size_t i = 0; i < json["nodes"].size(); ++i)
        if (json["nodes"][i].value("name", "") == name) return int(i);
    qFatal("no node %s", name.c_str());
    return -1;
}

} // namespace

class TestGltfGroups : public QObject {
    Q_OBJECT

    FileFolder folder_;

    LoadedScene load(const std::string& bytes) {
        const auto loaded = folder_.load("scene.glb", bytes);
        if (!loaded) throw std::runtime_error(loaded.error().text);
        return *loaded;
    }
    /// What one object after the other is in.
    static QByteArray groupsOf(const Scene& scene) {
        QByteArray all;
        for (const SceneObject& object : scene.objects)
            all += QByteArray::fromStdString(object.name + ":" + object.group + " ");
        return all.trimmed();
    }

private slots:
    void groupsComeBackToTheBit() {
        const Scene scene = fourTents();
        const std::string glb = saved(scene);
        const LoadedScene again = load(glb);
        COMPARE_LACKS(said(again), "group");
        QCOMPARE(difference(scene, again.scene), std::string());
        QCOMPARE(saved(again.scene), glb);
        Scene without = again.scene;
        ungroup(without, objectsOfGroup(without, "spoons"));
        ungroup(without, objectsOfGroup(without, "lid & \"pot\""));
        QCOMPARE(jsonOf(saved(without))["nodes"].size(), std::size_t(4));
    }

    /// Blender, three.js and whoever else multiplies the transforms of the nodes above.
    void otherProgramsSeeTheSamePlaces() {
        Scene flat = fourTents();
        for (SceneObject& object : flat.objects)
            object.group.clear();
        const Json grouped = jsonOf(saved(fourTents())), bare = jsonOf(saved(flat));
        const Json& group = grouped["nodes"][std::size_t(nodeNamed(grouped, "spoons"))];
        for (const char* key : {"translation", "rotation", "scale", "matrix", "mesh"})
            QVERIFY2(!group.contains(key), key);
        QCOMPARE_EQ(group["children"], Json({nodeNamed(grouped, "d")}));
        for (const char* name : {"a", "b", "c", "d"})
            QCOMPARE_EQ(grouped["nodes"][std::size_t(nodeNamed(grouped, name))],
                        bare["nodes"][std::size_t(nodeNamed(bare, name))]);
        QCOMPARE(grouped["scenes"][0]["nodes"].size(), std::size_t(3));
    }

    void aBodyIsInItsGroupWithAllThatMovesWithIt() {
        Scene scene = fourTents();
        QVERIFY(makeBody(scene, scene.objects[1].id));
        scene.mechanics.colliders.clear(); // hulls have an order of their own in a file
        scene.objects[2].body = scene.objects[1].body;
        const std::string glb = saved(scene);
        const Scene again = load(glb).scene;
        QCOMPARE(difference(scene, again), std::string());
        QCOMPARE(saved(again), glb);
    }

    void oneThatMovesByKeysIsInItsGroup() {
        Scene scene = fourTents();
        Motion motion;
        motion.translation.times = {0, 1};
        motion.translation.values = {{0, 0, 0}, {0, 1 / 3.0, 0}};
        scene.objects[2].motion = std::make_shared<const Motion>(motion);
        QCOMPARE(difference(scene, load(saved(scene)).scene), std::string());
    }

    void aFileWithoutGroupsIsTheSame() {
        Scene scene = fourTents();
        for (SceneObject& object : scene.objects)
            object.group.clear();
        QCOMPARE(jsonOf(saved(scene))["nodes"].size(), std::size_t(4));
        QCOMPARE(difference(scene, load(saved(scene)).scene), std::string());
    }

    void damagedGroupsAreOneLineAndTheSceneIsThere_data() {
        QTest::addColumn<QByteArray>("patch"); // of the node of "lid", 4, and that of "spoons", 5
        QTest::addColumn<QByteArray>("groups");
        QTest::addColumn<QByteArray>("said");
        const auto row = [](const char* name, const char* patch, const char* groups, const char* said) {
            QTest::newRow(name) << QByteArray(patch) << QByteArray(groups) << QByteArray(said);
        };
        row("holds itself", R"({"4":[1,2,4],"5":[3]})", "a: b:lid c:lid d:spoons", "1 inside of others");
        row("in a circle", R"({"4":[1,2,5],"5":[3,4]})", "a: b:lid c:lid d:spoons", "inside of others");
        row("member not there", R"({"4":[1,2,77,-1,"x",null,2.5],"5":[3]})", "a: b:lid c:lid d:spoons",
            "5 with members that are not there");
        row("in two", R"({"4":[1,2],"5":[3,2]})", "a: b:lid c:lid d:spoons",
            "1 with members that are elsewhere already");
        row("in one and at the root", R"({"4":[1,2,0],"5":[3]})", "a: b:lid c:lid d:spoons",
            "1 with members that are elsewhere already");
        row("twice", R"({"4":[1,1,2],"5":[3]})", "a: b:lid c:lid d:spoons", "elsewhere already");
        row("no list", R"({"4":7,"5":[1,2,3]})", "a: b:spoons c:spoons d:spoons", "");
    }
    void damagedGroupsAreOneLineAndTheSceneIsThere() {
        QFETCH(QByteArray, patch);
        QFETCH(QByteArray, groups);
        QFETCH(QByteArray, said);
        const std::string glb = saved(fourTents());
        Json json = jsonOf(glb);
        const int lid = nodeNamed(json, "lid & \"pot\""), spoons = nodeNamed(json, "spoons");
        QCOMPARE(lid, 4);
        QCOMPARE(spoons, 5);
        const Json patched = Json::parse(patch.toStdString());
        for (const auto& [key, list] : patched.items())
            json["nodes"][std::size_t(std::stoi(key))]["children"] = list;
        json["nodes"][std::size_t(lid)]["name"] = "lid";
        const LoadedScene loaded = load(withJson(glb, json));
        QCOMPARE(groupsOf(loaded.scene), groups);
        std::size_t lines = 0;
        for (const Finding& finding : loaded.findings)
            if (finding.sentence.find("groups cannot be") != std::string::npos) {
                ++lines;
                COMPARE_CONTAINS(QByteArray::fromStdString(finding.sentence), said);
            }
        QCOMPARE(lines, std::size_t(said.isEmpty() ? 0 : 1));
    }

    void aGroupThatWasMovedElsewhereMovesItsObjectsAndIsNone() {
        const std::string glb = saved(fourTents());
        Json json = jsonOf(glb);
        json["nodes"][std::size_t(nodeNamed(json, "spoons"))]["translation"] = {1, 0, 0};
        const LoadedScene loaded = load(withJson(glb, json));
        QCOMPARE(loaded.scene.objects[3].group, std::string());
        COMPARE_NEAR(loaded.scene.objects[3].pose.translation.x(), 1.1, 1e-12, "m");
        COMPARE_CONTAINS(said(loaded), "1 with a place of their own");
        QVERIFY(glbOf(loaded.scene));
    }

    void tensOfThousandsAndOnesTenThousandDeepAreRead_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("deep");
        QTest::newRow("deep") << 10'000 << true;
        QTest::newRow("many") << 90'000 << false;
    }
    void tensOfThousandsAndOnesTenThousandDeepAreRead() {
        QFETCH(int, count);
        QFETCH(bool, deep);
        const std::string glb = saved(fourTents());
        Json json = jsonOf(glb);
        const Json group = json["nodes"][std::size_t(nodeNamed(json, "spoons"))];
        const int first = int(json["nodes"].size());
        for (int i = 0; i < count; ++i) {
            Json next = group;
            next.erase("children");
            if (deep && i + 1 < count) next["children"] = {first + i + 1};
            json["nodes"].push_back(std::move(next));
            if (!deep || i == 0) json["scenes"][0]["nodes"].push_back(first + i);
        }
        const LoadedScene loaded = load(withJson(glb, json));
        QCOMPARE(groupsOf(loaded.scene), groupsOf(fourTents()));
        QCOMPARE(saved(loaded.scene), glb); // what is empty goes
    }

    void aMillionOfThemAreTooManyNodesAsAnyWouldBe() {
        Json json = jsonOf(saved(fourTents()));
        json["nodes"].get_ref<Json::array_t&>().resize(1'000'000, Json::object());
        const auto loaded = folder_.load("many.glb", withJson(saved(fourTents()), json));
        QVERIFY(!loaded);
        COMPARE_CONTAINS(QByteArray::fromStdString(loaded.error().text),
                         "has 1000000 nodes, and at most 100000 are read");
    }

    void twoOfOneNameGetTwo() {
        const std::string glb = saved(fourTents());
        Json json = jsonOf(glb);
        json["nodes"][std::size_t(nodeNamed(json, "lid & \"pot\""))]["name"] = "spoons";
        QCOMPARE(groupNames(load(withJson(glb, json)).scene).size(), std::size_t(2));
        json["nodes"][std::size_t(nodeNamed(json, "spoons"))]["name"] = Json::array();
        QCOMPARE(groupNames(load(withJson(glb, json)).scene).front(), std::string("Group"));
    }
};

TACTUM_TEST(TestGltfGroups)

} // namespace test_gltf_groups

#include "test_gltf_groups.moc"
