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
    }

    void daeWithoutUnitSaysItsGuess() {
        const auto loaded = folder_.load("a.dae", asDae(""));
        VERIFY_RESULT(loaded);
        COMPARE_CONTAINS(said(*loaded), "has no unit: taken as metres; 2.4");
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
    static const SceneObject& onlyObject(const LoadedScene& loaded) {
        if (loaded.scene.objects.size() != 1) qFatal("not one object");
        return loaded.scene.objects[0];
    }

    FileFolder folder_;
};

TACTUM_TEST(TestAssimpFormats)

} // namespace test_assimp_formats

#include "test_assimp_formats.moc"
