// What other programs see and feel of texture layers in our files: the look of a bump, and maps of
// MPEG_haptic_material.
#include <cstring>

#include <QImage>
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/gltf_maps.h"
#include "core/files/gltf/write_gltf.h"
#include "tests/core/files/json_text.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/test_program.h"

namespace test_gltf_maps {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kSide = 0.02; // m

/// With normals, as bumps that can be seen need them.
Soup sheet(const Vector2d& low = {0, 0}, const Vector2d& high = {1, 1}) {
    TriangleSoup soup = uvSquare(kSide, low, high);
    soup.cornerNormals.assign(soup.cornerUvs.size(), {0, 0, 1});
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

/// Rises by 0.3 along u and by 0.6 along v.
TextureLayer ramp(TextureTarget target, double strength) {
    TextureLayer layer = imageLayer(imageOf(
                                        64, 64, [](double u, double v) { return 0.3 * u + 0.6 * v; }, 16),
                                    TextureMapping::UvUnit, 0.01, strength);
    layer.target = target;
    return layer;
}

Scene sceneOf(Soup soup, std::vector<TextureLayer> layers) {
    SceneObject object;
    object.name = "sheet";
    object.geometry = std::move(soup);
    object.surfaces.resize(1);
    object.surfaces[0].name = "paint";
    object.surfaces[0].material = {500, 0, 0.5, 0.5, 0};
    object.surfaces[0].layers = std::move(layers);
    Scene scene;
    scene.add(object);
    return scene;
}

std::string saved(const Scene& scene) {
    const auto glb = glbOf(scene);
    return glb ? *glb : throw std::runtime_error(glb.error().text);
}

/// A file as another program has it.
struct Seen {
    explicit Seen(const std::string& glb) {
        std::uint32_t length = 0;
        std::memcpy(&length, glb.data() + 12, 4);
        json = Json::parse(glb.substr(20, length));
        binary = glb.substr(28 + length);
    }
    const Json& material() const { return json["materials"][0]; }
    std::string view(std::size_t i) const {
        const Json& view = json["bufferViews"][i];
        return binary.substr(view["byteOffset"], view["byteLength"]);
    }
    QImage picture(const Json& info) const {
        const std::size_t image = json["textures"][std::size_t(info["index"])]["source"];
        return QImage::fromData(QByteArray::fromStdString(view(json["images"][image]["bufferView"])));
    }
    Eigen::Vector4f tangent(std::size_t vertex) const {
        const std::size_t accessor = json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"];
        Eigen::Vector4f tangent;
        std::memcpy(tangent.data(), view(json["accessors"][accessor]["bufferView"]).data() + 16 * vertex, 16);
        return tangent;
    }
    Json json;
    std::string binary;
};

} // namespace

class TestGltfMaps : public QObject {
    Q_OBJECT

    FileFolder folder_;

    LoadedScene load(const std::string& glb) {
        auto loaded = folder_.load("scene.glb", glb);
        return loaded ? std::move(*loaded) : throw std::runtime_error(loaded.error().text);
    }

private slots:
    /// A slope of 0.3 and 0.6 times 5 mm over 20 mm.
    void aSlopeIsSeenAsItsNormal() {
        const Seen seen(saved(sceneOf(sheet(), {ramp(TextureTarget::Height, 5e-3)})));
        QVERIFY(seen.material().contains("normalTexture"));
        const QImage picture = seen.picture(seen.material()["normalTexture"]);
        QCOMPARE(picture.size(), QSize(64, 64));
        const Vec3 normal = Vec3(-0.3 * 5e-3 / kSide, -0.6 * 5e-3 / kSide, 1).normalized();
        for (const int x : {5, 32, 60})
            for (const int y : {3, 20, 62}) {
                const QColor colour = picture.pixelColor(x, y);
                const Vec3 shown(colour.red(), colour.green(), colour.blue());
                QVERIFY2((shown - (127.5 * normal.array() + 127.5).matrix()).cwiseAbs().maxCoeff() < 1,
                         qPrintable(colour.name()));
            }
        QVERIFY(seen.tangent(0) == Eigen::Vector4f(1, 0, 0, 1));
        // Mirrored coordinates turn the frame around.
        const Seen mirrored(saved(sceneOf(sheet({1, 0}, {0, 1}), {ramp(TextureTarget::Height, 5e-3)})));
        QVERIFY(mirrored.tangent(0) == Eigen::Vector4f(-1, 0, 0, -1));
    }
    void aPictureBeyondTheUnitSquareIsMoved() {
        const Seen seen(saved(sceneOf(sheet({-1, 2}, {1, 3}), {ramp(TextureTarget::Height, 5e-3)})));
        const Json& info = seen.material()["normalTexture"];
        const Json& moved = info["extensions"]["KHR_texture_transform"];
        QCOMPARE_EQ(moved["offset"], Json({0.5, 2.0}));
        QCOMPARE_EQ(moved["scale"], Json({0.5, 1.0}));
        QCOMPARE_EQ(std::ranges::count(seen.json["extensionsUsed"], Json("KHR_texture_transform")), 1);
        const std::string glb = saved(sceneOf(sheet({-1, 2}, {1, 3}), {ramp(TextureTarget::Height, 5e-3)}));
        QCOMPARE(saved(load(glb).scene), glb);
    }
    void theLookIsMadeAnewEachTime() {
        const std::string glb = saved(sceneOf(sheet(), {ramp(TextureTarget::Height, 5e-3)}));
        Scene again = load(glb).scene;
        QVERIFY(!again.kept.foreign);
        QCOMPARE(saved(again), glb);
        again.objects[0].surfaces[0].layers.clear();
        const Seen bare(saved(again));
        QVERIFY(!bare.material().contains("normalTexture"));
        QVERIFY(!bare.json.contains("textures") || bare.json["textures"].size() == 2); // MPEG's constants
        QVERIFY(!bare.material()["extensions"]["TACTUM_haptics"].contains("copies"));
    }
    void theLookThatOthersGaveStays() {
        Json theirs = Seen(saved(sceneOf(sheet(), {ramp(TextureTarget::Height, 5e-3)}))).json;
        const Seen ours(saved(sceneOf(sheet(), {ramp(TextureTarget::Height, 5e-3)})));
        for (const char* array : {"nodes", "meshes", "materials"})
            for (Json& element : theirs[array])
                element.erase("extensions");
        theirs.erase("extensions"), theirs.erase("extensionsUsed");
        theirs["materials"][0]["normalTexture"]["scale"] = 0.25;
        LoadedScene loaded = load(packGlb(theirs, ours.binary));
        loaded.scene.objects[0].surfaces[0].layers = {ramp(TextureTarget::Height, 1e-3)};
        std::string glb = saved(loaded.scene);
        for (int i = 0; i < 2; ++i) {
            const Seen seen(glb);
            QCOMPARE_EQ(seen.material()["normalTexture"], theirs["materials"][0]["normalTexture"]);
            QVERIFY(!seen.material()["extensions"]["TACTUM_haptics"].contains("copies"));
            const std::string again = saved(load(glb).scene);
            QCOMPARE_EQ(again, glb);
            glb = again;
        }
    }
    void withoutNormalsNoFrameIsGuessed() {
        auto bare = std::make_shared<TriangleSoup>(*sheet());
        bare->cornerNormals.clear();
        const Seen seen(saved(sceneOf(bare, {ramp(TextureTarget::Height, 5e-3)})));
        QVERIFY(!seen.material().contains("normalTexture"));
        QVERIFY(!seen.json["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
    }
    void layersAreMapsForOthers() {
        TextureLayer rubs = ramp(TextureTarget::DynamicFriction, -0.5);
        const Seen seen(saved(sceneOf(
            sheet(), {ramp(TextureTarget::Height, 1e-3), rubs, ramp(TextureTarget::Stiffness, 0.5)})));
        const Json& felt = seen.json["extensions"]["MPEG_haptic_material"]["materials"][0];
        const auto valueAt = [&](const char* property, int x, int y) { // of a texel, counted from the top
            const Json& entry = felt[property][0];
            const QImage picture = seen.picture(entry["texture"]).convertToFormat(QImage::Format_Grayscale16);
            const double part = reinterpret_cast<const quint16*>(picture.constScanLine(y))[x] / 65535.0;
            return double(entry["extras"]["min"]) +
                   part * (double(entry["extras"]["max"]) - double(entry["extras"]["min"]));
        };
        for (const auto& [x, y] : {std::pair{0, 63}, {10, 3}, {63, 0}}) {
            const double rise = 0.3 * (x + 0.5) / 64 + 0.6 * (63.5 - y) / 64;
            COMPARE_NEAR(valueAt("vibrotactileTexture", x, y), 1e-3 * rise, 1e-7, "m");
            COMPARE_NEAR(valueAt("friction", x, y), 0.5 * (1 - 0.5 * rise), 1e-4, "");
            COMPARE_NEAR(valueAt("stiffness", x, y), 500 * (1 + 0.5 * rise), 0.1, "N/m");
        }
        QCOMPARE_EQ(felt["friction"][0]["extras"]["unit"], Json(""));
        QCOMPARE_EQ(felt["vibrotactileTexture"][0]["extras"]["unit"], Json("m"));
    }
    /// What differs in colour alone is stored once; what lies elsewhere or is felt otherwise is not.
    void likeSurfacesShareTheirMap() {
        Scene scene = sceneOf(sheet(), {ramp(TextureTarget::Height, 5e-3)});
        auto soup = std::make_shared<TriangleSoup>(*scene.objects[0].geometry);
        soup->surfaceOf = {0, 1};
        soup->positions[2] *= 1 + 1e-9; // rounding
        scene.objects[0].geometry = soup;
        scene.objects[0].surfaces.push_back(scene.objects[0].surfaces[0]);
        const auto looks = [&](std::size_t i) {
            return int(Seen(saved(scene)).json["materials"][i]["normalTexture"]["index"]);
        };
        QCOMPARE(looks(0), looks(1));
        SurfaceMaps maps({});
        QCOMPARE(&maps.height(scene.objects[0], 1), &maps.height(scene.objects[0], 0)); // made once
        scene.objects[0].surfaces[1].layers[0].strength = 4e-3;
        QCOMPARE_NE(looks(0), looks(1));
    }
    /// Whatever the images of a scene are, its copies stay small.
    void mapsAreCapped() {
        Rng rng(3);
        const TextureLayer fine =
            imageLayer(imageOf(
                           1500, 40, [&](double, double) { return uniform(rng, 0, 1); }, 16),
                       TextureMapping::UvUnit, 0.01, 1e-3);
        const Seen seen(saved(sceneOf(sheet(), {fine})));
        QCOMPARE(seen.picture(seen.material()["normalTexture"]).size(), QSize(kLargestMapSide, 40));
    }
};

TACTUM_TEST(TestGltfMaps)

} // namespace test_gltf_maps

#include "test_gltf_maps.moc"
