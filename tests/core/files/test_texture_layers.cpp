// Texture layers of a scene: from bump maps of an OBJ, and what validation says of them.
#include <QTest>

#include "core/scene/describe.h"
#include "core/surface/texture_stack.h"
#include "tests/core/files/image_files.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_texture_layers {

using namespace tactum;

namespace {

const std::string kSquare = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl a\n"
                            "f 1/1 2/2 3/3\n";

using Severity = Finding::Severity;

Scene sceneWith(TextureLayer layer, bool withUvs = false) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    soup->triangles = {{0, 1, 2}};
    soup->surfaceOf = {0};
    if (withUvs) soup->cornerUvs = {{0, 0}, {1, 0}, {0, 1}};
    Scene scene;
    SceneObject object;
    object.name = "leaf";
    object.geometry = soup;
    object.surfaces.resize(1);
    object.surfaces[0].name = "top";
    layer.name = "veins";
    object.surfaces[0].layers = {std::move(layer)};
    scene.add(object);
    return scene;
}

/// The findings about textures; the mesh of one triangle has an open rim.
std::vector<Finding> saidOf(const Scene& scene) {
    std::vector<Finding> findings = validate(scene);
    std::erase_if(findings,
                  [](const Finding& finding) { return finding.sentence.find("rim") != std::string::npos; });
    return findings;
}

bool oneFinding(const Scene& scene, Severity severity, const std::string& part) {
    const std::vector<Finding> findings = saidOf(scene);
    if (findings.size() != 1) return false;
    return findings[0].severity == severity && !findings[0].remedy.empty() && findings[0].object == "leaf" &&
           findings[0].sentence.find(part) != std::string::npos;
}

} // namespace

class TestTextureLayers : public QObject {
    Q_OBJECT

private slots:
    void aBumpMapIsALayerOfHeight() {
        folder_.write("a bump.png", asPng(2, 1, {"\x10", "\x20"}));
        for (const char* line : {"bump a bump.png", "map_Bump -bm 0.5 a bump.png",
                                 "map_bump -clamp on -mm 0 1 -bm 0.5 -imfchan l a bump.png",
                                 "bump -s 1 1 1 -o 0 0 -bm 0.5 C:\\maps\\a bump.png"}) {
            const auto loaded = load(line);
            VERIFY_RESULT(loaded);
            const auto& layers = loaded->scene.objects[0].surfaces[0].layers;
            QVERIFY2(layers.size() == 1, line);
            const double multiplier = std::string(line).find("-bm") == std::string::npos ? 1 : 0.5;
            QCOMPARE(layers[0].strength, multiplier * kTextureHeight.initial);
            QCOMPARE(layers[0].name, std::string("a bump.png"));
            QCOMPARE(layers[0].pattern.mapping, TextureMapping::UvUnit);
            QCOMPARE(layers[0].pattern.image->width(), 2);
            COMPARE_CONTAINS(said(*loaded), "has no unit; its height is taken as");
            QCOMPARE_LE(validate(loaded->scene).size(), 1);
            QVERIFY(compileTextures(layers, loaded->scene.objects[0].geometry, 0));
        }
        COMPARE_CONTAINS(said(*load("bump -s 2 2 a bump.png")), "is scaled or moved by its library");
        COMPARE_LACKS(said(*load("bump -s 1 1 a bump.png")), "is scaled or moved");
    }

    void whatBecomesOfAnOddMultiplierIsSaid_data() {
        QTest::addColumn<QString>("multiplier");
        QTest::addColumn<double>("height");
        QTest::addColumn<QString>("sentence");
        const double usual = kTextureHeight.initial, most = kTextureHeight.maximum;
        QTest::newRow("word") << "x" << usual << "m.mtl:2: -bm \"x\" is not a number";
        QTest::newRow("nan") << "nan" << usual << "m.mtl:2: -bm \"nan\" is not a number";
        QTest::newRow("infinite") << "-inf" << usual << "m.mtl:2: -bm \"-inf\" is not a number";
        QTest::newRow("high") << "1000" << most << "m.mtl:2: -bm 1000 would be a height of 0.2 m";
        QTest::newRow("deep") << "-1000" << -most << "m.mtl:2: -bm -1000 would be a height of -0.2 m";
    }
    void whatBecomesOfAnOddMultiplierIsSaid() {
        QFETCH(QString, multiplier);
        QFETCH(double, height);
        QFETCH(QString, sentence);
        folder_.write("b.png", asPng(2, 1, {"\x10", "\x20"}));
        const auto loaded = load("bump -bm " + multiplier.toStdString() + " b.png");
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects[0].surfaces[0].layers.at(0).strength, height);
        const auto warning = std::ranges::find_if(loaded->findings, [&](const Finding& finding) {
            return finding.severity == Severity::Warning &&
                   finding.sentence.find(sentence.toStdString()) != std::string::npos;
        });
        QVERIFY(warning != loaded->findings.end());
        QVERIFY(!warning->remedy.empty());
        COMPARE_CONTAINS(said(*load("bump -bm b.png")),
                         "m.mtl:2: bump map names no picture"); // it was the multiplier
    }

    void surfacesOfOneMaterialShareItsImage() {
        folder_.write("b.png", asPng(2, 1, {"\x10", "\x20"}));
        folder_.write("m.mtl", "newmtl a\nbump b.png\nnewmtl c\nKd 1 0 0\nmap_bump b.png\n");
        const auto loaded = folder_.load("mesh.obj", kSquare + "usemtl c\nf 3/1 2/2 1/3\n");
        const auto& surfaces = loaded->scene.objects[0].surfaces;
        QCOMPARE(surfaces.size(), std::size_t(2));
        QVERIFY(surfaces[0].layers[0].pattern.image == surfaces[1].layers[0].pattern.image);
        QCOMPARE(surfaces[1].colour, Eigen::Vector3f(1, 0, 0));
    }

    void whatCannotBeReadIsAWarning() {
        folder_.write("broken.png", "\x89PNG\r\n\x1a\nxyz");
        for (const char* file : {"gone.png", "/etc/passwd", "../../etc/passwd", "broken.png", "m.mtl"}) {
            const auto loaded = load(std::string("bump ") + file);
            QVERIFY2(loaded, file);
            QVERIFY(loaded->scene.objects[0].surfaces[0].layers.empty());
            COMPARE_CONTAINS(said(*loaded), "bump map ");
        }
        for (const char* line : {"bump", "bump -bm", "bump -bm 1", "map_bump -s 1 1 1", "bump -"})
            QVERIFY2(load(line), line);
    }

    /// The lowest row of a picture lies at v = 0 in every format; in glTF it is the highest.
    void textureCoordinatesOfGltfAreTurned() {
        TriangleSoup soup;
        soup.positions = {{0.25, 0.125, 0.5}, {0.75, 0, 1}, {1, 1, 0}};
        soup.triangles = {{0, 1, 2}};
        std::string json = asGltf(soup); // its positions, taken as pairs: (0.25 0.125) (0.5 0.75) (0 1)
        const auto replace = [&](const std::string& part, const std::string& by) {
            json.replace(json.find(part), part.size(), by);
        };
        replace(R"("POSITION":0)", R"("POSITION":0,"TEXCOORD_0":2)");
        replace(R"(],"bufferViews")",
                R"(,{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}],"bufferViews")");
        const auto loaded = folder_.load("mesh.gltf", json);
        VERIFY_RESULT(loaded);
        const auto& uvs = loaded->scene.objects[0].geometry->cornerUvs;
        QCOMPARE(uvs[0], Eigen::Vector2f(0.25f, 0.875f));
        QCOMPARE(uvs[1], Eigen::Vector2f(0.5f, 0.25f));
    }

    void aSoundLayerHasNoFindings() {
        QVERIFY(saidOf(sceneWith({})).empty());
        TextureLayer layer;
        layer.pattern.mapping = TextureMapping::Uv;
        QVERIFY(saidOf(sceneWith(layer, true)).empty());
    }

    void whatIsNotFeltIsSaid() {
        TextureLayer noImage, noUvs, badMask, plane;
        noImage.pattern.source = TextureSource::Image;
        QVERIFY(oneFinding(sceneWith(noImage), Severity::Warning,
                           "image of layer \"veins\" of surface \"top\" is missing"));
        noUvs.pattern.mapping = TextureMapping::UvUnit;
        QVERIFY(oneFinding(sceneWith(noUvs), Severity::Warning, "needs texture coordinates"));
        badMask.mask = noImage.pattern;
        QVERIFY(oneFinding(sceneWith(badMask), Severity::Warning, "image of the mask of layer"));
        plane.target = TextureTarget::Viscosity;
        plane.ownPlane = true;
        QVERIFY(oneFinding(sceneWith(plane), Severity::Warning, "the layer is no height"));
        noImage.enabled = false;
        QVERIFY(saidOf(sceneWith(noImage)).empty());
    }

    void whatIsPaintedFitsItsMesh() {
        TextureLayer layer;
        layer.pattern.source = TextureSource::Painted;
        layer.pattern.mapping = TextureMapping::Uv; // says nothing here
        layer.pattern.frame.rotation.coeffs().setZero();
        QVERIFY(oneFinding(sceneWith(layer), Severity::Warning,
                           "nothing is painted of layer \"veins\" of surface \"top\", so it is not felt"));
        layer.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(4));
        QVERIFY(
            oneFinding(sceneWith(layer), Severity::Warning,
                       "what is painted of layer \"veins\" of surface \"top\" is of a mesh with 4 positions, "
                       "and this one has 3, so it is not felt"));
        layer.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(3));
        QVERIFY(saidOf(sceneWith(layer)).empty());
        TextureLayer masked;
        masked.mask = layer.pattern;
        QVERIFY(saidOf(sceneWith(masked)).empty());
        const auto describedAs = [](const TextureLayer& each) {
            return describe(sceneWith(each)).objects[0].surfaces[0].layers[0];
        };
        QCOMPARE_EQ(describedAs(layer).source, "painted");
        QVERIFY(describedAs(layer).mapping.empty());
        QVERIFY(describedAs(layer).mask.empty());
        QCOMPARE_EQ(describedAs(masked).mask, "painted");
        masked.mask->painted = {};
        QVERIFY(oneFinding(sceneWith(masked), Severity::Warning, "nothing is painted of the mask of layer"));
    }

    void everyNumberIsHeldAgainstItsRange() {
        for (const PatternField& field : kPatternFields) {
            const std::string label(field.parameter->label);
            TextureLayer layer;
            layer.strength = 1e-6; // never steep
            layer.pattern.*field.value = field.parameter->maximum + 1;
            QVERIFY2(oneFinding(sceneWith(layer), Severity::Warning, label + " of layer"), label.c_str());
            layer.pattern.*field.value = NAN;
            QVERIFY2(oneFinding(sceneWith(layer), Severity::Error, label + " of layer"), label.c_str());
        }
        TextureLayer layer;
        layer.opacity = 2;
        QVERIFY(oneFinding(sceneWith(layer), Severity::Warning, "Opacity of layer"));
        layer.opacity = 1;
        layer.pattern.size = 1;
        layer.strength = -0.02; // too deep, not senseless
        QVERIFY(oneFinding(sceneWith(layer), Severity::Warning, "Height of layer"));
        layer.target = TextureTarget::Stiffness; // a ratio now, and a sound one
        QVERIFY(saidOf(sceneWith(layer)).empty());
        layer.pattern.frame.rotation.w() = 3;
        QVERIFY(oneFinding(sceneWith(layer), Severity::Error, "is not a pose"));
    }

    void steepAndManyLayersAreSaid() {
        TextureLayer steep;
        steep.strength = 5e-3;
        QVERIFY(oneFinding(sceneWith(steep), Severity::Warning, "is large for its size"));
        Scene scene = sceneWith({});
        auto& layers = scene.objects[0].surfaces[0].layers;
        layers.resize(std::size_t(kMaxTextureLayers) + 1);
        QVERIFY(oneFinding(scene, Severity::Warning, "has 17 layers, of which 16 are felt"));
        layers.resize(5);
        for (TextureLayer& layer : layers)
            layer.ownPlane = true;
        QVERIFY(oneFinding(scene, Severity::Warning, "has 5 layers with a plane of its own; 4 get one"));
    }

private:
    Result<LoadedScene> load(const std::string& line) {
        folder_.write("m.mtl", "newmtl a\n" + line + "\n");
        return folder_.load("mesh.obj", kSquare);
    }

    FileFolder folder_;
};

TACTUM_TEST(TestTextureLayers)

} // namespace test_texture_layers

#include "test_texture_layers.moc"
