// Wavefront OBJ: objects, surfaces, corners, and its errors.
#include <QTest>

#include "core/files/corner_pool.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_obj {

using namespace tactum;

namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<std::string> surfaceNames(const SceneObject& object) {
    std::vector<std::string> names;
    for (const Surface& surface : object.surfaces)
        names.push_back(surface.name);
    return names;
}

using Names = std::vector<std::string>;

} // namespace

class TestObj : public QObject {
    Q_OBJECT

private slots:
    void objectsAreSeparateAndUseTheirOwnVertices() {
        const Scene scene = read(kSquare + "o left\nf 1 2 3\no right\nf 1 3 4\no left\nf 2 3 4\n");
        QCOMPARE(scene.objects.size(), std::size_t(2));
        QCOMPARE(scene.objects[0].name, std::string("left"));
        QCOMPARE(scene.objects[0].geometry->triangles.size(), std::size_t(2)); // the name came again
        QCOMPARE(scene.objects[1].name, std::string("right"));
        QCOMPARE(scene.objects[1].geometry->positions.size(), std::size_t(3));
        QCOMPARE_NE(scene.objects[0].id, scene.objects[1].id);
    }

    void aFileWithoutObjectsIsOneByTheNameOfTheFile() {
        const Scene scene = read(kSquare + "f 1 2 3\n");
        QCOMPARE(scene.objects.size(), std::size_t(1));
        QCOMPARE(scene.objects[0].name, std::string("mesh"));
        QCOMPARE(surfaceNames(scene.objects[0]), Names{"surface"});
    }

    void surfacesAreNamedByGroupOrMaterial() {
        QCOMPARE(names("g a\nf 1 2 3\ng b\nf 1 3 4\ng a\nf 1 2 4\n"), (Names{"a", "b"}));
        QCOMPARE(names("usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"), (Names{"red", "blue"}));
        QCOMPARE(names("g a\nusemtl red\nf 1 2 3\ng b\nf 1 3 4\n"), (Names{"a", "b"}));
        QCOMPARE(names("g a\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"), (Names{"a red", "a blue"}));
        QCOMPARE(names("g empty\ng a two words\nf 1 2 3\n"), (Names{"a two words"}));
    }

    void eachTriangleKnowsItsSurface() {
        const Scene scene = read(kSquare + "g a\nf 1 2 3 4\ng b\nf 1 2 3\ng a\nf 2 3 4\n");
        QCOMPARE(scene.objects[0].geometry->surfaceOf, (std::vector<Index>{0, 0, 1, 0}));
    }

    void tooManyGroupsBecomeTheirMaterials() {
        std::string faces = "usemtl red\n";
        for (int i = 0; i < 3000; ++i)
            faces += "g " + std::to_string(i) + "\nf 1 2 3\n";
        const auto loaded = folder_.load("mesh.obj", kSquare + faces);
        VERIFY_RESULT(loaded);
        QCOMPARE(surfaceNames(loaded->scene.objects[0]), Names{"red"});
        COMPARE_CONTAINS(said(*loaded), "3000 groups");
    }

    void coloursComeFromTheLibraryBesideIt() {
        folder_.write("paint.mtl", "newmtl red\nKa 0 0 0\nKd 0.9 0.1 0\nnewmtl odd\nKd x y z\n");
        const auto loaded = folder_.load("mesh.obj", "mtllib paint.mtl\n" + kSquare +
                                                         "usemtl red\nf 1 2 3\nusemtl odd\nf 1 3 4\n");
        VERIFY_RESULT(loaded);
        const auto& surfaces = loaded->scene.objects[0].surfaces;
        QCOMPARE(surfaces[0].colour, Eigen::Vector3f(0.9f, 0.1f, 0.f));
        QCOMPARE(surfaces[1].colour, Surface().colour);
    }

    void aMissingLibraryIsANoteNotAnError() {
        for (const char* library : {"gone.mtl", "/etc/passwd", "../up.mtl"}) {
            const auto loaded =
                folder_.load("mesh.obj", "mtllib " + std::string(library) + "\n" + kSquare + "f 1 2 3\n");
            VERIFY_RESULT(loaded);
            COMPARE_CONTAINS(said(*loaded), "material library");
        }
    }

    void normalsAndUvsStayWithTheirCorners() {
        const Scene scene = read(kSquare + "vn 0 0 2\nvn 1 0 0\nvt 0.5 0.25\nvt 1\nf 1/1/1 2/2/2 3/1/1\n");
        const TriangleSoup& soup = *scene.objects[0].geometry;
        QCOMPARE(soup.cornerNormals.size(), std::size_t(3));
        QCOMPARE(soup.cornerNormals[0], Eigen::Vector3f(0, 0, 1)); // made of unit length
        QCOMPARE(soup.cornerNormals[1], Eigen::Vector3f(1, 0, 0));
        QCOMPARE(soup.cornerUvs[0], Eigen::Vector2f(0.5f, 0.25f));
        QCOMPARE(soup.cornerUvs[1], Eigen::Vector2f(1, 0));
    }

    void missingNormalsAreFilledAndCounted() {
        const auto loaded =
            folder_.load("mesh.obj", kSquare + "vn 0 0 0\nvn 1 0 0\nf 1//1 2//2 3\nf 1 3 4\n");
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects[0].geometry->cornerNormals[0], Eigen::Vector3f(0, 0, 1));
        COMPARE_CONTAINS(said(*loaded), "5 corners without a usable normal");
    }

    void negativeAndLaterIndicesAreFound() {
        const Scene scene = read("v 9 9 9\n" + kSquare + "f -4 -3 -2\nv 5 5 5\nf 2 3 7\nv 7 7 7\n");
        const TriangleSoup& soup = *scene.objects[0].geometry;
        QCOMPARE(soup.triangles[0], (std::array<Index, 3>{1, 2, 3}));
        QCOMPARE(soup.positions[soup.triangles[1][2]], Vec3(7, 7, 7));
    }

    void linesContinueAfterABackslash() {
        const Scene scene = read(kSquare + "f 1 \\\n2 \\\r\n3\nf 1 3 4 # a comment\n");
        QCOMPARE(scene.objects[0].geometry->triangles.size(), std::size_t(2));
    }

    void linesAndPointsCanBeTouched() {
        const Scene scene = read(kSquare + "vt 0 0\nl 1 2/1 3\np 1 4\nf 2 4\n");
        const std::vector<std::array<Index, 3>> expected{
            {0, 1, 1}, {1, 2, 2}, {0, 0, 0}, {3, 3, 3}, {1, 3, 3}};
        QCOMPARE(scene.objects[0].geometry->triangles, expected);
    }

    void polygonsAreCutAlongTheirOutline() {
        const auto loaded =
            folder_.load("mesh.obj", "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 5 0\nv 0 5 0\nf 1 2 3 4 5 6\n");
        VERIFY_RESULT(loaded);
        const TriangleSoup& soup = *loaded->scene.objects[0].geometry;
        double area = 0;
        for (const auto& t : soup.triangles)
            area += 0.5 * (soup.positions[t[1]] - soup.positions[t[0]])
                              .cross(soup.positions[t[2]] - soup.positions[t[0]])
                              .norm();
        COMPARE_NEAR(area, 8, 1e-12, "");
        COMPARE_CONTAINS(said(*loaded), "1 polygon with more than three corners");
    }

    void namesAreMadePrintable() {
        const Scene scene = read("o \x1b[31mred\xff\n" + kSquare + "g \t\x07\ng b\xc3\xa9\x01\nf 1 2 3\n");
        QCOMPARE(scene.objects[0].name, std::string("?[31mred?"));
        QCOMPARE(scene.objects[0].surfaces[0].name, std::string("b\xc3\xa9?"));
    }

    void verticesAloneArePoints() {
        const auto loaded = folder_.load("mesh.obj", kSquare);
        QVERIFY(loaded);
        QCOMPARE(loaded->scene.objects.at(0).geometry->triangles.size(), std::size_t(4));
        QCOMPARE(cornersOf(loaded->scene.objects[0].geometry->triangles[3]), 1);
        COMPARE_CONTAINS(said(*loaded), "has vertices alone: 4 points");
    }

    /// One wrong number of a coordinate costs that corner its coordinate, not the person the file.
    void missingCoordinatesAndNormalsAreSaid() {
        const auto loaded = folder_.load(
            "mesh.obj", kSquare + "vt 0.5 0.5\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/-9\nf 1/1/1 3/0/1 4/1/1\n");
        QVERIFY(loaded);
        const TriangleSoup& soup = *loaded->scene.objects.at(0).geometry;
        QCOMPARE(soup.triangles.size(), std::size_t(2));
        QVERIFY(soup.cornerUvs.at(0) == Eigen::Vector2f(0.5f, 0.5f));
        QVERIFY(soup.cornerUvs.at(1) == Eigen::Vector2f(0, 0));
        QVERIFY(soup.cornerNormals.at(2) == Eigen::Vector3f::UnitZ());
        COMPARE_CONTAINS(said(*loaded),
                         "3 corners without the texture coordinate or normal that the file names");
    }

    /// What is not felt by itself is no reason to refuse what is.
    void wrongNumbersOfCoordinatesAndNormalsAreSaid() {
        const auto loaded =
            folder_.load("mesh.obj", kSquare + "vt 0.5 0.25\nvt x 1\nvt 1 y\nvt\nvn 0 0 1\nvn 0 zero 1\n"
                                               "f 1/1/1 2/2/2 3/3/1\nf 1/4/1 3/1/1 4/1/1\n");
        VERIFY_RESULT(loaded);
        const TriangleSoup& soup = *loaded->scene.objects.at(0).geometry;
        QCOMPARE(soup.cornerUvs.at(0), Eigen::Vector2f(0.5f, 0.25f));
        for (const std::size_t corner : {1, 2, 3})
            QCOMPARE(soup.cornerUvs.at(corner), Eigen::Vector2f(0, 0));
        QCOMPARE(soup.cornerNormals.at(1), Eigen::Vector3f(0, 0, 1));
        COMPARE_CONTAINS(said(*loaded), "3 corners without a usable texture coordinate");
        COMPARE_CONTAINS(said(*loaded), "1 corner without a usable normal");
    }

    void errorsNameTheLine_data() {
        QTest::addColumn<QString>("content");
        QTest::addColumn<QString>("error");
        const auto row = [](const char* name, const std::string& text, const char* error) {
            QTest::newRow(name) << QString::fromStdString(text) << QString(error);
        };
        row("index too large", kSquare + "f 1 2 99999\n",
            "mesh.obj:5: face refers to vertex 99999, but only 4 are defined; re-export the file");
        row("index zero", kSquare + "\n\nf 0 1 2\n", "mesh.obj:7: face refers to vertex 0,");
        row("too far back", "v 0 0 0\nf -1 -2 -3\n",
            "mesh.obj:2: face refers to vertex -2, but only 1 is defined before it");
        row("far back before more", kSquare + "f -1 -2 -5\nv 0 0 1\n",
            "mesh.obj:5: face refers to vertex -5, but only 4 are defined before it; re-export the file");
        row("polyline", kSquare + "l 1 9\n",
            "mesh.obj:5: polyline refers to vertex 9, but only 4 are defined");
        row("point", kSquare + "p x\n", "mesh.obj:5: point has the corner \"x\"");
        row("huge index", kSquare + "f 1 2 99999999999999999999\n", "mesh.obj:5: face has the corner");
        row("word in a face", kSquare + "f 1 2 three\n", "mesh.obj:5: face has the corner \"three\"");
        row("word in a vertex", "v 0 0 zero\n", "mesh.obj:1: vertex needs a number where \"zero\" is");
        row("short vertex", "v 0 0\n", "mesh.obj:1: vertex needs a number where the line ends");
        row("not a number", "# one\nv 0 nan 0\n",
            "mesh.obj:2: coordinate of a vertex is not a finite number; export it again");
        row("infinite", "v 0 inf 0\n", "mesh.obj:1: coordinate of a vertex is not a finite number");
        row("too far", "v 0 0 1.1e6\n",
            "mesh.obj:1: coordinate of a vertex is beyond 1e6 m; move the model to its origin, or scale it");
        row("beyond double", "v 0 0 1e999\n", "mesh.obj:1: vertex needs a number");
        row("no coordinate", kSquare + "f 1/x 2 3\n", "mesh.obj:5: face has the corner \"1/x\"");
        row("nothing to touch", "o nothing\n", "mesh.obj: has no faces, lines or points");
    }
    void errorsNameTheLine() {
        QFETCH(QString, content);
        QFETCH(QString, error);
        const auto loaded = folder_.load("mesh.obj", content.toStdString());
        QVERIFY(!loaded);
        const std::string place = (folder_.path() / error.toStdString()).string();
        COMPARE_BEGINS(loaded.error().text, place);
    }

private:
    Scene read(const std::string& content) {
        const auto loaded = folder_.load("mesh.obj", content);
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return loaded->scene;
    }
    Names names(const std::string& faces) { return surfaceNames(read(kSquare + faces).objects[0]); }

    FileFolder folder_;
};

TACTUM_TEST(TestObj)

} // namespace test_obj

#include "test_obj.moc"
