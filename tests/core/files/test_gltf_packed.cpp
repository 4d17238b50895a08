// Meshes packed by Draco and by meshoptimizer. What their own encoders keep whole arrives to the bit; what
// another program packed (gltf-transform 4.5 by its defaults, packed/draco.glb and packed/meshopt.glb of
// packed/ball.obj) as near as it says. Should these files be replaced by such as are not packed, whatIsRead()
// fails: it looks for the extension in them first.
#include <random>

#include <QFile>
#include <QTest>

#include <draco/compression/encode.h>
#include <meshoptimizer.h>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/save_scene.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_gltf_packed {

using namespace tactum;

namespace {

using Bytes = std::vector<unsigned char>;

/// A ball whose positions are single precision.
TriangleSoup singleBall() {
    TriangleSoup soup = *test::ball(0.07, 2);
    for (Vec3& p : soup.positions)
        p = p.cast<float>().cast<double>();
    return soup;
}

std::vector<float> floatsOf(const TriangleSoup& soup) {
    std::vector<float> values;
    for (const Vec3& p : soup.positions)
        for (int i = 0; i < 3; ++i)
            values.push_back(float(p[i]));
    return values;
}

std::vector<std::uint32_t> cornersOf(const TriangleSoup& soup) {
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : soup.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    return corners;
}

Json bufferOf(const Bytes& bytes) {
    const auto text =
        QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()))
            .toBase64()
            .toStdString();
    return {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + text}};
}

/// A file of one mesh, whose views are yet to be said.
Json fileOf(const TriangleSoup& soup) {
    return {{"asset", {{"version", "2.0"}}},
            {"nodes", {{{"mesh", 0}}}},
            {"scenes", {{{"nodes", {0}}}}},
            {"scene", 0},
            {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
            {"accessors",
             {{{"type", "VEC3"}, {"componentType", 5126}, {"count", soup.positions.size()}},
              {{"type", "SCALAR"}, {"componentType", 5125}, {"count", 3 * soup.triangles.size()}}}}};
}

Bytes packedByDraco(const TriangleSoup& soup) {
    draco::Mesh mesh;
    mesh.set_num_points(std::uint32_t(soup.positions.size()));
    draco::GeometryAttribute positions;
    positions.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = mesh.AddAttribute(positions, true, mesh.num_points());
    const std::vector<float> values = floatsOf(soup);
    for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &values[3 * i]);
    mesh.SetNumFaces(soup.triangles.size());
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
        mesh.SetFace(draco::FaceIndex(i),
                     {draco::PointIndex(soup.triangles[i][0]), draco::PointIndex(soup.triangles[i][1]),
                      draco::PointIndex(soup.triangles[i][2])});
    draco::Encoder encoder; // by its defaults nothing is rounded; so the order stays, too
    encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer to;
    if (!encoder.EncodeMeshToBuffer(mesh, &to).ok()) qFatal("Draco packs nothing");
    return {to.data(), to.data() + to.size()};
}

Json dracoFile(const TriangleSoup& soup, const Bytes& packed) {
    Json json = fileOf(soup);
    json["buffers"] = {bufferOf(packed)};
    json["bufferViews"] = {{{"buffer", 0}, {"byteLength", packed.size()}}};
    json["extensionsUsed"] = json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
    return json;
}

Bytes packedVertices(const std::vector<float>& values) {
    Bytes packed(meshopt_encodeVertexBufferBound(values.size() / 3, 12));
    packed.resize(
        meshopt_encodeVertexBuffer(packed.data(), packed.size(), values.data(), values.size() / 3, 12));
    return packed;
}

Bytes packedCorners(const std::vector<std::uint32_t>& corners, std::size_t vertices, bool triangles) {
    Bytes packed(2 * meshopt_encodeIndexBufferBound(corners.size(), vertices) +
                 meshopt_encodeIndexSequenceBound(corners.size(), vertices));
    packed.resize(
        triangles
            ? meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(), corners.size())
            : meshopt_encodeIndexSequence(packed.data(), packed.size(), corners.data(), corners.size()));
    return packed;
}

/// Positions, by a filter perhaps, and corners, as triangles or one by one.
Json meshoptFile(const TriangleSoup& soup, const char* mode, const char* filter, const Bytes& positions) {
    const bool triangles = mode == std::string_view("TRIANGLES");
    const Bytes corners = packedCorners(cornersOf(soup), soup.positions.size(), triangles);
    Bytes all = positions;
    all.insert(all.end(), corners.begin(), corners.end());
    const std::size_t count = soup.positions.size(), indices = 3 * soup.triangles.size();
    Json json = fileOf(soup);
    json["accessors"][0]["bufferView"] = 0;
    json["accessors"][1]["bufferView"] = 1;
    json["extensionsUsed"] = json["extensionsRequired"] = {"EXT_meshopt_compression"};
    json["buffers"] = {bufferOf(all),
                       {{"byteLength", 12 * count + 4 * indices},
                        {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    const auto view = [](std::size_t offset, std::size_t size, const Json& packed) {
        return Json{{"buffer", 1},
                    {"byteOffset", offset},
                    {"byteLength", size},
                    {"extensions", {{"EXT_meshopt_compression", packed}}}};
    };
    json["bufferViews"] = {view(0, 12 * count,
                                {{"buffer", 0},
                                 {"byteLength", positions.size()},
                                 {"byteStride", 12},
                                 {"count", count},
                                 {"mode", "ATTRIBUTES"},
                                 {"filter", filter}}),
                           view(12 * count, 4 * indices,
                                {{"buffer", 0},
                                 {"byteOffset", positions.size()},
                                 {"byteLength", corners.size()},
                                 {"byteStride", 4},
                                 {"count", indices},
                                 {"mode", mode}})};
    json["bufferViews"][0]["byteStride"] = 12;
    return json;
}

/// The same triangles, each from whichever of its corners.
bool areSame(const TriangleSoup& a, const TriangleSoup& b) {
    const auto turned = [](const TriangleSoup& soup) {
        auto triangles = soup.triangles;
        for (auto& triangle : triangles)
            std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
        std::ranges::sort(triangles);
        return triangles;
    };
    return a.positions == b.positions && turned(a) == turned(b);
}

double areaOf(const TriangleSoup& soup) {
    double area = 0;
    for (const auto& t : soup.triangles)
        area += (soup.positions[t[1]] - soup.positions[t[0]])
                    .cross(soup.positions[t[2]] - soup.positions[t[0]])
                    .norm() /
                2;
    return area;
}

} // namespace

class TestGltfPacked : public QObject {
    Q_OBJECT

    FileFolder folder_;

    Result<LoadedScene> loaded(const Json& json) { return folder_.load("packed.gltf", json.dump()); }

private slots:
    void dracoArrivesToTheBit() {
        const TriangleSoup soup = singleBall();
        const auto scene = loaded(dracoFile(soup, packedByDraco(soup)));
        VERIFY_RESULT(scene);
        const TriangleSoup& read = *scene->scene.objects.at(0).geometry;
        QVERIFY(read.positions == soup.positions);
        QVERIFY(read.triangles == soup.triangles);
        COMPARE_LACKS(said(*scene), "draco");
    }

    void meshoptArrivesToTheBit_data() {
        QTest::addColumn<QByteArray>("mode");
        QTest::newRow("as triangles") << QByteArray("TRIANGLES");
        QTest::newRow("as a sequence") << QByteArray("INDICES");
    }
    void meshoptArrivesToTheBit() {
        QFETCH(QByteArray, mode);
        const TriangleSoup soup = singleBall();
        const auto scene = loaded(meshoptFile(soup, mode, "NONE", packedVertices(floatsOf(soup))));
        VERIFY_RESULT(scene);
        QVERIFY(areSame(*scene->scene.objects.at(0).geometry, soup));
    }

    /// Of 24 bits, which leaves steps of 2^-23 m here. Not undone, they would be other numbers altogether.
    void filtersAreUndone() {
        const TriangleSoup soup = singleBall();
        const std::vector<float> values = floatsOf(soup);
        std::vector<float> filtered(values.size());
        meshopt_encodeFilterExp(filtered.data(), values.size() / 3, 12, 24, values.data());
        const auto scene = loaded(meshoptFile(soup, "TRIANGLES", "EXPONENTIAL", packedVertices(filtered)));
        VERIFY_RESULT(scene);
        const TriangleSoup& read = *scene->scene.objects.at(0).geometry;
        QCOMPARE(read.positions.size(), soup.positions.size());
        for (std::size_t i = 0; i < read.positions.size(); ++i)
            COMPARE_NEAR(read.positions[i], soup.positions[i], 2e-7, "m");
    }

    void whatAnotherProgramPacked_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>(
            "tolerance"); // m, of steps: 0.16 m of 2^14, and 0.08 m of 2^14 for each side of zero
        QTest::newRow("Draco") << QStringLiteral("draco.glb") << 1e-5;
        QTest::newRow("meshopt") << QStringLiteral("meshopt.glb") << 1e-5;
    }
    void whatAnotherProgramPacked() {
        QFETCH(QString, name);
        QFETCH(double, tolerance);
        const std::filesystem::path files = TACTUM_PACKED;
        QFile packed(QString::fromStdString((files / name.toStdString()).string()));
        QVERIFY(packed.open(QIODevice::ReadOnly));
        QVERIFY(packed.readAll().contains("_compression"));
        const auto original = loadScene(files / "ball.obj"), scene = loadScene(files / name.toStdString());
        VERIFY_RESULT(original);
        VERIFY_RESULT(scene);
        const SceneObject& object = scene->scene.objects.at(0);
        const TriangleSoup &read = *object.geometry, &was = *original->scene.objects.at(0).geometry;
        QCOMPARE(read.triangles.size(), was.triangles.size());
        COMPARE_NEAR(areaOf(read), areaOf(was), 1e-3 * areaOf(was), "m2");
        for (const Vec3& p : read.positions) {
            double nearest = 1;
            for (const Vec3& q : was.positions)
                nearest = std::min(nearest, (object.pose.apply(p) - q).norm());
            QCOMPARE_LT(nearest, tolerance);
        }
        // Saved again it is a file for everybody.
        const auto glb = glbOf(scene->scene);
        VERIFY_RESULT(glb);
        COMPARE_LACKS(*glb, "_compression");
        const auto again = folder_.load("again.glb", *glb);
        VERIFY_RESULT(again);
        QVERIFY(areSame(*again->scene.objects.at(0).geometry, read));
    }

    /// By its other name, and with a buffer that only stands in for what is unpacked and does not say so.
    void theNameMayBeTheOther() {
        const TriangleSoup soup = singleBall();
        Json json = meshoptFile(soup, "TRIANGLES", "NONE", packedVertices(floatsOf(soup)));
        json["buffers"][1].erase("extensions");
        std::string text = json.dump();
        for (std::size_t at = 0; (at = text.find("EXT_meshopt", at)) != std::string::npos;)
            text.replace(at, 3, "KHR");
        const auto scene = folder_.load("packed.gltf", text);
        VERIFY_RESULT(scene);
        QVERIFY(areSame(*scene->scene.objects.at(0).geometry, soup));
    }

    /// One primitive's arrays are another one's, too, and packed once or twice.
    void arraysAreShared() {
        const TriangleSoup soup = singleBall();
        Json json = dracoFile(soup, packedByDraco(soup));
        Json& primitives = json["meshes"][0]["primitives"];
        primitives.push_back(primitives[0]);
        const auto scene = loaded(json);
        VERIFY_RESULT(scene);
        QCOMPARE(scene->scene.objects.at(0).geometry->triangles.size(), 2 * soup.triangles.size());
    }

    void liesAreRefused() {
        const TriangleSoup soup = singleBall();
        const auto refused = [&](Json json, const std::function<void(Json&)>& lie) {
            lie(json);
            const auto scene = loaded(json);
            return scene ? std::string("it was read") : scene.error().text;
        };
        const Json draco = dracoFile(soup, packedByDraco(soup));
        const char* extension = "KHR_draco_mesh_compression";
        const auto packing = [&](Json& json) -> Json& {
            return json["meshes"][0]["primitives"][0]["extensions"][extension];
        };
        COMPARE_CONTAINS(refused(draco, [&](Json& json) { packing(json)["bufferView"] = 7; }),
                         "invalid bufferView");
        COMPARE_CONTAINS(refused(draco, [&](Json& json) { packing(json)["attributes"]["POSITION"] = 9; }),
                         "has an attribute that its packed data lack");
        COMPARE_CONTAINS(refused(draco, [](Json& json) { json["bufferViews"][0]["byteLength"] = 40; }),
                         "cannot be unpacked by Draco; export it without compression");
        COMPARE_CONTAINS(refused(draco, [](Json& json) { json["accessors"][0]["type"] = "MAT4"; }),
                         "has packed values of another type");
        const Json meshopt = meshoptFile(soup, "TRIANGLES", "NONE", packedVertices(floatsOf(soup)));
        const auto view = [](Json& json) -> Json& {
            return json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
        };
        for (const auto& [key, value] : {std::pair<const char*, Json>{"byteStride", 13},
                                         {"byteStride", 0},
                                         {"byteStride", 512},
                                         {"count", std::size_t(1) << 40},
                                         {"count", 100'000'000},
                                         {"mode", "WORDS"},
                                         {"filter", "OCTAHEDRAL"},
                                         {"filter", "LOW"},
                                         {"byteLength", 20}})
            COMPARE_CONTAINS(refused(meshopt, [&](Json& json) { view(json)[key] = value; }),
                             "bufferViews[0] cannot be unpacked by meshoptimizer; export it without");
        COMPARE_CONTAINS(refused(meshopt, [&](Json& json) { view(json)["buffer"] = 5; }),
                         "beyond its buffer");
    }

    /// Whatever byte is another one, the file is read or refused, by one line.
    void damagedBytesDoNoHarm() {
        const TriangleSoup soup = singleBall();
        std::mt19937 random(25);
        const Bytes draco = packedByDraco(soup), vertices = packedVertices(floatsOf(soup));
        for (int i = 0; i < 300; ++i) {
            Bytes damaged = i % 2 ? draco : vertices;
            for (int k = 0; k < 3; ++k)
                damaged[random() % damaged.size()] = (unsigned char)random();
            const auto scene =
                loaded(i % 2 ? dracoFile(soup, damaged) : meshoptFile(soup, "TRIANGLES", "NONE", damaged));
            if (!scene) QVERIFY(scene.error().text.find('\n') == std::string::npos);
        }
    }
};

TACTUM_TEST(TestGltfPacked)

} // namespace test_gltf_packed

#include "test_gltf_packed.moc"
