// Meshes and files that come in: what fits is read, what lies is refused, and memory is what has come.
#include <cstring>
#include <random>

#include <QFile>
#include <QTest>

#include "core/protocol/uploads.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_uploads {

using namespace tactum;

namespace {

template <class T> void append(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values)
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One triangle in z = 0.
struct Mesh {
    v1::MeshHead head;
    std::string bytes;

    Mesh() {
        head.set_positions(3);
        head.set_triangles(1);
        append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
        append<std::uint32_t>(bytes, {0, 1, 2});
    }
};

v1::UploadHead headOf(const Mesh& mesh) {
    v1::UploadHead head;
    *head.mutable_mesh() = mesh.head;
    head.set_size(mesh.bytes.size());
    return head;
}

Result<LoadedScene> readAll(Uploads& uploads, const v1::UploadHead& head, const std::string& bytes) {
    Incoming incoming(uploads, {});
    if (auto begun = incoming.begin(head); !begun) return tl::unexpected(begun.error());
    for (std::size_t at = 0; at < bytes.size(); at += 1000)
        if (auto added = incoming.add(std::string_view(bytes).substr(at, 1000)); !added)
            return tl::unexpected(added.error());
    return incoming.read({});
}

} // namespace

class TestUploads : public QObject {
    Q_OBJECT

private slots:
    void aMeshIsReadToTheBit();
    void everythingACornerMayHave();
    void whatLiesIsRefused();
    void anyBytesAreHarmless();
    void flatTrianglesAreRepairedAsInFiles();
    void aFileIsReadByItsEnding();
    void noPathIsTold();
    void sizesAreBounded();
    void clientsKeepTheirOwn();
};

void TestUploads::aMeshIsReadToTheBit() {
    v1::MeshHead head;
    head.set_positions(3), head.set_triangles(1), head.set_doubles(true);
    std::string bytes;
    append<double>(bytes, {0.1, 1.0 / 3, -2e-17, 1, 0, 0, 0, 1, 0});
    append<std::uint32_t>(bytes, {2, 0, 1});
    const auto soup = meshOf(head, bytes);
    VERIFY_RESULT(soup);
    QCOMPARE_EQ(soup->positions[0].y(), 1.0 / 3);
    QCOMPARE_EQ(soup->positions[0].z(), -2e-17);
    QVERIFY(soup->triangles[0] == (std::array<Index, 3>{2, 0, 1}));
    QCOMPARE_EQ(soup->surfaceOf.size(), std::size_t(1));
}

void TestUploads::everythingACornerMayHave() {
    Mesh mesh;
    mesh.head.set_normals(true), mesh.head.set_uvs(true), mesh.head.set_surfaces(true);
    mesh.head.set_surface_count(3);
    append<float>(mesh.bytes, {0, 0, 2, 0, 0, 2, 0, 3, 0});
    append<float>(mesh.bytes, {0, 0, 1, 0, 0, 1});
    append<std::uint32_t>(mesh.bytes, {2});
    const auto soup = meshOf(mesh.head, mesh.bytes);
    VERIFY_RESULT(soup);
    COMPARE_NEAR(Vec3(soup->cornerNormals[2].cast<double>()), Vec3::UnitY(), 1e-7, ""); // made unit
    QCOMPARE_EQ(soup->cornerUvs[1].x(), 1.0f);
    QCOMPARE_EQ(soup->surfaceOf[0], Index(2));
    Uploads uploads;
    const auto loaded = readAll(uploads, headOf(mesh), mesh.bytes);
    VERIFY_RESULT(loaded);
    QCOMPARE_EQ(loaded->scene.objects[0].surfaces.size(), std::size_t(3));
}

void TestUploads::whatLiesIsRefused() {
    const auto refused = [](auto change) {
        Mesh mesh;
        change(mesh);
        return test::refusal(meshOf(mesh.head, mesh.bytes));
    };
    const std::string size = "as many bytes";
    COMPARE_CONTAINS(refused([](Mesh& m) { m.bytes.pop_back(); }), size);
    COMPARE_CONTAINS(refused([](Mesh& m) { m.bytes += 'x'; }), size);
    COMPARE_CONTAINS(refused([](Mesh& m) { m.head.set_positions(1 << 30); }), size);
    COMPARE_CONTAINS(refused([](Mesh& m) { m.head.set_normals(true); }), size);
    COMPARE_CONTAINS(refused([](Mesh& m) { m.head.set_positions(~std::uint64_t(0)); }), "more corners");
    COMPARE_CONTAINS(refused([](Mesh& m) { m.head.set_triangles(~std::uint64_t(0) / 3); }), "more corners");
    COMPARE_CONTAINS(refused([](Mesh& m) { m.bytes[36] = 3; }), "a corner that there is not");
    COMPARE_CONTAINS(refused([](Mesh& m) {
                         const float nan = std::numeric_limits<float>::quiet_NaN();
                         std::memcpy(m.bytes.data(), &nan, sizeof nan);
                     }),
                     "not within");
    COMPARE_CONTAINS(refused([](Mesh& m) {
                         m.head.set_surfaces(true);
                         append<std::uint32_t>(m.bytes, {1});
                     }),
                     "a surface that there is not");
    COMPARE_CONTAINS(refused([](Mesh& m) {
                         m.head.set_normals(true);
                         append<float>(m.bytes, {0, 0, 0, 0, 0, 1, 0, 0, 1});
                     }),
                     "no length");
}

void TestUploads::anyBytesAreHarmless() {
    std::mt19937_64 random(21);
    for (int i = 0; i < 2000; ++i) {
        Mesh mesh;
        const bool changeHead = random() % 2;
        for (int k = 0; k < 4; ++k)
            mesh.bytes[random() % mesh.bytes.size()] = char(random());
        mesh.bytes.resize(random() % (2 * mesh.bytes.size()));
        if (changeHead) {
            mesh.head.set_positions(random() >> (random() % 64)),
                mesh.head.set_triangles(random() >> (random() % 64));
            mesh.head.set_doubles(random() % 2), mesh.head.set_normals(random() % 2),
                mesh.head.set_uvs(random() % 2);
        }
        const auto soup = meshOf(mesh.head, mesh.bytes);
        if (!soup) continue;
        for (const auto& triangle : soup->triangles)
            for (const Index corner : triangle)
                QCOMPARE_LT(corner, soup->positions.size());
        for (const Vec3& p : soup->positions)
            QVERIFY(p.allFinite());
    }
}

void TestUploads::flatTrianglesAreRepairedAsInFiles() {
    Mesh mesh;
    const float onLine[3] = {2, 0, 0};
    std::memcpy(mesh.bytes.data() + 24, onLine, sizeof onLine);
    Uploads uploads;
    const auto loaded = readAll(uploads, headOf(mesh), mesh.bytes);
    VERIFY_RESULT(loaded);
    const auto& corners = loaded->scene.objects[0].geometry->triangles[0];
    QCOMPARE_EQ(corners[1], corners[2]); // a segment
    QVERIFY(!loaded->findings.empty());
}

void TestUploads::aFileIsReadByItsEnding() {
    Uploads uploads;
    v1::UploadHead head;
    head.set_file("../../etc/plate.OBJ");
    const std::string text = "v -0.1 -0.1 0\nv 0.1 -0.1 0\nv 0.1 0.1 0\nf 1 2 3\n";
    head.set_size(text.size());
    const auto loaded = readAll(uploads, head, text);
    VERIFY_RESULT(loaded);
    QCOMPARE_EQ(triangleCount(loaded->scene), std::size_t(1));
    head.set_file("plate.sh");
    COMPARE_CONTAINS(test::refusal(readAll(uploads, head, text)), "no ending");
}

void TestUploads::noPathIsTold() {
    Uploads uploads;
    v1::UploadHead head;
    head.set_file("broken.obj");
    const std::string text = "v 1 2\nf 1 2 3\n";
    head.set_size(text.size());
    const std::string refusal = test::refusal(readAll(uploads, head, text));
    COMPARE_CONTAINS(refusal, "broken.obj");
    COMPARE_LACKS(refusal, "/");
}

void TestUploads::sizesAreBounded() {
    Uploads uploads({.one = 1000, .all = 1500, .kept = 2});
    v1::UploadHead head;
    head.set_file("a.obj");
    head.set_size(1001);
    Incoming first(uploads, {}), second(uploads, {});
    QVERIFY(!first.begin(head));
    head.set_size(0);
    QVERIFY(!first.begin(head));
    head.set_size(1000);
    VERIFY_RESULT(first.begin(head));
    VERIFY_RESULT(second.begin(head));
    VERIFY_RESULT(first.add(std::string(1000, 'x')));
    QVERIFY(!first.add("y")); // more than was said
    COMPARE_CONTAINS(test::refusal(second.add(std::string(600, 'x'))), "at once");
    VERIFY_RESULT(second.add(std::string(500, 'x')));
    QVERIFY(!second.complete());
    QVERIFY(!second.read({}));
}

void TestUploads::clientsKeepTheirOwn() {
    Uploads uploads({.kept = 2});
    const auto number = uploads.keep(1, {});
    QVERIFY(uploads.find(1, number) != nullptr);
    QVERIFY(uploads.find(2, number) == nullptr);
    uploads.keep(1, {}), uploads.keep(1, {});
    QVERIFY(uploads.find(1, number) == nullptr); // the oldest went
    const auto last = uploads.keep(1, {});
    uploads.forget(1);
    QVERIFY(uploads.find(1, last) == nullptr);
}

TACTUM_TEST(TestUploads)

} // namespace test_uploads

#include "test_uploads.moc"
