// glTF and glb: the node tree, primitives, accessors, and files that lie about them.
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_gltf {

using namespace tactum;

namespace {

TriangleSoup tetrahedron() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return soup;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    return at == std::string::npos ? "" : text.replace(at, what.size(), with);
}

std::string withNodes(const std::string& nodes) {
    return asGltf(tetrahedron(), R"("scenes":[{"nodes":[0]}],"nodes":)" + nodes);
}

double volumeOf(const TriangleSoup& soup) {
    double volume = 0;
    for (const auto& t : soup.triangles)
        volume += soup.positions[t[0]].dot(soup.positions[t[1]].cross(soup.positions[t[2]])) / 6;
    return volume;
}

/// The corner (1, 0, 0) of the tetrahedron, seen in the world.
Vec3 cornerX(const SceneObject& object) {
    return object.pose.apply(object.geometry->positions[1]);
}

std::string word(std::uint32_t value) {
    return {reinterpret_cast<const char*>(&value), 4};
}

} // namespace

class TestGltf : public QObject {
    Q_OBJECT

private slots:
    /// Refused by counting, before anything of it is built: each of these asks for minutes of work.
    void whatAsksForTooMuchIsRefusedAtOnce() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        for (int i = 0; i < 3000; ++i)
            soup.triangles.push_back({0, 1, 2});
        const auto refusal = [&](int nodes, const Json& node) {
            Json json = Json::parse(asGltf(soup));
            json["nodes"] = Json::array();
            json["scenes"] = {{{"nodes", Json::array()}}};
            json["scene"] = 0;
            for (int i = 0; i < nodes; ++i) {
                json["nodes"].push_back(node);
                json["scenes"][0]["nodes"].push_back(i);
            }
            const auto loaded = folder_.load("many.gltf", json.dump());
            return loaded ? std::string("read") : loaded.error().text;
        };
        COMPARE_CONTAINS(refusal(100'001, {{"name", "n"}}), "has 100001 nodes, and at most 100000 are read");
        COMPARE_CONTAINS(refusal(30'001, {{"mesh", 0}}), "shows 30001 meshes with all its copies");
        COMPARE_CONTAINS(refusal(25'000, {{"mesh", 0}}),
                         "more than 67 million triangles with all its copies");
        QCOMPARE(refusal(20, {{"mesh", 0}}), std::string("read"));
    }

    void version1IsNamed() {
        for (const char* text : {R"({"asset":{"version":"1.0"},"meshes":{"a":{}}})", R"({"meshes":{"a":{}}})",
                                 R"({"asset":{"version":1},"meshes":{}})"}) {
            const auto loaded = folder_.load("old.gltf", text);
            QVERIFY(!loaded);
            COMPARE_CONTAINS(loaded.error().text, "old.gltf: is glTF 1.0, and only 2.0 is read; ");
        }
    }

    /// A later minor version says nothing that a reader of 2.0 has to know, unless it says so.
    void laterVersionsAreNamed() {
        Json json = Json::parse(asGltf(tetrahedron()));
        const auto with = [&](const Json& asset) {
            json["asset"] = asset;
            return json.dump();
        };
        for (const Json& asset : {Json{{"version", "2.0"}},
                                  {{"version", "2.1"}},
                                  {{"version", "2"}},
                                  {{"version", "3.0"}, {"minVersion", "2.0"}}})
            QVERIFY(folder_.load("a.gltf", with(asset)));
        refused("a.gltf", with({{"generator", "x"}}), "does not say which version of glTF it is");
        refused("a.gltf", with(nullptr), "does not say which version of glTF it is");
        refused("a.gltf", with({{"version", "3.0"}}),
                "asks for a reader of glTF \"3.0\", and only 2.0 is read");
        refused("a.gltf", with({{"version", ""}}), "asks for a reader of glTF \"\"");
        refused("a.gltf", with({{"version", "2.1"}, {"minVersion", "2.1"}}), "glTF \"2.1\"");
    }

    void whatOnlyTheEyeMissesMayBeRequired() {
        Json json = Json::parse(asGltf(tetrahedron()));
        json["extensionsRequired"] = {"EXT_texture_webp"};
        QVERIFY(folder_.load("webp.gltf", json.dump()));
        json["extensionsRequired"] = {"ACME_other_meshes"};
        refused("other.gltf", json.dump(), "needs the extension \"ACME_other_meshes\", which is not read");
    }

    /// A second copy of what is there anyway; nobody needs it, and it is not kept.
    void packedMeshesWithAFallbackAreRead() {
        Json json = Json::parse(asGltf(tetrahedron()));
        json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
        json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
            {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
        const auto loaded = folder_.load("packed.gltf", json.dump());
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects.at(0).geometry->triangles.size(), tetrahedron().triangles.size());
        COMPARE_LACKS(said(*loaded), "stay in the file");
        QVERIFY(loaded->scene.kept.foreign);
        COMPARE_LACKS(loaded->scene.kept.foreign->json, "draco");
        for (Json& accessor : json["accessors"])
            accessor.erase("bufferView");
        refused("packed.gltf", json.dump(), "cannot be unpacked by Draco"); // what it names is something else
    }

    /// Vertex 1 is moved by a sparse accessor: over a view, and over zeros.
    void sparseAccessorsAreRead() {
        Json json = Json::parse(asGltf(tetrahedron()));
        // The bytes of 1, and of 2, 3, 4 in single precision.
        json["buffers"].push_back(
            {{"byteLength", 16}, {"uri", "data:application/octet-stream;base64,AQAAAAAAAEAAAEBAAACAQA=="}});
        const int buffer = int(json["buffers"].size()) - 1, view = int(json["bufferViews"].size());
        json["bufferViews"].push_back({{"buffer", buffer}, {"byteLength", 4}});
        json["bufferViews"].push_back({{"buffer", buffer}, {"byteOffset", 4}, {"byteLength", 12}});
        const std::size_t positions = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
        Json& accessor = json["accessors"][positions];
        accessor["sparse"] = {{"count", 1},
                              {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                              {"values", {{"bufferView", view + 1}}}};
        const TriangleSoup before = tetrahedron();
        const auto positionsOf = [&] { return read(json.dump()).objects.at(0).geometry->positions; };
        std::vector<Vec3> wanted = before.positions;
        wanted[1] = {2, 3, 4};
        QVERIFY(positionsOf() == wanted);
        accessor["bufferView"] = nullptr;
        accessor.erase("bufferView"), accessor.erase("byteOffset");
        std::ranges::fill(wanted, Vec3::Zero());
        wanted[1] = {2, 3, 4};
        QVERIFY(positionsOf() == wanted);
        for (const auto& [place, wrong] : {std::pair<const char*, int>{"/sparse/count", 2},
                                           {"/sparse/indices/bufferView", 99},
                                           {"/sparse/values/bufferView", -7},
                                           {"/sparse/indices/componentType", 5126},
                                           {"/sparse/indices/byteOffset", 4},
                                           {"/count", 1 << 30}}) {
            Json damaged = json;
            damaged["accessors"][positions][Json::json_pointer(place)] = wrong;
            const auto loaded = folder_.load("sparse.gltf", damaged.dump());
            QVERIFY2(!loaded, place);
            COMPARE_CONTAINS(loaded.error().text, "sparse");
        }
        // 1 and then 0, and twice 0: which of two values would be meant?
        json["accessors"][positions]["sparse"]["count"] = 2;
        json["accessors"][positions]["sparse"]["values"]["bufferView"] = 0;
        for (const int offset : {0, 1}) {
            json["accessors"][positions]["sparse"]["indices"]["byteOffset"] = offset;
            refused("sparse.gltf", json.dump(), "has sparse indices that do not rise");
        }
    }

    /// Each is an object where it stands, and saving writes each once.
    void instancesAreObjects() {
        Json json =
            Json::parse(asGltf(tetrahedron(), R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"screw",
            "mesh":0,"translation":[10,0,0],"scale":[2,2,2],"extensions":{"EXT_mesh_gpu_instancing":
            {"attributes":{"TRANSLATION":0}}}}],"extensionsUsed":["EXT_mesh_gpu_instancing"],
            "extensionsRequired":["EXT_mesh_gpu_instancing"])"));
        const std::size_t positions = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
        json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = positions;
        Json uneven = json, word = json;
        uneven["accessors"].push_back(json["accessors"][positions]);
        uneven["accessors"].back()["count"] = 3;
        uneven["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
            uneven["accessors"].size() - 1;
        word["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = "x";
        for (const auto& [damaged, part] :
             {std::pair{uneven, "not of one length"}, {word, "names no accessor"}}) {
            const auto loaded = folder_.load("uneven.gltf", damaged.dump());
            QVERIFY2(!loaded, part);
            COMPARE_CONTAINS(loaded.error().text, part);
        }
        const Scene scene = read(json.dump());
        const std::vector<Vec3> offsets = tetrahedron().positions; // the corners stand for four places
        QCOMPARE(scene.objects.size(), offsets.size());
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            COMPARE_NEAR(scene.objects[i].pose.translation, Vec3(Vec3(10, 0, 0) + 2 * offsets[i]), 1e-12,
                         "m");
            COMPARE_NEAR(scene.objects[i].geometry->positions[1], Vec3(2 * tetrahedron().positions[1]), 1e-12,
                         "m");
        }
        QCOMPARE(scene.objects[1].name, std::string("screw 2"));
        const auto glb = glbOf(scene);
        QVERIFY(glb);
        COMPARE_LACKS(*glb, "EXT_mesh_gpu_instancing");
        const auto again = folder_.load("again.glb", *glb);
        QVERIFY(again);
        QCOMPARE(again->scene.objects.size(), offsets.size());
        QCOMPARE_EQ(boundsOf(again->scene).high, boundsOf(scene).high);
    }

    void rigidTransformsBecomeThePose() {
        const Scene scene =
            read(withNodes(R"([{"name":"arm","translation":[1,2,3],"children":[1]},)"
                           R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])"));
        const SceneObject& object = scene.objects[0];
        COMPARE_NEAR(object.pose.translation, Vec3(1, 2, 3), 1e-9, "m");
        COMPARE_NEAR(cornerX(object), Vec3(1, 3, 3), 1e-9, "m");
        COMPARE_NEAR(object.geometry->positions[1], Vec3(1, 0, 0), 1e-9, "m"); // nothing baked
    }

    void scaleAndShearGoIntoTheVertices() {
        const Scene scene =
            read(withNodes(R"([{"scale":[2,1,1],"children":[1]},)"
                           R"({"mesh":0,"rotation":[0,0,0.3826834323650898,0.9238795325112867]}])"));
        const SceneObject& object = scene.objects[0];
        COMPARE_NEAR(cornerX(object), Vec3(std::sqrt(2), std::sqrt(0.5), 0), 1e-9, "m");
        COMPARE_NEAR(object.pose.rotation.norm(), 1, 1e-12, "");
        COMPARE_NEAR(volumeOf(*object.geometry), 2.0 / 6, 1e-9, "");
    }

    void mirroredMeshesStayRightSideOut() {
        const Scene scene = read(withNodes(R"([{"mesh":0,"scale":[-1,1,1]}])"));
        COMPARE_NEAR(cornerX(scene.objects[0]), Vec3(-1, 0, 0), 1e-9, "m");
        COMPARE_NEAR(volumeOf(*scene.objects[0].geometry), 1.0 / 6, 1e-9, "");
    }

    void matricesAreReadByColumns() {
        const Scene scene = read(withNodes(R"([{"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])"));
        COMPARE_NEAR(cornerX(scene.objects[0]), Vec3(5, 7, 7), 1e-9, "m");
    }

    void everyNodeWithAMeshIsAnObject() {
        const std::string nodes =
            R"("nodes":[{"name":"a","mesh":0},{"name":"b","mesh":0,"translation":[9,0,0]},{"mesh":0}])";
        const Scene all = read(asGltf(tetrahedron(), nodes));
        QCOMPARE(all.objects.size(), std::size_t(3));
        QCOMPARE(all.objects[1].name, std::string("b"));
        QCOMPARE(all.objects[2].name, std::string("mesh"));
        const Scene chosen =
            read(asGltf(tetrahedron(), nodes + R"(,"scene":1,"scenes":[{"nodes":[0,1]},{"nodes":[1]}])"));
        QCOMPARE(chosen.objects.size(), std::size_t(1));
        QCOMPARE(chosen.objects[0].name, std::string("b"));
    }

    void everyModeGivesItsTriangles_data() {
        using Triangles = std::vector<std::array<Index, 3>>;
        QTest::addColumn<int>("mode");
        QTest::addColumn<Triangles>("expected");
        QTest::newRow("points") << 0 << Triangles{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
        QTest::newRow("lines") << 1 << Triangles{{0, 1, 1}, {2, 3, 3}};
        QTest::newRow("loop") << 2 << Triangles{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 0}};
        QTest::newRow("line strip") << 3 << Triangles{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}};
        QTest::newRow("triangles") << 4 << Triangles{{0, 1, 2}};
        QTest::newRow("strip") << 5 << Triangles{{0, 1, 2}, {1, 3, 2}};
        QTest::newRow("fan") << 6 << Triangles{{0, 1, 2}, {0, 2, 3}};
    }
    void everyModeGivesItsTriangles() {
        QFETCH(int, mode);
        using Triangles = std::vector<std::array<Index, 3>>;
        QFETCH(Triangles, expected);
        const Scene scene =
            read(replaced(asGltf(tetrahedron()), R"(,"indices":1)", R"(,"mode":)" + std::to_string(mode)));
        QCOMPARE(scene.objects[0].geometry->triangles, expected);
    }

    void materialsAreSurfaces() {
        const std::string two =
            R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":1},)"
            R"({"attributes":{"POSITION":0},"indices":1,"material":0},)"
            R"({"attributes":{"POSITION":0},"indices":1,"material":1}]}],"materials":[)"
            R"({"name":"red","pbrMetallicRoughness":{"baseColorFactor":[1,0,0.5,1]}},{}])";
        const Scene scene =
            read(replaced(asGltf(tetrahedron()),
                          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])", two));
        const SceneObject& object = scene.objects[0];
        QCOMPARE(object.surfaces.size(), std::size_t(2));
        QCOMPARE(object.surfaces[0].name, std::string("material 1"));
        QCOMPARE(object.surfaces[1].name, std::string("red"));
        QCOMPARE(object.surfaces[1].colour, Eigen::Vector3f(1, 0, 0.5f));
        QCOMPARE(object.geometry->surfaceOf, (std::vector<Index>{0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0}));
        QCOMPARE(object.geometry->positions.size(), std::size_t(4)); // shared by all three;
    }

    void externalBuffersComeFromTheFolderOnly() {
        const std::string glb = asGlb(tetrahedron());
        const std::string binary = glb.substr(glb.size() - 96);
        const auto with = [&](const std::string& uri) {
            const std::string own = asGltf(tetrahedron());
            const std::size_t at = own.find(",\"uri\":");
            return own.substr(0, at) + ",\"uri\":\"" + uri + "\"}]}";
        };
        std::filesystem::create_directories(folder_.path() / "scene" / "data");
        folder_.write("scene/data/my mesh.bin", binary);
        folder_.write("outside.bin", binary);
        std::filesystem::create_symlink(folder_.path() / "outside.bin",
                                        folder_.path() / "scene" / "link.bin");
        QVERIFY(folder_.load("scene/mesh.gltf", with("data/my%20mesh.bin")));
        QVERIFY(folder_.load("scene/mesh.gltf", with("./data/../data/my mesh.bin")));
        const std::string absolute = (folder_.path() / "outside.bin").string();
        for (const std::string& uri :
             {std::string("../outside.bin"), absolute, "file://" + absolute, std::string("link.bin"),
              std::string("gone.bin"), std::string("http://127.0.0.1/x.bin"), std::string("data")})
            refused("scene/mesh.gltf", with(uri), "is not in its folder");
        folder_.write("scene/data/short.bin", binary.substr(1));
        refused("scene/mesh.gltf", with("data/short.bin"), "cannot be parsed");
    }

    void imagesAreNeitherReadNorMissed() {
        const std::string images =
            R"("images":[{"uri":"gone.png"},{"uri":"../../secret.png"},{"bufferView":99,"mimeType":"image/png"}],)"
            R"("textures":[{"source":0}],)";
        QVERIFY(folder_.load("a.gltf", replaced(asGltf(tetrahedron()), "{", "{" + images)));
    }

    void structuralLiesAreRefused_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("error");
        const auto row = [](const char* name, const std::string& text, const char* error) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QString(error);
        };
        const std::string good = asGltf(tetrahedron());
        row("own child", withNodes(R"([{"children":[0],"mesh":0}])"), "is its own ancestor");
        row("ring", withNodes(R"([{"children":[1]},{"children":[0]}])"), "is its own ancestor");
        row("two parents", withNodes(R"([{"children":[1,2]},{"children":[2]},{"mesh":0}])"), "two parents");
        row("no such node", withNodes(R"([{"children":[7]}])"), "nodes[7] is used but not there");
        row("no such mesh", withNodes(R"([{"mesh":3}])"), "names a mesh that is not there");
        row("zero rotation", withNodes(R"([{"mesh":0,"rotation":[0,0,0,0]}])"), "no usable rotation");
        row("projective", withNodes(R"([{"mesh":0,"matrix":[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])"),
            "not affine");
        row("far away", withNodes(R"([{"mesh":0,"translation":[1e7,0,0]}])"), "beyond 1e6 m");
        row("deep tree", withNodes(deepTree(65)), "deeper than 64 levels");
        row("deep JSON", "{\"extras\":" + std::string(100000, '['), "nests deeper than 128");
        std::string manyObjects;
        for (int i = 0; i < 1'500'000; ++i)
            manyObjects += "{},";
        row("wide JSON", "{\"extras\":[" + manyObjects + "{}]}", "1,500,000 lists and objects");
        row("count too large", replaced(good, "\"count\":4", "\"count\":5"), "accessors[0] reaches beyond");
        row("count beyond everything", replaced(good, "\"count\":12", "\"count\":4611686018427387905"),
            "accessors[1]");
        row("offset too large", replaced(good, "{\"bufferView\":0,", "{\"bufferView\":0,\"byteOffset\":8,"),
            "accessors[0] reaches beyond");
        row("view too long", replaced(good, "\"byteLength\":48}", "\"byteLength\":97}"),
            "bufferViews[0] reaches beyond");
        row("view too far", replaced(good, "\"byteOffset\":48", "\"byteOffset\":90"),
            "bufferViews[1] reaches beyond");
        row("no such buffer", replaced(good, "\"buffer\":0", "\"buffer\":2"),
            "bufferViews[0] reaches beyond");
        row("no such accessor", replaced(good, "\"POSITION\":0", "\"POSITION\":9"),
            "accessors[9] is used but not there");
        row("wrong type", replaced(good, "VEC3", "VEC2"), "accessors[0] has a type that does not fit");
        row("float indices", replaced(good, "5125", "5126"), "has indices that are not unsigned");
        row("compressed", replaced(good, "{", R"({"extensionsRequired":["ACME_other_meshes"],)"),
            "needs the extension");
        row("no JSON", "{\"asset\"", "its JSON cannot be parsed");
    }
    void structuralLiesAreRefused() {
        QFETCH(QByteArray, content);
        QFETCH(QString, error);
        QVERIFY(!content.isEmpty());
        refused("a.gltf", content.toStdString(), error.toStdString());
    }

    void indicesBeyondTheVerticesAreRefused() {
        TriangleSoup soup = tetrahedron();
        soup.triangles[2][1] = 4;
        refused("a.glb", asGlb(soup), "index 7 refers to vertex 4, but only 4 are defined");
    }

    void coordinatesMustBeFinite() {
        TriangleSoup soup = tetrahedron();
        soup.positions[3].y() = NAN;
        refused("a.glb", asGlb(soup), "coordinate of vertex 3");
    }

    void glbLengthsMustAddUp() {
        const std::string good = asGlb(tetrahedron());
        QVERIFY(folder_.load("a.glb", good));
        refused("a.glb", good + "more", "the length in its header");
        refused("a.glb", good.substr(0, good.size() - 4), "the length in its header");
        for (std::uint32_t length : {0u, 8u, 0xFFFFFFF0u}) // of the first chunk
            refused("a.glb", std::string(good).replace(12, 4, word(length)), "");
        refused("a.glb", std::string(good).replace(4, 4, word(1)), "glb version 1");
        const std::size_t second = good.size() - 96 - 8;
        refused("a.glb", std::string(good).replace(second, 4, word(100)),
                "byte " + std::to_string(second) + ": a chunk reaches");
        refused("a.glb", std::string(good).replace(second, 4, word(40)), ""); // the rest is no chunk
    }

private:
    static std::string deepTree(int levels) {
        std::string nodes = "[";
        for (int i = 0; i < levels; ++i)
            nodes += "{\"children\":[" + std::to_string(i + 1) + "]},";
        return nodes + "{\"mesh\":0}]";
    }

    Scene read(const std::string& content) {
        const auto loaded = folder_.load("mesh.gltf", content);
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return loaded->scene;
    }

    void refused(const std::string& name, const std::string& content, const std::string& part) {
        const auto loaded = folder_.load(name, content);
        QVERIFY2(!loaded, part.c_str());
        QVERIFY2(loaded.error().text.find(part) != std::string::npos, loaded.error().text.c_str());
        QVERIFY2(loaded.error().text.find('\n') == std::string::npos, loaded.error().text.c_str());
    }

    FileFolder folder_;
};

TACTUM_TEST(TestGltf)

} // namespace test_gltf

#include "test_gltf.moc"
