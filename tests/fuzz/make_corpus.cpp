// Writes the files that fuzzing begins with: make-fuzz-corpus FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <QBuffer>
#include <QImage>
#include <QImageWriter>

#include "core/archive/bundle_files.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/x3d/write_x3d.h"
#include "core/presets/preset_file.h"
#include "core/protocol/messages.h"
#include "core/recording/recording_file.h"
#include "core/scene/finger_path.h"
#include "core/scene/scene_bytes.h"
#include "tests/core/files/image_files.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/files/rare_files.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/support/random_scene.h"

using namespace tactum;

namespace {

/// A folded sheet with a line and a point: every kind of face in few bytes.
TriangleSoup folded() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {0.125, 0, 0}, {0, 0.125, 0}, {0.125, 0.125, 0.0625}, {0.25, 0, 0.125}};
    soup.triangles = {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {3, 4, 4}, {4, 4, 4}};
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

class Corpus {
public:
    explicit Corpus(std::filesystem::path folder) : folder_(std::move(folder)) {}
    void add(const std::string& target, const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories(folder_ / target);
        std::ofstream(folder_ / target / name, std::ios::binary) << bytes;
    }

private:
    std::filesystem::path folder_;
};

void addMeshes(const Corpus& corpus) {
    for (const WrittenMesh& mesh : inEveryFormat(folded()))
        corpus.add(mesh.name.substr(mesh.name.rfind('.') + 1), mesh.name, mesh.content);
    corpus.add("obj", "materials.obj",
               "mtllib m.mtl\no lid\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
               "usemtl red\ng a b\ns 1\nf 1/1/1 2/2/1 3/3/1 4//1\nusemtl blue\nl 1 2 -1\np 3\nf -1 -2 -3\n"
               "#mtl\nnewmtl red\nKd 1 0 0\nmap_bump -bm 0.5 -s 2 2 1 h.png\nnewmtl blue\nbump h.png\n");
    corpus.add(
        "ply", "lists.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
        "element face 1\nproperty list uchar uint vertex_indices\nproperty list uchar float texcoord\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0 0 0 1 9\n"
        "1 0 0 0 0 1 9\n1 1 0 0 0 1 9\n0 1 0 0 0 1 9\n4 0 1 2 3 8 0 0 1 0 1 1 0 1\n0 2\n");
    corpus.add("off", "polygons.off",
               "COFF\n4 2 0\n0 0 0 1 0 0 1\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n2 0 2\n");
    WrittenChannel slide{0, "translation", "CUBICSPLINE", {0, 1}, {}};
    slide.values.assign(6, {0, 0.125, 0});
    const WrittenChannel turn{0, "rotation", "LINEAR", {0, 1}, {{0, 0, 0, 1}, {1, 0, 0, 0}}};
    corpus.add("glb", "moving.glb", asAnimatedGlb(folded(), "", {slide, turn}));
    corpus.add(
        "gltf", "tree.gltf",
        asGltf(folded(),
               R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1,2],"scale":[2,-1,1]},)"
               R"({"mesh":0,"rotation":[0,0,1,0]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1]}])"));
    for (const char* name : {"draco.glb", "meshopt.glb"}) {
        std::ifstream in(std::filesystem::path(TACTUM_PACKED) / name, std::ios::binary);
        corpus.add("glb", name, {std::istreambuf_iterator<char>(in), {}});
    }
    const std::string mesh =
        "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='10' y='0' z='0'/><vertex x='0' y='20' z='0'/>"
        "</vertices><triangles><triangle v1='0' v2='1' v3='2' pid='9' p1='0'/></triangles></mesh>";
    corpus.add("3mf", "parts.model",
               threeMfModel("<basematerials id='9'><base name='a' displaycolor='#FF0000'/></basematerials>"
                            "<object id='1' name='cup'>" +
                                mesh +
                                "</object><object id='2'><components><component objectid='1' "
                                "transform='1 0 0 0 1 0 0 0 1 5 0 0'/></components></object>",
                            "<item objectid='2' transform='0 1 0 1 0 0 0 0 1 1 2 3'/>", "unit='inch'"));
    corpus.add("3ds", "a.3ds", as3ds(folded(), "lid", "red"));
    corpus.add("dae", "a.dae", asDae("<unit name='inch' meter='0.0254'/>"));
    corpus.add("fbx", "a.fbx", asFbx(2));
}

void addScenes(const Corpus& corpus) {
    for (unsigned seed = 0, added = 0; added < 6; ++seed) {
        const Scene scene = test::SceneDice(seed).scene();
        const std::string glb = glbOf(scene).value();
        if (glb.size() > 12'000) continue;
        const std::string number = std::to_string(added++);
        corpus.add("own", "scene-" + number + ".glb", glb);
        const X3dExport x3d = x3dOf(scene);
        if (x3d.scene.size() < 20'000) corpus.add("x3d", "scene-" + number + ".x3d", x3d.scene);
        if (added % 3 == 0)
            corpus.add("zip", "bundle-" + number + ".zip",
                       packBundle(std::vector<ZipEntry>{{bundle_name::kScene, glb}}));
    }
    corpus.add(
        "x3d", "polygons.x3d",
        "<X3D profile='H3DAPI'><Scene><Transform DEF='T' translation='1 0 0' rotation='0 1 0 1' scale='2 1 "
        "1'>"
        "<Shape DEF='S'><Appearance><Material diffuseColor='1 0 0'/><FrictionalSurface stiffness='0.5'/>"
        "</Appearance><IndexedFaceSet coordIndex='0 1 2 3 -1 0 2 1' convex='false' creaseAngle='1'>"
        "<Coordinate point='0 0 0, 1 0 0, 1 1 0, 0 1 0'/></IndexedFaceSet></Shape></Transform>"
        "<Transform USE='T'/><Shape><Box size='1 2 3'/></Shape><Shape USE='S'/></Scene></X3D>\n");
}

void setVector(v1::Vector& vector, double x, double y, double z) {
    vector.set_x(x), vector.set_y(y), vector.set_z(z);
}

/// What clients of the server send: an edit of each kind, a mesh with all that it may have.
void addMessages(const Corpus& corpus) {
    v1::Transaction all;
    v1::AddUpload& add = *all.add_edit()->mutable_add();
    add.set_upload(1), add.set_name("a"), add.set_hidden(true);
    setVector(*add.mutable_pose()->mutable_position(), 1, 2, 3);
    add.mutable_pose()->mutable_rotation()->set_w(1);
    all.add_edit()->mutable_open()->set_upload(1);
    v1::SetMaterial& material = *all.add_edit()->mutable_material();
    material.mutable_where()->set_object(1), material.mutable_where()->set_surface(1);
    material.set_stiffness(500), material.set_static_friction(0.4), material.set_viscosity(1);
    material.set_shading(true), material.set_sides("front");
    all.add_edit()->mutable_pose()->set_object(1);
    all.add_edit()->mutable_visible()->set_object(1);
    v1::Layer& layer = *all.add_edit()->mutable_layers()->add_layer();
    layer.set_source("image"), layer.set_mapping("triplanar"), layer.set_strength(1e-3), layer.set_size(0.01);
    layer.mutable_image()->set_width(2), layer.mutable_image()->set_height(1);
    layer.mutable_image()->set_texels("abcd");
    v1::SetBody& body = *all.add_edit()->mutable_body();
    body.set_object(1), body.set_mass(0.1);
    v1::SetJoint& joint = *all.add_edit()->mutable_joint();
    joint.set_object(1), joint.set_kind("hinge"), joint.set_low(-1), joint.set_high(1),
        joint.set_spacing(0.5);
    setVector(*joint.mutable_axis(), 0, 0, 1);
    all.add_edit()->set_proxy_radius(1e-3);
    setVector(*all.add_edit()->mutable_gravity(), 0, -9.81, 0);
    corpus.add("edits", "all", all.SerializeAsString());
    for (int i = 0; i < all.edit_size(); ++i) {
        v1::Transaction one;
        *one.add_edit() = all.edit(i);
        corpus.add("edits", "edit-" + std::to_string(i), one.SerializeAsString());
    }
    for (const bool doubles : {false, true}) {
        v1::UploadHead head;
        v1::MeshHead& mesh = *head.mutable_mesh();
        mesh.set_positions(3), mesh.set_triangles(1), mesh.set_doubles(doubles);
        mesh.set_normals(doubles), mesh.set_uvs(doubles), mesh.set_surfaces(doubles);
        std::string bytes;
        for (const double number : {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
            const float narrow = float(number);
            bytes += doubles ? std::string(reinterpret_cast<const char*>(&number), sizeof number)
                             : std::string(reinterpret_cast<const char*>(&narrow), sizeof narrow);
        }
        bytes += std::string("\0\0\0\0\1\0\0\0\2\0\0\0", 12);
        for (int i = 0; doubles && i < 9; ++i)
            bytes += std::string("\0\0\x80\x3f", 4); // normals
        if (doubles) bytes += std::string(6 * sizeof(float) + 4, '\0');
        head.set_size(bytes.size());
        const std::string said = head.SerializeAsString();
        corpus.add("mesh", doubles ? "whole" : "plain", char(said.size()) + said + bytes);
    }
}

/// As a window sends it to a server: one of everything, and the same with its parts only named.
void addSharedScenes(const Corpus& corpus) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    soup->triangles = {{0, 1, 2}};
    soup->surfaceOf = {0};
    soup->cornerUvs.assign(3, Eigen::Vector2f(0.5f, 0.5f));
    TextureLayer layer;
    layer.pattern.source = TextureSource::Image;
    layer.pattern.image = std::make_shared<const TextureImage>(2, 1, std::vector<std::uint16_t>{1, 65535});
    layer.mask = TexturePattern{};
    layer.mask->source = TextureSource::Painted;
    layer.mask->painted.values = std::make_shared<const PaintedValues>(std::vector<float>{0, 0.5, 1});
    SceneObject object;
    object.name = "a";
    object.geometry = std::move(soup);
    object.surfaces.resize(1);
    object.surfaces[0].layers = {layer};
    RigidBody body;
    body.id = object.body = 1;
    Scene scene;
    scene.add(std::move(object));
    scene.mechanics.bodies = {body};
    corpus.add("scene", "whole", bytesOf(scene));
    corpus.add("scene", "named", bytesOf(scene, KnownParts(scene)));
    corpus.add("scene", "empty", bytesOf(Scene()));
}

void addPictures(const Corpus& corpus) {
    const std::vector<std::string> grey(6, "\x40"), deep(6, std::string("\x40\x80")), colour(6, "abc");
    corpus.add("image", "grey.png", asPng(3, 2, grey));
    corpus.add("image", "deep.png", asPng(3, 2, deep, {.depth = 16, .extra = {}}));
    corpus.add("image", "interlaced.png",
               asPng(3, 2, colour, {.colour = 2, .interlaced = true, .extra = {}}));
    corpus.add(
        "image", "palette.png",
        asPng(3, 2, std::vector<std::string>(6, "\x01"), {.colour = 3, .extra = pngChunk("PLTE", "abcdef")}));
    corpus.add("image", "strip.tiff", asTiff(3, 2, std::string(6, 'x')));
    corpus.add("image", "float.tiff",
               asTiff(2, 1, std::string("\0\0\0\x3f\0\0\0\x3f", 8), {.bits = 32, .format = 3}));
    corpus.add("image", "tile.tiff",
               asTiff(3, 2, std::string(768, 'x'), {.samples = 3, .photometric = 2, .tile = 16}));
    QImage picture(9, 7, QImage::Format_RGB32);
    picture.fill(Qt::darkCyan);
    for (const bool progressive : {false, true}) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QImageWriter writer(&buffer, "jpeg");
        writer.setProgressiveScanWrite(progressive);
        writer.write(picture);
        corpus.add("image", progressive ? "progressive.jpg" : "plain.jpg", bytes.toStdString());
    }
}

void addPresets(const Corpus& corpus) {
    Surface surface;
    surface.layers.resize(2);
    surface.layers[0].pattern.source = TextureSource::Image;
    surface.layers[0].pattern.image = std::make_shared<const TextureImage>(
        3, 2, std::vector<std::uint16_t>{0, 257, 514, 771, 1028, 65535}, "dots");
    surface.layers[1].mask.emplace().source = TextureSource::Grooves;
    corpus.add("preset", "layers.tactum-preset",
               presetText(presetOf(surface, "layers", {"set by us", "https://example.org", true}).preset));
    corpus.add("preset", "friction.tactum-preset",
               R"({"tactumPreset":"1.0","name":"ice","category":"cold","tags":["a"],"colour":[0,0.5,1],)"
               R"("feel":{"staticFriction":0.1,"dynamicFriction":0.03},"later":[1],)"
               R"("sources":{"staticFriction":{"words":"w","link":"l","typical":true}}})");
    corpus.add("hatt", "two.xml",
               "<?xml version=\"1.0\"?><modelSet><material>fur</material><AccelUnits>m/s^2</AccelUnits>"
               "<SampleRate>10000</SampleRate><mu>0.5</mu><numMACoeff>0</numMACoeff><model><ARlsf>"
               "<value>0.5</value><value>1</value><value>2</value></ARlsf><gain>1</gain><var>0.1</var>"
               "<speedMod>100</speedMod><forceMod>1</forceMod></model><model><ARlsf/><var>0</var>"
               "<speedMod>0</speedMod><forceMod>0</forceMod></model></modelSet>\n");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const Corpus corpus(argv[1]);
    addMeshes(corpus);
    addScenes(corpus);
    addMessages(corpus);
    addSharedScenes(corpus);
    addPictures(corpus);
    addPresets(corpus);
    const std::vector<FingerPoint> path{{0, {0, 0, 0}}, {0.001, {1e-3, -2, 0.5}}};
    corpus.add("finger", "two.csv", fingerCsv(path));
    Scene touched;
    SceneObject sheet;
    sheet.geometry = std::make_shared<const TriangleSoup>(folded());
    sheet.surfaces.resize(1);
    touched.add(std::move(sheet));
    corpus.add("recording", "short.tactum-recording",
               recordingBytes({handMadeRun(4, touched), "a few steps", {}}));
}
