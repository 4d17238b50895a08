// What readers and writers make of files and scenes in which every kind of value occurs, to the last of them.
#include <cstring>

#include <QRegularExpression>
#include <QTest>

#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/loss_report.h"
#include "core/files/mesh/write_mesh.h"
#include "core/files/x3d/write_x3d.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/files/rich_mechanics.h"
#include "tests/core/files/scene_text.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_values {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Two square plates and a bent strip, with normals and texture coordinates.
std::shared_ptr<const TriangleSoup> plates() {
    auto soup = std::make_shared<TriangleSoup>();
    for (int i = 0; i < 2; ++i) {
        const Index first = Index(soup->positions.size());
        for (const auto& [x, z] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            soup->positions.emplace_back(0.05 * x, 0.01 * i + 0.002 * x, 0.05 * z);
        for (const auto& corners : {std::array<Index, 3>{0, 2, 1}, std::array<Index, 3>{0, 3, 2}}) {
            soup->triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
            soup->surfaceOf.push_back(Index(i));
            for (const Index corner : corners) {
                soup->cornerUvs.emplace_back(corner == 1 || corner == 2 ? 0.75f : 0.25f,
                                             corner > 1 ? 1.f : 0.f);
                soup->cornerNormals.push_back(Eigen::Vector3f(0.25f * float(i), 1, 0).normalized());
            }
        }
    }
    return soup;
}

TextureLayer layerOf(const char* name, TextureSource source) {
    TextureLayer layer;
    layer.name = name;
    layer.pattern.source = source;
    layer.pattern.size = 0.05; // coarse: pictures of it stay small
    layer.pattern.octaves = 1;
    return layer;
}

/// Every kind of value: layers of each source, masks, sides, motion, a finger, what is hidden and locked.
Scene richScene() {
    Scene scene;
    scene.proxyRadius = 0.0015;
    scene.finger = std::make_shared<const std::vector<FingerPoint>>(
        std::vector<FingerPoint>{{0, {0.01, 0.02, 0.03}}, {0.5, {0.01, 0.0, 0.03}}});
    SceneObject box;
    box.name = "Box & \"lid\" <1>";
    box.geometry = plates();
    box.pose = {Quat(0.5, 0.5, -0.5, 0.5), {0.1, 0.2, 0.3}};
    box.surfaces.resize(2);
    Surface& lid = box.surfaces[0];
    lid.name = "lid";
    lid.material = {500, 1.5, 0.6, 0.4, 2};
    lid.colour = {1, 0.5f, 0.25f};
    lid.sides = Sides::Front;
    lid.locked = true;
    lid.shading = {true, NormalSource::Computed, 0.5};
    lid.layers = {layerOf("noise", TextureSource::Noise), layerOf("grooves", TextureSource::Grooves),
                  layerOf("picture", TextureSource::Image), layerOf("painted", TextureSource::Painted)};
    lid.layers[0].strength = 0.0003;
    lid.layers[0].pattern.mapping = TextureMapping::Uv;
    lid.layers[1].target = TextureTarget::StaticFriction;
    lid.layers[1].strength = 0.5;
    lid.layers[1].blend = TextureBlend::Multiply;
    lid.layers[1].opacity = 0.75;
    lid.layers[1].pattern.mapping = TextureMapping::UvUnit;
    lid.layers[1].mask = layerOf("", TextureSource::Dots).pattern;
    lid.layers[2].pattern.image = std::make_shared<const TextureImage>(
        2, 2, std::vector<std::uint16_t>{0, 20000, 40000, 65535}, "cloth.png");
    lid.layers[2].pattern.mapping = TextureMapping::UvUnit;
    lid.layers[2].ownPlane = true;
    lid.layers[2].pattern.rotation = 0.25;
    lid.layers[3].target = TextureTarget::Stiffness;
    lid.layers[3].enabled = false;
    lid.layers[3].strength = -0.25;
    lid.layers[3].pattern.painted.values =
        std::make_shared<const PaintedValues>(std::vector<float>{0, 0.25f, 0.5f, 0.75f, 1, 0.5f, 0.25f, 0});
    Surface& floor = box.surfaces[1];
    floor.name = "floor";
    floor.sides = Sides::Back;
    floor.visible = false;
    scene.add(box);
    SceneObject plain;
    plain.name = "Plain";
    plain.visible = false;
    auto bare = std::make_shared<TriangleSoup>();
    bare->positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0.3, 0.1, 0.2}};
    bare->triangles = {{0, 1, 2}, {1, 3, 3}, {2, 2, 2}}; // a triangle, a segment and a point
    bare->surfaceOf = {0, 0, 0};
    plain.geometry = bare;
    plain.surfaces.resize(1);
    plain.surfaces[0].name = "all";
    plain.surfaces[0].sides = Sides::None;
    scene.add(plain);
    SceneObject mover;
    mover.name = "Mover";
    mover.geometry = plates();
    mover.surfaces.resize(2);
    mover.surfaces[0].name = "a", mover.surfaces[1].name = "b";
    mover.surfaces[0].material.viscosity = 12;
    auto motion = std::make_shared<Motion>();
    motion->translation = {Interpolation::Linear, {0, 1, 2}, {{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0}}, {}, {}};
    motion->rotation = {
        Interpolation::Step, {0, 1}, {QuatCoefficients(0, 0, 0, 1), QuatCoefficients(0, 0, 1, 0)}, {}, {}};
    motion->duration = 2;
    motion->jumps = {1};
    motion->jumpsAtEnd = true;
    mover.motion = motion;
    scene.add(mover);
    return scene;
}

/// The JSON of a glb, without the places of its bytes, one member a line.
QString jsonOf(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    return QString::fromStdString(Json::parse(glb.substr(20, length)).dump(1)) + u'\n';
}

/// The pictures in it are compressed by a library: its bytes are its own affair.
QString lossText(const std::vector<Loss>& losses) {
    return QString::fromStdString(reportMarkdown(losses));
}

} // namespace

class TestValues : public QObject {
    Q_OBJECT

    FileFolder folder_;

    /// What a file is read as, or why it is refused.
    QString read(const char* name, const std::string& content) {
        const auto loaded = folder_.load(name, content);
        const QString text =
            loaded ? sceneText(*loaded) : QString::fromStdString(loaded.error().text) + u'\n';
        return QString(text).replace(QString::fromStdString(folder_.path().string()),
                                     QStringLiteral("FOLDER"));
    }

private slots:
    void aSceneIsWrittenAndReadAsGltf() {
        const auto glb = glbOf(richScene());
        VERIFY_RESULT(glb);
        COMPARE_SHOWN(jsonOf(*glb), "written-gltf");
        COMPARE_SHOWN(read("rich.glb", *glb), "read-gltf");
        const auto again = folder_.load("rich.glb", *glb);
        VERIFY_RESULT(again);
        LoadedScene written{richScene(), {}, true};
        QCOMPARE(sceneText({again->scene, {}, true}), sceneText(written)); // nothing was lost on the way
    }

    /// The whole of a mechanism, and again: what is read is written the same.
    void whatMovesIsWrittenAndReadAsGltf() {
        Scene scene;
        scene.objects = {SceneObject{}};
        scene.objects[0].name = "carried";
        scene.objects[0].geometry = plates();
        scene.objects[0].surfaces.resize(2);
        scene.objects[0].body = 1;
        scene.mechanics = richMechanics();
        const auto glb = glbOf(scene);
        VERIFY_RESULT(glb);
        COMPARE_SHOWN(jsonOf(*glb), "written-mechanics");
        const auto loaded = folder_.load("mechanics.glb", *glb);
        VERIFY_RESULT(loaded);
        const Mechanics &before = scene.mechanics, &after = loaded->scene.mechanics;
        QVERIFY(after.bodies == before.bodies);
        QCOMPARE(after.joints.size(), before.joints.size());
        for (std::size_t i = 0; i < before.joints.size(); ++i) {
            const Joint &is = after.joints[i], &was = before.joints[i];
            QCOMPARE_EQ(is.name, was.name);
            QVERIFY(is.limits == was.limits);
            QVERIFY(is.drives == was.drives);
            QVERIFY(is.frictions == was.frictions);
            QVERIFY(is.path == was.path);
            QVERIFY(is.frameA == was.frameA);
            QVERIFY(is.frameB == was.frameB);
            QVERIFY(is == was);
        }
        QCOMPARE(after.colliders.size(), before.colliders.size());
        for (std::size_t i = 0; i < before.colliders.size(); ++i)
            QVERIFY2(after.colliders[i] == before.colliders[i], qPrintable(QString::number(i)));
        QVERIFY(after == before);
    }

    void aSceneIsWrittenAsX3d() {
        const X3dExport made = x3dOf(richScene());
        QString text = QString::fromStdString(made.scene);
        COMPARE_SHOWN(text, "written-x3d");
        COMPARE_SHOWN(QString::fromStdString(made.device), "written-x3d-device");
        QStringList names;
        for (const X3dImage& image : made.images)
            names << QString::fromStdString(image.name);
        QCOMPARE(names.removeDuplicates(), 0);
        COMPARE_SHOWN(names.join(u'\n') + u'\n' + lossText(made.losses), "written-x3d-losses");
        const auto file = folder_.write("rich.x3d", made.scene);
        for (const X3dImage& image : made.images) {
            std::filesystem::create_directories((folder_.path() / image.name).parent_path());
            folder_.write(image.name, image.bytes);
        }
        COMPARE_SHOWN(read("rich.x3d", made.scene), "read-x3d");
    }

    void aSceneIsWrittenAsMeshes() {
        QString all;
        for (const std::string& ending : writableMeshEndings()) {
            const auto files = meshFilesOf(richScene(), ending, "rich");
            VERIFY_RESULT(files);
            for (const MeshFile& file : *files) {
                const QByteArray bytes = QByteArray::fromStdString(file.bytes);
                const bool isText = ending != "stl" && ending != "ply";
                all += QStringLiteral("%1, %2 bytes\n%3\n")
                           .arg(QString::fromStdString(file.name))
                           .arg(bytes.size())
                           .arg(isText ? QString::fromUtf8(bytes)
                                       : QString::fromLatin1(bytes.toHex(' '))
                                             .replace(QRegularExpression(QStringLiteral("(.{96})")),
                                                      QStringLiteral("\\1\n")));
            }
        }
        COMPARE_SHOWN(all, "written-meshes");
        QVERIFY(!meshFilesOf(richScene(), "xyz", "rich"));
    }

    void whatIsLostIsToldOfEachFormat() {
        COMPARE_SHOWN(lossText(lossesOf(richScene())), "losses");
        for (const Loss& loss : lossesOf(richScene(), ExportTarget::Glb))
            QCOMPARE(loss.kind, LossKind::Kept);
    }

    void objFiles() {
        folder_.write("a.mtl", "newmtl red\nKd 1 0 0.5\nnewmtl odd\nkd 2 -1 nan\nbump -bm 0.5 -s 1 1 1 -o 0 "
                               "0 0 -mm 0 1 -clamp on "
                               "-imfchan r none here.png\nnewmtl placed\nKd 0.25 0.5 0.75\nKd 0.1 x "
                               "0\nmap_Bump -s 2 1 gone.png\n"
                               "newmtl empty\nmap_bump -bm x\nnewmtl joined\nKd 0.1 \\\n0.2 0.3\n");
        const char* rich =
            "# comment\nmtllib a.mtl\nmtllib ../out.mtl\no first\nv 0 0 0 1\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
            "vt 0.25\nvt 0.5 0.75 9\nvt 1 # end\nvn 0 0 2\nvn 0 1 0\ng side\nusemtl red\nf 1/1/1 2/2/1 3/3/1 "
            "4/1/2\n"
            "g default\nf -4//-1 -3//-1 -2//-2\nusemtl odd\nf 1/1 2/2 3/3\nusemtl placed\nf 1 2 3\nl 1 2 3 "
            "4\np 1 4\n"
            "usemtl empty\nf 1 3 4\nusemtl joined\nf 2 3 4\no second\nv 5 5 5\nf 1 2 5\no first\nf 3 4 "
            "1\no\nfo 4 3 2\n"
            "curv 0 1 2\nsurf 1\ncurv2 1 2\nf 1 2\nf 1 1 1\n";
        COMPARE_SHOWN(read("rich.obj", rich), "read-obj");
        QString faults;
        for (const char* text :
             {"v 1 2\n", "v 1 2 x\n", "v 1 2 2e6\n", "v 0 0 0\nvn 1 2\nf 1//1 1 1\n",
              "v 0 0 0\nvt\nf 1/1 1 1\n", "v 0 0 0\nvt 1 x\nf 1/1 1 1\n", "v 0 0 0\nvt x\nf 1/1 1 1\n",
              "v 0 0 0\nf 1 2 3\n", "v 0 0 0\nf 0 1 1\n", "v 0 0 0\nf 1 1 -2\n", "v 0 0 0\nf 1x 1 1\n",
              "v 0 0 0\nf 1/2 1 1\n", "v 0 0 0\nf 1//2 1 1\n", "v 0 0 0\nf 1/ 1 1\n", "v 0 0 0\nf x 1 1\n",
              "v 0 0 0\nvt 0\nvn 0 0 1\nf 1/1/1/1 1 1\n", "", "# nothing\n",
              "v 0 0 0\nf 1 1 99999999999999999999\n"})
            faults += QStringLiteral("%1=> %2").arg(QString::fromUtf8(text).replace(u'\n', u';'),
                                                    read("bad.obj", text));
        COMPARE_SHOWN(faults, "read-obj-faults");
    }

    void offFiles() {
        const char* body = "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n";
        QString all;
        for (const std::string head :
             {"OFF", "COFF", "NOFF", "STOFF", "4OFF", "nOFF", "XOFF", "OFF BINARY", ""}) {
            std::string text = body;
            if (head == "COFF")
                text = "4 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n4 0 1 2 3\n";
            if (head == "NOFF") text = "3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n3 0 1 2\n";
            if (head == "STOFF") text = "3 1 0\n0 0 0 0.25 0.5\n1 0 0 1 0\n1 1 0 1 1\n3 0 1 2\n";
            all += QString::fromStdString(head) + u'\n' + read("a.off", head + "\n" + text);
        }
        for (const char* text :
             {"OFF\n4 2\n", "OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 1 2\n",
              "OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n",
              "OFF\n# c\n\n3 1 0 # c\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 # c\n",
              "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n1 0\n", "OFF\n-1 1 0\n",
              "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 3e6 0\n3 0 1 2\n",
              "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7 7\n"})
            all += QStringLiteral("%1=> %2").arg(QString::fromUtf8(text).replace(u'\n', u';'),
                                                 read("b.off", text));
        COMPARE_SHOWN(all, "read-off");
    }

    void plyFiles() {
        const std::string vertices =
            "element vertex 4\nproperty float x\nproperty double y\nproperty float z\n";
        const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
        const std::string values = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
        const auto ply = [](const std::string& rest) {
            return "ply\nformat ascii 1.0\ncomment c\nobj_info i\n" + rest;
        };
        QString all;
        for (const std::string& text : std::vector<std::string>{
                 ply(vertices + faces + "end_header\n" + values + "4 0 1 2 3\n3 0 1 2\n"),
                 ply("element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
                     "nx\nproperty float ny\nproperty float "
                     "nz\nproperty float s\nproperty float t\nproperty uchar red\nelement face 1\nproperty "
                     "uchar flag\nproperty list uchar int "
                     "vertex_index\nproperty list uchar float texcoord\nend_header\n0 0 0 0 0 1 0.25 0.5 "
                     "7\n1 0 "
                     "0 0 0 1 1 0 7\n1 1 0 0 0 2 1 1 7\n9 3 0 "
                     "1 2 6 0 0 1 0 1 1\n"),
                 ply(vertices + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                     values + "6 0 1 2 -1 1 2\n"),
                 ply(vertices +
                     "element other 1\nproperty list uchar int stuff\nelement edge 1\nproperty int "
                     "vertex1\nproperty int "
                     "vertex2\nend_header\n" +
                     values + "2 5 6\n0 1\n"),
                 ply(vertices + faces + "end_header\n" + values + "4 0 1 2 4\n3 0 1 2\n"),
                 ply(vertices + faces + "end_header\n" + values + "4 0 1 2\n"),
                 ply(vertices + faces + "end_header\n0 0 0\n1 0 0\n1 1 x\n0 1 0\n4 0 1 2 3\n3 0 1 2\n"),
                 ply(vertices + faces + "end_header\n0 0 0\n1 0 0\n1 1 2e6\n0 1 0\n4 0 1 2 3\n3 0 1 2\n"),
                 ply(vertices + faces + "end_header\n" + values + "-1 0\n3 0 1 2\n"),
                 ply(vertices + faces + "end_header\n" + values + "2 0 1\n1 0\n"),
                 ply("element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n"),
                 ply("element vertex x\n"),
                 ply("property float x\n"),
                 ply("element vertex 1\nproperty thing x\n"),
                 ply("element vertex 1\nproperty list float int x\n"),
                 ply("element vertex 1\nelement vertex 2\nend_header\n"),
                 ply("strange words\nend_header\n"),
                 ply(vertices),
                 std::string("ply\nend_header\n"),
                 std::string("plyx\n"),
                 std::string("ply\nformat ascii 2.0\nend_header\n"),
                 std::string("ply\nformat odd 1.0\nend_header\n"),
                 std::string()})
            all += QStringLiteral("%1=> %2").arg(QString::fromStdString(text).replace(u'\n', u';'),
                                                 read("a.ply", text));
        COMPARE_SHOWN(all, "read-ply");
    }

    void stlFiles() {
        const std::string facet =
            "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
        QString all;
        for (const std::string& text : std::vector<std::string>{
                 "solid a thing\n" + facet + "endsolid a thing\n",
                 "solid\n" + facet + facet + "endsolid\nsolid two\n" + facet + "endsolid two\n",
                 "SOLID X\nFACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 0 0 0\n  VERTEX 1e0 0 0\n  VERTEX +0 1 "
                 "0\n "
                 "ENDLOOP\nENDFACET\nENDSOLID\n",
                 std::string("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                             "0\nendloop\nendfacet\nendsolid\n"),
                 std::string(
                     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                     "0\nvertex 1 1 0\nendloop\nendfacet\n"),
                 std::string(
                     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\nvertex 1 0 0\nvertex 0 1 "
                     "0\nendloop\nendfacet\nendsolid\n"),
                 std::string(
                     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 3e6\nvertex 1 0 0\nvertex 0 1 "
                     "0\nendloop\nendfacet\nendsolid\n"),
                 std::string("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n"),
                 std::string("solid a\nnonsense\nendsolid\n"), std::string("solid a\nendsolid a\n"),
                 "solid a\n" + facet, facet, std::string("vertex 0 0 0\n"), std::string("solid"),
                 std::string()})
            all += QStringLiteral("%1=> %2").arg(QString::fromStdString(text).replace(u'\n', u';'),
                                                 read("a.stl", text));
        const auto binary = [](std::uint32_t says, int has, std::size_t cut) {
            std::string bytes(80, 'h');
            bytes.append(reinterpret_cast<const char*>(&says), 4);
            for (int i = 0; i < has; ++i) {
                const float numbers[] = {0, 0, 1, float(i), 0, 0, 1, 0, 0, 0, 1, 0};
                bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
                bytes.append(2, '\0');
            }
            return bytes.substr(0, bytes.size() - cut);
        };
        for (const auto& [says, has, cut] :
             {std::tuple(2u, 2, 0u), {2u, 2, 1u}, {1u, 2, 0u}, {3u, 2, 0u}, {0u, 0, 0u}, {0u, 0, 5u}})
            all += QStringLiteral("binary %1 %2 %3=> %4")
                       .arg(says)
                       .arg(has)
                       .arg(cut)
                       .arg(read("b.stl", binary(says, has, cut)));
        COMPARE_SHOWN(all, "read-stl");
    }

    void x3dFiles() {
        const auto x3d = [](const std::string& inside) {
            return "<?xml version=\"1.0\"?><X3D profile=\"Full\" version=\"3.2\"><Scene>" + inside +
                   "</Scene></X3D>";
        };
        const auto shape = [](const std::string& geometry, const std::string& appearance = "") {
            return "<Shape>" + (appearance.empty() ? "" : "<Appearance>" + appearance + "</Appearance>") +
                   geometry + "</Shape>";
        };
        const std::string point = "<Coordinate point='0 0 0, 1 0 0, 1 1 0, 0 1 0'/>";
        const std::string ifs =
            "<IndexedFaceSet coordIndex='0 1 2 3 -1 0 1 2 -1'>" + point + "</IndexedFaceSet>";
        QString all;
        for (const std::string& text : std::vector<std::string>{
                 x3d(shape(ifs)),
                 x3d("<Transform translation='1 2 3' rotation='0 0 1 1.5707963' scale='2 2 2' center='1 0 "
                     "0'>" +
                     shape(ifs) + "</Transform>"),
                 x3d("<Transform scale='1 2 3' scaleOrientation='0 1 0 0.5'><Group DEF='g'>" + shape(ifs) +
                     "</Group></Transform><Group USE='g'/>"),
                 x3d(shape("<IndexedFaceSet ccw='false' coordIndex='0 1 2'>" + point +
                               "<Normal vector='0 0 1 0 0 1 0 0 1 0 0 1'/><TextureCoordinate "
                               "point='0 0 1 0 1 1 0 1'/></IndexedFaceSet>",
                           "<Material diffuseColor='1 0 0.5'/>")),
                 x3d(shape("<IndexedFaceSet normalPerVertex='false' normalIndex='1 0' texCoordIndex='0 1 2 "
                           "-1 2 1 0' "
                           "coordIndex='0 1 2 -1 0 2 3'>" +
                           point +
                           "<Normal vector='0 0 1 0 1 0'/><TextureCoordinate point='0 0 1 0 1 "
                           "1'/></IndexedFaceSet>")),
                 x3d(shape("<TriangleSet>" +
                           std::string("<Coordinate point='0 0 0 1 0 0 1 1 0 0 0 1 1 0 1 1 1 1 5 5 5'/>") +
                           "</TriangleSet>")),
                 x3d(shape("<IndexedTriangleSet index='0 1 2 0 2 3 1'>" + point + "</IndexedTriangleSet>")),
                 x3d(shape("<TriangleStripSet stripCount='4'>" + point + "</TriangleStripSet>")),
                 x3d(shape("<IndexedTriangleStripSet index='0 1 2 3 -1'>" + point +
                           "</IndexedTriangleStripSet>")),
                 x3d(shape("<TriangleFanSet fanCount='4'>" + point + "</TriangleFanSet>")),
                 x3d(shape("<IndexedTriangleFanSet index='0 1 2 3'>" + point + "</IndexedTriangleFanSet>")),
                 x3d(shape("<QuadSet>" + point + "</QuadSet>")),
                 x3d(shape("<IndexedQuadSet index='3 2 1 0'>" + point + "</IndexedQuadSet>")),
                 x3d(shape("<IndexedLineSet coordIndex='0 1 2 -1'>" + point + "</IndexedLineSet>")),
                 x3d(shape("<PointSet>" + point + "</PointSet>")),
                 x3d(shape("<Box size='1 2 3'/>")),

                 x3d(shape("<Rectangle2D size='1 2'/>")),
                 x3d(shape("<ElevationGrid xDimension='2' zDimension='2' xSpacing='0.5' height='0 1 2 3'/>")),
                 x3d(shape(ifs, "<Material diffuseColor='2 -1 0.5'/><FrictionalSurface stiffness='0.5' "
                                "damping='0.1' staticFriction='0.4' "
                                "dynamicFriction='0.2'/>")),
                 x3d(shape(ifs, "<FrictionalSurface useRelativeValues='false' stiffness='500' damping='2' "
                                "staticFriction='0.4' dynamicFriction='0.2'/>")),
                 x3d(shape(ifs, "<SmoothSurface useRelativeValues='false' stiffness='300'/>")),
                 x3d(shape(ifs, "<MagneticSurface stiffness='0.5'/>")),
                 x3d(shape("<IndexedFaceSet coordIndex='0 1 9'>" + point + "</IndexedFaceSet>")),
                 x3d(shape("<IndexedFaceSet coordIndex='0 1 x'>" + point + "</IndexedFaceSet>")),
                 x3d(shape("<IndexedFaceSet coordIndex='0 1 2'/>")),
                 x3d(shape("<TriangleStripSet stripCount='2'>" + point + "</TriangleStripSet>")),
                 x3d(shape("<TriangleStripSet stripCount='9'>" + point + "</TriangleStripSet>")),
                 x3d(shape("<IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 1 0 2e6 1 1 "
                           "0'/></IndexedFaceSet>")),
                 x3d(shape(
                     "<IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0 1 0'/></IndexedFaceSet>")),
                 x3d("<Transform translation='1 2'>" + shape(ifs) + "</Transform>"),
                 x3d("<Transform scale='0 1 1'>" + shape(ifs) + "</Transform>"),
                 x3d("<Switch whichChoice='1'>" + shape("<Box/>") + shape(ifs) + "</Switch>"),
                 x3d("<Inline url='\"a.x3d\"'/>" + shape(ifs)),
                 x3d("<Shape USE='nobody'/>"),
                 x3d(""),
                 std::string("<X3D></X3D>"),
                 std::string("<X3D><Scene>"),
                 std::string("<Other/>"),
                 std::string()})
            all += QStringLiteral("%1\n=> %2")
                       .arg(QString::fromStdString(text).section(QStringLiteral("<Scene>"), -1),
                            read("a.x3d", text));
        COMPARE_SHOWN(all, "read-x3d-nodes");
    }

    /// Each member of our extension of a material, right and wrong.
    void surfacesInJson() {
        const auto image = std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{7}, "i");
        const ReadShared shared{[&](int texture) { return texture == 3 ? image : nullptr; },
                                [](const Json& painted) {
                                    return painted == 5 ? std::make_shared<const PaintedValues>(
                                                              std::vector<float>{0.5f})
                                                        : nullptr;
                                }};
        QString all;
        for (
            const char* text :
            {"{}",
             "5",
             "[]",
             R"({"stiffness": 5, "damping": 1, "staticFriction": 0.5, "dynamicFriction": 0.25, "viscosity": 3})",
             R"({"stiffness": "x", "damping": null, "staticFriction": true, "dynamicFriction": [], "viscosity": {}})",
             R"({"sides": "front", "visible": false, "locked": true})",
             R"({"sides": "up", "visible": 1, "locked": "no"})",
             R"({"sides": 5})",
             R"({"shading": {"on": true, "normals": "computed", "creaseAngle": 0.5}})",
             R"({"shading": {"on": 1, "normals": "odd", "creaseAngle": "x"}})",
             R"({"shading": 5})",
             R"({"layers": 5})",
             R"({"layers": [5, {}]})",
             R"({"layers": [{"name": "n", "enabled": false, "target": "viscosity", "strength": 0.5, "blend": "replace", "opacity": 0.25, "ownPlane": true}]})",
             R"({"layers": [{"target": "stiffness"}, {"target": "height"}]})",
             R"({"layers": [{"name": 1, "enabled": 1, "target": "odd", "strength": "x", "blend": 7, "opacity": [], "ownPlane": 0, "pattern": 5, "mask": 6}]})",
             R"({"layers": [{"pattern": {"source": "image", "mapping": "uv-unit", "texture": {"index": 3}, "size": 0.5, "offsetU": 1, "offsetV": 2, "rotation": 3, "mappingRadius": 4, "fill": 0.1, "softness": 0.2, "octaves": 6, "seed": 7}, "mask": {"source": "painted", "painted": 5}}]})",
             R"({"layers": [{"pattern": {"texture": {"index": -1}}}, {"pattern": {"texture": {"index": 4}, "painted": 6}}, {"pattern": {"texture": 3}}]})",
             R"({"layers": [{"pattern": {"frame": {"translation": [1, 2, 3], "rotation": [0, 0, 2, 0]}}}]})",
             R"({"layers": [{"pattern": {"frame": {"translation": [1, 2], "rotation": [0, 0, 0, 0]}}}]})",
             R"({"layers": [{"pattern": {"frame": {"translation": [1, "x", 3], "rotation": [0, 0, 1]}}}]})",
             R"({"layers": [{"pattern": {"frame": 5}}]})",
             R"({"layers": [{"name": "a\nb"}]})"}) {
            Surface surface;
            surface.name = "s";
            std::vector<std::string> complaints;
            readSurfaceJson(Json::parse(text), kExtension, shared, surface, complaints);
            LoadedScene one;
            SceneObject object;
            object.geometry = std::make_shared<const TriangleSoup>();
            object.surfaces = {surface};
            one.scene.add(object);
            all += QString::fromUtf8(text) + u'\n' + sceneText(one).section(u'\n', 2);
            for (const std::string& complaint : complaints)
                all += QStringLiteral("! ") + QString::fromStdString(complaint) + u'\n';
        }
        COMPARE_SHOWN(all, "surface-json");
    }

    void membersOfJson() {
        const Json object = Json::parse(
            R"({"n": null, "i": 3, "m": -1, "x": 1.5, "s": "t", "extensions": {"A": {"k": 1}, "B": 5}})");
        QVERIFY(!member(object, "n"));
        QVERIFY(!member(object, "none"));
        QVERIFY(!member(Json(5), "i"));
        QCOMPARE(member(object, "i")->get<int>(), 3);
        for (const auto& [key, end, index] :
             {std::tuple("i", 4, 3), {"i", 3, -1}, {"m", 9, -1}, {"x", 9, -1}, {"s", 9, -1}, {"none", 9, -1}})
            QCOMPARE(indexIn(object, key, std::size_t(end)), index);
        for (const auto& [key, size] : {std::pair("i", 3), {"m", 0}, {"x", 0}, {"none", 0}})
            QCOMPARE(sizeIn(object, key), std::size_t(size));
        QVERIFY(extensionOf(object, "A"));
        QVERIFY(!extensionOf(object, "B")); // no object
        QVERIFY(!extensionOf(object, "C"));
        Json root =
            Json::parse(R"({"extensionsUsed": ["A", "B", "A"], "extensions": {"A": {}}, "name": "n"})");
        eraseUse(root, "A");
        QCOMPARE(root["extensionsUsed"].dump(), "[\"B\"]");
        eraseUse(root, "B");
        QVERIFY(!root.contains("extensionsUsed"));
        eraseExtension(root, "none");
        QVERIFY(root.contains("extensions"));
        eraseExtension(root, "A");
        QCOMPARE(root.dump(), R"({"name":"n"})");
        for (const auto& [text, number] : {std::pair("_TACTUM_PAINT_0", 0),
                                           {"_TACTUM_PAINT_65535", 65535},
                                           {"_TACTUM_PAINT_65536", -1},
                                           {"_TACTUM_PAINT_-1", -1},
                                           {"_TACTUM_PAINT_", -1},
                                           {"_TACTUM_PAINT_x", -1},
                                           {"TEXCOORD_0", -1}})
            QCOMPARE(paintNumber(text), number);
        QCOMPARE(jsonKey("static-friction"), "staticFriction");
        QCOMPARE(jsonKey("a-b-c"), "aBC");
        QCOMPARE(jsonKey("size"), "size");
        QCOMPARE(jsonKey("end-"), "end-");
    }

    void versionsOfTheFormat() {
        for (const auto& [version, later, strange] : {std::tuple(R"("1.0")", "", ""),
                                                      {R"("1.7")", "", ""},
                                                      {R"("2.0")", "2.0", ""},
                                                      {R"("17")", "17", ""},
                                                      {R"("0.9")", "", "\"0.9\""},
                                                      {R"("1")", "", "\"1\""},
                                                      {R"("1.x")", "", "\"1.x\""},
                                                      {R"("1.-1")", "", "\"1.-1\""},
                                                      {R"("x.1")", "", "\"x.1\""},
                                                      {"1.0", "", "\"1.0\""},
                                                      {"2", "2", ""},
                                                      {"null", "", "\"null\""},
                                                      {"{}", "", "\"{}\""},
                                                      {R"("")", "", "\"\""}}) {
            const Json root = Json::parse(std::string(R"({"extensions": {"TACTUM_haptics": {"version": )") +
                                          version + "}}}");
            QCOMPARE(laterFormat(root).value_or(""), std::string(later));
            QCOMPARE(strangeVersion(root).value_or(""), std::string(strange));
        }
        const Json none = Json::parse(R"({"extensions": {"TACTUM_haptics": {}}})");
        QVERIFY(!laterFormat(none));
        QVERIFY(!strangeVersion(none));
        QVERIFY(!laterFormat(Json::object()));
    }
};

TACTUM_TEST(TestValues)

} // namespace test_values

#include "test_values.moc"
