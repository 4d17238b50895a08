// PLY, STL and OFF: what is special in each, and their errors.
#include <algorithm>

#include <QTest>

#include "core/files/corner_pool.h"
#include "core/files/readers.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scan_formats {

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

std::string plyText(const std::string& vertex, const std::string& rest, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + vertex + rest + "end_header\n" + body;
}

const std::string kVertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

} // namespace

class TestScanFormats : public QObject {
    Q_OBJECT

private slots:
    void plyListsMayHaveAnyTypesAndNeighbours() {
        for (const char* type : {"char", "uchar", "int16", "ushort", "int", "uint32"})
            for (const char* count : {"uint8", "short", "uint"}) {
                const std::string face = "element face 2\nproperty float quality\nproperty list " +
                                         std::string(count) + " " + type +
                                         " vertex_index\nproperty list uchar float texcoord\n";
                const TriangleSoup soup = read(
                    "a.ply", plyText(kVertices, face, kCorners + "0.5 4 0 1 2 3 2 0.1 0.2\n1 3 0 1 2 0\n"));
                QCOMPARE(soup.triangles.size(), std::size_t(3));
            }
    }

    void plyVerticesAloneArePoints() {
        const TriangleSoup soup =
            read("a.ply",
                 plyText(kVertices, "element face 0\nproperty list uchar int vertex_indices\n", kCorners));
        QCOMPARE(soup.triangles.size(), std::size_t(4));
        QCOMPARE(cornersOf(soup.triangles[1]), 1);
    }

    /// In a text file a column of a kind that nobody knows is a word.
    void plyColumnsOfUnknownKindsAreSkipped() {
        const LoadedScene loaded = readPly(
            Source::ofBytes(
                "a.ply", plyText(kVertices + "property string name\nproperty list uchar thing more\n", kFaces,
                                 "0 0 0 red 0\n1 0 0 blue 2 x y\n1 1 0 9,5 1 z\n0 1 0 - 0\n3 0 1 2\n")),
            {});
        const TriangleSoup& soup = *loaded.scene.objects[0].geometry;
        QCOMPARE(soup.triangles.size(), std::size_t(1));
        QCOMPARE(soup.positions[2], Vec3(1, 1, 0));
        QCOMPARE(std::ranges::count(loaded.findings, "2 columns of an unknown type", &Finding::sentence), 1);
    }

    void plySkipsElementsThatItDoesNotKnow() {
        const std::string before =
            "element camera 2\nproperty double a\nproperty list uchar short b\nelement nothing "
            "1000000000000\n";
        const TriangleSoup soup =
            read("a.ply", "ply\nformat ascii 1.0\n" + before + kVertices +
                              "element material 1\nproperty int id\n" + kFaces +
                              "end_header\n1.5 2 7 8\n2.5 0\n" + kCorners + "77\n3 0 1 2\n");
        QCOMPARE(soup.positions[2], Vec3(1, 1, 0));
        QCOMPARE(soup.triangles.size(), std::size_t(1));
    }

    void plyKeepsNormalsAndUvsInAnyOrder() {
        const std::string vertex =
            "element vertex 3\nproperty double nz\nproperty double ny\nproperty double nx\n"
            "property uchar red\nproperty float z\nproperty float y\nproperty float x\n"
            "property float t\nproperty float s\n";
        const TriangleSoup soup = read("a.ply", plyText(vertex, kFaces,
                                                        "2 0 0 255 0 0 0 0.5 0.25\n2 0 0 1 0 0 1 0 0\n"
                                                        "2 0 0 1 0 1 0 0 0\n3 0 1 2\n"));
        QCOMPARE(soup.positions[1], Vec3(1, 0, 0));
        QCOMPARE(soup.cornerNormals[0], Eigen::Vector3f(0, 0, 1));
        QCOMPARE(soup.cornerUvs[0], Eigen::Vector2f(0.25f, 0.5f));
    }

    void plyStripsAndEdgesAreRead() {
        const TriangleSoup strip =
            read("a.ply", plyText(kVertices, "element tristrips 1\nproperty list int int vertex_indices\n",
                                  "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 2 1\n"));
        QCOMPARE(strip.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 3, 2}, {0, 2, 1}}));
        const TriangleSoup edges =
            read("a.ply", plyText(kVertices, "element edge 2\nproperty int vertex1\nproperty int vertex2\n",
                                  kCorners + "0 1\n2 3\n"));
        QCOMPARE(edges.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 1}, {2, 3, 3}}));
    }

    void plyHeadersMayEndInCrLf() {
        std::string text = plyText(kVertices, kFaces, kCorners + "3 0 1 2\n");
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
            text.insert(at, "\r");
        QCOMPARE(read("a.ply", text).triangles.size(), std::size_t(1));
    }

    void stlWeldsEqualCornersOnly() {
        QCOMPARE(read("a.stl", asStlBinary(tetrahedron())).positions.size(), std::size_t(4));
        QCOMPARE(read("a.stl", asStlText(tetrahedron())).positions.size(), std::size_t(4));
    }

    void binaryStlThatBeginsWithSolidIsBinary() {
        std::string content = asStlBinary(tetrahedron());
        content.replace(0, 12, "solid things");
        QCOMPARE(read("a.stl", content).triangles.size(), std::size_t(4));
    }

    void solidsAreSurfaces() {
        const std::string two = replaced(asStlText(tetrahedron()), "solid thing", "SOLID red part") +
                                replaced(asStlText(tetrahedron()), "solid thing", "solid");
        const auto loaded = folder_.load("a.stl", two);
        VERIFY_RESULT(loaded);
        const SceneObject& object = loaded->scene.objects[0];
        QCOMPARE(object.surfaces.size(), std::size_t(2));
        QCOMPARE(object.surfaces[0].name, std::string("red part"));
        QCOMPARE(object.surfaces[1].name, std::string("surface"));
        QCOMPARE(object.geometry->surfaceOf, (std::vector<Index>{0, 0, 0, 0, 1, 1, 1, 1}));
    }

    void offVariantsAreRead() {
        const std::string body = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n";
        QCOMPARE(read("a.off", "OFF " + body).triangles.size(), std::size_t(1));
        QCOMPARE(read("a.off", "OFF" + body).triangles.size(), std::size_t(1)); // a common slip
        QCOMPARE(read("a.off", "# hi\nCOFF\n# more\n3 1 0\n\n0 0 0 1 1 1 1 # red\n1 0 0 1 0 0 1\n0 1 0 0 "
                               "0 0 1\n3 0 1 2\n")
                     .triangles.size(),
                 std::size_t(1));
        const TriangleSoup soup =
            read("a.off", "NOFF\n3 1 0\n0 0 0 0 0 3\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
        QCOMPARE(soup.cornerNormals[0], Eigen::Vector3f(0, 0, 1));
    }

    void whatTheReaderDidIsSaid() {
        const auto loaded = folder_.load("a.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n"
                                                  "4 0 1 2 3\n3 0 1 2\n3 0 1 4\n0\n");
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects[0].geometry->triangles.size(), std::size_t(4));
        for (const char* part :
             {"1 polygon with", "1 face without corners", "1 triangle whose corners lie on one line"})
            COMPARE_CONTAINS(said(*loaded), part);
    }

    void errorsNameThePlace_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("error");
        const auto row = [](const char* name, const char* file, const std::string& text, const char* error) {
            QTest::newRow(name) << QString(file) << QByteArray::fromStdString(text) << QString(error);
        };
        const std::string little = asPly(tetrahedron(), PlyForm::LittleEndian),
                          binary = asStlBinary(tetrahedron());
        row("ply: wrong word", "a.ply", "plum\n", "a.ply:1: does not start with \"ply\"");
        row("ply: no end", "a.ply", "ply\nformat ascii 1.0\n", "a.ply:2: the header has no end_header");
        row("ply: no format", "a.ply", "ply\nend_header\n", "a.ply:2: the header names no format");
        row("ply: format", "a.ply", "ply\nformat utf 1.0\n", "a.ply:2: unknown format \"utf\"");
        row("ply: huge count", "a.ply", replaced(little, "vertex 4", "vertex 4000000000000000000"),
            "a.ply: promises 4000");
        row("ply: huge face count", "a.ply", replaced(little, "face 4", "face 9000000"),
            "a.ply: promises 9000000 of \"face\"");
        row("ply: negative count", "a.ply", replaced(little, "vertex 4", "vertex -4"),
            "a.ply:4: element needs a count");
        row("ply: type", "a.ply", replaced(little, "float y", "quad y"), "a.ply:6: unknown type \"quad\"");
        // The first of them has normals, the second none: a face that asked for one read past their end.
        row("ply: two lists of vertices", "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
            "z\n"
            "property float nx\nproperty float ny\nproperty float nz\n" +
                kVertices + kFaces + "end_header\n0 0 0 0 0 1\n" + kCorners + "3 2 3 4\n",
            "a.ply:10: a second element \"vertex\"");
        row("ply: no z", "a.ply", replaced(little, "float z", "float w"),
            "a.ply: its vertices have no x, y and z");
        row("ply: index", "a.ply", plyText(kVertices, kFaces, kCorners + "3 0 1 4\n"),
            "a.ply:14: face refers to vertex 4, but only 4 are defined (from 0)");
        row("ply: negative index", "a.ply", plyText(kVertices, kFaces, kCorners + "3 0 1 -1\n"),
            "a.ply:14: face refers to vertex -1");
        row("ply: long list", "a.ply", plyText(kVertices, kFaces, kCorners + "99999999 0 1 2\n"),
            "a.ply:14: a list of 99999999");
        row("ply: word", "a.ply", plyText(kVertices, kFaces, "0 0 zero\n" + kCorners),
            "a.ply:10: a number is needed where \"zero\"");
        row("ply: nan", "a.ply", plyText(kVertices, kFaces, "0 0 nan\n" + kCorners),
            "a.ply:10: coordinate of vertex 0");
        row("ply: faces of fractions", "a.ply", replaced(little, "uchar int", "float int"),
            "a.ply:9: list is counted by a fraction");
        row("ply: cut", "a.ply", little.substr(0, little.size() - 3), "a.ply: byte ");
        row("stl: cut", "a.stl", binary.substr(0, binary.size() - 1),
            "a.stl: promises 4 triangles, that is 284 bytes, but has 283");
        row("stl: longer", "a.stl", binary + "x",
            "a.stl: promises 4 triangles, that is 284 bytes, but has 285");
        row("stl: short", "a.stl", "abc", "a.stl: is too short");
        row("stl: nan", "a.stl", replaced(binary, std::string("\0\0\x80\x3f", 4), "\xff\xff\xff\x7f"),
            "a.stl: byte 84: coordinate of triangle 0");
        row("stl: word", "a.stl", replaced(asStlText(tetrahedron()), "outer", "inner"),
            "a.stl:3: \"outer\" is needed where \"inner\" is");
        row("stl: end", "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
            "a.stl:5: \"vertex\" is needed where \"\" is");
        row("off: header", "a.off", "OOF\n3 1 0\n", "a.off:1: does not start with OFF");
        row("off: binary", "a.off", "OFF BINARY\n3 1 0\n", "a.off:1: is a binary OFF file");
        row("off: 4-D", "a.off", "4OFF\n3 1 0\n", "a.off:1: does not start with OFF");
        row("off: counts", "a.off", "OFF\n3 many 0\n",
            "a.off:2: needs the number of faces where \"many\" is");
        row("off: huge", "a.off", "OFF\n99999999999 1 0\n0 0 0\n", "a.off:2: promises 99999999999 vertices");
        row("off: index", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
            "a.off:6: face refers to vertex 3");
        row("off: cut", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n",
            "a.off:5: the file ends before its last face");
        row("off: inf", "a.off", "OFF\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n",
            "a.off:3: coordinate of a vertex");
        row("nothing", "a.ply",
            plyText("element vertex 0\nproperty float x\nproperty float y\nproperty float z\n", "", ""),
            "a.ply: has no faces, lines or points");
        row("ply: words in a binary file", "a.ply",
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty string "
            "name\nend_header\nabc",
            "a.ply:4: unknown type \"string\"");
    }
    void errorsNameThePlace() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        QFETCH(QString, error);
        QVERIFY(!content.isEmpty());
        const auto loaded = folder_.load(file.toStdString(), content.toStdString());
        QVERIFY(!loaded);
        const std::string place = (folder_.path() / error.toStdString()).string();
        COMPARE_BEGINS(loaded.error().text, place);
    }

private:
    TriangleSoup read(const std::string& name, const std::string& content) {
        const auto loaded = folder_.load(name, content);
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return *loaded->scene.objects[0].geometry;
    }

    FileFolder folder_;
};

TACTUM_TEST(TestScanFormats)

} // namespace test_scan_formats

#include "test_scan_formats.moc"
