// 3DS, FBX and DAE: names, surfaces, units and every face.
#include <QTest>

#include "tests/core/files/mesh_files.h"
#include "tests/core/files/rare_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_assimp_formats {

using namespace tactum;

class TestAssimpFormats : public QObject {
    Q_OBJECT

private slots:
    void threeDsKeepsFacesNamesAndColour() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 1}};
        soup.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 1, 2}, {0, 3, 3}}; // doubled, turned over, and a line
        const auto loaded = folder_.load("a.3ds", as3ds(soup, "tetra", "rubber"));
        VERIFY_RESULT(loaded);
        const SceneObject& object = onlyObject(*loaded);
        QCOMPARE_EQ(object.name, "tetra");
        QCOMPARE(object.geometry->triangles.size(), std::size_t(4));
        QCOMPARE(object.geometry->positions.size(), std::size_t(4)); // equal places are one vertex
        QCOMPARE(object.surfaces[0].name, std::string("rubber"));
        QCOMPARE(object.surfaces[0].colour, Eigen::Vector3f(1, 0, 0));
        COMPARE_CONTAINS(said(*loaded), "has no unit: taken as metres; 1.1");
        QVERIFY(loaded->unitGuessed);
        QVERIFY(loaded->upGuessed);
    }

    void daeKeepsUnitTransformAndSurfaces() {
        const auto loaded = folder_.load("a.dae", asDae("<unit name='inch' meter='0.0254'/>"));
        VERIFY_RESULT(loaded);
        const SceneObject& object = onlyObject(*loaded);
        QCOMPARE_EQ(object.name, "plate");
        QCOMPARE(object.surfaces.size(), std::size_t(2));
        QCOMPARE(object.surfaces[0].name, std::string("red"));
        QCOMPARE(object.surfaces[1].colour, Eigen::Vector3f(0, 0, 1));
        QCOMPARE(object.geometry->triangles.size(), std::size_t(3)); // the square is two
        const Bounds box = boundsOf(loaded->scene);
        COMPARE_NEAR(box.low, Vec3(-2 * 0.0254, 0, 0), 1e-6, "m");
        COMPARE_NEAR(box.high, Vec3(0, 0.0254, 0.0254), 1e-6, "m");
        // The square's front looked along +z; in the mirror it still does.
        for (std::size_t f = 0; f < 3; ++f) {
            if (object.geometry->surfaceOf[f] != 0) continue;
            const auto at = [&](std::size_t i) {
                return object.geometry->positions[object.geometry->triangles[f][i]];
            };
            QCOMPARE_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0);
        }
        COMPARE_LACKS(said(*loaded), "has no unit");
        QVERIFY(!loaded->unitGuessed);
        QVERIFY(!loaded->upGuessed);
    }

    void daeWithoutUnitSaysItsGuess() {
        const auto loaded = folder_.load("a.dae", asDae(""));
        VERIFY_RESULT(loaded);
        COMPARE_CONTAINS(said(*loaded), "has no unit: taken as metres; 2.4");
        QVERIFY(loaded->unitGuessed);
        QVERIFY(!loaded->upGuessed); // its format says that
    }

    void camerasAndLightsAreLeftOutAloud() {
        std::string dae = asDae("");
        const auto insertBefore = [&](const std::string& place, const std::string& text) {
            dae.insert(dae.find(place), text);
        };
        insertBefore("<library_materials>",
                     "<library_lights><light id='l'><technique_common><point><color>1 1 1</color></point>"
                     "</technique_common></light></library_lights><library_cameras><camera id='c'><optics>"
                     "<technique_common><perspective><xfov>45</xfov><znear>0.1</znear><zfar>9</zfar>"
                     "</perspective></technique_common></optics></camera></library_cameras>");
        insertBefore("<node id='n'", "<node id='eye' name='eye'><instance_camera url='#c'/></node>"
                                     "<node id='lamp' name='lamp'><instance_light url='#l'/></node>");
        const auto loaded = folder_.load("a.dae", dae);
        VERIFY_RESULT(loaded);
        COMPARE_CONTAINS(said(*loaded), "1 camera left out");
        COMPARE_CONTAINS(said(*loaded), "1 light left out");
        COMPARE_LACKS(said(*folder_.load("a.dae", asDae(""))), "left out");
    }

    void fbxKeepsUnitNamesAndPlace() {
        for (const double centimetres : {1.0, 100.0, 2.54}) {
            const auto loaded = folder_.load("a.fbx", asFbx(centimetres));
            VERIFY_RESULT(loaded);
            const SceneObject& object = onlyObject(*loaded);
            QCOMPARE_EQ(object.name, "plate");
            QCOMPARE(object.surfaces[0].name, std::string("red"));
            QCOMPARE(object.geometry->triangles.size(), std::size_t(2));
            const double unit = centimetres / 100;
            const Bounds box = boundsOf(loaded->scene);
            COMPARE_NEAR(box.low, Vec3(0, 0, 5 * unit), 1e-6, "m");
            COMPARE_NEAR(box.high, Vec3(unit, unit, 5 * unit), 1e-6, "m");
            COMPARE_LACKS(said(*loaded), "has no unit");
        }
    }

    /// The square stands 5 m along the file's z. Each row: where that is with us, and where the square looks.
    void fbxAxesAreTurnedToOurs_data() {
        QTest::addColumn<QList<int>>("axes"); // up, its sign, front, its sign, side, its sign
        QTest::addColumn<QList<double>>("low");
        QTest::addColumn<QList<double>>("high");
        QTest::addColumn<QList<double>>("front");
        using Ints = QList<int>;
        using Reals = QList<double>;
        QTest::newRow("y up") << Ints{1, 1, 2, 1, 0, 1} << Reals{0, 0, 5} << Reals{1, 1, 5} << Reals{0, 0, 1};
        QTest::newRow("z up") << Ints{2, 1, 1, -1, 0, 1} << Reals{0, 5, -1} << Reals{1, 5, 0}
                              << Reals{0, 1, 0};
        QTest::newRow("x up") << Ints{0, 1, 2, 1, 1, -1} << Reals{-1, 0, 5} << Reals{0, 1, 5}
                              << Reals{0, 0, 1};
        QTest::newRow("left-handed") << Ints{1, 1, 2, -1, 0, 1} << Reals{0, 0, -5} << Reals{1, 1, -5}
                                     << Reals{0, 0, -1};
    }

    void fbxAxesAreTurnedToOurs() {
        QFETCH(QList<int>, axes);
        QFETCH(QList<double>, low);
        QFETCH(QList<double>, high);
        QFETCH(QList<double>, front);
        FbxWords words{axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], "", ""};
        const auto loaded = folder_.load("a.fbx", asFbx(100, words));
        VERIFY_RESULT(loaded);
        const Bounds box = boundsOf(loaded->scene);
        COMPARE_NEAR(box.low, Vec3(low[0], low[1], low[2]), 1e-6, "m");
        COMPARE_NEAR(box.high, Vec3(high[0], high[1], high[2]), 1e-6, "m");
        COMPARE_NEAR(normalOf(onlyObject(*loaded)), Vec3(front[0], front[1], front[2]), 1e-6, "");
    }

    void fbxAxesThatAreNoFrameAreSaid() {
        const auto loaded = folder_.load("a.fbx", asFbx(100, {1, 1, 1, 1, 0, 1, "", ""}));
        VERIFY_RESULT(loaded);
        COMPARE_CONTAINS(said(*loaded), "names axes that are no frame");
        COMPARE_NEAR(boundsOf(loaded->scene).low, Vec3(0, 0, 5), 1e-6, "m");
    }

    /// 3ds Max's way to move a mesh against its own node: what hangs below the node does not share it.
    void fbxGeometricTransformIsTheMeshsOwn() {
        FbxWords words;
        words.node = R"(P: "GeometricTranslation", "Vector3D", "Vector", "",0,0,2
P: "GeometricScaling", "Vector3D", "Vector", "",3,1,1
)";
        words.child = R"(P: "Lcl Translation", "Lcl Translation", "", "A",0,7,0
)";
        const auto loaded = folder_.load("a.fbx", asFbx(100, words));
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects.size(), std::size_t(2));
        const SceneObject &plate = loaded->scene.objects[0], &lid = loaded->scene.objects[1];
        QCOMPARE_EQ(plate.name, "plate");
        QCOMPARE_EQ(lid.name, "lid");
        COMPARE_NEAR(boundsOf(*plate.geometry).low, Vec3(0, 0, 7), 1e-6, "m");
        COMPARE_NEAR(boundsOf(*plate.geometry).high, Vec3(3, 1, 7), 1e-6, "m");
        COMPARE_NEAR(boundsOf(*lid.geometry).low, Vec3(0, 7, 5), 1e-6, "m");
        COMPARE_NEAR(boundsOf(*lid.geometry).high, Vec3(1, 8, 5), 1e-6, "m");
    }

    /// A quarter turn around z before the node's own: only where the node says that it is in use.
    void fbxPreRotationNeedsToBeActive() {
        for (const bool active : {true, false}) {
            FbxWords words;
            words.node = "P: \"RotationActive\", \"bool\", \"\", \"\"," + std::string(active ? "1" : "0") +
                         "\nP: \"PreRotation\", \"Vector3D\", \"Vector\", \"\",0,0,90\n";
            const auto loaded = folder_.load("a.fbx", asFbx(100, words));
            VERIFY_RESULT(loaded);
            COMPARE_NEAR(boundsOf(loaded->scene).low, Vec3(active ? -1 : 0, 0, 5), 1e-6, "m");
        }
    }

    void fbxScaleThatIsNotInheritedIsSaid() {
        const auto lid = [](int kind) {
            FbxWords words;
            words.node = "P: \"Lcl Scaling\", \"Lcl Scaling\", \"\", \"A\",1,2,1\n";
            words.child = "P: \"InheritType\", \"enum\", \"\", \"\"," + std::to_string(kind) + "\n";
            return asFbx(2.54, words);
        };
        COMPARE_LACKS(said(*folder_.load("a.fbx", lid(1))), "scale");
        COMPARE_CONTAINS(said(*folder_.load("a.fbx", lid(0))), "1 mesh under a scaled parent");
        COMPARE_CONTAINS(said(*folder_.load("a.fbx", lid(2))), "1 mesh under a scaled parent");
    }

    /// Such files are whole; nobody should look for the damage.
    void fbxThatIsNotReadIsToldFromADamagedOne() {
        const auto refusal = [&](const std::string& bytes) {
            const auto loaded = folder_.load("a.fbx", bytes);
            return loaded ? std::string("read") : loaded.error().text;
        };
        const auto binary = [](char order, std::string version) {
            return std::string("Kaydara FBX Binary  \0\x1A", 22) + order + version + std::string(100, '\0');
        };
        COMPARE_CONTAINS(refusal(binary('\0', std::string("\xd4\x17\0\0", 4))),
                         "version 6.1; only those from 7.0");
        COMPARE_CONTAINS(refusal(binary('\1', std::string("\0\0\x1c\xe8", 4))), "big-endian");
        COMPARE_CONTAINS(refusal("; FBX 6.1.0 project file\nFBXHeaderExtension: {\nFBXVersion: 6100\n}\n"),
                         "version 6.1");
        COMPARE_CONTAINS(refusal("; FBX 5.0.0 project file\nObjects: {\n}\n"), "version 5.0");
        COMPARE_LACKS(refusal(binary('\0', std::string("\xe8\x1c\0\0", 4))), "version");
        COMPARE_LACKS(refusal("; FBX 6.1.0 project file\n"), "damaged");
        COMPARE_LACKS(refusal("Kaydara FBX Binary  "), "version");
    }

    /// Whatever it is called: Assimp would otherwise read it as what it looks like.
    void aFileOfAnotherKindIsRefused() {
        for (const char* name : {"a.fbx", "a.3ds", "a.dae"}) {
            const auto loaded = folder_.load(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            QVERIFY(!loaded);
            COMPARE_LACKS(loaded.error().text, "\n");
        }
    }

    void truncatedFilesAreAnswered() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {0.25, 0, 0}, {0, 0.5, 0}};
        soup.triangles = {{0, 1, 2}};
        const std::string whole[] = {as3ds(soup, "a", "b"), asDae(""), asFbx(1)};
        const char* names[] = {"a.3ds", "a.dae", "a.fbx"};
        for (int i = 0; i < 3; ++i)
            for (std::size_t size = 1; size < whole[i].size(); size += 1 + whole[i].size() / 40) {
                const auto loaded = folder_.load(names[i], whole[i].substr(0, size));
                if (!loaded) COMPARE_LACKS(loaded.error().text, "\n");
            }
    }

private:
    static Vec3 normalOf(const SceneObject& object) {
        const auto at = [&](std::size_t i) {
            return object.geometry->positions[object.geometry->triangles[0][i]];
        };
        return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    }

    static const SceneObject& onlyObject(const LoadedScene& loaded) {
        if (loaded.scene.objects.size() != 1) qFatal("not one object");
        return loaded.scene.objects[0];
    }

    FileFolder folder_;
};

TACTUM_TEST(TestAssimpFormats)

} // namespace test_assimp_formats

#include "test_assimp_formats.moc"
