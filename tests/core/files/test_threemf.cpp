// 3MF by its core specification: units, transforms, parts of parts, materials, and what is wrong with a file.
#include <QTest>

#include "core/archive/zip_archive.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/files/rare_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_threemf {

using namespace tactum;

namespace {

/// A tetrahedron of 10, 20 and 30 along the axes.
const std::string kTetrahedron =
    "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='10' y='0' z='0'/><vertex x='0' y='20' z='0'/>"
    "<vertex x='0' y='0' z='30'/></vertices><triangles><triangle v1='0' v2='2' v3='1'/>"
    "<triangle v1='0' v2='1' v3='3'/><triangle v1='1' v2='2' v3='3'/><triangle v1='2' v2='0' v3='3'/>"
    "</triangles></mesh>";

std::string object(const std::string& id, const std::string& content, const std::string& more = "") {
    return "<object id='" + id + "' " + more + ">" + content + "</object>";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

const std::string kOne = threeMfModel(object("1", kTetrahedron, "name='cup'"), "<item objectid='1'/>");

} // namespace

class TestThreemf : public QObject {
    Q_OBJECT

private slots:
    /// z is up there, and a unit that is not said is a millimetre. The second copy stands 50 along x.
    void unitUpAndPartsAreKept() {
        const std::string parts =
            object("1", kTetrahedron, "name='cup'") +
            object("2", "<components><component objectid='1'/>"
                        "<component objectid='1' transform='1 0 0 0 1 0 0 0 1 50 0 0'/></components>");
        for (const auto& [unit, metres] : {std::pair<std::string, double>{"", 1e-3},
                                           {"unit='millimeter'", 1e-3},
                                           {"unit=\"inch\"", 0.0254},
                                           {"unit='micron'", 1e-6},
                                           {"unit='meter'", 1}}) {
            const auto loaded = load(threeMfModel(parts, "<item objectid='2'/>", unit));
            VERIFY_RESULT(loaded);
            QCOMPARE(loaded->scene.objects.size(), std::size_t(2));
            for (const SceneObject& each : loaded->scene.objects) {
                QCOMPARE_EQ(each.name, "cup");
                QCOMPARE(each.geometry->triangles.size(), std::size_t(4));
            }
            const Bounds box = boundsOf(loaded->scene);
            COMPARE_NEAR(box.low, Vec3(Vec3(0, 0, -20) * metres), 1e-12 * metres, "m");
            COMPARE_NEAR(box.high, Vec3(Vec3(60, 30, 0) * metres), 1e-12 * metres, "m");
            COMPARE_LACKS(said(*loaded), "unit");
        }
    }

    /// A point is a row that is multiplied from the left: first the component's matrix, then the item's. Here
    /// a quarter turn about z and a move along x, then twice the size.
    void transformsAreRowsFromTheLeft() {
        const auto loaded = load(threeMfModel(
            object("1", kTetrahedron) +
                object("2", "<components><component objectid='1' transform='0 1 0 -1 0 0 0 0 1 100 0 0'/>"
                            "</components>"),
            "<item objectid='2' transform='2 0 0 0 2 0 0 0 2 0 0 7'/>", "unit='meter'"));
        VERIFY_RESULT(loaded);
        // In the file's frame x from 160 to 200, y from 0 to 20, z from 7 to 67.
        const Bounds box = boundsOf(loaded->scene);
        COMPARE_NEAR(box.low, Vec3(160, 7, -20), 1e-9, "m");
        COMPARE_NEAR(box.high, Vec3(200, 67, 0), 1e-9, "m");
    }

    void baseMaterialsAreSurfaces() {
        std::string mesh = replaced(kTetrahedron, "v3='1'/>", "v3='1' pid='9' p1='1'/>");
        mesh = replaced(mesh, "v3='3'/>", "v3='3' pid='9' p1='7'/>");
        const auto loaded =
            load(threeMfModel("<basematerials id='9'><base name='cork' displaycolor='#FF0000'/>"
                              "<base name='felt' displaycolor='#0000FF80'/></basematerials>" +
                                  object("1", mesh, "pid='9' pindex='0'"),
                              "<item objectid='1'/>"));
        VERIFY_RESULT(loaded);
        const SceneObject& cup = loaded->scene.objects.at(0);
        QCOMPARE(cup.surfaces.size(), std::size_t(3));
        QCOMPARE(cup.surfaces[0].name, std::string("felt"));
        QCOMPARE(cup.surfaces[0].colour, Eigen::Vector3f(0, 0, 1));
        QCOMPARE(cup.surfaces[2].name, std::string("cork"));
        QCOMPARE(cup.surfaces[2].colour, Eigen::Vector3f(1, 0, 0));
        QCOMPARE(cup.geometry->surfaceOf, (std::vector<Index>{0, 1, 2, 2}));
        COMPARE_CONTAINS(said(*loaded), "1 triangle with a material that is not there");
    }

    /// The production extension puts objects into files of their own, and prefixes are as a writer likes.
    void partsInOtherFilesAreRead() {
        std::string root =
            threeMfModel(object("5", "<components><component objectid='1' p:path='/3D/Parts/a.model'/>"
                                     "</components>"),
                         "<item objectid='5'/>",
                         "requiredextensions='p' xmlns:p='http://schemas."
                         "microsoft.com/3dmanufacturing/production/2015/06'");
        std::string other = kOne;
        for (const char* name : {"model", "resources", "object", "mesh", "vertices", "triangles"})
            for (const char* bracket : {"<", "</"})
                other = replaced(other, std::string(bracket) + name, std::string(bracket) + "ns0:" + name);
        const auto loaded = folder_.load("a.3mf", as3mf(root, {{"3D/Parts/A.model", other}}));
        VERIFY_RESULT(loaded);
        QCOMPARE_EQ(loaded->scene.objects.at(0).name, "cup");
        QCOMPARE(loaded->scene.objects[0].geometry->triangles.size(), std::size_t(4));
    }

    void whatIsDoubtfulIsSaid() {
        const auto unit = load(replaced(kOne, "<model ", "<model unit='parsec' "));
        VERIFY_RESULT(unit);
        COMPARE_CONTAINS(said(*unit), "has the unit \"parsec\", which 3MF does not know");
        const auto lattice = load(replaced(kOne, "</mesh>", "<b:beamlattice/></mesh>"));
        VERIFY_RESULT(lattice);
        COMPARE_CONTAINS(said(*lattice), "1 beam lattice left out");
        const auto empty = load(replaced(replaced(kOne, "<build>", "<build><item objectid='2'/>"),
                                         "</resources>", "<object id='2'/></resources>"));
        VERIFY_RESULT(empty);
        COMPARE_CONTAINS(said(*empty), "1 object with neither mesh nor components left out");
    }

    void whatIsWrongIsNamedByItsLine_data() {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const std::string& text, const char* sentence) {
            QTest::newRow(name) << QString::fromStdString(text) << sentence;
        };
        row("word", replaced(kOne, "x='10'", "x='ten'"),
            ":3: <vertex>: x is \"ten\", which is no number; export it again");
        row("nothing", replaced(kOne, "x='10'", ""), ":3: <vertex>: has no x; export it again");
        row("infinite", replaced(kOne, "x='10'", "x='nan'"), "coordinate of vertex 1 is not a finite number");
        row("no vertex", replaced(kOne, "v2='2'", "v2='4'"),
            ":3: <triangle>: v2 is \"4\", but only 4 vertices are there (from 0); export it again");
        row("part of a vertex", replaced(kOne, "v2='2'", "v2='1.5'"), "v2 is \"1.5\", but only 4 vertices");
        row("before the first", replaced(kOne, "v2='2'", "v2='-1'"), "v2 is \"-1\", but only 4 vertices");
        row("no object", replaced(kOne, "objectid='1'", "objectid='8'"),
            ":4: <item>: refers to the object \"8\", which is not there; export it again");
        row("short transform", replaced(kOne, "objectid='1'", "objectid='1' transform='1 0 0'"),
            ":4: <item>: has a transform that is not twelve finite numbers; export it again");
        row("twice", replaced(kOne, "</resources>", object("1", kTetrahedron) + "</resources>"),
            "<object>: has the id \"1\" of another one; export it again");
        row("itself",
            threeMfModel(object("1", "<components><component objectid='1'/></components>"),
                         "<item objectid='1'/>"),
            ":3: <component>: puts the object \"1\" inside itself; take it out");
        row("each other",
            threeMfModel(object("1", "<components><component objectid='2'/></components>") +
                             object("2", "<components><component objectid='1'/></components>"),
                         "<item objectid='1'/>"),
            "puts the object \"1\" inside itself");
        row("far", replaced(kOne, "x='10'", "x='1e12'"), "coordinate of vertex 1 is beyond 1e6 m");
        row("extension", replaced(kOne, "<model ", "<model requiredextensions='b' xmlns:b='urn:beams' "),
            ":2: <model>: needs the extension \"urn:beams\", which is not read; export it without");
        row("no XML", "<model", "is no XML");
        row("no model", "<scene/>", ":1: <scene>: is no <model>; export it as 3MF again");
        row("nothing in it", threeMfModel("", ""), "has no faces, lines or points");
        std::string doubling = object("0", kTetrahedron);
        for (int i = 1; i < 60; ++i) {
            const std::string half = "<component objectid='" + std::to_string(i - 1) + "'/>";
            doubling += object(std::to_string(i), "<components>" + half + half + "</components>");
        }
        row("bomb", threeMfModel(doubling, "<item objectid='59'/>"), "meshes with all its copies");
        row("hollow bomb", threeMfModel(replaced(doubling, kTetrahedron, ""), "<item objectid='59'/>"),
            "is one part too many; export it with fewer copies");
    }
    void whatIsWrongIsNamedByItsLine() {
        QFETCH(QString, model);
        QFETCH(QString, sentence);
        const auto loaded = load(model.toStdString());
        QVERIFY(!loaded);
        COMPARE_CONTAINS(loaded.error().text, "a.3mf: ");
        COMPARE_CONTAINS(loaded.error().text, sentence.toStdString());
        COMPARE_LACKS(loaded.error().text, "\n");
    }

    void packagesThatAreNoneAreRefused() {
        const std::string whole = as3mf(kOne);
        QVERIFY(folder_.load("a.3mf", whole));
        for (std::size_t length = 1; length < whole.size(); length += 7)
            QVERIFY(!folder_.load("a.3mf", whole.substr(0, length)));
        const ZipEntry alone[] = {{"3D/3dmodel.model", kOne}};
        const auto loose = folder_.load("a.3mf", writeZip(alone));
        QVERIFY(!loose);
        COMPARE_CONTAINS(loose.error().text, "a.3mf: entry \"_rels/.rels\": is not there");
    }

private:
    Result<LoadedScene> load(const std::string& model) const { return folder_.load("a.3mf", as3mf(model)); }

    FileFolder folder_;
};

TACTUM_TEST(TestThreemf)

} // namespace test_threemf

#include "test_threemf.moc"
