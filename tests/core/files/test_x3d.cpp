// X3D: geometry, transforms, DEF and USE, and H3D's surfaces.
#include <array>
#include <cmath>

#include <QTest>

#include "core/files/images/write_png.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_x3d {

using namespace tactum;

namespace {

std::string x3d(const std::string& scene) {
    return "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='H3DAPI' version='2.0'>\n<Scene>\n" + scene +
           "\n</Scene>\n</X3D>\n";
}

const std::string kTriangle = "<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0, 1 0 0, 0 1 0'/>"
                              "<TextureCoordinate point='0 0 1 0 0 1'/></IndexedTriangleSet>";

std::string shape(const std::string& appearance, const std::string& geometry = kTriangle) {
    return "<Shape><Appearance>" + appearance + "</Appearance>" + geometry + "</Shape>";
}

double areaOf(const TriangleSoup& soup) {
    double area = 0;
    for (const auto& t : soup.triangles)
        area += 0.5 * (soup.positions[t[1]] - soup.positions[t[0]])
                          .cross(soup.positions[t[2]] - soup.positions[t[0]])
                          .norm();
    return area;
}

/// By the divergence theorem: positive where the triangles face outward.
double volumeOf(const TriangleSoup& soup) {
    double volume = 0;
    for (const auto& t : soup.triangles)
        volume += soup.positions[t[0]].dot(soup.positions[t[1]].cross(soup.positions[t[2]])) / 6;
    return volume;
}

} // namespace

class TestX3d : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreInTheUnitOfTheHead() {
        std::string text =
            x3d(shape("", "<IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 100 0 0 0 50 0'/>"
                          "</IndexedFaceSet>"));
        const std::size_t at = text.find("<Scene");
        QCOMPARE_NE(at, std::string::npos);
        text.insert(at, "<head><unit category='length' name='millimetre' conversionFactor='0.001'/></head>");
        const auto loaded = folder_.load("a.x3d", text);
        VERIFY_RESULT(loaded);
        COMPARE_NEAR(boundsOf(loaded->scene).high, Vec3(0.1, 0.05, 0), 1e-12, "m");
    }

    /// A ball of thirty bytes is over a thousand vertices: they are counted as they come, and what the file
    /// itself could write is free.
    void verticesThatNobodyWroteAreCounted() {
        std::string balls;
        for (int i = 0; i < 12'000; ++i)
            balls += "<Shape><Sphere/></Shape>";
        const auto many = folder_.load("balls.x3d", x3d(balls));
        QVERIFY(!many);
        COMPARE_CONTAINS(many.error().text, "10 million vertices");
    }

    void facesAreCutAlongTheirOutline() {
        // An L of area 3, with a texture coordinate for each corner and a normal for the face.
        const auto loaded =
            load(shape("", "<IndexedFaceSet coordIndex='0 1 2 3 4 5 -1' normalPerVertex='false'>"
                           "<Coordinate point='0 0 0 2 0 0 2 1 0 1 1 0 1 2 0 0 2 0'/>"
                           "<Normal vector='0 0 1'/></IndexedFaceSet>"));
        const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
        QCOMPARE(soup.triangles.size(), std::size_t(4));
        COMPARE_NEAR(areaOf(soup), 3, 1e-12, "");
        for (const auto& n : soup.cornerNormals)
            QCOMPARE(n, Eigen::Vector3f(0, 0, 1));
    }

    void clockwiseFacesAreTurnedOver() {
        for (const bool ccw : {true, false}) {
            const auto loaded = load(
                shape("", std::string("<IndexedFaceSet coordIndex='0 1 2' ccw='") + (ccw ? "true" : "false") +
                              "'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet>"));
            const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
            const auto at = [&](std::size_t i) { return soup.positions[soup.triangles[0][i]]; };
            QCOMPARE((at(1) - at(0)).cross(at(2) - at(0)).z() > 0, ccw);
        }
    }

    void ownIndicesOfNormalsAndTextureCoordinates() {
        const auto loaded = load(shape("", "<IndexedFaceSet coordIndex='0 1 2 -1' normalIndex='1 1 0 -1' "
                                           "texCoordIndex='2 1 0 -1'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
                                           "<Normal vector='0 0 1 0 1 0'/>"
                                           "<TextureCoordinate point='0 0 0.5 0 1 1'/></IndexedFaceSet>"));
        const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
        QCOMPARE(soup.cornerNormals[0], Eigen::Vector3f(0, 1, 0));
        QCOMPARE(soup.cornerNormals[2], Eigen::Vector3f(0, 0, 1));
        QCOMPARE(soup.cornerUvs[0], Eigen::Vector2f(1, 1));
    }

    void stripsAndFansKeepTheirSide() {
        const std::string points = "<Coordinate point='0 0 0 1 0 0 0 1 0 1 1 0'/>";
        for (const std::string& geometry :
             {"<IndexedTriangleStripSet index='0 1 2 3 -1'>" + points + "</IndexedTriangleStripSet>",
              "<TriangleStripSet stripCount='4'>" + points + "</TriangleStripSet>",
              "<IndexedTriangleFanSet index='0 1 3 2'>" + points + "</IndexedTriangleFanSet>"}) {
            const auto loaded = load(shape("", geometry));
            const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
            QCOMPARE(soup.triangles.size(), std::size_t(2));
            for (const auto& t : soup.triangles)
                QCOMPARE_GT((soup.positions[t[1]] - soup.positions[t[0]])
                                .cross(soup.positions[t[2]] - soup.positions[t[0]])
                                .z(),
                            0);
        }
    }

    void bodiesAreClosedAndOfTheirVolume_data() {
        QTest::addColumn<QString>("node");
        QTest::addColumn<double>("volume");
        const double pi = M_PI;
        QTest::newRow("box") << "<Box size='1 2 3'/>" << 6.0;
        QTest::newRow("sphere") << "<Sphere radius='0.5'/>" << 4 * pi / 3 / 8;
        QTest::newRow("cylinder") << "<Cylinder radius='0.5' height='3'/>" << pi * 0.75;
        QTest::newRow("cone") << "<Cone bottomRadius='0.5' height='3'/>" << pi * 0.25;
    }
    void bodiesAreClosedAndOfTheirVolume() {
        QFETCH(QString, node);
        QFETCH(double, volume);
        const auto loaded = load(shape("", node.toStdString()));
        const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
        COMPARE_NEAR(volumeOf(soup) / volume, 1, 0.005, "");
        COMPARE_LACKS(said(loaded), "open rim");
        COMPARE_LACKS(said(loaded), "face opposite ways");
    }

    /// Out of the specification: T C R SR S -SR -C.
    void transformsFollowTheStandard() {
        const auto loaded =
            load("<Transform DEF='arm' translation='0 0 5' rotation='0 0 1 1.5707963267948966' scale='2 1 1' "
                 "center='1 0 0'>" +
                 shape("") + "</Transform>");
        const SceneObject& object = loaded.scene.objects[0];
        QCOMPARE(object.name, std::string("arm"));
        const Bounds box = boundsOf(loaded.scene);
        // (0,0,0) -> (1,-2,5); (1,0,0) -> (1,0,5); (0,1,0) -> (0,-2,5)
        COMPARE_NEAR(box.low, Vec3(0, -2, 5), 1e-9, "m");
        COMPARE_NEAR(box.high, Vec3(1, 0, 5), 1e-9, "m");
    }

    void definedNodesAreUsedAgain() {
        const auto loaded =
            load("<Transform><Shape DEF='s'><Appearance DEF='a'><Material DEF='red' diffuseColor='1 0 "
                 "0'/></Appearance>" +
                 kTriangle +
                 "</Shape></Transform><Transform translation='3 0 "
                 "0'><Shape USE='s'/></Transform><Shape><Appearance USE='a'/><Box/></Shape>");
        QCOMPARE(loaded.scene.objects.size(), std::size_t(3));
        for (const SceneObject& object : loaded.scene.objects)
            QCOMPARE(object.surfaces[0].colour, Eigen::Vector3f(1, 0, 0));
        QCOMPARE(loaded.scene.objects[1].geometry->positions[0].x(), 3.0);
        QCOMPARE(loaded.scene.objects[2].surfaces[0].name, std::string("a"));
    }

    void whatIsNotReadIsSaid() {
        const auto loaded = load(shape("", "<Extrusion/>") + shape("") +
                                 "<Inline url='\"other.x3d\"'/>"
                                 "<PositionInterpolator/><Switch whichChoice='1'>" +
                                 shape("") + shape("") + "</Switch><ForceField force='1 0 0'/>");
        QCOMPARE(loaded.scene.objects.size(), std::size_t(2));
        COMPARE_CONTAINS(said(loaded), "1 geometry of the kind \"Extrusion\" left out");
        COMPARE_CONTAINS(said(loaded), "1 Inline left out");
        COMPARE_CONTAINS(said(loaded), "1 animation or script left out");
        COMPARE_CONTAINS(said(loaded), "1 force effect of H3D left out");
        COMPARE_LACKS(said(loaded), "light");
        COMPARE_LACKS(said(loaded), "viewpoint");
        const auto seen = load(shape("") + "<Viewpoint/><PointLight/><SpotLight/>");
        COMPARE_CONTAINS(said(seen), "1 viewpoint left out");
        COMPARE_CONTAINS(said(seen), "2 lights left out");
    }

    void hostileFilesAreRefused_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("inside itself") << "<Group DEF='g'><Group USE='g'/></Group>"
                                       << "inside itself";
        QString laughs = "<Group DEF='g0'><Shape/></Group>";
        for (int i = 1; i < 40; ++i)
            laughs += QStringLiteral("<Switch><Group DEF='g%1'>").arg(i) +
                      QStringLiteral("<Group USE='g%1'/>").arg(i - 1).repeated(10) + "</Group></Switch>";
        QTest::newRow("laughs") << laughs + "<Group USE='g39'/>"
                                << "used too often";
        QTest::newRow("index")
            << "<Shape><IndexedFaceSet coordIndex='0 1 7'><Coordinate point='0 0 0 1 0 0'/>"
               "</IndexedFaceSet></Shape>"
            << "refers to point 7, but only 2 are there";
        QTest::newRow("negative")
            << "<Shape><IndexedFaceSet coordIndex='0 1 -5'><Coordinate point='0 0 0 1 0 "
               "0'/></IndexedFaceSet></Shape>"
            << "refers to point";
        QTest::newRow("far") << "<Transform scale='1e9 1 1'><Shape><Box/></Shape></Transform>"
                             << "beyond 1e6 m";
        QTest::newRow("nan") << "<Shape><IndexedFaceSet coordIndex='0 0 0'><Coordinate point='nan 0 0'/>"
                                "</IndexedFaceSet></Shape>"
                             << "is not a finite number";
        QTest::newRow("five numbers") << "<Shape><PointSet><Coordinate point='0 0 0 1 0'/></PointSet></Shape>"
                                      << "point has 5 numbers, which are not three for each point";
        QTest::newRow("word") << "<Shape><Box size='1 two 3'/></Shape>"
                              << "\"two\", which is no number";
        QTest::newRow("grid")
            << "<Shape><ElevationGrid xDimension='1000000' zDimension='1000000' height='1'/></Shape>"
            << "fewer heights";
    }
    void hostileFilesAreRefused() {
        QFETCH(QString, scene);
        QFETCH(QString, sentence);
        const auto loaded = folder_.load("a.x3d", x3d(scene.toStdString()));
        QVERIFY(!loaded);
        QVERIFY2(QString::fromStdString(loaded.error().text).contains(sentence), loaded.error().text.c_str());
        COMPARE_LACKS(loaded.error().text, "\n");
    }

    void absoluteValuesAreTakenAsTheyAre() {
        const Surface surface =
            surfaceOf("<FrictionalSurface useRelativeValues='false' stiffness='600' damping='2' "
                      "staticFriction='0.5' dynamicFriction='0.3'/>");
        QCOMPARE(surface.material.stiffness, 600.0);
        QCOMPARE(surface.material.damping, 2.0);
        QCOMPARE(surface.material.staticFriction, 0.5);
        QCOMPARE(surface.material.dynamicFriction, 0.3);
        QCOMPARE(surface.sides, Sides::Front); // as drawn: the geometry is solid
    }

    void relativeValuesSayTheirDevice() {
        auto loaded = load(shape("<SmoothSurface/>"));
        QCOMPARE(loaded.scene.objects[0].surfaces[0].material.stiffness, 350.0);
        COMPARE_CONTAINS(said(loaded), "stiffness 0.5 is a part of what the device can do");
        loaded = load("<DeviceInfo><FalconDevice/></DeviceInfo>" + shape("<SmoothSurface stiffness='1'/>"));
        QCOMPARE(loaded.scene.objects[0].surfaces[0].material.stiffness, 800.0);
    }

    void slidingAboveStandingHoldsLikeIt() {
        const auto loaded = load(shape("<FrictionalSurface/>")); // H3D's initial values: 0.1 and 0.4
        QCOMPARE(loaded.scene.objects[0].surfaces[0].material.staticFriction, 0.4);
        COMPARE_CONTAINS(said(loaded), "dynamic friction 0.4 is above static friction 0.1");
    }

    void magnetsAreSaid() {
        const auto loaded = load(shape("<MagneticSurface snapDistance='0.02'/>"));
        COMPARE_CONTAINS(said(loaded), "pulls the finger from 0.02 m away");
        COMPARE_CONTAINS(said(load(shape("<OpenHapticsSurface magnetic='true'/>"))), "pulls the finger");
        COMPARE_LACKS(said(load(shape("<OpenHapticsSurface/>"))), "pulls the finger");
    }

    void depthMapsAreLayersOfHeight() {
        writeHill();
        // The standard's own quoting, which other readers fail at.
        const Surface surface =
            surfaceOf("<DepthMapSurface useRelativeValues='false' stiffness='500' maxDepth='0.002' "
                      "whiteIsOut='false'><ImageTexture containerField='depthMap' "
                      "url='\"missing.png\" \"hill.png\"'/></DepthMapSurface>");
        QCOMPARE(surface.layers.size(), std::size_t(1));
        QCOMPARE(surface.layers[0].strength, -0.002);
        QCOMPARE(surface.layers[0].target, TextureTarget::Height);
        QCOMPARE(surface.layers[0].pattern.mapping, TextureMapping::UvUnit);
        QCOMPARE_EQ(surface.layers[0].pattern.image->width(), 2);
    }

    void parameterMapsGoFromLeastToMost() {
        writeHill();
        const Surface surface = surfaceOf(
            "<HapticTexturesSurface useRelativeValues='false' stiffness='500' minStiffness='200' "
            "maxStiffness='600' minStaticFriction='0' maxStaticFriction='1.1' staticFriction='0.5' "
            "dynamicFriction='0.05'>"
            "<ImageTexture containerField='stiffnessMap' url='hill.png'/>"
            "<ImageTexture containerField='staticFrictionMap' url='hill.png'/></HapticTexturesSurface>");
        QCOMPARE(surface.layers.size(), std::size_t(2));
        QCOMPARE(surface.material.stiffness, 200.0);
        QCOMPARE(surface.layers[0].strength, 2.0); // 200 (1 + 2) = 600
        QCOMPARE(surface.layers[1].target, TextureTarget::StaticFriction);
        COMPARE_NEAR(surface.material.staticFriction * (1 + surface.layers[1].strength), 1.1, 1e-12, "");
    }

    void sidesFollowTheOptions() {
        const auto sides = [&](const std::string& scene) {
            return load(scene).scene.objects[0].surfaces[0].sides;
        };
        const auto box = [](const std::string& options, const std::string& solid = "") {
            return shape("", "<Box" + solid + ">" + options + "</Box>");
        };
        QCOMPARE(sides(box("")), Sides::Both);
        QCOMPARE(sides(box("<HapticsOptions touchableFace='FRONT'/>")), Sides::Front);
        QCOMPARE(sides(box("<HapticsOptions touchableFace='BACK'/>")), Sides::Back);
        QCOMPARE(sides(box("<HapticsOptions touchableFace='FRONT_AND_BACK'/>")), Sides::Both);
        QCOMPARE(sides(box("<HapticsOptions/>", " solid='false'")), Sides::Both);
        QCOMPARE(sides("<GlobalSettings><HapticsOptions touchableFace='BACK'/></GlobalSettings>" + box("")),
                 Sides::Back);
    }

    void theProxyHasTheRadiusOfTheRenderer() {
        QCOMPARE(load(shape("")).scene.proxyRadius, kProxyRadius.initial);
        const std::string device = "<DeviceInfo><AnyDevice><RuspiniRenderer proxyRadius='";
        QCOMPARE(load(shape("") + device + "0.004'/></AnyDevice></DeviceInfo>").scene.proxyRadius, 0.004);
        const auto loaded = load(shape("") + device + "9'/></AnyDevice></DeviceInfo>");
        QCOMPARE(loaded.scene.proxyRadius, kProxyRadius.maximum);
        COMPARE_CONTAINS(said(loaded), "proxy radius 9 m is out of range");
    }

    void truncatedFilesAreAnswered() {
        const std::string whole = x3d("<Transform>" + shape("<FrictionalSurface/>") + "</Transform>");
        for (std::size_t size = 1; size < whole.size(); size += 3) {
            const auto loaded = folder_.load("a.x3d", whole.substr(0, size));
            QVERIFY(loaded || loaded.error().text.find('\n') == std::string::npos);
        }
    }

private:
    LoadedScene load(const std::string& scene) {
        auto loaded = folder_.load("a.x3d", x3d(scene));
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return std::move(*loaded);
    }
    Surface surfaceOf(const std::string& haptic) {
        return load(shape(haptic)).scene.objects.at(0).surfaces.at(0);
    }

    void writeHill() const {
        const std::array<std::uint16_t, 2> values{0, 65535};
        folder_.write("hill.png", encodePng(2, 1, 1, 8, values));
    }

    FileFolder folder_;
};

TACTUM_TEST(TestX3d)

} // namespace test_x3d

#include "test_x3d.moc"
