// What is written as X3D: well formed whatever the names are, and in H3D's terms what the scene says.
#include <functional>

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include "core/files/corner_pool.h"
#include "core/files/flatten_layers.h"
#include "core/files/images/read_image.h"
#include "core/files/x3d/write_x3d.h"
#include "tests/core/files/bodies.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/files/parsed_xml.h"
#include "tests/core/files/x3d_scenes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_write_x3d {

using namespace tactum;
using namespace tactum::test;

namespace {

Scene sceneOf(SceneObject object) {
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

/// A square with texture coordinates that fill the unit square.
SceneObject textured(std::vector<TextureLayer> layers) {
    auto soup = std::make_shared<TriangleSoup>(*sheet(0.05));
    for (const auto& t : soup->triangles)
        for (const Index corner : t)
            soup->cornerUvs.push_back(
                (soup->positions[corner].head<2>() * 10 + Vector2d::Constant(0.5)).cast<float>());
    SceneObject object = bodyOf("wall", soup);
    object.surfaces[0].layers = std::move(layers);
    return object;
}

const X3dImage* imageOf(const X3dExport& written, const Element& texture) {
    for (const X3dImage& image : written.images)
        if (texture.attributes["url"] == QString::fromStdString("\"" + image.name + "\"")) return &image;
    return nullptr;
}

} // namespace

class TestWriteX3d : public QObject {
    Q_OBJECT
private slots:
    void randomScenesAreWellFormed();
    void sameSceneSameBytes();
    void namesComeBackFromTheMetadata();
    void surfacesAreAbsolute_data();
    void surfacesAreAbsolute();
    void depthMapsHoldTheHeight();
    void parametersWithoutHeightAreMaps();
    void coordinatesFitTheMap();
    void trianglesAreExact();
    void posesTurnAsOurs();
    void motionsFollowTheirKeys();
    void hiddenObjectsAreSwitchedOff();
    void theDeviceStandsApart();
    void filesAreCalledAfterTheScene();
    void ourReaderKnowsTheNamesAgain();
    void ourOwnFilesComeBackAsTheyWere();

private:
    FileFolder folder_;
};

void TestWriteX3d::randomScenesAreWellFormed() {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Rng rng(seed);
        const Scene scene = randomHapticScene(rng);
        const X3dExport written = x3dOf(scene);
        const Element root = parsed(written.scene);
        parsed(written.device);
        QSet<QString> defs;
        std::size_t triangles = 0;
        const std::function<void(const Element&)> visit = [&](const Element& element) {
            if (const QString def = element.attributes.value("DEF"); !def.isNull()) {
                QVERIFY(QRegularExpression("^[A-Za-z][A-Za-z0-9_-]*$").match(def).hasMatch());
                QVERIFY2(!defs.contains(def), qPrintable(def));
                defs.insert(def);
            }
            if (element.name.endsWith("Surface"))
                QCOMPARE(element.attributes["useRelativeValues"], QString("false"));
            if (element.name == "ImageTexture") QVERIFY(imageOf(written, element));
            // Shapes for bodies to meet say which field they are of.
            if (element.name == "IndexedFaceSet" && !element.attributes.contains("containerField"))
                triangles += std::size_t(element.attributes["coordIndex"].count("-1"));
            for (const Element& child : element.children)
                visit(child);
        };
        visit(root);
        for (const Element* route : root.all("ROUTE")) {
            QVERIFY(defs.contains(route->attributes["fromNode"]));
            QVERIFY(defs.contains(route->attributes["toNode"]));
        }
        std::size_t wanted = 0;
        for (const SceneObject& object : scene.objects)
            for (const auto& t : object.geometry->triangles)
                wanted += cornersOf(t) == 3;
        QCOMPARE(triangles, wanted);
    }
}

void TestWriteX3d::sameSceneSameBytes() {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Rng one(seed), other(seed);
        const X3dExport a = x3dOf(randomHapticScene(one)), b = x3dOf(randomHapticScene(other));
        QCOMPARE_EQ(a.scene, b.scene);
        QCOMPARE_EQ(a.device, b.device);
        QVERIFY(a.losses == b.losses);
        for (std::size_t i = 0; i < a.images.size(); ++i) {
            QCOMPARE_EQ(a.images[i].name, b.images[i].name);
            QCOMPARE_EQ(a.images[i].bytes, b.images[i].bytes);
        }
    }
}

void TestWriteX3d::namesComeBackFromTheMetadata() {
    SceneObject object = textured({});
    object.name = "a \"b\" \\ <c> & T\xC3\xA4sse";
    const Element root = parsed(x3dOf(sceneOf(object)).scene);
    const Element* name = root.all("MetadataString").front();
    QCOMPARE(name->attributes["value"], QString::fromUtf8("\"a \\\"b\\\" \\\\ <c> & T\xC3\xA4sse\""));
}

void TestWriteX3d::surfacesAreAbsolute_data() {
    QTest::addColumn<double>("mu");
    QTest::addColumn<QString>("node");
    QTest::newRow("smooth") << 0.0 << "SmoothSurface";
    QTest::newRow("rough") << 0.4 << "FrictionalSurface";
}

void TestWriteX3d::surfacesAreAbsolute() {
    QFETCH(double, mu);
    QFETCH(QString, node);
    SceneObject object = textured({});
    object.surfaces[0].material = {650, 1.5, mu, mu / 2, 0.25};
    object.surfaces[0].sides = Sides::Back;
    const Element root = parsed(x3dOf(sceneOf(object)).scene);
    const Element& surface = root.one(node);
    QCOMPARE(surface.number("stiffness"), 650.0);
    QCOMPARE(surface.number("damping"), 1.5);
    QCOMPARE(surface.attributes.contains("staticFriction"), mu > 0);
    QCOMPARE(surface.attributes.contains("dynamicFriction"), mu > 0);
    if (mu > 0) QCOMPARE(surface.number("staticFriction"), mu);
    if (mu > 0) QCOMPARE(surface.number("dynamicFriction"), mu / 2);
    QCOMPARE(root.one("IndexedFaceSet").one("HapticsOptions").attributes["touchableFace"], QString("BACK"));
    for (const Element* number : surface.all("MetadataDouble"))
        if (number->attributes["name"] == "viscosity") QCOMPARE(number->number("value"), 0.25);
    QCOMPARE(root.one("GeometryBoundTreeOptions").attributes["boundType"], QString("SPHERE"));
}

void TestWriteX3d::depthMapsHoldTheHeight() {
    Rng rng(7);
    const SceneObject object =
        textured({imageLayer(noiseImage(rng), TextureMapping::UvUnit, 0.01, 6e-4),
                  heightLayer(TextureSource::Dots, TextureMapping::Planar, 0.02, -3e-4)});
    const X3dExport written = x3dOf(sceneOf(object));
    const Element root = parsed(written.scene);
    const Element& surface = root.one("DepthMapSurface");
    const X3dImage* image = imageOf(written, surface.one("ImageTexture"));
    QVERIFY(image);
    QVERIFY(surface.one("ImageTexture").attributes["containerField"] == "depthMap");
    const auto read = readImage(folder_.write("depth.png", image->bytes));
    VERIFY_RESULT(read);
    QCOMPARE_EQ(read->image->bits(), 8);
    const FlatPicture height = flattenHeight(object, 0);
    const double span = surface.number("maxDepth");
    QCOMPARE(span, height.high - height.low);
    const auto stack = stackOf(object.surfaces[0].layers, object.geometry);
    const TextureImage& map = *read->image;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            TexturePoint point;
            point.uv = height.canvas.uvAt(x, y);
            point.position << (point.uv - Vector2d::Constant(0.5)) / 10, 0;
            const double wanted = feel(*stack, point, 0).height - height.low;
            QCOMPARE_LE(std::abs(span * map.texel(map.level(0), x, y) - wanted), 0.502 * span / 255);
        }
}

void TestWriteX3d::parametersWithoutHeightAreMaps() {
    TextureLayer rough = imageLayer(ramp(), TextureMapping::UvUnit, 0.01, 1);
    rough.target = TextureTarget::StaticFriction;
    SceneObject object = textured({rough});
    object.surfaces[0].material = {600, 0, 0.5, 0.3, 0};
    {
        const X3dExport written = x3dOf(sceneOf(object));
        const Element root = parsed(written.scene);
        const Element& surface = root.one("HapticTexturesSurface");
        QCOMPARE(surface.one("ImageTexture").attributes["containerField"], QString("staticFrictionMap"));
        COMPARE_NEAR(surface.number("minStaticFriction"), 0.5, 0.01, "");
        COMPARE_NEAR(surface.number("maxStaticFriction"), 1.0, 0.01, "");
        QVERIFY(!surface.attributes.contains("minStiffness"));
    }
    // Beside height only the mean is left, and that is said.
    object.surfaces[0].layers.push_back(imageLayer(ramp(), TextureMapping::UvUnit, 0.01, 5e-4));
    const X3dExport written = x3dOf(sceneOf(object));
    const Element root = parsed(written.scene);
    COMPARE_NEAR(root.one("DepthMapSurface").number("staticFriction"), 0.75, 1e-3, "");
    QCOMPARE(root.one("ImageTexture").attributes["containerField"], QString("depthMap"));
    QCOMPARE(written.images.size(), std::size_t(1));
    QVERIFY(std::ranges::any_of(written.losses, [](const Loss& loss) {
        return loss.sentence.find("mean") != std::string::npos && loss.what == "layers";
    }));
}

void TestWriteX3d::coordinatesFitTheMap() {
    SceneObject object = textured({imageLayer(ramp(8), TextureMapping::UvUnit, 0.01, 5e-4)});
    auto wide = std::make_shared<TriangleSoup>(*object.geometry);
    for (auto& uv : wide->cornerUvs)
        uv = 4 * uv - Eigen::Vector2f(1, 1); // -1 to 3
    object.geometry = wide;
    const Element root = parsed(x3dOf(sceneOf(object)).scene);
    const auto uvs = root.one("TextureCoordinate").numbers("point");
    QCOMPARE(std::ranges::min(uvs), 0.0);
    QCOMPARE(std::ranges::max(uvs), 1.0);
}

void TestWriteX3d::trianglesAreExact() {
    SceneObject object = bodyOf("ball", ball(0.0437, 2));
    const Element root = parsed(x3dOf(sceneOf(object)).scene);
    const auto points = root.one("Coordinate").numbers("point"),
               indices = root.one("IndexedFaceSet").numbers("coordIndex");
    const TriangleSoup& soup = *object.geometry;
    QCOMPARE(indices.size(), 4 * soup.triangles.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i % 4 == 3) continue;
        const Vec3& wanted = soup.positions[soup.triangles[i / 4][i % 4]];
        for (std::size_t k = 0; k < 3; ++k)
            QCOMPARE_EQ(points[3 * std::size_t(indices[i]) + k], wanted[int(k)]);
    }
}

void TestWriteX3d::posesTurnAsOurs() {
    Rng rng(8);
    for (int n = 0; n < 50; ++n) {
        SceneObject object = bodyOf("ball", ball(0.05, 0));
        object.pose = {Quat(Eigen::AngleAxisd(uniform(rng, -3.1, 3.1), direction(rng))), inBox(rng, 1)};
        const Element root = parsed(x3dOf(sceneOf(object)).scene);
        const auto turn = root.one("Transform").numbers("rotation"),
                   move = root.one("Transform").numbers("translation");
        const Pose read{Quat(Eigen::AngleAxisd(turn[3], Vec3(turn[0], turn[1], turn[2]))),
                        {move[0], move[1], move[2]}};
        for (const Vec3& p : object.geometry->positions)
            COMPARE_NEAR(read.apply(p), object.pose.apply(p), 1e-12, "m");
    }
}

/// An interpolator of X3D is straight between its keys; of two keys of one part the later one counts from
/// there on.
void TestWriteX3d::motionsFollowTheirKeys() {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Rng rng(seed);
        SceneObject object = bodyOf("ball", ball(0.05, 0));
        object.motion = randomMotion(rng);
        const Element root = parsed(x3dOf(sceneOf(object)).scene);
        const double cycle = root.one("TimeSensor").number("cycleInterval");
        QCOMPARE(root.one("TimeSensor").attributes["loop"] == "true", object.motion->duration > 0);
        const auto key = root.one("PositionInterpolator").numbers("key"),
                   value = root.one("PositionInterpolator").numbers("keyValue");
        QCOMPARE(value.size(), 3 * key.size());
        for (int n = 0; n < 200; ++n) {
            const double t = uniform(rng, 0, key.back() * cycle);
            const auto later = std::size_t(std::upper_bound(key.begin(), key.end(), t / cycle) - key.begin());
            if (later == 0 || later == key.size()) continue;
            const double part = (t / cycle - key[later - 1]) / (key[later] - key[later - 1]);
            Vec3 found;
            for (std::size_t k = 0; k < 3; ++k)
                found[int(k)] = (1 - part) * value[3 * later - 3 + k] + part * value[3 * later + k];
            const bool isCubic = object.motion->translation.interpolation == Interpolation::CubicSpline;
            const double off = (found - object.motion->at(t).translation).norm();
            QVERIFY2(off < (isCubic ? 5e-5 : 1e-12), qPrintable(QString("%1 m, %2").arg(off).arg(isCubic)));
        }
        const auto turns = root.one("OrientationInterpolator").numbers("keyValue"),
                   parts = root.one("OrientationInterpolator").numbers("key");
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            if (object.motion->rotation.interpolation != Interpolation::Linear) break;
            const Eigen::AngleAxisd turn(turns[4 * i + 3],
                                         Vec3(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2]));
            QCOMPARE_LT(Quat(turn).angularDistance(object.motion->at(parts[i] * cycle).rotation), 1e-6);
        }
    }
}

void TestWriteX3d::hiddenObjectsAreSwitchedOff() {
    SceneObject object = textured({});
    object.visible = false;
    const Element root = parsed(x3dOf(sceneOf(object)).scene);
    QCOMPARE(root.one("Switch").attributes["whichChoice"], QString("-1"));
    QCOMPARE(root.one("Switch").all("Shape").size(), std::size_t(1));
}

void TestWriteX3d::theDeviceStandsApart() {
    Scene scene;
    scene.proxyRadius = 0.0031;
    const X3dExport written = x3dOf(scene);
    const Element device = parsed(written.device);
    QCOMPARE(device.one("RuspiniRenderer").number("proxyRadius"), 0.0031);
    QCOMPARE_GT(device.one("AnyDevice").number("forceLimit"), 0);
    QVERIFY(parsed(written.scene).all("DeviceInfo").empty());
}

void TestWriteX3d::filesAreCalledAfterTheScene() {
    const Scene scene =
        sceneOf(textured({heightLayer(TextureSource::Dots, TextureMapping::Planar, 0.02, 1e-4)}));
    const X3dExport alone = x3dOf(scene), beside = x3dOf(scene, X3dNames::beside("my cup?"));
    QVERIFY(!alone.images.empty());
    COMPARE_BEGINS(alone.images[0].name, "maps/");
    COMPARE_CONTAINS(alone.scene, " deviceinfo.x3d.");
    COMPARE_BEGINS(beside.images[0].name, "my~20cup~3F-maps/");
    QCOMPARE(X3dNames::beside("my cup?").device, std::string("my~20cup~3F-deviceinfo.x3d"));
    COMPARE_CONTAINS(beside.scene, beside.images[0].name);
    COMPARE_CONTAINS(beside.scene, " my~20cup~3F-deviceinfo.x3d.");
}

void TestWriteX3d::ourReaderKnowsTheNamesAgain() {
    Rng rng(5);
    Scene scene;
    for (const char* name : {"lid", "a \"b\" \\ <c> & T\xC3\xA4sse", "  ]]> ", "1", "lid"}) {
        SceneObject object = textured({});
        object.name = name;
        object.surfaces[0].name = std::string(name) + " skin";
        if (scene.objects.size() % 2 == 0) object.motion = randomMotion(rng); // one Transform more
        scene.add(object);
    }
    const auto loaded = loadScene(folder_.write("own.x3d", x3dOf(scene).scene));
    VERIFY_RESULT(loaded);
    QCOMPARE(loaded->scene.objects.size(), scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        QCOMPARE(loaded->scene.objects[i].name, scene.objects[i].name);
        QCOMPARE(loaded->scene.objects[i].surfaces[0].name, scene.objects[i].surfaces[0].name);
    }
}

/// What H3D has no field for stands in our metadata, and is read again: a scene is not five objects of one
/// name.
void TestWriteX3d::ourOwnFilesComeBackAsTheyWere() {
    Scene scene;
    SceneObject object;
    object.surfaces.resize(3);
    object.name = "plate \"one\"";
    object.surfaces[0].name = "cork", object.surfaces[1].name = "cork", object.surfaces[2].name = "glue";
    object.surfaces[0].material = {321, 1.5, 0.7, 0.3, 2.25};
    object.surfaces[1].material = {900, 0, 0, 0, 0};
    object.surfaces[1].shading = {true, NormalSource::File, 0.5};
    object.surfaces[1].visible = false;
    object.surfaces[2].sides = Sides::None;
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 0}};
    soup->triangles = {{0, 2, 1}, {1, 2, 3}, {1, 4, 4}, {3, 3, 3}, {1, 3, 4}};
    soup->surfaceOf = {0, 1, 0, 0, 2};
    object.geometry = soup;
    object.pose = {Quat::Identity(), {0, 0.5, 0}};
    scene.add(object);
    object.name = "hidden", object.visible = false;
    scene.add(object);
    const auto loaded = folder_.load("a.x3d", x3dOf(scene, X3dNames::beside("a")).scene);
    QVERIFY2(loaded, loaded ? "" : loaded.error().text.c_str());
    QCOMPARE(loaded->scene.objects.size(), std::size_t(2));
    for (std::size_t i = 0; i < 2; ++i) {
        const SceneObject &was = scene.objects[i], &is = loaded->scene.objects[i];
        QCOMPARE(is.name, was.name);
        QCOMPARE(is.visible, was.visible);
        QCOMPARE(is.geometry->triangles.size(), soup->triangles.size());
        QCOMPARE(is.geometry->positions.size(), soup->positions.size()); // welded where surfaces meet
        QCOMPARE(boundsOf(loaded->scene).high, boundsOf(scene).high);
        QCOMPARE(is.surfaces.size(), std::size_t(3));
        for (std::size_t k = 0; k < 3; ++k) {
            const Surface &before = was.surfaces[k], &after = is.surfaces[k];
            QCOMPARE(after.name, before.name);
            if (k < 2) QCOMPARE(after.material, before.material); // what is not felt has no feel
            QCOMPARE(after.material.viscosity, before.material.viscosity);
            QCOMPARE(after.shading, before.shading);
            QCOMPARE(after.sides, before.sides);
            QCOMPARE(after.visible, before.visible);
        }
    }
}

TACTUM_TEST(TestWriteX3d)

} // namespace test_write_x3d

#include "test_write_x3d.moc"
