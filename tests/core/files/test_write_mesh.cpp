// Bare meshes written and read by our own readers: equal up to what the format can say.
#include <algorithm>
#include <set>

#include <QTest>

#include "core/base/single_precision.h"
#include "core/files/corner_pool.h"
#include "core/files/mesh/write_mesh.h"
#include "tests/core/files/bodies.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_write_mesh {

using namespace tactum;
using namespace tactum::test;

namespace {

/// One face as an object has it: its corners in the world, and what they carry.
struct Face {
    std::string object, surface;
    int different = 3; ///< corners: 3 of a triangle, 2 of a segment, 1 of a point
    std::vector<Vec3> corners;
    std::vector<Eigen::Vector3f> normals;
    std::vector<Eigen::Vector2f> uvs;
};

std::vector<Face> facesOf(const Scene& scene) {
    std::vector<Face> faces;
    for (const SceneObject& object : scene.objects)
        for (std::size_t i = 0; i < object.geometry->triangles.size(); ++i) {
            const TriangleSoup& soup = *object.geometry;
            Face face{
                object.name, object.surfaces[soup.surfaceOf[i]].name, cornersOf(soup.triangles[i]), {}, {},
                {}};
            for (std::size_t k = 0; k < 3; ++k) {
                face.corners.push_back(object.pose.apply(soup.positions[soup.triangles[i][k]]));
                if (!soup.cornerNormals.empty())
                    face.normals.push_back(
                        object.pose.rotate(soup.cornerNormals[3 * i + k].cast<double>()).cast<float>());
                if (!soup.cornerUvs.empty()) face.uvs.push_back(soup.cornerUvs[3 * i + k]);
            }
            faces.push_back(std::move(face));
        }
    return faces;
}

bool isTriangle(const Face& face) {
    return face.different == 3;
}

/// Objects with poses, several surfaces, and normals and coordinates on some of them. Triangles are not
/// slivers.
Scene randomScene(Rng& rng) {
    Scene scene;
    const int objects = 1 + int(rng() % 3);
    for (int n = 0; n < objects; ++n) {
        auto soup = std::make_shared<TriangleSoup>(*randomSoup(rng, 40, 0.1));
        for (auto& surface : soup->surfaceOf)
            surface = Index(rng() % 3);
        for (auto& t : soup->triangles) // a flat triangle would be read as a point
            if (soup->positions[t[0]] == soup->positions[t[1]]) t = {t[0], t[0], t[0]};
        const bool normals = rng() % 2, uvs = rng() % 2;
        for (std::size_t i = 0; i < 3 * soup->triangles.size(); ++i) {
            if (normals) soup->cornerNormals.push_back(direction(rng).cast<float>());
            if (uvs) soup->cornerUvs.push_back(inBox(rng, 2).head<2>().cast<float>());
        }
        SceneObject object;
        object.name = "object " + std::to_string(n);
        object.geometry = soup;
        object.pose.translation = inBox(rng, 0.5);
        if (n > 0) object.pose.rotation = Eigen::AngleAxisd(uniform(rng, 0, 3), direction(rng));
        for (const char* name : {"lid", "body \xC3\xA4", "foot"}) {
            object.surfaces.push_back({});
            object.surfaces.back().name = name;
            object.surfaces.back().colour = inBox(rng, 1).cast<float>().cwiseAbs();
        }
        scene.add(object);
    }
    return scene;
}

class MeshFolder : public FileFolder {
public:
    LoadedScene roundTrip(const Scene& scene, const std::string& ending,
                          const std::string& stem = "mesh") const {
        const auto files = meshFilesOf(scene, ending, stem);
        for (const MeshFile& file : *files)
            write(file.name, file.bytes);
        return loadScene(path() / files->front().name).value();
    }
};

} // namespace

class TestWriteMesh : public QObject {
    Q_OBJECT
private slots:
    void objKeepsEverythingOfTheMesh();
    void plyKeepsTheCorners();
    void stlKeepsTrianglesInFloats();
    void offKeepsEveryFaceExactly();
    void plyWidensOnlyWhereItMust();
    void hostileNamesStayOnTheirLine();
    void oneMeshAtRestComesBackAsItWas();
    void anotherEndingIsRefused();
    void pointsAloneComeBackAsPoints();
    void everyStemFindsItsLibrary();

private:
    MeshFolder folder_;
};

void TestWriteMesh::objKeepsEverythingOfTheMesh() {
    Rng rng(1);
    for (int n = 0; n < 20; ++n) {
        const Scene scene = randomScene(rng);
        const LoadedScene loaded = folder_.roundTrip(scene, "obj");
        QCOMPARE(loaded.scene.objects.size(), scene.objects.size());
        const std::vector<Face> wanted = facesOf(scene), found = facesOf(loaded.scene);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QCOMPARE(found[i].object, wanted[i].object);
            QCOMPARE(found[i].surface, wanted[i].surface);
            QVERIFY(found[i].corners == wanted[i].corners);
            if (!isTriangle(wanted[i])) continue; // lines and points carry no more
            for (std::size_t k = 0; k < wanted[i].normals.size(); ++k)
                QCOMPARE_LT((found[i].normals[k] - wanted[i].normals[k]).norm(), 1e-6f);
            QVERIFY(wanted[i].uvs.empty() || found[i].uvs == wanted[i].uvs);
        }
        for (const SceneObject& object : scene.objects)
            for (const Surface& surface : object.surfaces)
                for (const SceneObject& other : loaded.scene.objects)
                    for (const Surface& same : other.surfaces)
                        if (other.name == object.name && same.name == surface.name)
                            QVERIFY(same.colour == surface.colour);
    }
}

/// One object is left, triangles before lines; points are no faces there.
void TestWriteMesh::plyKeepsTheCorners() {
    Rng rng(2);
    for (int n = 0; n < 20; ++n) {
        const Scene scene = randomScene(rng);
        std::vector<Face> wanted = facesOf(scene);
        std::erase_if(wanted, [](const Face& face) { return face.different == 1; });
        std::ranges::stable_partition(wanted, isTriangle);
        const std::vector<Face> found = facesOf(folder_.roundTrip(scene, "ply").scene);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QVERIFY(found[i].corners == wanted[i].corners);
            for (std::size_t k = 0; k < std::size_t(wanted[i].different); ++k) {
                if (!wanted[i].normals.empty())
                    QCOMPARE_LT((found[i].normals[k] - wanted[i].normals[k]).norm(), 1e-6f);
                if (!wanted[i].uvs.empty()) QCOMPARE(found[i].uvs[k], wanted[i].uvs[k]);
            }
        }
    }
}

void TestWriteMesh::stlKeepsTrianglesInFloats() {
    Rng rng(3);
    for (int n = 0; n < 20; ++n) {
        const Scene scene = randomScene(rng);
        std::vector<Face> wanted = facesOf(scene);
        std::erase_if(wanted, [](const Face& face) { return !isTriangle(face); });
        const std::vector<Face> found = facesOf(folder_.roundTrip(scene, "stl").scene);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(found[i].corners[k] == asSingle(wanted[i].corners[k]));
    }
}

void TestWriteMesh::offKeepsEveryFaceExactly() {
    Rng rng(4);
    for (int n = 0; n < 20; ++n) {
        const Scene scene = randomScene(rng);
        const std::vector<Face> wanted = facesOf(scene),
                                found = facesOf(folder_.roundTrip(scene, "off").scene);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            QVERIFY(found[i].corners == wanted[i].corners);
    }
}

void TestWriteMesh::plyWidensOnlyWhereItMust() {
    Scene scene;
    scene.add(bodyOf("sheet", sheet(0.5)));
    COMPARE_CONTAINS(asPly(scene), "property float x");
    scene.objects[0].geometry = sheet(0.1);
    COMPARE_CONTAINS(asPly(scene), "property double x");
}

void TestWriteMesh::hostileNamesStayOnTheirLine() {
    Scene scene;
    for (const char* name : {"a\nf 1 2 3", "a\\", "", " ", "default", "#", "\xFF\xFE", "a\nf 1 2 3"}) {
        SceneObject object = bodyOf(name, sheet(0.1));
        object.surfaces[0].name = name;
        scene.add(object);
    }
    const LoadedScene loaded = folder_.roundTrip(scene, "obj");
    QCOMPARE(loaded.scene.objects.size(), scene.objects.size());
    for (const SceneObject& object : loaded.scene.objects)
        QCOMPARE(object.geometry->triangles.size(), std::size_t(2));
}

void TestWriteMesh::oneMeshAtRestComesBackAsItWas() {
    Scene scene;
    scene.add(bodyOf("ball", ball(0.05, 2)));
    for (const char* ending : {"obj", "off"})
        QVERIFY(*folder_.roundTrip(scene, ending).scene.objects[0].geometry == *scene.objects[0].geometry);
}

void TestWriteMesh::anotherEndingIsRefused() {
    QVERIFY(!meshFilesOf({}, "dwg", "mesh"));
    for (const std::string& ending : writableMeshEndings())
        VERIFY_RESULT(meshFilesOf({}, ending, "mesh"));
}

void TestWriteMesh::pointsAloneComeBackAsPoints() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.3}};
    soup.triangles = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    soup.surfaceOf = {0, 0, 0};
    Scene scene;
    scene.add(bodyOf("scan", std::make_shared<const TriangleSoup>(soup)));
    for (const char* ending : {"ply", "obj", "off"}) {
        const Scene back = folder_.roundTrip(scene, ending).scene;
        QVERIFY2(back.objects[0].geometry->positions == soup.positions, ending);
        QVERIFY2(back.objects[0].geometry->triangles == soup.triangles, ending);
    }
    const auto stl = meshFilesOf(scene, "stl", "scan");
    QVERIFY(!stl);
    COMPARE_CONTAINS(stl.error().text, "has no triangles");
}

void TestWriteMesh::everyStemFindsItsLibrary() {
    Rng rng(3);
    const Scene scene = randomScene(rng);
    std::set<std::string> libraries;
    const std::vector<std::string> stems{" lead",     "trail ",   "\t",     "in the middle", "line\nfeed",
                                         "return\r",  "bell\a",   "back\\", "T\xC3\xA4sse",  "broken\xC3",
                                         "broken~C3", "# remark", "a.b",    "\"quoted\""};
    for (const std::string& stem : stems) {
        const LoadedScene loaded = folder_.roundTrip(scene, "obj", stem);
        for (const Finding& finding : loaded.findings)
            COMPARE_LACKS(finding.sentence, "library");
        for (const Surface& surface : loaded.scene.objects[0].surfaces) { // in the order of their faces
            const auto& all = scene.objects[0].surfaces;
            const auto same = std::ranges::find(all, surface.name, &Surface::name);
            QVERIFY2(same != all.end() && surface.colour == same->colour, stem.c_str());
        }
        std::filesystem::remove(folder_.path() / (stem + ".obj")); // QTemporaryDir cannot say some of them
        libraries.insert(meshFilesOf(scene, "obj", stem)->back().name);
    }
    QCOMPARE(libraries.size(), stems.size());
    QVERIFY(libraries.contains("T\xC3\xA4sse.mtl"));
    QVERIFY(libraries.contains("a.b.mtl"));
}

TACTUM_TEST(TestWriteMesh)

} // namespace test_write_mesh

#include "test_write_mesh.moc"
