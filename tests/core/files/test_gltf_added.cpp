// A glTF model that comes into a scene of another file looks as it did there, as far as numbers say it.
#include <QTest>

#include "core/scene/compose.h"
#include "tests/core/files/glb_json.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_gltf_added {

using namespace tactum;
using test::jsonOf;
using test::saved;
using test::withJson;

namespace {

/// One triangle with one surface.
Scene triangle(const std::string& name) {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    soup.triangles = {{0, 2, 1}};
    soup.surfaceOf = {0};
    Scene scene;
    SceneObject object;
    object.name = name;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.emplace_back().name = name + " surface";
    scene.add(std::move(object));
    return scene;
}

} // namespace

class TestGltfAdded : public QObject {
    Q_OBJECT

    FileFolder folder_;

    /// The material of a model, where it stands beside another one in a file of both; the same after that was
    /// opened.
    Json besides(const Json& material, const Json& textures = {}) {
        const std::string glb = saved(triangle("model"));
        Json json = jsonOf(glb);
        json["materials"] = Json::array({material});
        if (textures.is_array()) json["textures"] = textures;
        const auto model = folder_.load("model.glb", withJson(glb, json));
        Scene scene = triangle("first");
        addScene(scene, model.value().scene);
        const std::string both = saved(scene);
        const std::string again = saved(folder_.load("both.glb", both).value().scene);
        if (both != again) throw std::runtime_error("the second save differs");
        return jsonOf(both)["materials"][1];
    }

private slots:
    void itsNumbersComeAlong() {
        const Json look = besides({{"name", "brass"},
                                   {"doubleSided", false},
                                   {"alphaMode", "BLEND"},
                                   {"emissiveFactor", {0.1, 0.2, 0.3}},
                                   {"pbrMetallicRoughness",
                                    {{"baseColorFactor", {0.8, 0.6, 0.2, 0.5}},
                                     {"metallicFactor", 0.75},
                                     {"roughnessFactor", 0.25}}}});
        QCOMPARE_EQ(look["name"], "brass");
        QCOMPARE_EQ(look["doubleSided"], false);
        QCOMPARE_EQ(look["alphaMode"], "BLEND");
        QCOMPARE_EQ(look["emissiveFactor"], Json({0.1, 0.2, 0.3}));
        QCOMPARE_EQ(look["pbrMetallicRoughness"]["metallicFactor"], 0.75);
        QCOMPARE_EQ(look["pbrMetallicRoughness"]["roughnessFactor"], 0.25);
        QCOMPARE_EQ(look["pbrMetallicRoughness"]["baseColorFactor"][3], 0.5);
    }

    // Pictures stay in their file; so does what only scales them, and no number names what is not there.
    void whatHangsOnItsPicturesStaysBehind() {
        const Json picture{{"index", 0}};
        const Json look = besides({{"name", "brass"},
                                   {"alphaMode", "MASK"},
                                   {"emissiveFactor", {1, 1, 1}},
                                   {"emissiveTexture", picture},
                                   {"normalTexture", picture},
                                   {"extras", {{"of", "another program"}}},
                                   {"pbrMetallicRoughness",
                                    {{"baseColorFactor", {1, 1, 1, 0.5}},
                                     {"baseColorTexture", picture},
                                     {"metallicRoughnessTexture", picture},
                                     {"metallicFactor", 1.0},
                                     {"roughnessFactor", 1.0}}}},
                                  Json::array({Json::object()}));
        for (const char* key : {"alphaMode", "emissiveFactor", "emissiveTexture", "normalTexture"})
            QVERIFY2(!look.contains(key), key);
        const Json& pbr = look["pbrMetallicRoughness"];
        QVERIFY(!pbr.contains("baseColorTexture") && !pbr.contains("metallicRoughnessTexture"));
        QCOMPARE_EQ(pbr["metallicFactor"], 0.0);
        QCOMPARE_EQ(pbr["roughnessFactor"], 0.7);
        QCOMPARE_EQ(pbr["baseColorFactor"][3], 1.0);
    }
};

TACTUM_TEST(TestGltfAdded)

} // namespace test_gltf_added

#include "test_gltf_added.moc"
